// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Style documents: the built-in ones load; what is wrong in one is refused, named, and changes
// nothing.
#include "nprTestScene.h"
#include "vtkNPRExpressionLines.h"
#include "vtkNPRIllustrationStyle.h"

#include <vtkCamera.h>
#include <vtkCell.h>
#include <vtkCommand.h>
#include <vtkElevationFilter.h>
#include <vtkFieldData.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSphereSource.h>
#include <vtkStringArray.h>
#include <vtkTestErrorObserver.h>

#include <cstdlib>
#include <iostream>

namespace
{
bool Good = true;

void Check(bool condition, const std::string& what)
{
  if (!condition)
  {
    std::cerr << "FAILED: " << what << "\n";
    Good = false;
  }
}

void CheckRefused(const std::string& json, const std::string& mentioned)
{
  vtkNew<vtkNPRIllustrationStyle> style;
  vtkNew<vtkTest::ErrorObserver> observer;
  style->AddObserver(vtkCommand::ErrorEvent, observer);
  style->LoadBuiltIn("ink");
  Check(!style->LoadString(json), "accepted: " + json);
  Check(observer->GetError(), "no error event for " + json);
  Check(style->GetErrorMessage().find(mentioned) != std::string::npos,
    "'" + mentioned + "' is not in: " + style->GetErrorMessage());
  Check(style->GetName() == "ink", "a refused document changed the style: " + json);
}

// Parameters arrive at the lines: how many levels there are, and of what.
void CheckLineParameters()
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(40);
  sphere->SetPhiResolution(40);
  vtkNew<vtkElevationFilter> elevation; // from 0 at the bottom to 1 at the top
  elevation->SetInputConnection(sphere->GetOutputPort());
  elevation->SetLowPoint(0.0, 0.0, -0.5);
  elevation->SetHighPoint(0.0, 0.0, 0.5);
  npr::TestScene scene(elevation->GetOutputPort());
  vtkNew<vtkPolyData> lines;
  const auto extract = [&]() -> vtkIdType
  {
    scene.Illustration->Apply();
    lines->Initialize();
    scene.Illustration->GetLines(lines);
    return lines->GetNumberOfLines();
  };
  scene.Style->LoadString(R"({"shading": {"style": "paper"}, "geometry": {"refinement": 0},
    "lines": [{"type": "isolines", "array": "Elevation", "values": [0.3, 0.52, 7]}]})");
  Check(extract() == 2, "the levels of a list");
  Check(scene.Style->SelectLines({ "topographic" }), "select height lines");
  Check(scene.Style->SetLineParameter("topographic", "levels", "5"), "a number by its name");
  Check(scene.Style->SetLineParameter("topographic", "direction", "0,2,0"), "three by theirs");
  Check(extract() == 5, "a number of levels");
  double bounds[6];
  lines->GetCell(0)->GetBounds(bounds);
  Check(bounds[3] - bounds[2] < 1.0e-6, "in the given direction");
  Check(scene.Style->SelectLines({ "isolines" }), "select lines of an array");
  Check(scene.Style->SetLineParameter("isolines", "array", "Elevation") &&
      scene.Style->SetLineParameter("isolines", "values", "0.25,0.5,0.75"),
    "a text and a list by their names");
  Check(extract() == 3, "the levels of that list");

  vtkNew<vtkTest::ErrorObserver> observer;
  scene.Style->AddObserver(vtkCommand::ErrorEvent, observer);
  const auto refuses = [&](const char* type, const char* name, const char* value, const char* what)
  {
    Check(!scene.Style->SetLineParameter(type, name, value), std::string("accepted: ") + value);
    Check(scene.Style->GetErrorMessage().find(what) != std::string::npos,
      "'" + std::string(what) + "' is not in: " + scene.Style->GetErrorMessage());
  };
  refuses("contours", "levels", "5", "isolines");
  refuses("isolines", "level", "5", "isolines/level is not known");
  refuses("isolines", "levels", "5,6", "isolines/levels must be one number");
  refuses("isolines", "levels", "5;6", "isolines/levels must be a number");
  refuses("isolines", "levels", "", "isolines/levels must be a number");
  refuses("isolines", "levels", "0", "isolines/levels is out of range");
  Check(extract() == 3, "what was refused changed nothing");
}

// Lines from formulas, in a style and beside it.
void CheckDefinedLines()
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(40);
  sphere->SetPhiResolution(40);
  npr::TestScene scene(sphere->GetOutputPort());
  vtkNew<vtkTest::ErrorObserver> observer;
  scene.Style->AddObserver(vtkCommand::ErrorEvent, observer);
  const auto names = [&]() -> std::string
  {
    scene.Illustration->Apply();
    vtkNew<vtkPolyData> lines;
    scene.Illustration->GetLines(lines);
    auto array =
      vtkStringArray::SafeDownCast(lines->GetFieldData()->GetAbstractArray("LineTypeNames"));
    std::string all;
    for (vtkIdType i = 0; array && i < array->GetNumberOfValues(); ++i)
    {
      all += array->GetValue(i) + " ";
    }
    return lines->GetNumberOfLines() > 0 ? all : "no lines";
  };
  Check(scene.Style->LoadString(R"json({"lines": [{"type": "contours"}, {"type": "expression",
    "name": "waves", "field": "sin(w * py)", "test": "ndotv > 0 and abs(nx) < 0.9", "fade": 0.25,
    "levels": [-0.5, 0.5], "constants": "w = 40", "optional": true}]})json"),
    "lines from a formula in a style");
  Check(names() == "contours ", "optional as others are, not " + names());
  Check(scene.Style->SelectLines({ "waves", "contours" }), "selected by their name");
  Check(names() == "waves contours ", "in the order asked for, not " + names());

  vtkNew<vtkNPRExpressionLines> slices;
  slices->SetName("slices");
  slices->SetField("px");
  Check(!scene.Style->AddLines({ "slices" }), "not known yet");
  Check(vtkNPRLineDefinition::AddKind(slices), "now it is");
  Check(scene.Style->AddLines({ "slices", "waves" }), "added");
  Check(names() == "waves contours slices ", "once each, not " + names());
  Check(scene.Style->LoadString(R"({"lines": [{"type": "slices", "levels": [0.1]}]})"),
    "an added kind in a style");
  Check(names() == "slices ", "drawn, not " + names());
  vtkNPRLineDefinition::RemoveKind("slices");
}

// What strokes say reaches the picture, for all lines or for one.
void CheckStrokes()
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(40);
  sphere->SetPhiResolution(40);
  npr::TestScene scene(sphere->GetOutputPort());
  scene.Renderer->ResetCamera();
  const auto count = [&](const std::string& keys, const std::string& common)
  {
    const bool loaded = scene.Style->LoadString(R"({"shading": {"style": "paper"}, "strokes": {)" +
      common + R"(}, "lines": [{"type": "contours", "width": 20)" + keys + "}]}");
    Check(loaded, "strokes: " + keys + " " + common);
    scene.Illustration->Apply();
    return npr::CountDarkPixels(scene.Render(), 128);
  };
  const int all = count("", "");
  Check(all > 1000, "a thick outline");
  const auto isHalf = [all](int pixels) { return std::abs(2 * pixels - all) < 0.1 * all; };
  Check(isHalf(count(R"(, "dashes": [30, 30], "cap": "butt")", "")), "dashes of a line");
  Check(isHalf(count("", R"("dashes": [30, 30], "cap": "butt")")), "dashes of all lines");
  Check(std::abs(count(R"(, "dashes": [0, 0])", R"("dashes": [30, 30], "cap": "butt")") - all) <
      0.02 * all,
    "a line's own word is the last");
  Check(isHalf(
          count("", R"("width_by": [{"by": "Strength", "range": [0, 0.5], "factors": [1, 0.5]}])")),
    "widths by an array");
  // The light comes from above on the left, and so the outline is thicker below on the right.
  const int shaded = count("",
    R"("width_by": [{"by": "Shade", "range": [-0.2, 0.2], "factors": [1, 0], "smooth": true}])");
  Check(isHalf(shaded),
    "widths by the light: " + std::to_string(shaded) + " of " + std::to_string(all));
  // Of the contour, what the light (35 degrees to the left, 40 up) leaves darker than the level.
  // The contour's normals lean towards the eye.
  const double lean = std::asin(0.5 / scene.Renderer->GetActiveCamera()->GetDistance());
  const double light[2] = { 0.7788, 0.6275 }; // across the line of sight, and along
  const double cosine = (0.5 + light[1] * std::sin(lean)) / (light[0] * std::cos(lean));
  const int dark = count("", R"("isophote_level": -0.5, "bend_reach": 1,
    "width_by": [{"by": "IsophoteDistance", "range": [0, 0.1], "factors": [0, 1]}])");
  Check(std::abs(dark - std::acos(cosine) / vtkMath::Pi() * all) < 0.02 * all,
    "widths by the distance to an isophote: " + std::to_string(dark) + " of " +
      std::to_string(all));
  // The Gaussian curvature of a sphere, whose length scale is its radius, is 1.
  Check(isHalf(count("", R"("width_by": [{"by": "K", "range": [0.5, 1.5], "factors": [0, 1]}])")),
    "widths by the curvature of the surface");
  Check(count("", R"("medium": "pencil", "grain": 1, "grain_size": 3)") < 0.97 * all, "a medium");
  Check(count("", R"("wobble": 3, "wobble_length": 50, "seed": 3)") > 0.8 * all, "a wobble");
}

}

int TestIllustrationStyle(int, char*[])
{
  Check(vtkNPRIllustrationStyle::GetBuiltInNames().size() >= 4, "built-in styles");
  for (const std::string& name : vtkNPRIllustrationStyle::GetBuiltInNames())
  {
    vtkNew<vtkNPRIllustrationStyle> style;
    Check(style->Load(name) && style->GetName() == name, "built-in style " + name);
    Check(!style->GetDescription().empty(), "description of " + name);
    vtkNew<vtkNPRIllustrationStyle> copy;
    Check(copy->LoadString(vtkNPRIllustrationStyle::GetBuiltInJson(name)), "its document " + name);
  }

  vtkNew<vtkNPRIllustrationStyle> style;
  Check(style->LoadString(R"({"name": "mine", "background": {"top": "white", "bottom": [0.5, 0, 1]},
    "shading": {"style": "gooch", "alpha": 0.3, "cool_color": "#000080"}, "lines": []})"),
    "a good document");
  Check(style->SelectLines({ "contours", "creases" }), "select lines");
  Check(style->SetBackground("tomato"), "an HTML colour");

  Check(style->LoadString(R"({"lines": [{"type": "isolines", "array": "red", "values": [1, 2.5]},
    {"type": "isolines", "array": "12", "values": [], "component": 2},
    {"type": "topographic", "direction": [0, 1, 0], "levels": 7}]})"),
    "texts, lists and vectors as parameters of lines");
  CheckLineParameters();
  CheckDefinedLines();
  CheckStrokes();

  CheckRefused("", "line 1, column 1");
  CheckRefused("{\n\"name\": 1,\n]", "line 3, column 1");
  CheckRefused("[]", "object");
  CheckRefused(R"({"lines": [{"type": "contours", "width": 1e999}]})", "JSON");
  CheckRefused(R"({"lines": [{"type": "contours", "smoothing": 2.5}]})", "/lines/0/smoothing");
  CheckRefused(R"({"name": 3})", "/name");
  CheckRefused(R"({"nmae": "x"})", "/nmae");
  CheckRefused(R"({"background": "whyte"})", "/background");
  CheckRefused(R"({"background": [0, 0, 2]})", "/background");
  CheckRefused(R"({"background": {"left": "white"}})", "/background/left");
  CheckRefused(R"({"shading": {"style": "velvet"}})", "velvet");
  CheckRefused(R"({"shading": {"style": "gooch", "alhpa": 0.3}})", "/shading/alhpa");
  CheckRefused(R"({"shading": {"style": "gooch", "alpha": "much"}})", "/shading/alpha");
  CheckRefused(R"({"shading": {"style": "paper", "alpha": 1}})", "/shading/alpha");
  CheckRefused(R"({"shading": {"style": "gooch", "alhpa": "red"}})", "/shading/alhpa is not known");
  CheckRefused(R"({"shading": {"style": "gooch", "cool_color": "blu"}})",
    "/shading/cool_color is not a colour");
  CheckRefused(R"({"shading": {"style": "gooch", "cool_color": [1, 0]}})",
    "/shading/cool_color must be a list of 3 numbers");
  CheckRefused(R"({"shading": {"style": "gooch", "alpha": 7}})", "/shading/alpha is out of range");
  CheckRefused(R"({"lights": [{"elevation": 100}]})", "/lights/0/elevation");
  CheckRefused(R"({"lights": {}})", "/lights");
  CheckRefused(R"({"geometry": {"crease_angle": -1}})", "/geometry/crease_angle");
  CheckRefused(R"({"lines": [{"type": "ridges", "optional": 1}]})", "/lines/0/optional");
  CheckRefused(R"({"geometry": {"estimator": "guess"}})", "per-face");
  CheckRefused(R"({"geometry": {"estimator": 1}})", "/geometry/estimator");
  CheckRefused(R"({"lines": [{"width": 1}]})", "/lines/0/type");
  CheckRefused(R"({"lines": [{"type": "contours"}, {"type": "hair"}]})", "/lines/1");
  CheckRefused(R"({"lines": [{"type": "contours", "width": 0}]})", "/lines/0/width");
  CheckRefused(R"({"lines": [{"type": "contours", "spline": "bezier"}]})", "/lines/0/spline");
  CheckRefused(R"({"lines": [{"type": "contours", "taper": 1}]})", "/lines/0/taper");
  CheckRefused(R"({"lines": [{"type": "contours", "fade": 1}]})", "/lines/0/fade");
  CheckRefused(R"({"lines": [{"type": "contours", "fade": "yes"}]})", "/lines/0/fade");
  CheckRefused(R"({"lines": [{"type": "expression", "field": "kr", "fade": 0}]})",
    "/lines/0/fade is out of range");
  CheckRefused(R"({"lines": [{"type": "expression"}]})", "/lines/0: they have no field");
  CheckRefused(R"({"lines": [{"type": "expression", "field": "kr *"}]})", "column 5");
  CheckRefused(
    R"({"lines": [{"type": "creases", "angle": 270}]})", "/lines/0/angle is out of range");
  CheckRefused(
    R"({"lines": [{"type": "creases", "angle": "red"}]})", "/lines/0/angle must be a number");
  CheckRefused(
    R"({"lines": [{"type": "creases", "angle": [30, 40]}]})", "/lines/0/angle must be one number");
  CheckRefused(R"({"lines": [{"type": "creases", "angle": {}}]})", "/lines/0/angle");
  CheckRefused(R"({"lines": [{"type": "isolines", "array": 3}]})", "/lines/0/array must be a text");
  CheckRefused(R"({"lines": [{"type": "isolines", "array": ["a"]}]})", "/lines/0/array");
  CheckRefused(R"({"lines": [{"type": "isolines", "values": "a"}]})",
    "/lines/0/values must be a list of numbers");
  CheckRefused(R"({"lines": [{"type": "topographic", "direction": [0, 1]}]})",
    "/lines/0/direction must be a list of 3 numbers");
  CheckRefused(
    R"({"lines": [{"type": "creases", "angel": "red"}]})", "/lines/0/angel is not known");
  CheckRefused(R"({"strokes": 1})", "/strokes must be an object");
  CheckRefused(R"({"strokes": {"width": 2}})", "/strokes/width is not known");
  CheckRefused(R"({"strokes": {"cap": "square"}})", "/strokes/cap must be \"round\" or \"butt\"");
  CheckRefused(R"({"strokes": {"join": 2}})", "/strokes/join");
  CheckRefused(R"({"strokes": {"mitre_limit": 0}})", "/strokes/mitre_limit");
  CheckRefused(R"({"strokes": {"dashes": 3}})", "/strokes/dashes must be a list of two numbers");
  CheckRefused(R"({"strokes": {"dashes": [3, -1]}})", "/strokes/dashes");
  CheckRefused(R"({"strokes": {"medium": "oil"}})", "\"charcoal\" or \"brush\"");
  CheckRefused(R"({"strokes": {"grain": 2}})", "/strokes/grain");
  CheckRefused(R"({"strokes": {"wobble": "much"}})", "/strokes/wobble");
  CheckRefused(R"({"strokes": {"width_by": {"by": "Shade"}}})", "/strokes/width_by must be a list");
  CheckRefused(R"({"strokes": {"width_by": [{"factors": [1, 2]}]}})", "/width_by/0/by is missing");
  CheckRefused(R"({"strokes": {"width_by": [{"by": "Heat"}]}})", "/strokes/width_by/0/by must be");
  CheckRefused(R"({"strokes": {"opacity_by": [{"by": "Strength", "factors": [0, 2]}]}})",
    "/strokes/opacity_by/0/factors");
  CheckRefused(R"({"strokes": {"opacity_by": [{"by": "Strength", "from": 2}]}})",
    "/strokes/opacity_by/0/from is not known");
  CheckRefused(R"({"lines": [{"type": "contours", "taper_length": -1}]})", "/lines/0/taper_length");
  CheckRefused(R"({"lines": [{"type": "contours", "overshoot": []}]})", "/lines/0/overshoot");
  CheckRefused(R"({"outline": "grazing"})", "/outline must be an object");
  CheckRefused(
    R"({"outline": {"kind": "halo"}})", "/outline/kind must be \"none\", \"back-faces\"");
  CheckRefused(R"({"outline": {"type": "grazing"}})", "/outline/type is not known");
  CheckRefused(R"({"outline": {"width": 0}})", "/outline/width");
  CheckRefused(R"({"outline": {"color": "inky"}})", "/outline/color");
  CheckRefused(R"({"outline": {"grazing_threshold": 1.5}})", "/outline/grazing_threshold");
  CheckRefused(R"({"outline": {"grazing_softness": -1}})", "/outline/grazing_softness");
  CheckRefused(R"({"outline": {"depth_threshold": 0}})", "/outline/depth_threshold");
  CheckRefused(R"({"outline": {"normal_threshold": 270}})", "/outline/normal_threshold");
  CheckRefused(R"({"outline": {"object_edges": 1}})", "/outline/object_edges");
  return Good ? EXIT_SUCCESS : EXIT_FAILURE;
}
