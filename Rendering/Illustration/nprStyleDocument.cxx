// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprStyleDocument.h"

#include <vtkColor.h>
#include <vtkNamedColors.h>
#include <vtkNew.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <set>

namespace npr
{
namespace
{
using Json = nlohmann::json;

/// The byte offset that the parser reports, as people count.
std::string PlaceOf(const std::string& text, std::size_t offset)
{
  const std::string before = text.substr(0, offset);
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::size_t start = before.rfind('\n');
  const std::size_t column = before.size() - (start == std::string::npos ? 0 : start + 1) + 1;
  return "line " + std::to_string(line) + ", column " + std::to_string(column);
}

/// One object of the document. Remembers which keys were asked for, so that Finish() can refuse
/// the others: a misspelt key must not be ignored.
class Section
{
public:
  Section(const Json& object, std::string path) : Object(object), Path(std::move(path))
  {
    if (!object.is_object())
    {
      throw StyleError((this->Path.empty() ? "the style" : this->Path) + " must be an object { }");
    }
  }

  [[noreturn]] void Fail(const std::string& key, const std::string& what) const
  {
    throw StyleError(this->Path + "/" + key + " " + what);
  }

  const Json* Find(const std::string& key)
  {
    this->Known.insert(key);
    const auto found = this->Object.find(key);
    return found == this->Object.end() ? nullptr : &*found;
  }

  void Read(const std::string& key, std::string& value)
  {
    if (const Json* json = this->Find(key))
    {
      if (!json->is_string())
      {
        this->Fail(key, "must be a string");
      }
      value = json->get<std::string>();
    }
  }

  void Read(const std::string& key, bool& value)
  {
    if (const Json* json = this->Find(key))
    {
      if (!json->is_boolean())
      {
        this->Fail(key, "must be true or false");
      }
      value = json->get<bool>();
    }
  }

  void Read(const std::string& key, double& value, double low, double high)
  {
    if (const Json* json = this->Find(key))
    {
      const double number = json->is_number() ? json->get<double>() : std::nan("");
      if (!(number >= low && number <= high))
      {
        this->Fail(key, "must be a number from " + Text(low) + " to " + Text(high));
      }
      value = number;
    }
  }

  void Read(const std::string& key, int& value, int low, int high)
  {
    double number = value;
    this->Read(key, number, double(low), double(high));
    if (number != std::floor(number))
    {
      this->Fail(key, "must be a whole number");
    }
    value = static_cast<int>(number);
  }

  void Read(const std::string& key, Color& value)
  {
    if (const Json* json = this->Find(key))
    {
      value = this->ToColor(key, *json);
    }
  }

  Color ToColor(const std::string& key, const Json& json) const
  {
    if (json.is_string())
    {
      try
      {
        return ParseColor(json.get<std::string>());
      }
      catch (const StyleError& error)
      {
        this->Fail(key, std::string("is not a colour: ") + error.what());
      }
    }
    const std::vector<double> numbers = this->ToNumbers(key, json);
    if (numbers.size() != 3 ||
      std::any_of(numbers.begin(), numbers.end(), [](double v) { return v < 0.0 || v > 1.0; }))
    {
      this->Fail(key, "must be a colour: \"#rrggbb\", a name, or three numbers from 0 to 1");
    }
    return { numbers[0], numbers[1], numbers[2] };
  }

  /// All keys that nobody asked for, as parameters for the object that the section describes.
  Parameters ReadOthers()
  {
    Parameters others;
    for (const auto& [key, json] : this->Object.items())
    {
      if (this->Known.count(key) == 0)
      {
        if (json.is_string())
        {
          others[key] = json.get<std::string>();
        }
        else
        {
          others[key] = this->ToNumbers(key, json);
        }
      }
    }
    return others;
  }

  void Finish() const
  {
    for (const auto& item : this->Object.items())
    {
      if (this->Known.count(item.key()) == 0)
      {
        std::string known;
        for (const std::string& name : this->Known)
        {
          known += (known.empty() ? "" : ", ") + name;
        }
        this->Fail(item.key(), "is not known; the keys here are: " + known);
      }
    }
  }

  /// The sections of the list under a key; empty when there is none.
  std::vector<Section> List(const std::string& key)
  {
    std::vector<Section> sections;
    if (const Json* list = this->Find(key))
    {
      if (!list->is_array())
      {
        this->Fail(key, "must be a list [ ]");
      }
      for (std::size_t i = 0; i < list->size(); ++i)
      {
        sections.emplace_back((*list)[i], this->Path + "/" + key + "/" + std::to_string(i));
      }
    }
    return sections;
  }

private:
  static std::string Text(double value)
  {
    std::string text = std::to_string(value);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.')
    {
      text.pop_back();
    }
    return text;
  }

  std::vector<double> ToNumbers(const std::string& key, const Json& json) const
  {
    std::vector<double> numbers;
    const auto add = [&](const Json& item)
    {
      if (!item.is_number() && !item.is_boolean())
      {
        this->Fail(key, "must be a number, true or false, a text, or a list of numbers");
      }
      numbers.push_back(item.is_boolean() ? double(item.get<bool>()) : item.get<double>());
    };
    if (json.is_array())
    {
      std::for_each(json.begin(), json.end(), add);
    }
    else
    {
      add(json);
    }
    return numbers;
  }

  const Json& Object;
  std::string Path;
  std::set<std::string> Known;
};

void ReadBackground(Section& root, StyleDocument& style)
{
  const Json* background = root.Find("background");
  if (background && background->is_object())
  {
    Section section(*background, "/background");
    section.Read("bottom", style.BackgroundBottom);
    section.Read("top", style.BackgroundTop);
    section.Finish();
  }
  else if (background)
  {
    style.BackgroundBottom = style.BackgroundTop = root.ToColor("background", *background);
  }
}

ShadingStyle ReadShading(Section section)
{
  ShadingStyle shading;
  section.Read("style", shading.Style);
  section.Read("color", shading.Surface);
  section.Read("ambient", shading.Ambient, 0.0, 1.0);
  section.Read("diffuse", shading.Diffuse, 0.0, 1.0);
  section.Read("specular", shading.Specular, 0.0, 1.0);
  section.Read("specular_power", shading.SpecularPower, 0.0, 1000.0);
  shading.StyleParameters = section.ReadOthers();
  return shading;
}

LightStyle ReadLight(Section section)
{
  LightStyle light;
  section.Read("azimuth", light.Azimuth, -360.0, 360.0);
  section.Read("elevation", light.Elevation, -90.0, 90.0);
  section.Read("intensity", light.Intensity, 0.0, 10.0);
  section.Read("color", light.Tint);
  section.Finish();
  return light;
}

GeometryStyle ReadGeometry(Section section)
{
  GeometryStyle geometry;
  section.Read("crease_angle", geometry.CreaseAngle, 0.0, 180.0);
  section.Read("smoothing", geometry.Smoothing, 0.0, 100.0);
  section.Read("refinement", geometry.Refinement, 0.0, 1000.0);
  section.Read("estimator", geometry.Estimator);
  section.Finish();
  return geometry;
}

LineStyle ReadLine(Section section)
{
  LineStyle line;
  section.Read("type", line.Type);
  if (line.Type.empty())
  {
    section.Fail("type", "is missing: name the kind of line, such as \"contours\"");
  }
  section.Read("width", line.Width, 0.01, 1000.0);
  section.Read("color", line.Ink);
  section.Read("opacity", line.Opacity, 0.0, 1.0);
  section.Read("spline", line.Spline);
  if (line.Spline != "catmull-rom" && line.Spline != "b-spline" && line.Spline != "none")
  {
    section.Fail("spline", "must be \"catmull-rom\", \"b-spline\" or \"none\"");
  }
  section.Read("smoothing", line.Smoothing, 0, 1000);
  section.Read("taper", line.Taper);
  const Json* fade = section.Find("fade");
  if (!fade || !fade->is_number())
  {
    section.Read("fade", line.Fade);
  }
  section.Read("minimum_length", line.MinimumLength, 0.0, 1000.0);
  section.Read("optional", line.Optional);
  line.DefinitionParameters = section.ReadOthers();
  if (fade && fade->is_number())
  {
    line.DefinitionParameters["fade"] = std::vector<double>{ fade->get<double>() };
  }
  return line;
}
}

//------------------------------------------------------------------------------
Color ParseColor(const std::string& text)
{
  vtkNew<vtkNamedColors> colors;
  const bool isCode = !text.empty() && text[0] == '#' && (text.size() == 4 || text.size() == 7) &&
    text.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
  if (!isCode && !colors->ColorExists(text))
  {
    throw StyleError("'" + text + "' (write #rrggbb or an HTML colour name such as white)");
  }
  const vtkColor3ub color = isCode ? colors->HTMLColorToRGB(text) : colors->GetColor3ub(text);
  return { color[0] / 255.0, color[1] / 255.0, color[2] / 255.0 };
}

//------------------------------------------------------------------------------
bool IsCalled(const LineStyle& line, const std::string& name)
{
  const auto found = line.DefinitionParameters.find("name");
  const auto* text =
    found == line.DefinitionParameters.end() ? nullptr : std::get_if<std::string>(&found->second);
  return line.Type == name || (text && *text == name);
}

//------------------------------------------------------------------------------
StyleDocument ParseStyle(const std::string& json)
{
  Json parsed;
  try
  {
    parsed = Json::parse(json);
  }
  catch (const Json::parse_error& error)
  {
    throw StyleError("not valid JSON at " + PlaceOf(json, error.byte == 0 ? 0 : error.byte - 1));
  }
  catch (const Json::exception& error)
  {
    throw StyleError(std::string("not valid JSON: ") + error.what());
  }

  StyleDocument style;
  Section root(parsed, "");
  root.Read("name", style.Name);
  root.Read("description", style.Description);
  ReadBackground(root, style);
  if (const Json* shading = root.Find("shading"))
  {
    style.Shading = ReadShading(Section(*shading, "/shading"));
  }
  for (const Section& light : root.List("lights"))
  {
    style.Lights.push_back(ReadLight(light));
  }
  if (const Json* geometry = root.Find("geometry"))
  {
    style.Geometry = ReadGeometry(Section(*geometry, "/geometry"));
  }
  for (const Section& line : root.List("lines"))
  {
    style.Lines.push_back(ReadLine(line));
  }
  root.Finish();
  return style;
}
}
