// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
//
// PLY, read by VTK. VTK's reader trusts the header: it takes garbage for the missing end of a
// binary file, and runs past the end of a short ASCII line. So the bytes are walked through here
// before.
#include "nprFileFormats.h"

#include <vtkEventForwarderCommand.h>
#include <vtkNew.h>
#include <vtkPLYReader.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <sstream>

namespace npr
{
namespace
{
struct PLYProperty
{
  int Size = 0;      // bytes
  int CountSize = 0; // bytes of a list's count, 0 where it is no list
  bool CountIsSigned = false;
};

struct PLYElement
{
  std::string Name;
  long long Count = 0;
  std::vector<PLYProperty> Properties;
};

int TypeSize(const std::string& type)
{
  static const std::vector<std::pair<const char*, int>> types = { { "char", 1 }, { "int8", 1 },
    { "uchar", 1 }, { "uint8", 1 }, { "short", 2 }, { "int16", 2 }, { "ushort", 2 },
    { "uint16", 2 }, { "int", 4 }, { "int32", 4 }, { "uint", 4 }, { "uint32", 4 }, { "float", 4 },
    { "float32", 4 }, { "double", 8 }, { "float64", 8 } };
  for (const auto& [name, size] : types)
  {
    if (type == name)
    {
      return size;
    }
  }
  throw ModelError("its header names the unknown type '" + type.substr(0, 20) +
    "'; the file is damaged or not a PLY");
}

class PLYCheck
{
public:
  explicit PLYCheck(const std::string& bytes) : Bytes(bytes) {}
  void Run()
  {
    this->ReadHeader();
    for (const PLYElement& element : this->Elements)
    {
      for (long long i = 0; i < element.Count; ++i)
      {
        if (!(this->IsAscii ? this->SkipLine(element) : this->SkipBinary(element)))
        {
          throw ModelError("it ends too early or is damaged: " + element.Name + " " +
            std::to_string(i) + " of " + std::to_string(element.Count) +
            " is not complete; copy or export it again");
        }
      }
    }
  }
  long long GetCount(const char* name) const
  {
    for (const PLYElement& element : this->Elements)
    {
      if (element.Name == name)
      {
        return element.Count;
      }
    }
    return 0;
  }

private:
  void ReadHeader();
  bool SkipLine(const PLYElement& element);
  bool SkipBinary(const PLYElement& element);

  const std::string& Bytes;
  std::size_t At = 0;
  bool IsAscii = false;
  bool IsBigEndian = false;
  std::vector<PLYElement> Elements;
};

void PLYCheck::ReadHeader()
{
  const std::size_t end = this->Bytes.find("end_header");
  if (this->Bytes.compare(0, 3, "ply") != 0 || end == std::string::npos)
  {
    throw ModelError(
      "it has no PLY header ('ply' ... 'end_header'); the file is damaged or not a PLY");
  }
  std::istringstream lines(this->Bytes.substr(0, end));
  for (std::string line; std::getline(lines, line);)
  {
    std::istringstream words(line);
    std::string keyword;
    std::string type;
    words >> keyword;
    if (keyword == "format")
    {
      words >> type;
      this->IsAscii = type == "ascii";
      this->IsBigEndian = type == "binary_big_endian";
    }
    else if (keyword == "element")
    {
      PLYElement element;
      words >> element.Name >> element.Count;
      if (!words || element.Count < 0)
      {
        throw ModelError("its header has a wrong count in '" + line.substr(0, 60) + "'");
      }
      this->Elements.push_back(element);
    }
    else if (keyword == "property" && !this->Elements.empty())
    {
      PLYProperty property;
      words >> type;
      if (type == "list")
      {
        words >> type;
        property.CountSize = TypeSize(type);
        property.CountIsSigned = type.front() != 'u';
        words >> type;
      }
      property.Size = TypeSize(type);
      this->Elements.back().Properties.push_back(property);
    }
  }
  for (const PLYElement& element : this->Elements)
  {
    if (element.Properties.empty() && element.Count > 0)
    {
      throw ModelError(
        "its header gives '" + element.Name + "' no properties; the file is damaged");
    }
  }
  // A header may end its lines as Windows does.
  this->At = std::min(this->Bytes.find('\n', end), this->Bytes.size() - 1) + 1;
}

bool PLYCheck::SkipLine(const PLYElement& element)
{
  const std::size_t end = std::min(this->Bytes.find('\n', this->At), this->Bytes.size());
  const char* at = this->Bytes.data() + this->At;
  const char* last = this->Bytes.data() + end;
  const auto isSpace = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  const auto nextWord = [&]() -> const char*
  {
    while (at < last && isSpace(*at))
    {
      ++at;
    }
    const char* word = at;
    while (at < last && !isSpace(*at))
    {
      ++at;
    }
    return word < at ? word : nullptr;
  };
  for (const PLYProperty& property : element.Properties)
  {
    long long words = 1;
    if (property.CountSize > 0)
    {
      const char* word = nextWord();
      words = word ? std::atoll(std::string(word, at).c_str()) : -1;
      if (words < 0)
      {
        return false;
      }
    }
    for (long long i = 0; i < words; ++i)
    {
      if (!nextWord())
      {
        return false;
      }
    }
  }
  this->At = end + 1;
  return true;
}

bool PLYCheck::SkipBinary(const PLYElement& element)
{
  for (const PLYProperty& property : element.Properties)
  {
    std::size_t items = 1;
    if (property.CountSize > 0)
    {
      const auto size = static_cast<std::size_t>(property.CountSize);
      if (this->At + size > this->Bytes.size() || size > 4)
      {
        return false;
      }
      std::uint32_t value = 0;
      for (std::size_t i = 0; i < size; ++i)
      {
        const auto byte = static_cast<unsigned char>(this->Bytes[this->At + i]);
        value |= std::uint32_t(byte) << (8 * (this->IsBigEndian ? size - 1 - i : i));
      }
      if (property.CountIsSigned && ((value >> (8 * size - 1)) & 1u) != 0)
      {
        return false;
      }
      items = value;
      this->At += size;
    }
    const std::size_t length = items * static_cast<std::size_t>(property.Size);
    if (length > this->Bytes.size() - this->At)
    {
      return false;
    }
    this->At += length;
  }
  return true;
}
}

void ReadPLY(ModelFile& file)
{
  const std::string bytes = ReadBytes(file.Path);
  PLYCheck check(bytes);
  check.Run();

  vtkNew<vtkPLYReader> reader;
  file.Watch(reader);
  reader->ReadFromInputStringOn();
  reader->SetInputString(bytes);
  reader->Update();
  vtkPolyData* surface = reader->GetOutput();
  if (surface->GetNumberOfPoints() != check.GetCount("vertex"))
  {
    throw ModelError("VTK took " + std::to_string(surface->GetNumberOfPoints()) + " of its " +
      std::to_string(check.GetCount("vertex")) + " points; the file is damaged, export it again");
  }
  file.AddPart(surface);
}
}
