// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Input of every bad kind goes through the whole pipeline: no crash, nothing that is not finite.
#include "nprCurvaturePipeline.h"
#include "vtkNPRSurfaceRefinement.h"

#include <vtkFloatArray.h>
#include <vtkObject.h>

#include <limits>

using namespace nprtest;

namespace
{
const double NaN = std::numeric_limits<double>::quiet_NaN();
const double Infinity = std::numeric_limits<double>::infinity();

vtkSmartPointer<vtkPolyData> Make(
  const std::vector<Vector3d>& points, const std::vector<std::vector<vtkIdType>>& cells)
{
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> meshPoints;
  for (const Vector3d& point : points)
  {
    meshPoints->InsertNextPoint(point.data());
  }
  vtkNew<vtkCellArray> polygons;
  for (const auto& cell : cells)
  {
    polygons->InsertNextCell(static_cast<vtkIdType>(cell.size()), cell.data());
  }
  mesh->SetPoints(meshPoints);
  mesh->SetPolys(polygons);
  return mesh;
}

void CheckFinite(vtkPolyData* output, const std::string& name, Checks& check)
{
  for (const char* array : GetArrayNames())
  {
    vtkDataArray* values = output->GetPointData()->GetArray(array);
    if (output->GetNumberOfPoints() == 0)
    {
      continue;
    }
    if (!check(values && values->GetNumberOfTuples() == output->GetNumberOfPoints(),
          name + " has " + array))
    {
      continue;
    }
    for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
    {
      for (int c = 0; c < values->GetNumberOfComponents(); ++c)
      {
        check(std::isfinite(values->GetComponent(i, c)), name + ": finite " + array);
      }
    }
  }
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    check(std::abs(GetTuple<3>(output, npr::names::Normals, i).norm() - 1.0) < 1e-5,
      name + ": unit normals");
  }
}

/// With and without the preparation, with each estimator, and with a refinement in between.
void TestInput(const std::string& name, vtkPolyData* mesh, Checks& check)
{
  for (int i = 0; i < 2 * vtkNPRCurvatureTensor::GetNumberOfEstimators(); ++i)
  {
    const bool prepared = i % 2 == 0;
    const int estimator = i / 2;
    Pipeline pipeline(mesh);
    pipeline.Tensor->SetEstimator(estimator);
    pipeline.Tensor->SetSmoothingRadius(0.1);
    pipeline.Derivatives->SetSmoothingRadius(0.1);
    vtkNew<vtkNPRSurfaceRefinement> refinement;
    refinement->SetMaximumNumberOfTriangles(5000);
    refinement->SetInputConnection(pipeline.Tensor->GetOutputPort());
    pipeline.Derivatives->SetInputConnection(refinement->GetOutputPort());
    if (!prepared)
    {
      pipeline.Normals->SetInputData(mesh);
    }
    CheckFinite(pipeline.Update(),
      name + (prepared ? ", prepared, " : ", raw, ") +
        vtkNPRCurvatureTensor::GetEstimatorName(estimator),
      check);
  }
}

void TestMissingArrays(Checks& check)
{
  // The curvature without normals makes its own; with bad ones it mends them.
  AnalyticSurface torus = MakeTorus(1.0, 0.4, 64, 32);
  vtkNew<vtkNPRCurvatureTensor> tensor;
  tensor->SetInputData(torus.Mesh);
  tensor->Update();
  const double right = GetValue(tensor->GetOutput(), npr::names::PrincipalCurvature1, 5);
  check(std::abs(right - 2.5) < 0.1, "curvature without given normals", right);

  vtkNew<vtkFloatArray> normals;
  normals->SetName(npr::names::Normals);
  normals->SetNumberOfComponents(3);
  for (const Truth& truth : torus.Truths)
  {
    // Any length will do; one is zero and one is nothing.
    const Vector3d n = 7.0 * truth.Normal;
    normals->InsertNextTuple(n.data());
  }
  normals->SetTuple3(5, NaN, 0, 0);
  normals->SetTuple3(6, 0, 0, 0);
  torus.Mesh->GetPointData()->SetNormals(normals);
  tensor->Update();
  check(std::abs(GetValue(tensor->GetOutput(), npr::names::PrincipalCurvature1, 5) - 2.5) < 0.1,
    "curvature mends bad normals");

  // Derivatives without a tensor: an error that says so, and no crash.
  vtkObject::GlobalWarningDisplayOff();
  vtkNew<vtkNPRCurvatureDerivatives> derivatives;
  derivatives->SetInputData(torus.Mesh);
  derivatives->Update();
  vtkObject::GlobalWarningDisplayOn();
  check(!derivatives->GetOutput()->GetPointData()->HasArray(npr::names::CurvatureDerivatives),
    "no derivatives without a tensor");

  // With a tensor and no directions they make their own.
  tensor->GetOutput()->GetPointData()->RemoveArray(npr::names::PrincipalDirection1);
  vtkNew<vtkNPRCurvatureDerivatives> second;
  second->SetInputData(tensor->GetOutput());
  second->Update();
  check(second->GetOutput()->GetPointData()->HasArray(npr::names::PrincipalDirection1) &&
      second->GetOutput()->GetPointData()->HasArray(npr::names::CurvatureDerivatives),
    "derivatives from the tensor alone");
}
}

int TestDegenerateSurfaces(int, char*[])
{
  Checks check;
  const Vector3d o = Vector3d::Zero();
  const Vector3d x = Vector3d::UnitX();
  const Vector3d y = Vector3d::UnitY();
  const Vector3d z = Vector3d::UnitZ();
  vtkNew<vtkPolyData> nothing;
  TestInput("nothing", nothing, check);
  TestInput("only points", Make({ o, x, y }, {}), check);
  TestInput("one triangle", Make({ o, x, y }, { { 0, 1, 2 } }), check);
  TestInput("unused points", Make({ z, o, x, y, z }, { { 1, 2, 3 } }), check);
  TestInput(
    "no area", Make({ o, x, 2.0 * x, y }, { { 0, 1, 2 }, { 0, 2, 3 }, { 1, 1, 3 } }), check);
  TestInput("all in one place", Make({ x, x, x, x }, { { 0, 1, 2 }, { 1, 2, 3 } }), check);
  TestInput("points that are no numbers",
    Make({ o, x, y, { NaN, 0, 0 }, { 0, Infinity, 0 } }, { { 0, 1, 2 }, { 1, 2, 3 }, { 0, 2, 4 } }),
    check);
  TestInput("points that do not exist",
    Make({ o, x, y }, { { 0, 1, 2 }, { 0, 1, 99 }, { -1, 1, 2 } }), check);
  TestInput(
    "duplicates", Make({ o, x, y, o, x, y }, { { 0, 1, 2 }, { 3, 4, 5 }, { 5, 4, 3 } }), check);
  TestInput("three sheets at an edge",
    Make({ o, x, y, -y, z }, { { 0, 1, 2 }, { 1, 0, 3 }, { 0, 1, 4 } }), check);
  TestInput("two cones tip to tip",
    Make({ o, x + z, y + z, -x - y + z, x - z, y - z, -x - y - z },
      { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 1 }, { 0, 5, 4 }, { 0, 6, 5 }, { 0, 4, 6 } }),
    check);
  TestInput("a fold", Make({ o, x, y, y }, { { 0, 1, 2 }, { 1, 0, 3 } }), check);
  TestInput("a needle", Make({ o, x, 1e-7 * y + 0.5 * x, y }, { { 0, 2, 1 }, { 0, 1, 3 } }), check);
  TestInput("tiny polygons", Make({ o, x, y, z }, { {}, { 0 }, { 0, 1 }, { 0, 1, 2, 3 } }), check);
  TestMissingArrays(check);
  return check.GetResult();
}
