// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Where derivatives of curvature mean something: on regular meshes, however thin their triangles,
// and on irregular ones of well-shaped triangles, but not on the slivers of fillets.
#include "nprChecks.h"
#include "nprCurvaturePipeline.h"
#include "nprFilletBox.h"

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

// Neither size nor place nor rotation matters.
void TestInvariance(Checks& check)
{
  const auto box = MakeFilletBox(0.1);
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
  TestInvariance(check);
  TestFilters(check);
  return check.GetResult();
}
