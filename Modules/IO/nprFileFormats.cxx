// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprFileFormats.h"

#include "nprMessageCapture.h"

#include <vtkAlgorithm.h>
#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCommand.h>
#include <vtkEventForwarderCommand.h>
#include <vtkImageData.h>
#include <vtkImageReader2.h>
#include <vtkImageReader2Factory.h>
#include <vtkJPEGReader.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkTransform.h>
#include <vtkTransformPolyDataFilter.h>
#include <vtkUnstructuredGrid.h>
#include <vtk_zlib.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <limits>

namespace npr
{
const std::vector<FileFormat>& GetFileFormats()
{
  // CAD programs and medical images have Z up; most scans and scenes have Y up.
  constexpr int Y = 1;
  constexpr int Z = 2;
  static const std::vector<FileFormat> formats = {
    { ".obj", "Wavefront OBJ mesh, with its MTL materials and textures", false, Y, ReadOBJ },
    { ".ply", "Stanford PLY mesh, with point colours", false, Y, ReadPLY },
    { ".ply.gz", "Stanford PLY mesh compressed by gzip", false, Y, ReadPLY },
    { ".stl", "STL mesh", false, Z, ReadSTL },
    { ".gltf", "glTF 2.0 scene", false, Y, ReadGLTF },
    { ".glb", "glTF 2.0 scene, binary", false, Y, ReadGLTF },
    { ".vtp", "VTK surface", false, Y, ReadVTP },
    { ".vtu", "VTK unstructured grid, its outside", false, Y, ReadXMLDataSet },
    { ".vts", "VTK structured grid, its outside", false, Y, ReadXMLDataSet },
    { ".vtr", "VTK rectilinear grid, its outside", false, Y, ReadXMLDataSet },
    { ".vtk", "VTK legacy file: a surface, the outside of a grid, or a volume", true, Y,
      ReadLegacyVTK },
    { ".vti", "VTK volume", true, Y, ReadVTI },
    { ".nii", "NIfTI volume", true, Z, ReadNIFTI, 180.0 },
    { ".nii.gz", "NIfTI volume compressed by gzip", true, Z, ReadNIFTI, 180.0 },
    { ".nrrd", "NRRD volume", true, Z, ReadNRRD },
    { ".nhdr", "NRRD volume, detached header", true, Z, ReadNRRD },
    { ".mha", "MetaImage volume", true, Z, ReadMetaImage },
    { ".mhd", "MetaImage volume, detached header", true, Z, ReadMetaImage },
    { ".vdb", "OpenVDB volume", true, Y, ReadVDB },
  };
  return formats;
}

const FileFormat* FindFileFormat(const std::string& path)
{
  std::string lower = path;
  std::transform(lower.begin(), lower.end(), lower.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const FileFormat* best = nullptr;
  for (const FileFormat& format : GetFileFormats())
  {
    const std::string extension = format.Extension;
    if (lower.size() > extension.size() &&
      lower.compare(lower.size() - extension.size(), extension.size(), extension) == 0 &&
      (!best || extension.size() > std::string(best->Extension).size()))
    {
      best = &format;
    }
  }
  return best;
}

void ModelFile::Watch(vtkAlgorithm* reader) const
{
  if (this->Progress)
  {
    reader->AddObserver(vtkCommand::ProgressEvent, this->Progress);
  }
}

void ModelFile::AddPart(vtkPolyData* surface)
{
  ModelPart part;
  part.Surface = vtkSmartPointer<vtkPolyData>::New();
  part.Surface->ShallowCopy(surface);
  this->Parts.push_back(part);
}

std::string Printable(std::string text)
{
  std::replace_if(
    text.begin(), text.end(), [](unsigned char c) { return c < 32 || c > 126; }, '?');
  return text;
}

std::string ReadBytes(const std::string& path)
{
  // zlib reads plain files as they are.
  gzFile stream = gzopen(path.c_str(), "rb");
  if (!stream)
  {
    throw ModelError("it can not be opened; check its permissions");
  }
  std::string bytes;
  std::vector<char> buffer(1 << 18);
  int count = 0;
  while ((count = gzread(stream, buffer.data(), static_cast<unsigned int>(buffer.size()))) > 0)
  {
    bytes.append(buffer.data(), static_cast<std::size_t>(count));
  }
  int code = Z_OK;
  gzerror(stream, &code);
  gzclose_r(stream);
  if (count < 0 || code == Z_BUF_ERROR)
  {
    throw ModelError("its gzip data is damaged or ends too early; copy or download it again");
  }
  return bytes;
}

vtkSmartPointer<vtkProperty> MakePlainProperty(const double diffuse[3], double opacity)
{
  auto property = vtkSmartPointer<vtkProperty>::New();
  property->SetColor(diffuse[0], diffuse[1], diffuse[2]);
  property->SetOpacity(opacity);
  property->SetAmbient(0.0);
  property->SetDiffuse(1.0);
  property->SetInterpolationToPhong();
  return property;
}

namespace
{
// VTK's PNG reader crashes on damaged bytes in memory, so its chunks and their sums are checked.
bool IsSoundPNG(const std::string& bytes)
{
  const auto word = [&bytes](std::size_t at)
  {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i)
    {
      value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
    }
    return value;
  };
  if (bytes.compare(0, 8, "\x89PNG\r\n\x1A\n") != 0 || bytes.compare(12, 4, "IHDR") != 0)
  {
    return false;
  }
  for (std::size_t at = 8; at + 12 <= bytes.size();)
  {
    const std::size_t size = word(at);
    if (size > bytes.size() - at - 12)
    {
      return false;
    }
    const auto sum = crc32(0, reinterpret_cast<const unsigned char*>(bytes.data()) + at + 4,
      static_cast<unsigned int>(size + 4));
    if (sum != word(at + 8 + size))
    {
      return false;
    }
    if (bytes.compare(at + 4, 4, "IEND") == 0)
    {
      return true;
    }
    at += size + 12;
  }
  return false;
}

// The texture of a reader that has its file or bytes; a damaged image is no reason to lose the
// model.
vtkSmartPointer<vtkTexture> MakeTexture(
  ModelFile& file, vtkImageReader2* reader, const std::string& name)
{
  const MessageCapture messages;
  if (reader)
  {
    reader->Update();
  }
  if (!reader || reader->GetErrorCode() != 0 || !messages.GetErrors().empty() ||
    reader->GetOutput()->GetNumberOfPoints() == 0)
  {
    file.Warnings.push_back("The texture '" + name +
      "' is not an image that VTK reads; the plain colour is used. Convert it to PNG or JPEG.");
    return nullptr;
  }
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(reader->GetOutput());
  texture->InterpolateOn();
  texture->MipmapOn();
  return texture;
}
}

vtkSmartPointer<vtkTexture> ReadTexture(ModelFile& file, const std::string& path)
{
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored))
  {
    file.Warnings.push_back("The texture '" + path + "' is missing; the plain colour is used.");
    return nullptr;
  }
  auto reader = vtkSmartPointer<vtkImageReader2>::Take(
    vtkImageReader2Factory::CreateImageReader2(path.c_str()));
  if (reader)
  {
    reader->SetFileName(path.c_str());
  }
  return MakeTexture(file, reader, path);
}

vtkSmartPointer<vtkTexture> ReadTextureBytes(
  ModelFile& file, const std::string& bytes, const std::string& name)
{
  vtkSmartPointer<vtkImageReader2> reader;
  if (bytes.size() > 16 && IsSoundPNG(bytes))
  {
    reader = vtkSmartPointer<vtkPNGReader>::New();
  }
  else if (bytes.compare(0, 2, "\xFF\xD8") == 0)
  {
    reader = vtkSmartPointer<vtkJPEGReader>::New();
  }
  if (reader)
  {
    reader->SetMemoryBuffer(bytes.data());
    reader->SetMemoryBufferLength(static_cast<vtkIdType>(bytes.size()));
  }
  return MakeTexture(file, reader, name);
}

bool NeedsDouble(const std::vector<std::array<double, 3>>& points)
{
  double size = 0.0;
  double farthest = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    double least = std::numeric_limits<double>::infinity();
    double most = -least;
    for (const auto& point : points)
    {
      least = std::min(least, std::isfinite(point[i]) ? point[i] : least);
      most = std::max(most, std::isfinite(point[i]) ? point[i] : most);
    }
    if (least <= most)
    {
      size = std::max(size, most - least);
      farthest = std::max({ farthest, std::abs(least), std::abs(most) });
    }
  }
  // Of the 24 bits of a float 17 are left here, steps of 1e-5 of the size.
  return farthest > 100.0 * size;
}

void ReversePolygons(vtkPolyData* surface)
{
  vtkNew<vtkCellArray> polygons;
  polygons->DeepCopy(surface->GetPolys());
  for (vtkIdType cell = 0; cell < polygons->GetNumberOfCells(); ++cell)
  {
    polygons->ReverseCellAtId(cell);
  }
  surface->SetPolys(polygons);
}

vtkSmartPointer<vtkPolyData> TransformSurface(vtkPolyData* surface, vtkMatrix4x4* matrix)
{
  vtkNew<vtkTransform> transform;
  transform->SetMatrix(matrix);
  vtkNew<vtkTransformPolyDataFilter> filter;
  filter->SetTransform(transform);
  filter->SetInputData(surface);
  filter->Update();
  vtkSmartPointer<vtkPolyData> result = filter->GetOutput();
  if (matrix->Determinant() < 0.0)
  {
    ReversePolygons(result);
  }
  return result;
}

namespace
{
void CheckCellArray(vtkCellArray* cells, vtkIdType numberOfPoints)
{
  if (!cells || cells->GetNumberOfCells() == 0)
  {
    return;
  }
  auto iterator = vtkSmartPointer<vtkCellArrayIterator>::Take(cells->NewIterator());
  for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    iterator->GetCurrentCell(size, points);
    for (vtkIdType i = 0; i < size; ++i)
    {
      if (points[i] < 0 || points[i] >= numberOfPoints)
      {
        throw ModelError("a face refers to point " + std::to_string(points[i]) +
          ", but there are " + std::to_string(numberOfPoints) +
          " points; the file is damaged, write it again");
      }
    }
  }
}
}

void CheckCells(vtkPointSet* data)
{
  const vtkIdType points = data->GetNumberOfPoints();
  if (auto surface = vtkPolyData::SafeDownCast(data))
  {
    for (vtkCellArray* cells :
      { surface->GetVerts(), surface->GetLines(), surface->GetPolys(), surface->GetStrips() })
    {
      CheckCellArray(cells, points);
    }
  }
  else if (auto grid = vtkUnstructuredGrid::SafeDownCast(data))
  {
    CheckCellArray(grid->GetCells(), points);
  }
}
}
