// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Style documents: the built-in ones load; what is wrong in one is refused, named, and changes
// nothing.
#include "vtkNPRIllustrationStyle.h"

#include <vtkCommand.h>
#include <vtkNew.h>
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
  CheckRefused(R"({"lines": [{"type": "creases", "angle": 270}]})", "/lines/0/angle");
  return Good ? EXIT_SUCCESS : EXIT_FAILURE;
}
