// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Meshes that VTK's own readers read.
#include "nprFileFormats.h"

#include <vtkGeometryFilter.h>
#include <vtkNew.h>
#include <vtkRectilinearGrid.h>
#include <vtkSTLReader.h>
#include <vtkStructuredGrid.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLRectilinearGridReader.h>
#include <vtkXMLStructuredGridReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <algorithm>
#include <cctype>
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
}
