// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Where derivatives of curvature mean something: on regular meshes, however thin their triangles,
// and on irregular ones of well-shaped triangles, but not on the slivers of fillets, nor on coarse
// cylinders that meet planes.
#include "nprChecks.h"
#include "nprCurvaturePipeline.h"
#include "nprFilletBox.h"
#include "nprIrregularSurfaces.h"
#include "nprPlaneFacets.h"
#include "nprRibs.h"

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkTransform.h>
#include <vtkTransformPolyDataFilter.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace nprtest;

namespace
{
std::vector<double> GetDoubts(vtkPolyData* mesh, int estimator)
{
  Pipeline pipeline(mesh);
  pipeline.Tensor->SetEstimator(estimator);
  pipeline.Tensor->Update();
  vtkPolyData* const surface = pipeline.Tensor->GetOutput();
  std::vector<double> doubts;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    doubts.push_back(GetValue(surface, npr::names::DerivativeDoubt, i));
  }
  return doubts;
}

void TestTrusted(const std::string& name, vtkPolyData* mesh, int estimator, Checks& check)
{
  const std::vector<double> doubts = GetDoubts(mesh, estimator);
  const double largest = *std::max_element(doubts.begin(), doubts.end());
  check(largest < 0.8,
    name + " by " + vtkNPRCurvatureTensor::GetEstimatorName(estimator) + " is trusted", largest);
}

void TestFillets(Checks& check)
{
  for (const double radius : { 0.02, 0.1 })
  {
    const auto box = MakeFilletBox(radius);
    const std::vector<double> doubts = GetDoubts(box, vtkNPRCurvatureTensor::PER_FACE);
    const double least = *std::min_element(doubts.begin(), doubts.end());
    check(least > 1.0, "no point of a box with fillets is trusted", least);
  }
}

std::vector<float> GetFacets(vtkPolyData* surface)
{
  npr::TriangleMesh mesh(surface);
  mesh.BuildIncidence();
  return npr::MeasurePlaneFacets(mesh);
}

// Two thirds of the edges on the ribs lie inside planes, and all on the plate: known by the making.
void TestRibs(Checks& check)
{
  for (const int steps : { 3, 4, 6 })
  {
    const auto ribs = MakeRibs(steps);
    const std::vector<float> facets = GetFacets(ribs);
    const std::vector<double> doubts = GetDoubts(ribs, vtkNPRCurvatureTensor::PER_FACE);
    check(facets.size() == doubts.size(), "as many points");
    double least = 1.0;
    for (vtkIdType i = 0; i < ribs->GetNumberOfPoints(); ++i)
    {
      // Not at borders, whose edges are in no plane.
      double point[3];
      ribs->GetPoint(i, point);
      const bool isInside = point[1] > 0.3 && point[1] < 0.5 && point[0] > 0.3 && point[0] < 1.0;
      least = isInside ? std::min<double>(least, facets[i]) : least;
      check(facets[i] <= 1.0f, "a share is not more than all", facets[i]);
    }
    check(least > 0.66 && least < 0.75, "planes between the lines of ribs", least);
    const double largest = *std::max_element(doubts.begin(), doubts.end());
    check(largest > 1.5, "where ribs begin derivatives are in doubt", largest);
  }
}

// A grid of plane quadrangles has a third; of irregular points hardly any two triangles are in one
// plane, however fine the mesh is.
void TestFacets(Checks& check)
{
  for (const int size : { 20, 100 })
  {
    const std::vector<float> torus = GetFacets(MakeTorus(1.0, 0.4, 2 * size, size).Mesh);
    check(*std::max_element(torus.begin(), torus.end()) < 0.334f, "a third of a torus in a grid",
      *std::max_element(torus.begin(), torus.end()));
    const std::vector<float> jittered = GetFacets(MakeJitteredTorus(size).Mesh);
    check(*std::max_element(jittered.begin(), jittered.end()) < 0.2f,
      "hardly any of an irregular torus", *std::max_element(jittered.begin(), jittered.end()));
  }
}

// Neither size nor place nor rotation matters.
void TestInvariance(vtkPolyData* box, Checks& check)
{
  const std::vector<double> doubts = GetDoubts(box, vtkNPRCurvatureTensor::PER_FACE);
  for (const double scale : { 1.0e-6, 1.0, 1.0e6 })
  {
    vtkNew<vtkTransform> transform;
    transform->Scale(scale, scale, scale);
    transform->RotateWXYZ(50.0, 1.0, 2.0, 3.0);
    transform->Translate(0.5, -0.3, 0.2);
    vtkNew<vtkTransformPolyDataFilter> filter;
    filter->SetTransform(transform);
    filter->SetInputData(box);
    filter->Update();
    const std::vector<double> moved =
      GetDoubts(filter->GetOutput(), vtkNPRCurvatureTensor::PER_FACE);
    double largest = 0.0;
    for (std::size_t i = 0; i < doubts.size(); ++i)
    {
      largest = std::max(largest, std::abs(moved[i] - doubts[i]) / doubts[i]);
    }
    check(largest < 1.0e-3, "doubt has no unit", largest);
  }
}

// Both filters that make derivatives say the same of the same ones.
void TestFilters(Checks& check)
{
  Pipeline pipeline(MakeFilletBox(0.1));
  vtkPolyData* const surface = pipeline.Update();
  vtkPolyData* const before = pipeline.Tensor->GetOutput();
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    const double doubt = GetValue(surface, npr::names::DerivativeDoubt, i);
    const double expected = GetValue(before, npr::names::DerivativeDoubt, i);
    check(std::abs(doubt - expected) < 1.0e-3 * expected, "vtkNPRCurvatureDerivatives", doubt);
  }
  pipeline.Tensor->OutputDerivativesOff();
  pipeline.Tensor->Update();
  check(!before->GetPointData()->HasArray(npr::names::DerivativeDoubt),
    "without derivatives there is nothing to doubt");
}
}

int TestDerivativeDoubt(int, char*[])
{
  Checks check;
  constexpr int perFace = vtkNPRCurvatureTensor::PER_FACE;
  constexpr int jets = vtkNPRCurvatureTensor::JETS;
  TestTrusted("a torus", MakeTorus(1.0, 0.3, 50, 50).Mesh, perFace, check);
  TestTrusted("a torus of slivers", MakeTorus(1.0, 0.1, 50, 50).Mesh, perFace, check);
  TestTrusted("a finer torus", MakeTorus(1.0, 0.3, 100, 50).Mesh, jets, check);
  for (const int estimator : { perFace, jets })
  {
    TestTrusted("waves", MakeWaves(40).Mesh, estimator, check);
    TestTrusted("an ellipsoid", MakeSurface(EllipsoidPatch({ 1.0, 0.7, 0.5 }), 40, 40).Mesh,
      estimator, check);
  }
  TestFillets(check);
  TestRibs(check);
  TestFacets(check);
  TestInvariance(MakeFilletBox(0.1), check);
  TestFilters(check);
  return check.GetResult();
}
