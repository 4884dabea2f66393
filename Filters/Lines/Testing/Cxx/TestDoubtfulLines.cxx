// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Lines that go by derivatives of curvature end where these are in doubt, however they are defined
// and looked for; other lines do not. So parts with fillets have no zigzags on their flat faces.
#include "nprFilletBox.h"
#include "nprLineTesting.h"
#include "nprRibs.h"

#include "vtkNPRCurvatureTensor.h"
#include "vtkNPRExpressionLines.h"
#include "vtkNPRSurfacePreparation.h"
#include "vtkNPRSurfaceRefinement.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>

using namespace nprtest;

namespace
{
vtkSmartPointer<vtkPolyData> AddCurvature(vtkPolyData* mesh)
{
  vtkNew<vtkNPRCurvatureTensor> tensor;
  tensor->SetEstimatorToPerFace();
  tensor->SetInputData(mesh);
  tensor->Update();
  return tensor->GetOutput();
}

vtkSmartPointer<vtkPolyData> GetLines(vtkNPRFeatureLines* filter)
{
  filter->Update();
  auto lines = vtkSmartPointer<vtkPolyData>::New();
  lines->DeepCopy(filter->GetOutput());
  return lines;
}

bool AreSame(vtkPolyData* a, vtkPolyData* b)
{
  const std::vector<Chain> chains = GetChains(a);
  const std::vector<Chain> others = GetChains(b);
  bool same = chains.size() == others.size();
  for (std::size_t i = 0; same && i < chains.size(); ++i)
  {
    same = chains[i].Points == others[i].Points && chains[i].Strength == others[i].Strength;
  }
  return same;
}

const std::vector<Vector> Eyes = { { 4.0, 3.0, 2.0 }, { -5.0, 1.0, 2.0 }, { 1.0, -5.0, -3.0 } };

// Kinds that go by the size of derivatives, and a user's field without a test.
void TestPart(
  vtkPolyData* mesh, const std::string& name, const std::vector<const char*>& kinds, Checks& check)
{
  const auto box = AddCurvature(mesh);
  for (const char* kind : kinds)
  {
    vtkNew<vtkNPRFeatureLines> filter;
    filter->SetInputData(box);
    if (std::string(kind) == "expression")
    {
      vtkNew<vtkNPRExpressionLines> lines;
      lines->SetField("dwkr");
      filter->AddDefinition(lines);
    }
    else
    {
      filter->AddDefinition(kind);
    }
    std::size_t kept = 0;
    for (const Vector& eye : Eyes)
    {
      filter->SetCamera(MakeCamera(eye, false));
      filter->KeepDoubtfulOff();
      check(GetChains(GetLines(filter)).empty(), std::string(kind) + " of " + name);
      filter->KeepDoubtfulOn();
      kept += GetChains(GetLines(filter)).size();
    }
    check(kept > 0, std::string(kind) + " where doubtful lines are kept");
  }
  // Maxima of curvature, and what needs none.
  for (const char* kind : { "ridges", "valleys", "apparent-ridges", "contours" })
  {
    vtkNew<vtkNPRFeatureLines> filter;
    filter->SetInputData(box);
    filter->AddDefinition(kind);
    filter->SetCamera(MakeCamera(Eyes[0], false));
    const auto lines = GetLines(filter);
    check(!GetChains(lines).empty(), std::string(kind) + " of " + name);
    filter->KeepDoubtfulOn();
    check(AreSame(lines, GetLines(filter)), std::string(kind) + " are beyond doubt");
  }
}

// A file of facets with coordinates in single precision, far from the origin.
vtkSmartPointer<vtkPolyData> MakeFacets(vtkPolyData* mesh)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToFloat();
  vtkNew<vtkCellArray> triangles;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    mesh->GetCellPoints(cell, size, corners);
    triangles->InsertNextCell(3);
    for (int i = 0; i < 3; ++i)
    {
      double point[3];
      mesh->GetPoint(corners[i], point);
      triangles->InsertCellPoint(
        points->InsertNextPoint(point[0] + 30.0, point[1] - 20.0, point[2] + 10.0));
    }
  }
  auto facets = vtkSmartPointer<vtkPolyData>::New();
  facets->SetPoints(points);
  facets->SetPolys(triangles);
  return facets;
}

// As drawings are made of such a file.
vtkSmartPointer<vtkPolyData> Prepare(vtkPolyData* facets, int estimator)
{
  vtkNew<vtkNPRSurfacePreparation> preparation;
  preparation->SetInputData(facets);
  vtkNew<vtkNPRCurvatureTensor> tensor;
  tensor->SetEstimator(estimator);
  tensor->SetInputConnection(preparation->GetOutputPort());
  vtkNew<vtkNPRSurfaceRefinement> refinement;
  refinement->SetInputConnection(tensor->GetOutputPort());
  refinement->Update();
  return refinement->GetOutput();
}

// Where faces are flat no curvature changes its sign, whatever the points at their rims say; where
// a surface is round the lines stay, to the last bit of their length.
void TestParts(Checks& check)
{
  for (const double radius : { 0.02, 0.05, 0.1 })
  {
    const auto part = Prepare(MakeFacets(MakeFilletBox(radius)), vtkNPRCurvatureTensor::PER_FACE);
    for (const char* kind : { "parabolic", "mean-curvature" })
    {
      vtkNew<vtkNPRFeatureLines> filter;
      filter->SetInputData(part);
      filter->AddDefinition(kind);
      const std::size_t size = GetChains(GetLines(filter)).size();
      check(size == 0, std::string(kind) + " of a part with fillets", static_cast<double>(size));
    }
  }
  const auto torus =
    Prepare(MakeFacets(Torus{ 1.0, 0.7 }.Make(120, 60)), vtkNPRCurvatureTensor::JETS);
  for (const char* kind : { "parabolic", "mean-curvature" })
  {
    vtkNew<vtkNPRFeatureLines> filter;
    filter->SetInputData(torus);
    filter->AddDefinition(kind);
    const auto lines = GetLines(filter);
    check(GetChains(lines).size() == 2, std::string(kind) + ": the two circles of a torus");
    filter->KeepDoubtfulOn();
    check(AreSame(lines, GetLines(filter)), std::string(kind) + " of a torus are beyond doubt");
  }
}

// Half of a torus in doubt, growing along x.
vtkSmartPointer<vtkPolyData> MakeDoubtfulTorus()
{
  auto torus = Torus().Make(120, 60);
  auto doubts = AddArray(torus, npr::names::DerivativeDoubt, 1);
  for (vtkIdType i = 0; i < torus->GetNumberOfPoints(); ++i)
  {
    doubts->SetTuple1(i, torus->GetPoint(i)[0] + 1.0);
  }
  return torus;
}

void TestHalf(Checks& check)
{
  const auto torus = MakeDoubtfulTorus();
  vtkNew<vtkNPRFeatureLines> filter;
  filter->SetInputData(torus);
  filter->AddDefinition("suggestive")->SetParameter("threshold", 0.3);
  filter->SetLengthScale(1.0);
  filter->SetCamera(MakeCamera({ 1.0, 5.0, 2.0 }, false));
  const auto lines = GetLines(filter);
  const auto chains = GetChains(lines);
  check(!chains.empty(), "lines where there is no doubt");
  CheckSound(chains, check);
  for (const Chain& chain : chains)
  {
    for (std::size_t i = 0; i < chain.Points.size(); ++i)
    {
      const double doubt = chain.Points[i][0] + 1.0;
      const double limit = std::max(0.0, (1.0 - doubt) / 0.2);
      check(doubt < 1.0 + 1.0e-6, "no line in doubt", doubt);
      check(chain.Strength[i] < limit + 1.0e-4 || doubt < 0.8 + 0.02, "lines fade out",
        chain.Strength[i]);
    }
  }
  filter->SetStrategy(vtkNPRFeatureLines::FULL_TRAVERSAL);
  check(AreSame(lines, GetLines(filter)), "full traversal");

  // As the built-in lines, so the expression that is said to be the same.
  vtkNew<vtkNPRExpressionLines> expression;
  expression->SetField("kr");
  expression->SetTest("if(ndotv > 0 and sintheta > a, min((dwkr - 0.3) * sintheta / 2, "
                      "(sintheta - a) / a, ndotv / 0.02), min((sintheta - a) / a, ndotv / 0.02))");
  expression->SetConstants("a = 0.25881904510252074");
  vtkNew<vtkNPRFeatureLines> defined;
  defined->SetInputData(torus);
  defined->AddDefinition(expression);
  defined->SetLengthScale(1.0);
  defined->SetCamera(filter->GetCamera());
  check(AreSame(lines, GetLines(defined)), "the expression");

  // Data that change, and lines that no view changes.
  filter->KeepDoubtfulOn();
  const auto all = GetLines(filter);
  check(!AreSame(lines, all), "doubtful lines are kept");
  filter->KeepDoubtfulOff();
  torus->GetPointData()->RemoveArray(npr::names::DerivativeDoubt);
  torus->Modified();
  check(AreSame(all, GetLines(filter)), "without the array all is trusted");
}
}

int TestDoubtfulLines(int, char*[])
{
  Checks check;
  const std::vector<const char*> kinds = { "suggestive", "suggestive-highlights", "demarcating",
    "mean-curvature", "expression" };
  TestPart(MakeRibs(), "a plate with ribs", kinds, check);
  TestPart(MakeFilletBox(0.1), "a box with fillets", kinds, check);
  TestPart(MakeFilletBox(0.1), "a box with fillets", { "parabolic" }, check); // ribs have none
  TestParts(check);
  TestHalf(check);
  return check.GetResult();
}
