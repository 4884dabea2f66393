// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Volumes behind a header of text: NRRD and MetaImage. VTK reads their values, but leaves out the
// directions of their axes; MetaIO brings the program down over a damaged header; and neither says
// that the values end too early. So the header is read here, too.
#include "nprFileFormats.h"

#include <vtkDataArray.h>
#include <vtkEventForwarderCommand.h>
#include <vtkImageData.h>
#include <vtkMetaImageReader.h>
#include <vtkNew.h>
#include <vtkNrrdReader.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

namespace npr
{
namespace
{
struct Header
{
  std::map<std::string, std::string> Fields; // names in lower case
  std::uint64_t Size = 0;                    // bytes before the values

  std::string Get(const std::string& name) const
  {
    const auto field = this->Fields.find(name);
    return field == this->Fields.end() ? "" : field->second;
  }
  std::vector<double> GetNumbers(const std::string& name) const
  {
    std::string text = this->Get(name);
    std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '(' || c == ')' || c == ','; }, ' ');
    std::istringstream stream(text);
    std::vector<double> numbers;
    for (std::string word; stream >> word;)
    {
      char* end = nullptr;
      const double number = std::strtod(word.c_str(), &end);
      if (*end == '\0')
      {
        numbers.push_back(number);
      }
    }
    return numbers;
  }
};

std::string Trim(const std::string& text)
{
  const auto first = text.find_first_not_of(" \t\r");
  const auto last = text.find_last_not_of(" \t\r");
  return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

// Reads lines "name<separator>value" up to the line that ends the header: an empty one (NRRD), or
// the one of the given name (MetaImage).
Header ReadHeader(const std::string& path, char separator, const std::string& last)
{
  constexpr std::size_t longest =
    250; // MetaIO copies values to buffers of 255 bytes, without a check
  Header header;
  std::ifstream stream(path, std::ios::binary);
  for (std::string line; std::getline(stream, line);)
  {
    line = Trim(line);
    if (line.size() > 4 * longest || Printable(line) != line)
    {
      break;
    }
    const auto at = line.find(separator);
    if (at != std::string::npos && line.front() != '#')
    {
      std::string name = Trim(line.substr(0, at));
      std::transform(name.begin(), name.end(), name.begin(),
        [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
      const auto begin = line.find_first_not_of(separator, at); // NRRD also has ":="
      const std::string value = begin == std::string::npos ? "" : Trim(line.substr(begin));
      if (separator == '=' && (value.size() > longest || name.size() > longest))
      {
        break;
      }
      header.Fields[name] = value;
    }
    if (last.empty() ? line.empty() : at != std::string::npos && header.Fields.count(last) > 0)
    {
      header.Size = static_cast<std::uint64_t>(stream.tellg());
      return header;
    }
  }
  // A header alone may end with the file.
  if (last.empty() && stream.eof() && header.Fields.count("data file") > 0)
  {
    return header;
  }
  throw ModelError("its header is damaged or ends too early; copy or export it again");
}

void CheckValues(std::uint64_t there, double announced)
{
  if (static_cast<double>(there) < announced)
  {
    throw ModelError("its values are damaged or end too early: there are " + std::to_string(there) +
      " bytes of " + std::to_string(static_cast<long long>(announced)) +
      "; copy or export it again");
  }
}

// How many bytes of values there are, in the file itself or in the one that its header names.
std::uint64_t SizeOfValues(const std::string& path, const std::string& name, const Header& header)
{
  if (name.empty())
  {
    return static_cast<std::uint64_t>(std::filesystem::file_size(path)) - header.Size;
  }
  const auto other = std::filesystem::path(path).parent_path() / name;
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(other, ignored))
  {
    throw ModelError(
      "its values are in '" + other.string() + "', which is missing; put the file beside it");
  }
  return static_cast<std::uint64_t>(std::filesystem::file_size(other));
}

// The matrix that turns the image about its origin to the directions of its axes, null for none.
vtkSmartPointer<vtkMatrix4x4> TurnTo(const std::vector<double>& axes, vtkImageData* image)
{
  if (axes.size() != 9)
  {
    return nullptr;
  }
  auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
  const double* origin = image->GetOrigin();
  for (int column = 0; column < 3; ++column)
  {
    const double* axis = axes.data() + 3 * column;
    const double length = std::hypot(axis[0], axis[1], axis[2]);
    if (!(length > 0.0) || !std::isfinite(length))
    {
      return nullptr;
    }
    for (int row = 0; row < 3; ++row)
    {
      matrix->SetElement(row, column, axis[row] / length);
    }
  }
  for (int row = 0; row < 3; ++row)
  {
    double turned = 0.0;
    for (int column = 0; column < 3; ++column)
    {
      turned += matrix->GetElement(row, column) * origin[column];
    }
    matrix->SetElement(row, 3, origin[row] - turned);
  }
  return std::abs(matrix->Determinant()) > 1e-6 ? matrix : nullptr;
}

double Product(const std::vector<double>& numbers)
{
  double product = numbers.empty() ? 0.0 : 1.0;
  for (const double number : numbers)
  {
    product *= number;
  }
  return product;
}
}

void ReadNRRD(ModelFile& file)
{
  const Header header = ReadHeader(file.Path, ':', "");
  const std::uint64_t size = SizeOfValues(file.Path, header.Get("data file"), header);
  vtkNew<vtkNrrdReader> reader;
  file.Watch(reader);
  reader->SetFileName(file.Path.c_str());
  CheckSize(reader, size);
  if (header.Get("encoding") == "raw")
  {
    CheckValues(size,
      Product(header.GetNumbers("sizes")) *
        vtkDataArray::GetDataTypeSize(reader->GetDataScalarType()));
  }
  reader->Update();
  vtkImageData* image = reader->GetOutput();
  AddIsoSurface(file, image, TurnTo(header.GetNumbers("space directions"), image));
}

void ReadMetaImage(ModelFile& file)
{
  const Header header = ReadHeader(file.Path, '=', "elementdatafile");
  const std::vector<double> sizes = header.GetNumbers("dimsize");
  if (header.GetNumbers("ndims").size() != 1 || sizes.size() != header.GetNumbers("ndims")[0] ||
    sizes.empty() || sizes.size() > 4 || *std::min_element(sizes.begin(), sizes.end()) < 1.0)
  {
    throw ModelError("its header has no right NDims and DimSize; copy or export it again");
  }
  const std::string name = header.Get("elementdatafile");
  const bool isLocal = name == "LOCAL" || name == "Local" || name == "local";
  const std::uint64_t size = SizeOfValues(file.Path, isLocal ? "" : name, header);
  const std::vector<double> packed = header.GetNumbers("compresseddatasize");
  if (packed.size() == 1)
  {
    CheckValues(size, packed[0]);
  }

  vtkNew<vtkMetaImageReader> reader;
  file.Watch(reader);
  reader->SetFileName(file.Path.c_str());
  CheckSize(reader, size);
  if (packed.empty())
  {
    CheckValues(size, Product(sizes) * vtkDataArray::GetDataTypeSize(reader->GetDataScalarType()));
  }
  reader->Update();
  vtkImageData* image = reader->GetOutput();
  AddIsoSurface(file, image, TurnTo(header.GetNumbers("transformmatrix"), image));
}
}
