// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprStyleDocument.h"

#include "nprArrayNames.h"
#include "nprStyleSection.h"
#include "nprViewQuantities.h"

#include <vtkColor.h>
#include <vtkNamedColors.h>
#include <vtkNew.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>

namespace npr
{
namespace
{
using Json = StyleSection::Json;

/// The byte offset that the parser reports, as people count.
std::string PlaceOf(const std::string& text, std::size_t offset)
{
  const std::string before = text.substr(0, offset);
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::size_t start = before.rfind('\n');
  const std::size_t column = before.size() - (start == std::string::npos ? 0 : start + 1) + 1;
  return "line " + std::to_string(line) + ", column " + std::to_string(column);
}

/// The document, as long as no object in it has a key twice: one of the two values would be lost.
class UniqueKeysParser
{
public:
  Json Parse(const std::string& text)
  {
    return Json::parse(text,
      [this](int, Json::parse_event_t event, const Json& parsed)
      {
        this->Follow(event, parsed);
        return true;
      });
  }

private:
  /// An object or a list that the parser is in.
  struct Level
  {
    std::set<std::string> Keys;
    std::string Place; ///< The key of the value that comes, or the index of the last one.
    int Items = 0;
    bool IsList = false;
  };

  void Follow(Json::parse_event_t event, const Json& parsed)
  {
    using Event = Json::parse_event_t;
    const bool begins = event == Event::object_start || event == Event::array_start;
    if ((begins || event == Event::value) && !this->Levels.empty() && this->Levels.back().IsList)
    {
      this->Levels.back().Place = std::to_string(this->Levels.back().Items++);
    }
    if (begins)
    {
      this->Levels.emplace_back();
      this->Levels.back().IsList = event == Event::array_start;
    }
    else if (event == Event::object_end || event == Event::array_end)
    {
      this->Levels.pop_back();
    }
    else if (event == Event::key)
    {
      this->Levels.back().Place = parsed.get<std::string>();
      if (!this->Levels.back().Keys.insert(this->Levels.back().Place).second)
      {
        throw StyleError(this->GetPath() + " is given twice; leave out one of them");
      }
    }
  }

  std::string GetPath() const
  {
    std::string path;
    for (const Level& level : this->Levels)
    {
      path += "/" + level.Place;
    }
    return path;
  }

  std::vector<Level> Levels;
};

void ReadBackground(StyleSection& root, StyleDocument& style)
{
  const Json* background = root.Find("background");
  if (background && background->is_object())
  {
    StyleSection section(*background, "/background");
    section.Read("bottom", style.BackgroundBottom);
    section.Read("top", style.BackgroundTop);
    section.Finish();
  }
  else if (background)
  {
    style.BackgroundBottom = style.BackgroundTop = root.ToColor("background", *background);
  }
}

std::vector<TermStyle> ReadTerms(
  StyleSection& section, const std::string& key, double most, std::vector<TermStyle> terms)
{
  if (section.Find(key))
  {
    terms.clear();
  }
  for (StyleSection& item : section.List(key))
  {
    TermStyle term;
    int array = -1;
    item.Read("by", array, TermStyle::GetArrays());
    if (array < 0)
    {
      item.Fail("by", "is missing: name an array of lines, such as \"ViewDistance\"");
    }
    term.Array = TermStyle::GetArrays()[array];
    item.Read("range", term.Range, -1.0e9, 1.0e9);
    item.Read("factors", term.Factors, 0.0, most);
    item.Read("smooth", term.Smooth);
    item.Finish();
    terms.push_back(term);
  }
  return terms;
}

void ReadStrokeStyle(StyleSection& section, StrokeStyle& stroke)
{
  section.Read("cap", stroke.Cap, { "round", "butt" });
  section.Read("join", stroke.Join, { "round", "bevel", "mitre" });
  section.Read("mitre_limit", stroke.MitreLimit, 1.0, 100.0);
  section.Read("dashes", stroke.Dashes, 0.0, 1000.0);
  section.Read("hidden_opacity", stroke.HiddenOpacity, 0.0, 1.0);
  section.Read("hidden_dashes", stroke.HiddenDashes, 0.0, 1000.0);
  section.Read("medium", stroke.Medium, { "ink", "pencil", "charcoal", "brush" });
  section.Read("grain", stroke.Grain, 0.0, 1.0);
  section.Read("grain_size", stroke.GrainSize, 0.1, 100.0);
  section.Read("taper_length", stroke.TaperLength, 0.0, 1000.0);
  section.Read("taper_width", stroke.TaperedWidth, 0.0, 1.0);
  section.Read("taper_opacity", stroke.TaperedOpacity, 0.0, 1.0);
  section.Read("width_limit", stroke.WidthLimit, 0.0, 1.0);
  section.Read("overshoot", stroke.Overshoot, 0.0, 1000.0);
  section.Read("wobble", stroke.Wobble, 0.0, 100.0);
  section.Read("wobble_length", stroke.WobbleLength, 1.0, 10000.0);
  section.Read("bend_reach", stroke.BendReach, 0.1, 1000.0);
  section.Read("isophote_level", stroke.IsophoteLevel, -1.0, 1.0);
  section.Read("seed", stroke.Seed, 0, 1000000);
  stroke.WidthBy = ReadTerms(section, "width_by", 100.0, std::move(stroke.WidthBy));
  stroke.OpacityBy = ReadTerms(section, "opacity_by", 1.0, std::move(stroke.OpacityBy));
}

ShadingStyle ReadShading(StyleSection section)
{
  ShadingStyle shading;
  section.Read("style", shading.Style);
  section.Read("color", shading.Surface);
  section.Read("ambient", shading.Ambient, 0.0, 1.0);
  section.Read("diffuse", shading.Diffuse, 0.0, 1.0);
  section.Read("specular", shading.Specular, 0.0, 1.0);
  section.Read("specular_power", shading.SpecularPower, 0.0, 1000.0);
  shading.StyleParameters = section.ReadOthers();
  shading.CommonKeys = section.DescribeKeys();
  return shading;
}

LightStyle ReadLight(StyleSection section)
{
  LightStyle light;
  section.Read("azimuth", light.Azimuth, -360.0, 360.0);
  section.Read("elevation", light.Elevation, -90.0, 90.0);
  section.Read("intensity", light.Intensity, 0.0, 10.0);
  section.Read("color", light.Tint);
  section.Finish();
  return light;
}

GeometryStyle ReadGeometry(StyleSection section)
{
  GeometryStyle geometry;
  section.Read("crease_angle", geometry.CreaseAngle, 0.0, 180.0);
  section.Read("smoothing", geometry.Smoothing, 0.0, 100.0);
  section.Read("refinement", geometry.Refinement, 0.0, 1000.0);
  section.Read("estimator", geometry.Estimator);
  section.Finish();
  return geometry;
}

OutlineStyle ReadOutline(StyleSection section)
{
  OutlineStyle outline;
  section.Read("kind", outline.Kind, OutlineStyle::GetKindNames());
  section.Read("width", outline.Width, 0.01, 100.0);
  section.Read("color", outline.Ink);
  section.Read("grazing_threshold", outline.GrazingThreshold, 0.0, 1.0);
  section.Read("grazing_softness", outline.GrazingSoftness, 0.0, 1.0);
  section.Read("depth_threshold", outline.DepthThreshold, 1.0e-4, 1.0);
  section.Read("normal_threshold", outline.NormalThreshold, 1.0, 180.0);
  section.Read("object_edges", outline.ObjectEdges);
  section.Finish();
  return outline;
}

LineStyle ReadLine(StyleSection section, const StrokeStyle& strokes)
{
  LineStyle line;
  line.Stroke = strokes;
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
  ReadStrokeStyle(section, line.Stroke);
  section.Read("minimum_length", line.MinimumLength, 0.0, 1000.0);
  section.Read("optional", line.Optional);
  line.DefinitionParameters = section.ReadOthers();
  line.CommonKeys = section.DescribeKeys();
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
const std::vector<std::string>& TermStyle::GetArrays()
{
  static const std::vector<std::string> arrays = []()
  {
    std::vector<std::string> all{ names::Strength, names::ViewDistance, names::ArcLength,
      names::CurveCurvature, names::Shade, names::IsophoteDistance };
    for (const ViewQuantity& quantity : GetViewQuantities())
    {
      if (quantity.Components == 1)
      {
        all.emplace_back(quantity.Name);
      }
    }
    return all;
  }();
  return arrays;
}

//------------------------------------------------------------------------------
const std::vector<std::string>& OutlineStyle::GetKindNames()
{
  static const std::vector<std::string> names{ "none", "back-faces", "grazing", "image-edges" };
  return names;
}

//------------------------------------------------------------------------------
bool StrokeStyle::NeedsAttributes() const
{
  return this->TaperLength > 0.0 || this->WidthLimit > 0.0 || this->Overshoot > 0.0 ||
    this->Wobble > 0.0 || !this->WidthBy.empty() || !this->OpacityBy.empty();
}

//------------------------------------------------------------------------------
std::vector<std::string> StrokeStyle::GetQuantities() const
{
  std::vector<std::string> quantities;
  for (const auto* terms : { &this->WidthBy, &this->OpacityBy })
  {
    for (const TermStyle& term : *terms)
    {
      if (FindViewQuantity(term.Array))
      {
        quantities.push_back(term.Array);
      }
      else if (term.Array == names::IsophoteDistance)
      {
        quantities.emplace_back(names::RadialCurvature);
      }
    }
  }
  return quantities;
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
    parsed = UniqueKeysParser().Parse(json);
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
  StyleSection root(parsed, "");
  root.Read("name", style.Name);
  root.Read("description", style.Description);
  ReadBackground(root, style);
  if (const Json* shading = root.Find("shading"))
  {
    style.Shading = ReadShading(StyleSection(*shading, "/shading"));
  }
  for (const StyleSection& light : root.List("lights"))
  {
    style.Lights.push_back(ReadLight(light));
  }
  if (const Json* geometry = root.Find("geometry"))
  {
    style.Geometry = ReadGeometry(StyleSection(*geometry, "/geometry"));
  }
  if (const Json* outline = root.Find("outline"))
  {
    style.Outline = ReadOutline(StyleSection(*outline, "/outline"));
  }
  StrokeStyle strokes;
  if (const Json* common = root.Find("strokes"))
  {
    StyleSection section(*common, "/strokes");
    ReadStrokeStyle(section, strokes);
    section.Finish();
  }
  for (const StyleSection& line : root.List("lines"))
  {
    style.Lines.push_back(ReadLine(line, strokes));
  }
  root.Finish();
  return style;
}
}
