// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Meshes that VTK's own readers read.
#include "nprFileFormats.h"

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkEventForwarderCommand.h>
#include <vtkFloatArray.h>
#include <vtkGLTFImporter.h>
#include <vtkGeometryFilter.h>
#include <vtkMapper.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkRectilinearGrid.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSTLReader.h>
#include <vtkStructuredGrid.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLRectilinearGridReader.h>
#include <vtkXMLStructuredGridReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>

namespace npr
{
namespace
{
std::string Lower(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

// Some programs write it in capitals, or after blanks.
bool StartsWithSolid(const std::string& text)
{
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first != std::string::npos && Lower(text.substr(first, 5)) == "solid";
}

// VTK's STL reader takes what there is of a file that ends too early, and says nothing.
void CheckSTL(const std::string& path)
{
  const auto size = static_cast<std::uint64_t>(std::filesystem::file_size(path));
  std::ifstream stream(path, std::ios::binary);
  char start[512] = {};
  stream.read(start, sizeof(start));
  const auto read = static_cast<std::size_t>(stream.gcount());
  const auto byte = [&](int i) { return std::uint64_t(static_cast<unsigned char>(start[i])); };
  const std::uint64_t triangles = byte(80) | byte(81) << 8 | byte(82) << 16 | byte(83) << 24;
  const std::uint64_t expected = 84 + 50 * triangles;
  if (StartsWithSolid(std::string(start, read)) && size != expected)
  {
    stream.clear();
    stream.seekg(static_cast<std::streamoff>(size > 512 ? size - 512 : 0));
    std::string end(512, '\0');
    stream.read(end.data(), 512);
    if (Lower(end).find("endsolid") == std::string::npos)
    {
      throw ModelError("it ends before 'endsolid'; copy or export it again");
    }
  }
  else if (size < expected)
  {
    throw ModelError("it ends too early: its header announces " + std::to_string(triangles) +
      " triangles, there is room for " + std::to_string(size < 84 ? 0 : (size - 84) / 50) +
      "; copy or export it again");
  }
}

template<typename Reader>
vtkSmartPointer<vtkDataSet> ReadWith(ModelFile& file)
{
  vtkNew<Reader> reader;
  file.Watch(reader);
  reader->SetFileName(file.Path.c_str());
  reader->Update();
  vtkDataSet* data = reader->GetOutput();
  return data;
}

double ToSRGB(double linear)
{
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

// Texture coordinates of glTF run downwards; VTK's importer turns them in the shader.
void TurnTextureCoordinates(vtkPolyData* surface)
{
  vtkDataArray* coordinates = surface->GetPointData()->GetTCoords();
  if (!coordinates)
  {
    return;
  }
  vtkNew<vtkFloatArray> turned;
  turned->SetName(coordinates->GetName());
  turned->SetNumberOfComponents(2);
  turned->SetNumberOfTuples(coordinates->GetNumberOfTuples());
  for (vtkIdType i = 0; i < coordinates->GetNumberOfTuples(); ++i)
  {
    turned->SetTuple2(i, coordinates->GetComponent(i, 0), 1.0 - coordinates->GetComponent(i, 1));
  }
  surface->GetPointData()->SetTCoords(turned);
}
}

void ReadSTL(ModelFile& file)
{
  CheckSTL(file.Path);
  file.AddPart(vtkPolyData::SafeDownCast(ReadWith<vtkSTLReader>(file)));
}

void ReadVTP(ModelFile& file)
{
  file.AddPart(vtkPolyData::SafeDownCast(ReadWith<vtkXMLPolyDataReader>(file)));
}

void ReadXMLDataSet(ModelFile& file)
{
  const std::string extension = FindFileFormat(file.Path)->Extension;
  vtkSmartPointer<vtkDataSet> data = extension == ".vtu"
    ? ReadWith<vtkXMLUnstructuredGridReader>(file)
    : extension == ".vts" ? ReadWith<vtkXMLStructuredGridReader>(file)
                          : ReadWith<vtkXMLRectilinearGridReader>(file);
  AddOutside(file, data);
}

void AddOutside(ModelFile& file, vtkDataSet* data)
{
  if (auto points = vtkPointSet::SafeDownCast(data))
  {
    CheckCells(points);
  }
  vtkNew<vtkGeometryFilter> outside;
  outside->SetInputData(data);
  outside->Update();
  file.AddPart(outside->GetOutput());
}

void ReadGLTF(ModelFile& file)
{
  vtkNew<vtkRenderWindow> window; // never drawn: the importer wants one to put its renderer in
  vtkNew<vtkRenderer> renderer;
  window->AddRenderer(renderer);
  vtkNew<vtkGLTFImporter> importer;
  if (file.Progress)
  {
    importer->AddObserver(vtkCommand::ProgressEvent, file.Progress);
  }
  importer->SetFileName(file.Path.c_str());
  importer->SetRenderWindow(window);
  importer->Update();

  vtkActorCollection* actors = renderer->GetActors();
  actors->InitTraversal();
  while (vtkActor* actor = actors->GetNextActor())
  {
    actor->GetMapper()->Update();
    auto surface = vtkPolyData::SafeDownCast(actor->GetMapper()->GetInput());
    if (!surface)
    {
      continue;
    }
    file.AddPart(surface);
    ModelPart& part = file.Parts.back();
    TurnTextureCoordinates(part.Surface);
    part.Matrix = vtkSmartPointer<vtkMatrix4x4>::New();
    part.Matrix->DeepCopy(actor->GetMatrix());
    vtkProperty* material = actor->GetProperty();
    double colour[3];
    material->GetColor(colour);
    std::transform(colour, colour + 3, colour, ToSRGB); // glTF's factors are linear
    part.Property = MakePlainProperty(colour, material->GetOpacity());
    if (vtkTexture* base = material->GetTexture("albedoTex"))
    {
      base->UseSRGBColorSpaceOff(); // nothing turns it back without physically based shading
      part.Texture = base;
    }
  }
}
}
