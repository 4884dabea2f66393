// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Wavefront OBJ with MTL. VTK's own reader is not taken: it wants an MTL file, cuts lines after
// 4096 characters, knows no negative indices and trusts indices that point outside of the file.
#include "nprFileFormats.h"

#include <vtkAlgorithm.h>
#include <vtkCellArray.h>
#include <vtkCommand.h>
#include <vtkEventForwarderCommand.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <map>
#include <string_view>

namespace npr
{
namespace
{
using Corner = std::array<vtkIdType, 3>; // point, texture coordinate, normal; -1: none

struct Material
{
  double Diffuse[3] = { 0.8, 0.8, 0.8 };
  double Specular[3] = { 0.0, 0.0, 0.0 };
  double Shininess = 0.0;
  double Opacity = 1.0;
  std::string Texture;
};

struct Group
{
  vtkNew<vtkCellArray> Polygons;
  std::vector<Corner> Corners; // of each point of the part
  std::map<Corner, vtkIdType> Points;
};

// The words of one line, cut off its front one by one.
class Words
{
public:
  explicit Words(std::string_view line) : Rest(line) {}
  std::string_view Next()
  {
    const auto first = this->Rest.find_first_not_of(" \t\r");
    if (first == std::string_view::npos)
    {
      this->Rest = {};
      return {};
    }
    this->Rest.remove_prefix(first);
    const auto end = std::min(this->Rest.find_first_of(" \t\r"), this->Rest.size());
    const std::string_view word = this->Rest.substr(0, end);
    this->Rest.remove_prefix(end);
    return word;
  }
  std::string_view All()
  {
    const auto first = this->Rest.find_first_not_of(" \t\r");
    const auto last = this->Rest.find_last_not_of(" \t\r");
    return first == std::string_view::npos ? std::string_view{}
                                           : this->Rest.substr(first, last - first + 1);
  }
  // Reads up to n numbers and returns how many there were; independent of the locale.
  template<typename T>
  int Numbers(T* values, int n)
  {
    int count = 0;
    for (; count < n; ++count)
    {
      std::string_view word = this->Next();
      if (!word.empty() && word.front() == '+')
      {
        word.remove_prefix(1);
      }
      const auto result = std::from_chars(word.data(), word.data() + word.size(), values[count]);
      if (word.empty() || result.ec == std::errc::invalid_argument)
      {
        break;
      }
      if (result.ec == std::errc::result_out_of_range)
      {
        values[count] = T(0); // the one likely case: a denormal
      }
    }
    return count;
  }

private:
  std::string_view Rest;
};

// Calls f(words, number of the line) for each line, joined where a backslash ends it.
template<typename Function>
void ForEachLine(const std::string& text, Function f)
{
  std::string joined;
  std::size_t number = 0;
  for (std::size_t begin = 0; begin < text.size();)
  {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    std::string_view line(text.data() + begin, end - begin);
    begin = end + 1;
    ++number;
    if (!line.empty() && line.back() == '\r')
    {
      line.remove_suffix(1);
    }
    if (!line.empty() && line.back() == '\\')
    {
      line.remove_suffix(1);
      joined.append(line).append(" ");
      continue;
    }
    if (joined.empty())
    {
      f(Words(line), number);
    }
    else
    {
      joined.append(line);
      f(Words(joined), number);
      joined.clear();
    }
  }
}

[[noreturn]] void Fail(std::size_t line, const std::string& what)
{
  throw ModelError("line " + std::to_string(line) + ": " + what);
}

class OBJParser
{
public:
  explicit OBJParser(ModelFile& file)
    : File(file), Folder(std::filesystem::path(file.Path).parent_path())
  {
  }

  void Parse();

private:
  void ParseFace(Words& words, std::size_t line);
  Corner ParseCorner(std::string_view word, std::size_t line) const;
  void ParseLibraries(Words& words);
  void ParseMaterials(const std::filesystem::path& path);
  void AddPart(const Group& group, const Material* material);

  ModelFile& File;
  std::filesystem::path Folder;
  std::vector<std::array<double, 3>> Points;
  std::vector<std::array<float, 2>> TextureCoordinates;
  std::vector<std::array<float, 3>> Normals;
  std::map<std::string, Material> Materials;
  bool HasLibrary = false; // one that could be read
  std::map<std::string, Group> Groups;
  int PointType = VTK_FLOAT;
  Group* Current = nullptr;
  std::vector<vtkIdType> Face;
};

void OBJParser::Parse()
{
  const std::string text = ReadBytes(this->File.Path);
  this->Current = &this->Groups[""];
  std::size_t lines = 0;
  ForEachLine(text,
    [&](Words words, std::size_t line)
    {
      const std::string_view keyword = words.Next();
      lines = line;
      if (keyword == "v" || keyword == "vn")
      {
        std::array<double, 3> value;
        if (words.Numbers(value.data(), 3) < 3)
        {
          Fail(line, "a point or normal needs three numbers; the file is damaged or not an OBJ");
        }
        if (keyword == "v")
        {
          this->Points.push_back(value);
        }
        else
        {
          this->Normals.push_back({ static_cast<float>(value[0]), static_cast<float>(value[1]),
            static_cast<float>(value[2]) });
        }
      }
      else if (keyword == "vt")
      {
        std::array<float, 2> value = { 0.0f, 0.0f };
        if (words.Numbers(value.data(), 2) < 1)
        {
          Fail(line, "a texture coordinate needs a number; the file is damaged");
        }
        this->TextureCoordinates.push_back(value);
      }
      else if (keyword == "f")
      {
        this->ParseFace(words, line);
      }
      else if (keyword == "usemtl")
      {
        this->Current = &this->Groups[std::string(words.All())];
      }
      else if (keyword == "mtllib")
      {
        this->ParseLibraries(words);
      }
    });
  this->PointType = NeedsDouble(this->Points) ? VTK_DOUBLE : VTK_FLOAT;
  for (const auto& [name, group] : this->Groups)
  {
    if (group.Polygons->GetNumberOfCells() > 0)
    {
      const auto material = this->Materials.find(name);
      if (material == this->Materials.end() && this->HasLibrary && !name.empty())
      {
        this->File.Warnings.push_back("The material '" + Printable(name) +
          "' is in none of its libraries; the surface gets a plain colour.");
      }
      this->AddPart(group, material == this->Materials.end() ? nullptr : &material->second);
    }
  }
}

Corner OBJParser::ParseCorner(std::string_view word, std::size_t line) const
{
  const std::array<std::size_t, 3> sizes = { this->Points.size(), this->TextureCoordinates.size(),
    this->Normals.size() };
  static constexpr const char* kinds[3] = { "point", "texture coordinate", "normal" };
  Corner corner = { -1, -1, -1 };
  for (int i = 0; i < 3 && !word.empty(); ++i)
  {
    const auto slash = std::min(word.find('/'), word.size());
    const std::string_view digits = word.substr(0, slash);
    word.remove_prefix(std::min(slash + 1, word.size()));
    if (digits.empty())
    {
      continue;
    }
    vtkIdType index = 0;
    const auto result = std::from_chars(digits.data(), digits.data() + digits.size(), index);
    const auto size = static_cast<vtkIdType>(sizes[i]);
    if (index < 0)
    {
      index += size + 1; // counted back from the latest
    }
    if (result.ec != std::errc() || index < 1 || index > size)
    {
      Fail(line,
        "a face refers to " + std::string(kinds[i]) + " '" +
          Printable(std::string(digits.substr(0, 20))) + "', but " + std::to_string(size) +
          " stand before it; the file is damaged, export it again");
    }
    corner[i] = index - 1;
  }
  return corner;
}

void OBJParser::ParseFace(Words& words, std::size_t line)
{
  this->Face.clear();
  for (std::string_view word = words.Next(); !word.empty() && word.front() != '#';
       word = words.Next())
  {
    const Corner corner = this->ParseCorner(word, line);
    if (corner[0] < 0)
    {
      Fail(line, "a face has a corner without a point; the file is damaged, export it again");
    }
    const auto [entry, isNew] = this->Current->Points.try_emplace(
      corner, static_cast<vtkIdType>(this->Current->Corners.size()));
    if (isNew)
    {
      this->Current->Corners.push_back(corner);
    }
    this->Face.push_back(entry->second);
  }
  if (this->Face.size() >= 3)
  {
    this->Current->Polygons->InsertNextCell(
      static_cast<vtkIdType>(this->Face.size()), this->Face.data());
  }
}

// One file whose name may have spaces, or several without.
void OBJParser::ParseLibraries(Words& words)
{
  std::vector<std::filesystem::path> paths = { this->Folder / std::string(words.All()) };
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(paths.front(), ignored))
  {
    paths.clear();
    for (std::string_view name = words.Next(); !name.empty(); name = words.Next())
    {
      paths.push_back(this->Folder / std::string(name));
    }
  }
  for (const std::filesystem::path& path : paths)
  {
    if (!std::filesystem::is_regular_file(path, ignored))
    {
      this->File.Warnings.push_back("The materials '" + Printable(path.string()) +
        "' are missing; the surface gets a plain colour.");
      continue;
    }
    try
    {
      this->ParseMaterials(path);
      this->HasLibrary = true;
    }
    catch (const ModelError& error) // the surface is good without them
    {
      this->File.Warnings.push_back(
        "The materials '" + Printable(path.string()) + "' are not used: " + error.what() + ".");
    }
  }
}

void OBJParser::ParseMaterials(const std::filesystem::path& path)
{
  Material unnamed;
  Material* material = &unnamed;
  ForEachLine(ReadBytes(path.string()),
    [&](Words words, std::size_t)
    {
      const std::string_view keyword = words.Next();
      double value = 0.0;
      if (keyword == "newmtl")
      {
        material = &this->Materials[std::string(words.All())];
      }
      else if (keyword == "Kd")
      {
        words.Numbers(material->Diffuse, 3);
      }
      else if (keyword == "Ks")
      {
        words.Numbers(material->Specular, 3);
      }
      else if (keyword == "Ns" && words.Numbers(&value, 1) == 1)
      {
        material->Shininess = value;
      }
      else if (keyword == "d" && words.Numbers(&value, 1) == 1)
      {
        material->Opacity = value;
      }
      else if (keyword == "Tr" && words.Numbers(&value, 1) == 1)
      {
        material->Opacity = 1.0 - value;
      }
      else if (keyword == "map_Kd")
      {
        // Options with their numbers stand first; a file's name without them may have spaces.
        std::string_view all = words.All();
        if (!all.empty() && all.front() == '-')
        {
          all.remove_prefix(all.find_last_of(" \t") + 1);
        }
        material->Texture = std::string(all);
        std::replace(material->Texture.begin(), material->Texture.end(), '\\', '/');
      }
    });
}

void OBJParser::AddPart(const Group& group, const Material* material)
{
  const auto count = static_cast<vtkIdType>(group.Corners.size());
  vtkNew<vtkPoints> points;
  points->SetDataType(this->PointType);
  points->SetNumberOfPoints(count);
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetName("TextureCoordinates");
  coordinates->SetNumberOfComponents(2);
  coordinates->SetNumberOfTuples(count);
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(count);
  bool hasCoordinates = count > 0;
  bool hasNormals = count > 0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    const Corner& corner = group.Corners[static_cast<std::size_t>(i)];
    points->SetPoint(i, this->Points[corner[0]].data());
    hasCoordinates = hasCoordinates && corner[1] >= 0;
    hasNormals = hasNormals && corner[2] >= 0;
    if (hasCoordinates)
    {
      coordinates->SetTypedTuple(i, this->TextureCoordinates[corner[1]].data());
    }
    if (hasNormals)
    {
      normals->SetTypedTuple(i, this->Normals[corner[2]].data());
    }
  }
  vtkNew<vtkPolyData> surface;
  surface->SetPoints(points);
  surface->SetPolys(group.Polygons);
  if (hasCoordinates)
  {
    surface->GetPointData()->SetTCoords(coordinates);
  }
  if (hasNormals)
  {
    surface->GetPointData()->SetNormals(normals);
  }
  this->File.AddPart(surface);
  if (!material)
  {
    return;
  }

  ModelPart& part = this->File.Parts.back();
  if (!material->Texture.empty() && hasCoordinates)
  {
    part.Texture = ReadTexture(this->File, (this->Folder / material->Texture).string());
  }
  double diffuse[3];
  std::copy_n(material->Diffuse, 3, diffuse);
  if (part.Texture && *std::max_element(diffuse, diffuse + 3) < 0.01)
  {
    std::fill_n(
      diffuse, 3, 1.0); // several programs write black beside a texture, which would hide it
  }
  part.Property = MakePlainProperty(diffuse, std::clamp(material->Opacity, 0.0, 1.0));
  if (material->Shininess > 0.0 &&
    *std::max_element(material->Specular, material->Specular + 3) > 0.0)
  {
    part.Property->SetSpecular(1.0);
    part.Property->SetSpecularColor(material->Specular);
    part.Property->SetSpecularPower(std::clamp(material->Shininess, 1.0, 128.0));
  }
}
}

void ReadOBJ(ModelFile& file)
{
  OBJParser(file).Parse();
}
}
