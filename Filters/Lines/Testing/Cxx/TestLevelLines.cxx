// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Height lines and lines of a point array: how many there are, where, and what they say of
// themselves.
#include "nprTrueCurves.h"

#include "vtkNPRIsoLines.h"
#include "vtkNPRTopographicLines.h"

#include <vtkMath.h>

using namespace nprtest;

namespace
{
struct Lines
{
  std::vector<Chain> Chains;
  std::vector<double> Levels;
  std::string Error;
};

Lines Extract(vtkPolyData* surface, vtkNPRLineDefinition* definition)
{
  vtkNew<vtkNPRFeatureLines> lines;
  lines->AddDefinition(definition);
  lines->SetInputData(surface);
  const std::string errors = GetErrors(lines);
  Lines result = { GetChains(lines->GetOutput()), {}, errors };
  for (std::size_t i = 0; i < result.Chains.size(); ++i)
  {
    result.Levels.push_back(lines->GetOutput()
                              ->GetCellData()
                              ->GetArray(npr::names::LineLevel)
                              ->GetTuple1(static_cast<vtkIdType>(i)));
  }
  return result;
}

void CheckError(
  vtkPolyData* surface, vtkNPRLineDefinition* definition, const std::string& text, Checks& check)
{
  const Lines lines = Extract(surface, definition);
  check(lines.Chains.empty(), "no lines after an error");
  check(lines.Error.find(text) != std::string::npos, "'" + text + "' is not in: " + lines.Error);
}

vtkSmartPointer<vtkPolyData> MakeExactTorus(const Vector3d& centre)
{
  const AnalyticSurface torus = MakeTorus(1.0, 0.4, 90, 60);
  AddExactArrays(torus, { 1.0, Eigen::Matrix3d::Identity(), centre });
  return torus.Mesh;
}

void CheckHeights(const Lines& lines, const Vector3d& direction, double error, Checks& check)
{
  for (std::size_t i = 0; i < lines.Chains.size(); ++i)
  {
    for (const Vector3d& p : lines.Chains[i].Points)
    {
      check(std::abs(p.dot(direction) - lines.Levels[i]) < error, "at the height it says",
        p.dot(direction) - lines.Levels[i]);
    }
  }
}

void TestHeights(Checks& check)
{
  // Far away, too: 1e6 times the size of the surface.
  for (const Vector3d& centre : { Vector3d(0.0, 0.0, 0.1), Vector3d(1.0e6, -2.0e6, 3.0e6 + 0.1) })
  {
    const auto torus = MakeExactTorus(centre);
    vtkNew<vtkNPRTopographicLines> heights;
    Lines lines = Extract(torus, heights);
    check(
      lines.Chains.size() == 40, "two circles at each of 20 levels", double(lines.Chains.size()));
    for (std::size_t i = 0; i < lines.Chains.size(); ++i)
    {
      check(lines.Chains[i].Closed, "height lines of a closed surface are closed");
      const double level = (lines.Levels[i] - centre[2] + 0.4) / 0.8 * 20.0 - 0.5;
      check(std::abs(level - std::round(level)) < 1.0e-4, "in the middles of equal parts", level);
    }
    CheckHeights(lines, Vector3d::UnitZ(), 1.0e-6, check);
    CheckSound(lines.Chains, check);

    heights->SetSpacing(0.25);
    lines = Extract(torus, heights);
    check(lines.Chains.size() == 6, "two circles at each of three multiples",
      double(lines.Chains.size()));
    for (const double level : lines.Levels)
    {
      check(std::abs(level / 0.25 - std::round(level / 0.25)) < 1.0e-6, "multiples in the model",
        level);
    }
    CheckHeights(lines, Vector3d::UnitZ(), 1.0e-6, check);

    heights->SetSpacing(0.0);
    heights->SetLevels(7.0);
    check(heights->SetParameter("direction", { 0.0, 3.0, 4.0 }), "a direction");
    lines = Extract(torus, heights);
    check(lines.Chains.size() > 7, "levels in that direction");
    CheckHeights(lines, { 0.0, 0.6, 0.8 }, 2.0e-6, check);
  }
  const auto torus = MakeExactTorus(Vector3d::Zero());
  vtkNew<vtkNPRTopographicLines> heights;
  heights->SetDirection(0.0, 0.0, 0.0);
  CheckError(torus, heights, "must not be 0 0 0", check);
  heights->SetDirection(0.0, 0.0, 1.0);
  heights->SetSpacing(1.0e-9);
  CheckError(torus, heights, "make it larger", check);
  // The top and the bottom touch multiples, and are no lines.
  heights->SetSpacing(0.4);
  check(Extract(torus, heights).Chains.size() == 2, "none touches the extremes");
}

void TestUnusedPoints(Checks& check)
{
  const auto torus = MakeExactTorus(Vector3d::Zero());
  vtkNew<vtkPolyData> surface;
  vtkNew<vtkPoints> points;
  points->DeepCopy(torus->GetPoints());
  points->InsertNextPoint(0.0, 0.0, 100.0);
  surface->SetPoints(points);
  surface->SetPolys(torus->GetPolys());
  vtkNew<vtkNPRTopographicLines> heights;
  const Lines lines = Extract(surface, heights);
  check(lines.Chains.size() == 40, "a point that no triangle has doesn't count",
    double(lines.Chains.size()));
}

void TestHeightConvergence(Checks& check)
{
  vtkNew<vtkNPRTopographicLines> heights;
  heights->SetDirection(1.0, 0.0, 2.0);
  heights->SetSpacing(10.0);
  const Vector3d unit = Vector3d(1.0, 0.0, 2.0).normalized();
  CheckConvergence(
    heights, { Waves(), [&](const Truth& t) { return t.Point.dot(unit); } }, 1, check);
}

void TestArrays(Checks& check)
{
  const auto torus = MakeExactTorus(Vector3d::Zero());
  vtkNew<vtkFloatArray> values;
  values->SetName("velocity");
  values->SetNumberOfComponents(3);
  vtkNew<vtkFloatArray> holes;
  holes->SetName("with holes");
  for (vtkIdType i = 0; i < torus->GetNumberOfPoints(); ++i)
  {
    double p[3];
    torus->GetPoint(i, p);
    values->InsertNextTuple3(p[0], p[1], 5.0 + p[2]);
    const std::array<double, 3> noNumbers = { vtkMath::Nan(), vtkMath::Inf(), -vtkMath::Inf() };
    holes->InsertNextValue(static_cast<float>(p[0] > 1.0 ? noNumbers[i % 3] : p[2]));
  }
  torus->GetPointData()->AddArray(values);
  torus->GetPointData()->AddArray(holes);

  vtkNew<vtkNPRIsoLines> lines;
  CheckError(torus, lines, "isolines.array=NAME", check);
  // Ours, such as Normals, are not offered.
  CheckError(torus, lines, "its point arrays are: velocity, with holes", check);
  lines->SetArray("speed");
  CheckError(torus, lines, "none named \"speed\"", check);
  lines->SetArray("velocity");
  lines->SetComponent(3.0);
  CheckError(torus, lines, "from -1 to 2", check);

  lines->SetComponent(2.0);
  Lines made = Extract(torus, lines);
  check(made.Chains.size() == 20, "two circles at each of 10 levels", double(made.Chains.size()));
  for (double& level : made.Levels)
  {
    level -= 5.0;
  }
  CheckHeights(made, Vector3d::UnitZ(), 1.0e-6, check);

  check(lines->SetParameter("values", { 5.2, 4.9, 5.2, 77.0 }), "levels one by one");
  made = Extract(torus, lines);
  check(made.Chains.size() == 4 && std::abs(made.Levels[0] - 4.9) < 1.0e-6 &&
      std::abs(made.Levels[3] - 5.2) < 1.0e-6,
    "each once, in their order", double(made.Chains.size()));

  lines->SetValues({});
  lines->SetSpacing(0.3);
  check(Extract(torus, lines).Chains.size() == 4, "4.8 and 5.1");

  lines->SetComponent(-1.0);
  lines->SetSpacing(0.0);
  made = Extract(torus, lines);
  check(!made.Chains.empty(), "the magnitude");
  for (std::size_t i = 0; i < made.Chains.size(); ++i)
  {
    for (const Vector3d& p : made.Chains[i].Points)
    {
      const double magnitude = Vector3d(p[0], p[1], 5.0 + p[2]).norm();
      check(std::abs(magnitude - made.Levels[i]) < 2.0e-3, "is that of the vector", magnitude);
    }
  }

  lines->SetArray("with holes");
  for (const double component : { -1.0, 0.0 })
  {
    lines->SetComponent(component);
    made = Extract(torus, lines);
    check(made.Chains.size() == 20, "values that are no numbers do not count",
      double(made.Chains.size()));
    for (const Chain& chain : made.Chains)
    {
      for (const Vector3d& p : chain.Points)
      {
        check(p.allFinite() && p[0] < 1.01, "no line where there is no number", p[0]);
      }
    }
  }
}
}

int TestLevelLines(int, char*[])
{
  Checks check;
  TestHeights(check);
  TestUnusedPoints(check);
  TestHeightConvergence(check);
  TestArrays(check);
  return check.GetResult();
}
