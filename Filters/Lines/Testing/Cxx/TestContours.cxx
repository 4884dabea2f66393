// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Contours against the known circle of a sphere, and their number and direction on a torus.
#include "nprLineTesting.h"

using namespace nprtest;

namespace
{
// The contour of a sphere is the circle in the plane at radius^2 / distance towards the eye.
void TestSphere(bool parallel, Checks& check)
{
  const double radius = 2.0;
  const Vector centre(100.0, -30.0, 7.0);
  const Vector towards = Vector(3.0, 1.0, 2.0).normalized();
  const double distance = 9.0;
  vtkNew<vtkCamera> camera;
  const Vector eye = centre + distance * towards;
  camera->SetPosition(eye[0], eye[1], eye[2]);
  camera->SetFocalPoint(centre[0], centre[1], centre[2]);
  camera->SetParallelProjection(parallel);
  const double height = parallel ? 0.0 : radius * radius / distance;
  const double trueRadius = std::sqrt(radius * radius - height * height);

  double lastError = 0.0;
  for (int n : { 20, 40, 80 })
  {
    const auto chains = Extract(MakeSphere(n, radius, centre), { "contours" }, camera);
    CheckSound(chains, check);
    if (!check(chains.size() == 1 && chains[0].Closed, "a sphere has one closed contour",
          static_cast<double>(chains.size())))
    {
      return;
    }
    double error = 0.0;
    double turn = 0.0;
    for (std::size_t i = 0; i < chains[0].Points.size(); ++i)
    {
      const Vector p = chains[0].Points[i] - centre;
      const Vector across = p - p.dot(towards) * towards;
      // With exact normals the field is linear in the point: the plane is met exactly.
      check(std::abs(p.dot(towards) - height) < 2.0e-6, "the contour lies in its plane",
        p.dot(towards) - height);
      error = std::max(error, std::abs(across.norm() - trueRadius));
      const Vector next = chains[0].Next(i) - centre;
      turn += p.cross(next).dot(towards);
      check(chains[0].Strength[i] == 1.0, "contours have full strength");
      check((chains[0].Normals[i] - p.normalized()).norm() < 1.0e-3 * 400 / (n * n) * 20,
        "normals are the sphere's");
    }
    // Front on the left: seen from the eye, the front lies inside, so the line turns to the left.
    check(turn > 0.0, "the contour has the front on its left", turn);
    if (lastError > 0.0)
    {
      check(error < 0.3 * lastError, "the radius converges with h^2", error / lastError);
    }
    lastError = error;
  }
  check(lastError < 1.0e-3 * radius, "the radius is right", lastError);
}

void TestTorus(Checks& check)
{
  const Torus torus;
  for (bool parallel : { false, true })
  {
    for (const Vector& eye :
      { Vector(3.0, 1.0, 4.0), Vector(0.3, -3.5, 1.0), Vector(5.0, 4.0, -3.0) })
    {
      auto camera = MakeCamera(eye, parallel);
      const auto chains = Extract(torus.Make(100, 50), { "contours" }, camera);
      CheckSound(chains, check);
      check(chains.size() == 2, "a torus has two contours", static_cast<double>(chains.size()));
      for (const Chain& chain : chains)
      {
        check(chain.Closed, "contours of a torus are closed");
        for (std::size_t i = 0; i < chain.Points.size(); ++i)
        {
          // A step to the left of the line must lead to the front.
          const Vector middle = 0.5 * (chain.Points[i] + chain.Next(i));
          const Vector along = chain.Next(i) - chain.Points[i];
          const Vector left = chain.Normals[i].cross(along).normalized();
          const Vector p = middle + 0.05 * left;
          const double u = std::atan2(p[1], p[0]);
          const double v = std::atan2(p[2], std::hypot(p[0], p[1]) - torus.R);
          const Vector toEye = parallel ? eye : Vector(eye - torus.Point(u, v));
          check(torus.Normal(u, v).dot(toEye) > 0.0, "the front is on the left",
            torus.Normal(u, v).dot(toEye));
        }
      }
    }
  }
}

// A cylinder with lids: smooth around, split at both rims, where the field of the side and that of
// a lid end at different places. Its front is one piece in every view, so its outline is one closed
// line.
void TestCylinder(Checks& check)
{
  const int n = 17;
  auto cylinder = MakeGrid(n, 4, true, false);
  std::vector<vtkIdType> welded;
  std::vector<Vector> normals;
  for (vtkIdType i = 0; i < 4 * n; ++i)
  {
    const double u = 2.0 * Pi * (i / 4) / n;
    normals.emplace_back(std::cos(u), std::sin(u), 0.0);
    cylinder->GetPoints()->SetPoint(i, std::cos(u), std::sin(u), i % 4 - 1.5);
    welded.push_back(i);
  }
  for (int lid : { 0, 3 })
  {
    const vtkIdType first = cylinder->GetNumberOfPoints();
    const Vector up(0.0, 0.0, lid == 0 ? -1.0 : 1.0);
    cylinder->GetPoints()->InsertNextPoint(Vector(1.5 * up).data());
    welded.push_back(first);
    normals.push_back(up);
    for (int i = 0; i < n; ++i)
    {
      double p[3];
      cylinder->GetPoint(i * 4 + lid, p);
      cylinder->GetPoints()->InsertNextPoint(p);
      welded.push_back(i * 4 + lid);
      normals.push_back(up);
      const vtkIdType a = first + 1 + i;
      const vtkIdType b = first + 1 + (i + 1) % n;
      cylinder->GetPolys()->InsertNextCell({ first, lid == 0 ? b : a, lid == 0 ? a : b });
    }
  }
  AddWeldedIds(cylinder, welded);
  auto array = AddArray(cylinder, npr::names::Normals, 3);
  for (std::size_t i = 0; i < normals.size(); ++i)
  {
    array->SetTuple(static_cast<vtkIdType>(i), normals[i].data());
  }
  for (int view = 0; view < 200; ++view)
  {
    const double u = 2.4 * view;
    const double height = 0.05 * (view - 100);
    auto camera = MakeCamera({ 4.0 * std::cos(u), 4.0 * std::sin(u), height }, view % 2 == 0);
    const auto chains = Extract(cylinder, { "contours" }, camera);
    CheckSound(chains, check);
    check(
      chains.size() == 1 && chains[0].Closed, "the outline of a cylinder is one closed line", view);
  }
}

// Two caps that meet in a sharp rim of few edges: the fields of both sides change their signs
// within one edge. Lines stay closed, and never run back over themselves.
void TestLens(Checks& check)
{
  const int n = 7;
  vtkNew<vtkPolyData> lens;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> triangles;
  lens->SetPoints(points);
  lens->SetPolys(triangles);
  std::vector<vtkIdType> welded;
  std::vector<Vector> normals;
  for (double up : { 1.0, -1.0 })
  {
    const vtkIdType first = points->InsertNextPoint(0.0, 0.0, 0.3 * up);
    welded.push_back(first);
    normals.emplace_back(0.0, 0.0, up);
    for (int i = 0; i < n; ++i)
    {
      const double u = 2.0 * Pi * i / n;
      points->InsertNextPoint(std::cos(u), std::sin(u), 0.0);
      welded.push_back(1 + i);
      normals.push_back(Vector(0.6 * std::cos(u), 0.6 * std::sin(u), 0.8 * up));
      const vtkIdType a = first + 1 + i;
      const vtkIdType b = first + 1 + (i + 1) % n;
      triangles->InsertNextCell({ first, up > 0.0 ? a : b, up > 0.0 ? b : a });
    }
  }
  AddWeldedIds(lens, welded);
  auto array = AddArray(lens, npr::names::Normals, 3);
  for (std::size_t i = 0; i < normals.size(); ++i)
  {
    array->SetTuple(static_cast<vtkIdType>(i), normals[i].data());
  }
  for (int view = 0; view < 200; ++view)
  {
    const double u = 2.4 * view;
    auto camera =
      MakeCamera({ 9.0 * std::cos(u), 9.0 * std::sin(u), 0.02 * (view - 100.3) }, view % 2 == 0);
    const auto chains = Extract(lens, { "contours" }, camera);
    CheckSound(chains, check);
    check(!chains.empty(), "a lens has an outline", view);
    for (const Chain& chain : chains)
    {
      check(chain.Closed, "the outline of a lens is closed", view);
      for (std::size_t i = 0; i < chain.Points.size(); ++i)
      {
        const Vector here = (chain.Next(i) - chain.Points[i]).normalized();
        const Vector next = (chain.Next(i + 1) - chain.Next(i)).normalized();
        check(here.dot(next) > -0.9999, "a line does not run back over itself", view);
      }
    }
  }
}
}

int TestContours(int, char*[])
{
  Checks check;
  TestSphere(false, check);
  TestSphere(true, check);
  TestTorus(check);
  TestCylinder(check);
  TestLens(check);
  return check.GetResult();
}
