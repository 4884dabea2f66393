// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Bounds of how far the eye is from the planes of triangles, against each of these planes.
#include "nprLineTesting.h"

#include "nprLineView.h"
#include "nprPlaneBounds.h"

#include <vtkMinimalStandardRandomSequence.h>
#include <vtkNew.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <vector>

using namespace nprtest;

namespace
{
using Vector = npr::TriangleMesh::Vector;

// Triangles near a place; `tilt` is how far they turn from one plane.
npr::TriangleMesh MakePatch(int size, float tilt, const std::function<float()>& draw)
{
  std::vector<Vector> points;
  std::vector<npr::TriangleMesh::Triangle> triangles;
  const Vector place(3.0f * draw(), 3.0f * draw(), 3.0f * draw());
  for (int i = 0; i < size; ++i)
  {
    const int first = static_cast<int>(points.size());
    for (int k = 0; k < 3; ++k)
    {
      points.push_back(place + Vector(draw(), draw(), tilt * draw()));
    }
    triangles.push_back({ first, first + 1, first + 2 });
  }
  return npr::TriangleMesh(points, triangles);
}

npr::LineView MakeView(bool isParallel, const std::function<float()>& draw)
{
  npr::LineView view;
  view.Perspective = isParallel ? 0.0f : 1.0f;
  const Vector eye(draw(), draw(), draw());
  const Vector placed = isParallel ? Vector(eye.normalized()) : Vector(6.0f * eye);
  view.Eye = { placed.x(), placed.y(), placed.z() };
  return view;
}

// n.(eye - p), or n.eye, of a triangle.
double GetDistance(
  const npr::TriangleMesh& mesh, npr::TriangleMesh::Index triangle, const npr::LineView& view)
{
  const auto point = [&](int corner)
  { return Eigen::Vector3d(mesh.GetPoint(mesh.GetTriangle(triangle)[corner]).cast<double>()); };
  const Eigen::Vector3d normal = (point(1) - point(0)).cross(point(2) - point(0)).normalized();
  const Eigen::Vector3d eye(view.Eye[0], view.Eye[1], view.Eye[2]);
  return normal.dot(eye - double(view.Perspective) * point(0));
}
}

//------------------------------------------------------------------------------
int TestPlaneBounds(int, char*[])
{
  Checks check;
  vtkNew<vtkMinimalStandardRandomSequence> random;
  random->SetSeed(11);
  const std::function<float()> draw = [&]()
  {
    random->Next();
    return static_cast<float>(random->GetRangeValue(-1.0, 1.0));
  };
  for (const float tilt : { 0.0f, 0.02f, 1.0f })
  {
    for (int i = 0; i < 200; ++i)
    {
      const int size = i % 20 == 0 ? 1 : 12;
      const npr::TriangleMesh mesh = MakePatch(size, tilt, draw);
      const npr::PlaneBounds bounds(mesh, 0, size);
      for (int k = 0; k < 10; ++k)
      {
        const npr::LineView view = MakeView(k % 2 == 0, draw);
        const auto [low, high] = bounds.GetRange(view);
        double least = std::numeric_limits<double>::max();
        double most = -least;
        for (int t = 0; t < size; ++t)
        {
          const double distance = GetDistance(mesh, t, view);
          least = std::min(least, distance);
          most = std::max(most, distance);
        }
        check(low <= least && most <= high, "all planes are within the bounds", low - least);
        if (size == 1)
        {
          check(high - low < 1.0e-4, "the bounds of one plane are narrow", high - low);
        }
      }
    }
  }
  return check.GetResult();
}
