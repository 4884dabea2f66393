// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRModelImporter.h"

#include "nprFileFormats.h"
#include "nprMessageCapture.h"

#include <vtkActor.h>
#include <vtkAppendPolyData.h>
#include <vtkBoundingBox.h>
#include <vtkCellArray.h>
#include <vtkEventForwarderCommand.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <new>

struct vtkNPRModelImporter::Internals
{
  std::vector<npr::ModelPart> Parts;
  std::string ErrorMessage;
  std::string Warnings;
  vtkTimeStamp ReadTime;
  bool IsRead = false;
};

namespace
{
std::string KnownExtensions()
{
  std::string text;
  for (const npr::FileFormat& format : npr::GetFileFormats())
  {
    text += (text.empty() ? "" : " ") + std::string(format.Extension);
  }
  return text;
}

const npr::FileFormat& CheckPath(const std::string& path)
{
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status))
  {
    throw npr::ModelError(status.type() == std::filesystem::file_type::not_found
        ? "there is no such file; check the path"
        : "it can not be reached (" + error.message() + "); check its permissions");
  }
  if (std::filesystem::is_directory(status))
  {
    throw npr::ModelError("it is a directory; name a file in it");
  }
  const npr::FileFormat* format = npr::FindFileFormat(path);
  if (!format)
  {
    throw npr::ModelError(
      "its extension is not known; rename or convert it to one of " + KnownExtensions());
  }
  std::ifstream stream(path, std::ios::binary);
  if (!stream)
  {
    throw npr::ModelError(
      "it can not be opened (" + std::string(std::strerror(errno)) + "); check its permissions");
  }
  if (stream.peek() == std::ifstream::traits_type::eof())
  {
    throw npr::ModelError("it is empty; copy or export it again");
  }
  return *format;
}

// Nothing downstream should meet a part that it can not walk over.
void CheckParts(npr::ModelFile& file)
{
  vtkIdType polygons = 0;
  vtkIdType points = 0;
  vtkIdType badPoints = 0;
  vtkBoundingBox box;
  for (npr::ModelPart& part : file.Parts)
  {
    npr::CheckCells(part.Surface);
    polygons += part.Surface->GetNumberOfPolys() + part.Surface->GetNumberOfStrips();
    points += part.Surface->GetNumberOfPoints();
    for (vtkIdType i = 0; i < part.Surface->GetNumberOfPoints(); ++i)
    {
      const double* point = part.Surface->GetPoint(i);
      if (std::isfinite(point[0]) && std::isfinite(point[1]) && std::isfinite(point[2]))
      {
        box.AddPoint(point[0], point[1], point[2]);
      }
      else
      {
        ++badPoints;
      }
    }
  }
  if (polygons == 0)
  {
    throw npr::ModelError("there are no triangles in it (" + std::to_string(points) +
      " points); vtkNPR draws surfaces, so export one");
  }
  if (badPoints == points)
  {
    throw npr::ModelError(
      "none of its " + std::to_string(points) + " points has finite coordinates; export it again");
  }
  if (!(box.GetMaxLength() > 0.0))
  {
    throw npr::ModelError("all its points are in one place; export it again");
  }
  if (badPoints > 0)
  {
    file.Warnings.push_back(std::to_string(badPoints) + " of " + std::to_string(points) +
      " points have no finite coordinates.");
  }
}

void ReadFile(npr::ModelFile& file)
{
  const npr::FileFormat& format = CheckPath(file.Path);
  npr::MessageCapture messages;
  std::string reason;
  try
  {
    format.Read(file);
  }
  catch (const npr::ModelError& error)
  {
    reason = error.what();
  }
  catch (const std::bad_alloc&)
  {
    reason = "there is not enough memory for it, or it is damaged";
  }
  catch (const std::exception& error)
  {
    reason = std::string("it is damaged (") + error.what() + "); copy or export it again";
  }
  const auto errors = messages.GetErrors();
  if (!errors.empty())
  {
    // A reader of ours has said it in the same words; VTK's say less.
    const std::string ours = "Cannot read '" + file.Path + "': ";
    reason = errors.front().compare(0, ours.size(), ours) == 0
      ? errors.front().substr(ours.size())
      : "it is damaged, or not what its name says (" + errors.front() +
        "); copy or export it again";
  }
  else if (reason.empty() && file.Parts.empty())
  {
    const std::string text = messages.GetConsoleText();
    reason = "there are no triangles in it" + (text.empty() ? "" : " (" + text + ")") +
      "; vtkNPR draws surfaces, so export one";
  }
  if (!reason.empty())
  {
    throw npr::ModelError(reason);
  }
  CheckParts(file);
  for (const std::string& warning : messages.GetWarnings())
  {
    file.Warnings.push_back(warning);
  }
  if (file.IsoValue && !format.IsVolume)
  {
    file.Warnings.push_back("The iso value is not used, for this is a mesh and not a volume.");
  }
}

bool HasPointColours(vtkPolyData* surface)
{
  auto colours = vtkUnsignedCharArray::SafeDownCast(surface->GetPointData()->GetScalars());
  return colours && colours->GetNumberOfComponents() >= 3;
}
}

vtkStandardNewMacro(vtkNPRModelImporter);

vtkNPRModelImporter::vtkNPRModelImporter() : Internal(std::make_unique<Internals>()) {}

vtkNPRModelImporter::~vtkNPRModelImporter()
{
  this->SetFileName(nullptr);
  this->SetGridName(nullptr);
}

void vtkNPRModelImporter::SetIsoValue(double value)
{
  if (!this->UseIsoValue || this->IsoValue != value)
  {
    this->IsoValue = value;
    this->UseIsoValue = true;
    this->Modified();
  }
}

bool vtkNPRModelImporter::Read()
{
  Internals& internal = *this->Internal;
  if (internal.IsRead && internal.ReadTime > this->GetMTime())
  {
    return true;
  }
  internal = Internals();
  npr::ModelFile file;
  file.Path = this->FileName ? this->FileName : "";
  file.GridName = this->GridName ? this->GridName : "";
  file.Progress = vtkSmartPointer<vtkEventForwarderCommand>::New();
  file.Progress->SetTarget(this);
  if (this->UseIsoValue)
  {
    file.IsoValue = this->IsoValue;
  }
  file.VolumeSmoothing = this->VolumeSmoothing;
  try
  {
    if (file.Path.empty())
    {
      throw npr::ModelError("no file is named; call SetFileName()");
    }
    ReadFile(file);
  }
  catch (const npr::ModelError& error)
  {
    internal.ErrorMessage = "Cannot read '" + file.Path + "': " + error.what() + ".";
    vtkErrorMacro(<< internal.ErrorMessage);
    return false;
  }
  for (const std::string& warning : file.Warnings)
  {
    internal.Warnings += (internal.Warnings.empty() ? "" : "\n") + warning;
  }
  internal.Parts = std::move(file.Parts);
  internal.IsRead = true;
  internal.ReadTime.Modified();
  return true;
}

bool vtkNPRModelImporter::ImportInto(vtkRenderer* renderer)
{
  if (!renderer)
  {
    vtkErrorMacro("There is no renderer to import into; hand one to ImportInto().");
    return false;
  }
  if (!this->Read())
  {
    return false;
  }
  for (const npr::ModelPart& part : this->Internal->Parts)
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(part.Surface);
    mapper->SetScalarVisibility(HasPointColours(part.Surface));
    mapper->SetColorModeToDirectScalars();
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->SetUserMatrix(part.Matrix);
    actor->SetTexture(part.Texture);
    if (part.Property)
    {
      actor->SetProperty(part.Property);
    }
    renderer->AddActor(actor);
  }
  return true;
}

bool vtkNPRModelImporter::GetSurface(vtkPolyData* surface)
{
  if (!surface)
  {
    vtkErrorMacro("There is no vtkPolyData to fill; hand one to GetSurface().");
    return false;
  }
  if (!this->Read())
  {
    return false;
  }
  std::vector<vtkSmartPointer<vtkPolyData>> surfaces;
  for (const npr::ModelPart& part : this->Internal->Parts)
  {
    surfaces.push_back(
      part.Matrix ? npr::TransformSurface(part.Surface, part.Matrix) : part.Surface);
  }
  if (surfaces.size() == 1)
  {
    surface->ShallowCopy(surfaces.front());
    return true;
  }
  vtkNew<vtkAppendPolyData> append;
  for (vtkPolyData* each : surfaces)
  {
    append->AddInputData(each);
  }
  append->Update();
  surface->ShallowCopy(append->GetOutput());
  return true;
}

int vtkNPRModelImporter::GetNumberOfParts() const
{
  return static_cast<int>(this->Internal->Parts.size());
}

int vtkNPRModelImporter::GetUpAxis() const
{
  const npr::FileFormat* format = this->FileName ? npr::FindFileFormat(this->FileName) : nullptr;
  return format ? format->UpAxis : 1;
}

double vtkNPRModelImporter::GetFrontAzimuth() const
{
  const npr::FileFormat* format = this->FileName ? npr::FindFileFormat(this->FileName) : nullptr;
  return format ? format->FrontAzimuth : 0.0;
}

const char* vtkNPRModelImporter::GetErrorMessage() const
{
  return this->Internal->ErrorMessage.c_str();
}

const char* vtkNPRModelImporter::GetWarnings() const
{
  return this->Internal->Warnings.c_str();
}

int vtkNPRModelImporter::GetNumberOfFormats()
{
  return static_cast<int>(npr::GetFileFormats().size());
}

const char* vtkNPRModelImporter::GetFormatExtension(int format)
{
  return format >= 0 && format < GetNumberOfFormats() ? npr::GetFileFormats()[format].Extension
                                                      : nullptr;
}

const char* vtkNPRModelImporter::GetFormatDescription(int format)
{
  return format >= 0 && format < GetNumberOfFormats() ? npr::GetFileFormats()[format].Description
                                                      : nullptr;
}

bool vtkNPRModelImporter::GetFormatIsVolume(int format)
{
  return format >= 0 && format < GetNumberOfFormats() && npr::GetFileFormats()[format].IsVolume;
}

int vtkNPRModelImporter::GetFormatUpAxis(int format)
{
  return format >= 0 && format < GetNumberOfFormats() ? npr::GetFileFormats()[format].UpAxis : -1;
}

bool vtkNPRModelImporter::IsFileNameKnown(const char* fileName)
{
  return fileName && npr::FindFileFormat(fileName);
}

void vtkNPRModelImporter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "IsoValue: " << this->IsoValue << "\n";
  os << indent << "UseIsoValue: " << this->UseIsoValue << "\n";
  os << indent << "VolumeSmoothing: " << this->VolumeSmoothing << "\n";
  os << indent << "GridName: " << (this->GridName ? this->GridName : "(none)") << "\n";
  os << indent << "Parts: " << this->Internal->Parts.size() << "\n";
}
