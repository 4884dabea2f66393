// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// What must not matter (place, turn, size, the order of triangles, threads) does not; what must
// (which side is out) does.
#include "nprCurvaturePipeline.h"

#include <vtkSMPTools.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cstring>
#include <thread>

using namespace nprtest;

namespace
{
using Map = std::function<Vector3d(const Vector3d&)>;

AnalyticSurface Transform(AnalyticSurface surface, const Map& map)
{
  for (vtkIdType i = 0; i < surface.Mesh->GetNumberOfPoints(); ++i)
  {
    surface.Mesh->GetPoints()->SetPoint(i, map(surface.Truths[i].Point).data());
  }
  return surface;
}

/// Errors of the torus after it was turned and scaled, times the scale.
Errors MeasureTorus(const Eigen::Matrix3d& rotation, double scale, const Vector3d& offset,
  const std::function<void(vtkPolyData*)>& change = {})
{
  AnalyticSurface surface = Transform(MakeTorus(1.0, 0.4, 96, 48),
    [&](const Vector3d& p) { return Vector3d(scale * (rotation * p) + offset); });
  if (change)
  {
    change(surface.Mesh);
  }
  Pipeline pipeline(surface.Mesh);
  vtkPolyData* output = pipeline.Update();
  Errors worst;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    Truth truth = surface.Truths[i];
    truth.Normal = rotation * truth.Normal;
    truth.Frame = { rotation * truth.Frame.U, rotation * truth.Frame.V };
    truth.Form /= scale;
    truth.Cubic /= scale * scale;
    Errors errors = GetErrors(output, i, truth);
    errors.Form *= scale;
    errors.Principal *= scale;
    errors.Cubic *= scale * scale;
    worst.Include(errors);
  }
  return worst;
}

void CheckClose(
  const Errors& a, const Errors& b, double noise, const std::string& what, Checks& check)
{
  check(std::abs(a.Normal - b.Normal) < noise, what + ": normals", a.Normal - b.Normal);
  check(std::abs(a.Form - b.Form) < 100 * noise, what + ": tensors", a.Form - b.Form);
  check(std::abs(a.Direction - b.Direction) < 100 * noise, what + ": directions",
    a.Direction - b.Direction);
  check(std::abs(a.Cubic - b.Cubic) < 1e4 * noise, what + ": derivatives", a.Cubic - b.Cubic);
}

void ReverseTriangles(vtkPolyData* mesh)
{
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkIdList> ids;
  for (vtkIdType c = mesh->GetNumberOfCells() - 1; c >= 0; --c)
  {
    mesh->GetPolys()->GetCellAtId(c, ids);
    const vtkIdType turned[3] = { ids->GetId(1), ids->GetId(2), ids->GetId(0) };
    cells->InsertNextCell(3, turned);
  }
  mesh->SetPolys(cells);
}

void TestFlip(Checks& check)
{
  AnalyticSurface surface = MakeWaves(24);
  Pipeline pipeline(surface.Mesh);
  vtkPolyData* before = pipeline.Update();
  AnalyticSurface other = MakeWaves(24);
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkIdList> ids;
  for (vtkIdType c = 0; c < other.Mesh->GetNumberOfCells(); ++c)
  {
    other.Mesh->GetPolys()->GetCellAtId(c, ids);
    const vtkIdType turned[3] = { ids->GetId(0), ids->GetId(2), ids->GetId(1) };
    cells->InsertNextCell(3, turned);
  }
  other.Mesh->SetPolys(cells);
  Pipeline flipped(other.Mesh);
  vtkPolyData* after = flipped.Update();
  for (vtkIdType i = 0; i < before->GetNumberOfPoints(); ++i)
  {
    check((GetTuple<3>(before, npr::names::Normals, i) + GetTuple<3>(after, npr::names::Normals, i))
            .norm() < 1e-5,
      "the other side has the opposite normal");
    check((GetTuple<6>(before, npr::names::CurvatureTensor, i) +
            GetTuple<6>(after, npr::names::CurvatureTensor, i))
            .norm() < 1e-3,
      "the other side has the opposite curvature");
  }
}

void TestThreads(Checks& check)
{
  AnalyticSurface surface = MakeWaves(60);
  std::vector<vtkSmartPointer<vtkPolyData>> outputs;
  const std::string backend = vtkSMPTools::GetBackend();
  for (int threads : { 1, 2 })
  {
    // TBB would not take more threads again after it has been held to one.
    vtkSMPTools::SetBackend(threads == 1 ? "Sequential" : "STDThread");
    vtkSMPTools::Initialize(threads);
    check(vtkSMPTools::GetEstimatedNumberOfThreads() == threads ||
        std::thread::hardware_concurrency() < 2,
      "there are as many threads as asked for");
    Pipeline pipeline(surface.Mesh);
    pipeline.Normals->SetSmoothingRadius(0.03);
    pipeline.Normals->SetFeaturePreservation(1.0);
    pipeline.Tensor->SetSmoothingRadius(0.05);
    pipeline.Derivatives->SetSmoothingRadius(0.05);
    outputs.emplace_back(pipeline.Update());
  }
  vtkSMPTools::SetBackend(backend.c_str());
  for (const char* name : GetArrayNames())
  {
    vtkDataArray* a = outputs[0]->GetPointData()->GetArray(name);
    vtkDataArray* b = outputs[1]->GetPointData()->GetArray(name);
    check(a && b && a->GetDataSize() == b->GetDataSize() &&
        std::memcmp(
          a->GetVoidPointer(0), b->GetVoidPointer(0), a->GetDataSize() * a->GetDataTypeSize()) == 0,
      std::string("the same bits for any number of threads: ") + name);
  }
}
}

int TestCurvatureInvariance(int, char*[])
{
  Checks check;
  const Eigen::Matrix3d identity = Eigen::Matrix3d::Identity();
  const Vector3d nowhere = Vector3d::Zero();
  const Errors plain = MeasureTorus(identity, 1.0, nowhere);
  check(plain.Form < 0.05 && plain.Cubic < 0.5, "the torus is right", plain.Cubic);

  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(1.1, Vector3d(1.0, 2.0, -0.5).normalized()).toRotationMatrix();
  CheckClose(MeasureTorus(turn, 1.0, nowhere), plain, 1e-5, "turned", check);
  for (double scale : { 1e-9, 1e-3, 1e3, 1e9 })
  {
    CheckClose(MeasureTorus(identity, scale, nowhere), plain, 1e-5,
      "scaled " + std::to_string(scale), check);
  }
  CheckClose(MeasureTorus(identity, 1.0, Vector3d::Constant(1e6)), plain, 1e-5, "far away", check);
  CheckClose(
    MeasureTorus(identity, 1.0, nowhere, ReverseTriangles), plain, 1e-5, "other order", check);
  // A mirrored torus has its normals inside until the preparation turns it.
  Eigen::Matrix3d mirror = identity;
  mirror(0, 0) = -1.0;
  CheckClose(MeasureTorus(mirror, 1.0, nowhere), plain, 1e-5, "mirrored", check);
  TestFlip(check);
  TestThreads(check);
  return check.GetResult();
}
