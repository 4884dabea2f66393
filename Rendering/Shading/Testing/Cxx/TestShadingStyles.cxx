// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The list of styles, and their parameters by name.

#include "nprShadingTest.h"

#include "vtkNPRGoochStyle.h"
#include "vtkNPRShadingStyles.h"
#include "vtkNPRToonStyle.h"

#include <vtkDoubleArray.h>
#include <vtkSmartPointer.h>

#include <limits>

using namespace npr::testing;

int TestShadingStyles(int argc, char* argv[])
{
  Checker check(argc, argv);
  std::set<std::string> names;
  for (int i = 0; i < vtkNPRShadingStyles::GetNumberOfStyles(); ++i)
  {
    const std::string name = vtkNPRShadingStyles::GetStyleName(i);
    names.insert(name);
    check(std::strlen(vtkNPRShadingStyles::GetStyleDescription(i)) > 10, name + ": no description");
    auto style = vtk::TakeSmartPointer(vtkNPRShadingStyles::CreateStyle(name));
    check(style != nullptr, name + ": not created");
    if (!style)
    {
      continue;
    }
    check(style->GetCode().find("vec3 nprShade(NprSurface s)") != std::string::npos,
      name + ": no nprShade");
    // Every parameter takes back its own value and the ends of its range, and nothing outside it.
    for (int p = 0; p < style->GetNumberOfParameters(); ++p)
    {
      const std::string parameter = style->GetParameterName(p);
      const std::vector<double> values = style->GetParameter(parameter);
      double range[2];
      style->GetParameterRange(p, range);
      const int size = style->GetParameterSize(p);
      check(size == 0 || values.size() == static_cast<size_t>(size), parameter + ": wrong size");
      check(std::strlen(style->GetParameterDescription(p)) > 5, parameter + ": no description");
      for (double value : range)
      {
        const std::vector<double> ends(values.size(), value);
        check(style->SetParameter(parameter, ends), parameter + ": an end of its range is refused");
        check(style->GetParameter(parameter) == ends || size == 0,
          parameter + ": an end of its range did not arrive");
      }
      check(style->SetParameter(parameter, values), parameter + ": its own value is refused");
      check(style->GetParameter(parameter) == values, parameter + ": its own value changed");
      for (double bad : { range[0] - 1.0, range[1] + 1.0, std::nan("") })
      {
        check(!style->SetParameter(parameter, std::vector<double>(values.size(), bad)),
          parameter + ": a bad value is taken");
      }
      check(size == 0 || !style->SetParameter(parameter, std::vector<double>(values.size() + 1)),
        parameter + ": one value too many is taken");
      check(style->GetParameter(parameter) == values, parameter + ": a refused value changed it");
    }
    for (int bad : { -1, style->GetNumberOfParameters() })
    {
      double range[2] = { 7.0, 9.0 };
      style->GetParameterRange(bad, range);
      check(!style->GetParameterName(bad) && !style->GetParameterDescription(bad) &&
          style->GetParameterSize(bad) == 0 && range[0] == 7.0 && range[1] == 9.0,
        name + ": has a parameter of an index out of range");
    }
    check(!style->SetParameter(nullptr, 0, nullptr), name + ": takes a parameter without a name");
    check(!style->SetParameter("no_such_parameter", { 1.0 }), name + ": takes unknown parameters");
  }
  check(names.count("phong") && names.count("toon") && names.count("gooch"), "a style is missing");
  check(names.size() == static_cast<size_t>(vtkNPRShadingStyles::GetNumberOfStyles()),
    "two styles of one name");
  check(vtkNPRShadingStyles::CreateStyle("no such style") == nullptr, "a style out of nothing");
  check(vtkNPRShadingStyles::GetStyleName(-1) == nullptr, "a name out of range");

  // Defaults of the definitions.
  vtkNew<vtkNPRGoochStyle> gooch;
  check(
    gooch->GetParameter("cool_color") == std::vector<double>({ 0.0, 0.0, 0.55 }), "cool colour");
  check(gooch->GetParameter("warm_color") == std::vector<double>({ 0.3, 0.3, 0.0 }), "warm colour");
  check(gooch->GetAlpha() == 0.25 && gooch->GetBeta() == 0.5, "alpha, beta");

  // A ramp that can not be one is refused, and a changed one counts as a change.
  vtkNew<vtkNPRToonStyle> toon;
  vtkNew<MessageCatcher> messages;
  messages->Watch(toon);
  vtkNew<vtkDoubleArray> ramp;
  ramp->SetNumberOfComponents(2);
  ramp->InsertNextTuple2(0.0, 1.0);
  toon->SetDiffuseRamp(ramp);
  check(messages->Errors.size() == 1 && !toon->GetDiffuseRamp(), "a two-component ramp is taken");
  const int most = vtkNPRShadingStyle::MaximumSize;
  check(toon->SetParameter("diffuse_ramp", std::vector<double>(most, 0.5)) &&
      toon->GetParameter("diffuse_ramp").size() == static_cast<size_t>(most),
    "the longest ramp is refused");
  check(!toon->SetParameter("diffuse_ramp", std::vector<double>(most + 1, 0.25)) &&
      toon->GetParameter("diffuse_ramp")[0] == 0.5 && messages->Errors.size() == 1,
    "a ramp that is too long is said to be taken");
  vtkNew<vtkDoubleArray> levels;
  levels->InsertNextValue(0.5);
  toon->SetDiffuseRamp(levels);
  const vtkMTimeType before = toon->GetMTime();
  levels->SetValue(0, 0.6);
  levels->Modified();
  check(toon->GetMTime() > before, "a changed ramp is not noticed");
  return check.Result();
}
