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
#include <array>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <sstream>

namespace npr
{
namespace
{
// VTK cuts longer lines.
constexpr std::size_t LongestLine = 4090;

struct PLYProperty
{
  std::string Name;
  int Size = 0;      // bytes
  int CountSize = 0; // bytes of a list's count, 0 where it is no list
  bool CountIsSigned = false;
  bool IsSigned = false;
  bool IsReal = false;

  // 0 .. 2 for a coordinate that a float may not hold, else -1.
  int GetWideAxis() const
  {
    const bool isWide = this->IsReal && this->Size == 8 && this->CountSize == 0;
    return isWide && this->Name.size() == 1 && this->Name >= "x" && this->Name <= "z"
      ? this->Name[0] - 'x'
      : -1;
  }
  bool IsIndices() const
  {
    return this->CountSize > 0 && (this->Name == "vertex_indices" || this->Name == "vertex_index");
  }
};

struct PLYElement
{
  std::string Name;
  long long Count = 0;
  std::vector<PLYProperty> Properties;

  bool IsWide() const
  {
    return std::count_if(this->Properties.begin(), this->Properties.end(),
             [](const PLYProperty& p) { return p.GetWideAxis() >= 0; }) == 3;
  }
  bool Has(const char* name, bool asList) const
  {
    return std::any_of(this->Properties.begin(), this->Properties.end(),
      [&](const PLYProperty& p) { return p.Name == name && (p.CountSize > 0) == asList; });
  }
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
  throw ModelError("its header names the unknown type '" + Printable(type.substr(0, 20)) +
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
          throw ModelError("it ends too early or is damaged: " + Printable(element.Name) + " " +
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

  /// All points, where the file has their coordinates in double precision, else none.
  const std::vector<std::array<double, 3>>& GetWidePoints() const { return this->WidePoints; }

private:
  void ReadHeader();
  void CheckElements() const;
  void AddWidePoint(const PLYElement& element);
  bool SkipLine(const PLYElement& element);
  bool SkipBinary(const PLYElement& element);
  long long Decode(int size, bool isSigned);
  void CheckIndex(const PLYElement& element, long long index) const;

  const std::string& Bytes;
  std::size_t At = 0;
  bool IsAscii = false;
  bool IsBigEndian = false;
  std::vector<PLYElement> Elements;
  std::vector<std::array<double, 3>> WidePoints;
};

void PLYCheck::ReadHeader()
{
  const std::size_t end = this->Bytes.find("end_header");
  if (this->Bytes.compare(0, 3, "ply") != 0 || end == std::string::npos)
  {
    throw ModelError(
      "it has no PLY header ('ply' ... 'end_header'); the file is damaged or not a PLY");
  }
  bool hasFormat = false;
  std::istringstream lines(this->Bytes.substr(0, end));
  for (std::string line; std::getline(lines, line);)
  {
    std::istringstream stream(line);
    const std::vector<std::string> words{ std::istream_iterator<std::string>(stream), {} };
    const std::string keyword = words.empty() ? "" : words[0];
    const std::size_t count = words.size();
    if (keyword.empty() || keyword == "ply" || keyword == "comment" || keyword == "obj_info")
    {
      continue;
    }
    const bool isList = count > 1 && words[1] == "list";
    if (keyword == "format" && count == 3)
    {
      this->IsAscii = words[1] == "ascii";
      this->IsBigEndian = words[1] == "binary_big_endian";
      hasFormat = this->IsAscii || this->IsBigEndian || words[1] == "binary_little_endian";
    }
    else if (keyword == "element" && count == 3 && words[2].size() < 10 &&
      words[2].find_first_not_of("0123456789") == std::string::npos)
    {
      this->Elements.push_back({ words[1], std::stoll(words[2]), {} });
    }
    else if (keyword == "property" && count == (isList ? 5u : 3u) && !this->Elements.empty())
    {
      PLYProperty property;
      property.Name = words.back();
      property.Size = TypeSize(words[count - 2]);
      property.CountSize = isList ? TypeSize(words[2]) : 0;
      property.CountIsSigned = isList && words[2].front() != 'u';
      property.IsSigned = words[count - 2].front() != 'u';
      property.IsReal = words[count - 2].front() == 'f' || words[count - 2].front() == 'd';
      if (property.IsIndices() && (property.Size > 4 || words[count - 2].front() == 'f'))
      {
        throw ModelError("its header gives indices the type '" + words[count - 2] +
          "'; the file is damaged, export it again");
      }
      this->Elements.back().Properties.push_back(property);
    }
    else
    {
      throw ModelError("its header has the wrong line '" + Printable(line.substr(0, 60)) +
        "'; the file is damaged or not a PLY");
    }
  }
  if (!hasFormat)
  {
    throw ModelError("its header has no known format; the file is damaged or not a PLY");
  }
  this->CheckElements();
  // A header may end its lines as Windows does.
  this->At = std::min(this->Bytes.find('\n', end), this->Bytes.size() - 1) + 1;
}

// What VTK's reader asks for without making sure that it is there.
void PLYCheck::CheckElements() const
{
  bool hasUnknown = false;
  for (const PLYElement& element : this->Elements)
  {
    const bool isVertex = element.Name == "vertex";
    const bool isFace = element.Name == "face";
    const bool isKnown = isVertex || isFace || element.Name == "tristrips";
    if (isKnown && hasUnknown)
    {
      throw ModelError("'" + element.Name +
        "' stands behind elements that VTK can not skip; export it "
        "with vertices and faces first");
    }
    hasUnknown = hasUnknown || !isKnown;
    const bool isComplete = isVertex
      ? element.Has("x", false) && element.Has("y", false) && element.Has("z", false)
      : !isKnown || element.Has("vertex_indices", true) || element.Has("vertex_index", true);
    if (element.Properties.empty() || !isComplete)
    {
      throw ModelError("its header lacks properties of '" + Printable(element.Name) +
        "' (x, y, z; the list vertex_indices); the file is damaged, export it again");
    }
  }
  if (this->GetCount("vertex") == 0 || this->GetCount("face") + this->GetCount("tristrips") == 0)
  {
    throw ModelError("there are no triangles in it (" + std::to_string(this->GetCount("vertex")) +
      " points); vtkNPR draws surfaces, so export one");
  }
}

// VTK's reader looks points up while it reads, whether they are there or not.
void PLYCheck::CheckIndex(const PLYElement& element, long long index) const
{
  const bool isEndOfStrip = element.Name == "tristrips" && index == -1;
  if (!isEndOfStrip && (index < 0 || index >= this->GetCount("vertex")))
  {
    throw ModelError("a face refers to point " + std::to_string(index) + ", but there are " +
      std::to_string(this->GetCount("vertex")) + " points; the file is damaged, export it again");
  }
}

void PLYCheck::AddWidePoint(const PLYElement& element)
{
  if (element.Name == "vertex" && element.IsWide())
  {
    this->WidePoints.push_back({ 0.0, 0.0, 0.0 });
  }
}

bool PLYCheck::SkipLine(const PLYElement& element)
{
  const std::size_t end = std::min(this->Bytes.find('\n', this->At), this->Bytes.size());
  if (this->At >= this->Bytes.size() || end - this->At > LongestLine)
  {
    return false;
  }
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
  this->AddWidePoint(element);
  for (const PLYProperty& property : element.Properties)
  {
    long long words = 1;
    if (property.CountSize > 0)
    {
      const char* word = nextWord();
      words = word ? std::strtoll(std::string(word, at).c_str(), nullptr, 10) : -1;
    }
    if (words < 0)
    {
      return false;
    }
    for (; words > 0; --words)
    {
      const char* word = nextWord();
      if (!word)
      {
        return false;
      }
      if (!this->WidePoints.empty() && element.Name == "vertex" && property.GetWideAxis() >= 0)
      {
        std::from_chars(word + (*word == '+' ? 1 : 0), at,
          this->WidePoints.back()[static_cast<std::size_t>(property.GetWideAxis())]);
      }
      if (property.IsIndices())
      {
        this->CheckIndex(element, std::strtoll(std::string(word, at).c_str(), nullptr, 10));
      }
    }
  }
  this->At = end + 1;
  return true;
}

// A whole number of up to four bytes.
long long PLYCheck::Decode(int size, bool isSigned)
{
  std::uint32_t value = 0;
  for (int i = 0; i < size; ++i)
  {
    const auto byte = static_cast<unsigned char>(this->Bytes[this->At++]);
    value |= std::uint32_t(byte) << (8 * (this->IsBigEndian ? size - 1 - i : i));
  }
  const bool isNegative = isSigned && ((value >> (8 * size - 1)) & 1u) != 0;
  return isNegative ? static_cast<long long>(value) - (1LL << (8 * size)) : value;
}

bool PLYCheck::SkipBinary(const PLYElement& element)
{
  const auto left = [this]() { return static_cast<long long>(this->Bytes.size() - this->At); };
  this->AddWidePoint(element);
  for (const PLYProperty& property : element.Properties)
  {
    if (property.CountSize > left() || property.CountSize > 4)
    {
      return false;
    }
    const long long items =
      property.CountSize > 0 ? this->Decode(property.CountSize, property.CountIsSigned) : 1;
    if (items < 0 || items * property.Size > left())
    {
      return false;
    }
    if (!this->WidePoints.empty() && element.Name == "vertex" && property.GetWideAxis() >= 0)
    {
      std::string bytes = this->Bytes.substr(this->At, 8);
      if (this->IsBigEndian)
      {
        std::reverse(bytes.begin(), bytes.end());
      }
      std::memcpy(&this->WidePoints.back()[static_cast<std::size_t>(property.GetWideAxis())],
        bytes.data(), 8);
    }
    if (!property.IsIndices())
    {
      this->At += static_cast<std::size_t>(items * property.Size);
      continue;
    }
    for (long long i = 0; i < items; ++i)
    {
      this->CheckIndex(element, this->Decode(property.Size, property.IsSigned));
    }
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
  if (NeedsDouble(check.GetWidePoints()))
  {
    vtkNew<vtkPoints> points; // VTK's reader makes floats of them
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(surface->GetNumberOfPoints());
    for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
    {
      points->SetPoint(i, check.GetWidePoints()[static_cast<std::size_t>(i)].data());
    }
    surface->SetPoints(points);
  }
  file.AddPart(surface);
}
}
