// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRIllustrationStyle.h"

#include "nprBuiltInStyles.h"
#include "nprDrawingInks.h"
#include "nprStyleDocument.h"
#include "nprStyleObjects.h"
#include "vtkNPRFeatureLines.h"

#include <vtkNew.h>
#include <vtkObjectFactory.h>

#include <algorithm>
#include <fstream>
#include <sstream>

vtkStandardNewMacro(vtkNPRIllustrationStyle);

//------------------------------------------------------------------------------
vtkNPRIllustrationStyle::vtkNPRIllustrationStyle()
  : Document(std::make_unique<npr::StyleDocument>())
{
  this->LoadBuiltIn("technical");
}

vtkNPRIllustrationStyle::~vtkNPRIllustrationStyle() = default;

//------------------------------------------------------------------------------
std::vector<std::string> vtkNPRIllustrationStyle::GetBuiltInNames()
{
  std::vector<std::string> names;
  for (const npr::BuiltInStyle& style : npr::GetBuiltInStyles())
  {
    names.emplace_back(style.Name);
  }
  return names;
}

//------------------------------------------------------------------------------
std::string vtkNPRIllustrationStyle::GetBuiltInJson(const std::string& name)
{
  for (const npr::BuiltInStyle& style : npr::GetBuiltInStyles())
  {
    if (name == style.Name)
    {
      return style.Json;
    }
  }
  return {};
}

//------------------------------------------------------------------------------
bool vtkNPRIllustrationStyle::Fail(const std::string& message)
{
  this->ErrorMessage = message;
  vtkErrorMacro(<< message);
  return false;
}

//------------------------------------------------------------------------------
bool vtkNPRIllustrationStyle::LoadDocument(const std::string& json, const std::string& origin)
{
  try
  {
    npr::StyleDocument document = npr::ParseStyle(json);
    npr::CheckStyleNames(document);
    *this->Document = std::move(document);
  }
  catch (const npr::StyleError& error)
  {
    return this->Fail(origin + ": " + error.what());
  }
  this->ErrorMessage.clear();
  this->Modified();
  return true;
}

//------------------------------------------------------------------------------
bool vtkNPRIllustrationStyle::LoadBuiltIn(const std::string& name)
{
  const std::string json = GetBuiltInJson(name);
  if (!json.empty())
  {
    return this->LoadDocument(json, "built-in style " + name);
  }
  std::string names;
  for (const std::string& known : GetBuiltInNames())
  {
    names += (names.empty() ? "" : ", ") + known;
  }
  return this->Fail("unknown style '" + name + "'; the built-in styles are: " + names +
    " (or give the path of a style file)");
}

//------------------------------------------------------------------------------
bool vtkNPRIllustrationStyle::LoadFile(const std::string& fileName)
{
  std::ifstream file(fileName);
  std::stringstream text;
  if (!(file && text << file.rdbuf()))
  {
    return this->Fail(fileName +
      ": cannot read this style file; check that it exists, is not "
      "empty and may be read");
  }
  return this->LoadDocument(text.str(), fileName);
}

//------------------------------------------------------------------------------
bool vtkNPRIllustrationStyle::LoadString(const std::string& json)
{
  return this->LoadDocument(json, "style");
}

//------------------------------------------------------------------------------
bool vtkNPRIllustrationStyle::Load(const std::string& nameOrFile)
{
  const bool isPath = nameOrFile.find_first_of("./\\") != std::string::npos;
  return isPath ? this->LoadFile(nameOrFile) : this->LoadBuiltIn(nameOrFile);
}

//------------------------------------------------------------------------------
// How lines of a kind are drawn. @throws StyleError when there is no such kind.
npr::LineStyle vtkNPRIllustrationStyle::MakeLine(const std::string& type) const
{
  const std::vector<npr::LineStyle>& all = this->Document->Lines;
  const auto found = std::find_if(
    all.begin(), all.end(), [&](const npr::LineStyle& line) { return npr::IsCalled(line, type); });
  npr::LineStyle line;
  if (found != all.end())
  {
    line = *found;
  }
  else
  {
    line.Type = type;
    const bool isCurved = npr::NeedsCurvature(line, "lines");
    const auto alike = std::find_if(all.begin(), all.end(),
      [&](const npr::LineStyle& other) { return npr::NeedsCurvature(other, "lines") == isCurved; });
    if (!all.empty())
    {
      line = alike == all.end() ? all.front() : *alike;
      line.DefinitionParameters.clear();
      line.Type = type;
    }
  }
  line.Optional = false;
  npr::MakeLineDefinition(line, "lines");
  return line;
}

//------------------------------------------------------------------------------
bool vtkNPRIllustrationStyle::SelectLines(const std::vector<std::string>& types)
{
  std::vector<npr::LineStyle> selected;
  try
  {
    for (const std::string& type : types)
    {
      selected.push_back(this->MakeLine(type));
    }
  }
  catch (const npr::StyleError& error)
  {
    return this->Fail(error.what());
  }
  this->Document->Lines = std::move(selected);
  this->ErrorMessage.clear();
  this->Modified();
  return true;
}

//------------------------------------------------------------------------------
bool vtkNPRIllustrationStyle::AddLines(const std::vector<std::string>& types)
{
  std::vector<npr::LineStyle> lines = this->Document->Lines;
  try
  {
    for (const std::string& type : types)
    {
      const bool isDrawn = std::any_of(lines.begin(), lines.end(),
        [&](const npr::LineStyle& line) { return !line.Optional && npr::IsCalled(line, type); });
      if (!isDrawn)
      {
        lines.push_back(this->MakeLine(type));
      }
    }
  }
  catch (const npr::StyleError& error)
  {
    return this->Fail(error.what());
  }
  this->Document->Lines = std::move(lines);
  this->ErrorMessage.clear();
  this->Modified();
  return true;
}

//------------------------------------------------------------------------------
bool vtkNPRIllustrationStyle::AddQuantity(const std::string& name)
{
  vtkNew<vtkNPRFeatureLines> lines;
  lines->AddQuantity(name.c_str());
  if (lines->GetNumberOfQuantities() == 0)
  {
    return this->Fail("lines can not carry a quantity \"" + name +
      "\": they have an array of this name of their own");
  }
  this->Document->Quantities.push_back(name);
  this->ErrorMessage.clear();
  this->Modified();
  return true;
}

//------------------------------------------------------------------------------
bool vtkNPRIllustrationStyle::UsesLineDefault(
  const std::string& type, const std::string& parameter) const
{
  const std::vector<npr::LineStyle>& lines = this->Document->Lines;
  return std::any_of(lines.begin(), lines.end(),
    [&](const npr::LineStyle& line)
    {
      return !line.Optional && npr::IsCalled(line, type) &&
        line.DefinitionParameters.count(parameter) == 0;
    });
}

//------------------------------------------------------------------------------
bool vtkNPRIllustrationStyle::SetLineParameter(
  const std::string& type, const std::string& parameter, const std::string& value)
{
  std::vector<npr::LineStyle> lines = this->Document->Lines;
  std::string drawn;
  bool found = false;
  try
  {
    for (npr::LineStyle& line : lines)
    {
      if (!line.Optional)
      {
        drawn += (drawn.empty() ? "" : ", ") + line.Type;
        if (npr::IsCalled(line, type))
        {
          found = true;
          line.DefinitionParameters[parameter] = npr::ParseLineParameter(line, parameter, value);
          // What all lines have is of the drawing, and can not be set here.
          npr::LineStyle own = line;
          own.CommonKeys.clear();
          npr::MakeLineDefinition(own, type);
        }
      }
    }
  }
  catch (const npr::StyleError& error)
  {
    return this->Fail(error.what());
  }
  if (!found)
  {
    return this->Fail("no lines '" + type +
      "' are drawn, of which a parameter could be set; there are: " +
      (drawn.empty() ? "none" : drawn));
  }
  this->Document->Lines = std::move(lines);
  this->ErrorMessage.clear();
  this->Modified();
  return true;
}

//------------------------------------------------------------------------------
void vtkNPRIllustrationStyle::SetOutline(int kind)
{
  kind = std::clamp(kind, int(NoOutline), int(ImageEdges));
  if (this->Document->Outline.Kind != kind)
  {
    this->Document->Outline.Kind = kind;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkNPRIllustrationStyle::GetOutline() const
{
  return this->Document->Outline.Kind;
}

//------------------------------------------------------------------------------
std::vector<std::string> vtkNPRIllustrationStyle::GetOutlineNames()
{
  return npr::OutlineStyle::GetKindNames();
}

//------------------------------------------------------------------------------
bool vtkNPRIllustrationStyle::SetBackground(const std::string& color)
{
  try
  {
    this->Document->BackgroundBottom = this->Document->BackgroundTop = npr::ParseColor(color);
  }
  catch (const npr::StyleError& error)
  {
    return this->Fail(std::string("unknown colour ") + error.what());
  }
  this->ErrorMessage.clear();
  this->Modified();
  return true;
}

//------------------------------------------------------------------------------
void vtkNPRIllustrationStyle::GetDrawingStyle(vtkNPRDrawingStyle* inks, double shorterSide) const
{
  npr::SetInks(*this->Document, 0.001 * shorterSide, inks);
}

bool vtkNPRIllustrationStyle::HasShading() const
{
  return !npr::IsPaper(this->Document->Shading);
}

//------------------------------------------------------------------------------
std::string vtkNPRIllustrationStyle::GetName() const
{
  return this->Document->Name;
}

//------------------------------------------------------------------------------
std::string vtkNPRIllustrationStyle::GetDescription() const
{
  return this->Document->Description;
}

//------------------------------------------------------------------------------
void vtkNPRIllustrationStyle::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Name: " << this->Document->Name << "\n";
  os << indent << "Description: " << this->Document->Description << "\n";
  os << indent << "Shading: " << this->Document->Shading.Style << "\n";
  os << indent << "Outline: " << GetOutlineNames()[this->Document->Outline.Kind] << "\n";
  os << indent << "Lines: " << this->Document->Lines.size() << "\n";
  os << indent << "ErrorMessage: " << this->ErrorMessage << "\n";
}
