// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRDrawingWriter.h"

#include "nprPageComposer.h"
#include "vtkNPRDrawingStyle.h"

#include <vtkCamera.h>
#include <vtkErrorCode.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkPolyData.h>

#include <vtksys/FStream.hxx>
#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>
#include <vector>

//------------------------------------------------------------------------------
vtkNPRDrawingWriter::vtkNPRDrawingWriter() : Style(vtkSmartPointer<vtkNPRDrawingStyle>::New()) {}

vtkNPRDrawingWriter::~vtkNPRDrawingWriter()
{
  delete[] this->FileName;
}

//------------------------------------------------------------------------------
void vtkNPRDrawingWriter::SetCamera(vtkCamera* camera)
{
  if (this->Camera != camera)
  {
    this->Camera = camera;
    this->Modified();
  }
}

vtkCamera* vtkNPRDrawingWriter::GetCamera() const
{
  return this->Camera;
}

void vtkNPRDrawingWriter::SetStyle(vtkNPRDrawingStyle* style)
{
  if (this->Style != style)
  {
    this->Style = style ? style : vtkSmartPointer<vtkNPRDrawingStyle>::New().Get();
    this->Modified();
  }
}

vtkNPRDrawingStyle* vtkNPRDrawingWriter::GetStyle() const
{
  return this->Style;
}

void vtkNPRDrawingWriter::SetImage(vtkImageData* image)
{
  if (this->Image != image)
  {
    this->Image = image;
    this->Modified();
  }
}

vtkImageData* vtkNPRDrawingWriter::GetImage() const
{
  return this->Image;
}

void vtkNPRDrawingWriter::SetTones(vtkImageData* tones)
{
  if (this->Tones != tones)
  {
    this->Tones = tones;
    this->Modified();
  }
}

vtkImageData* vtkNPRDrawingWriter::GetTones() const
{
  return this->Tones;
}

//------------------------------------------------------------------------------
void vtkNPRDrawingWriter::SetPageSize(double width, double height)
{
  this->CustomSize[0] = width;
  this->CustomSize[1] = height;
  this->Paper = CUSTOM_PAPER;
  this->Modified();
}

void vtkNPRDrawingWriter::GetPageSize(double size[2]) const
{
  constexpr double Sizes[][2] = { { 210.0, 297.0 }, { 297.0, 420.0 }, { 215.9, 279.4 } };
  constexpr double MillimetresPerPixel = 25.4 / 96.0;
  if (this->Paper == CUSTOM_PAPER)
  {
    std::copy_n(this->CustomSize, 2, size);
  }
  else if (this->Paper == VIEWPORT_PAPER)
  {
    size[0] = MillimetresPerPixel * this->ViewportSize[0];
    size[1] = MillimetresPerPixel * this->ViewportSize[1];
  }
  else
  {
    std::copy_n(Sizes[this->Paper - A4_PAPER], 2, size);
    if (this->Orientation == LANDSCAPE ||
      (this->Orientation == AUTOMATIC_ORIENTATION && this->ViewportSize[0] > this->ViewportSize[1]))
    {
      std::swap(size[0], size[1]);
    }
  }
}

//------------------------------------------------------------------------------
double vtkNPRDrawingWriter::GetShorterSide() const
{
  double room[2];
  this->GetPageSize(room);
  for (double& side : room)
  {
    side = std::max(side - 2.0 * this->GetUsedMargin(), 0.0);
  }
  if (this->Fit != FIT_VIEWPORT || this->ViewportSize[0] < 1 || this->ViewportSize[1] < 1)
  {
    return std::min(room[0], room[1]);
  }
  return std::min(room[0] / this->ViewportSize[0], room[1] / this->ViewportSize[1]) *
    std::min(this->ViewportSize[0], this->ViewportSize[1]);
}

//------------------------------------------------------------------------------
int vtkNPRDrawingWriter::FillInputPortInformation(int, vtkInformation* information)
{
  information->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
npr::PageRequest vtkNPRDrawingWriter::MakeRequest()
{
  npr::PageRequest request;
  request.Camera = this->Camera;
  std::copy_n(this->ViewportSize, 2, request.Viewport);
  this->GetPageSize(request.Size);
  request.Margin = this->GetUsedMargin();
  request.Fit = static_cast<npr::PageFit>(this->Fit);
  request.MillimetresPerUnit = this->MillimetresPerUnit;
  request.Scale = this->Scale;
  request.ScaleBar = this->ScaleBar;
  request.UnitName = this->UnitName;
  request.Hidden = static_cast<npr::HiddenLines>(this->HiddenLines);
  request.Tolerance = this->Tolerance;
  request.CornerAngle = this->CornerAngle;
  request.Style = this->Style;
  request.Image = this->Image;
  request.Tones = this->Tones;
  request.Title = this->Title;
  request.Date = this->Date;
  return request;
}

//------------------------------------------------------------------------------
void vtkNPRDrawingWriter::WriteData()
{
  vtkPolyData* const strokes = vtkPolyData::SafeDownCast(this->GetInput());
  if (!this->FileName || !*this->FileName)
  {
    vtkErrorMacro("There is no name for the drawing; give one to SetFileName().");
    this->SetErrorCode(vtkErrorCode::NoFileNameError);
    return;
  }
  try
  {
    std::vector<std::string> warnings;
    const npr::PageDrawing drawing = npr::ComposePage(this->MakeRequest(), strokes, warnings);
    for (const std::string& warning : warnings)
    {
      vtkWarningMacro(<< this->FileName << ": " << warning);
    }
    this->WriteBytes(this->Encode(drawing));
  }
  catch (const npr::DrawingError& error)
  {
    vtkErrorMacro(<< this->FileName << " is not written: " << error.what());
    this->SetErrorCode(vtkErrorCode::UserError);
  }
}

//------------------------------------------------------------------------------
void vtkNPRDrawingWriter::WriteBytes(const std::string& bytes)
{
  vtksys::ofstream file(this->FileName, std::ios::out | std::ios::binary | std::ios::trunc);
  if (!file)
  {
    vtkErrorMacro(<< this->FileName
                  << " can't be opened for writing: see that its folder is there, that "
                     "you may write to it, and that it is no folder itself.");
    this->SetErrorCode(vtkErrorCode::CannotOpenFileError);
    return;
  }
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  if (!file)
  {
    std::error_code ignored;
    if (std::filesystem::is_regular_file(this->FileName, ignored))
    {
      vtksys::SystemTools::RemoveFile(this->FileName);
    }
    vtkErrorMacro(<< this->FileName << " could not be written whole (" << bytes.size()
                  << " bytes) and is not kept: see that the disk is not full.");
    this->SetErrorCode(vtkErrorCode::OutOfDiskSpaceError);
  }
}

//------------------------------------------------------------------------------
void vtkNPRDrawingWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "Camera: " << this->Camera.Get() << "\n";
  os << indent << "ViewportSize: " << this->ViewportSize[0] << " " << this->ViewportSize[1] << "\n";
  os << indent << "Style: " << this->Style->GetName() << "\n";
  os << indent << "Paper: " << this->Paper << "\n";
  os << indent << "Orientation: " << this->Orientation << "\n";
  os << indent << "Margin: " << this->Margin << "\n";
  os << indent << "Fit: " << this->Fit << "\n";
  os << indent << "MillimetresPerUnit: " << this->MillimetresPerUnit << "\n";
  os << indent << "Scale: " << this->Scale << "\n";
  os << indent << "ScaleBar: " << this->ScaleBar << "\n";
  os << indent << "UnitName: " << this->UnitName << "\n";
  os << indent << "HiddenLines: " << this->HiddenLines << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "CornerAngle: " << this->CornerAngle << "\n";
  os << indent << "Image: " << this->Image.Get() << "\n";
  os << indent << "Tones: " << this->Tones.Get() << "\n";
  os << indent << "Title: " << this->Title << "\n";
  os << indent << "Date: " << this->Date << "\n";
}
