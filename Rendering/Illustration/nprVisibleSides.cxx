// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprVisibleSides.h"

#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkMath.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace npr
{
namespace
{
constexpr int RaysAcross = 192;
constexpr double Tie = 1e-6;      // of the surface's size: hits that are in one place
constexpr double Outside = -1e-9; // barycentric coordinate: no ray slips through between triangles

using Point = std::array<double, 3>;

/// Parallel rays along one axis, and the first and the last triangle that each of them meets.
class Rays
{
public:
  Rays(int axis, const double bounds[6]) : Axis(axis)
  {
    for (int i = 0; i < 2; ++i)
    {
      const int across = this->GetAcross(i);
      this->Origin[i] = bounds[2 * across];
      const double length = bounds[2 * across + 1] - bounds[2 * across];
      this->Scale[i] = length > 0.0 ? RaysAcross / length : 0.0;
    }
    this->Tolerance = Tie *
      std::sqrt(vtkMath::Distance2BetweenPoints(Point{ bounds[0], bounds[2], bounds[4] }.data(),
        Point{ bounds[1], bounds[3], bounds[5] }.data()));
  }

  void Add(const std::array<Point, 3>& corners)
  {
    double place[3][2];
    double low[2] = { RaysAcross, RaysAcross };
    double high[2] = { -1.0, -1.0 };
    for (int corner = 0; corner < 3; ++corner)
    {
      for (int i = 0; i < 2; ++i)
      {
        place[corner][i] =
          (corners[corner][this->GetAcross(i)] - this->Origin[i]) * this->Scale[i] - 0.5;
        low[i] = std::min(low[i], place[corner][i]);
        high[i] = std::max(high[i], place[corner][i]);
      }
    }
    const auto side = [&](int a, int b, double x, double y)
    {
      return (place[b][0] - place[a][0]) * (y - place[a][1]) -
        (place[b][1] - place[a][1]) * (x - place[a][0]);
    };
    const double area = side(0, 1, place[2][0], place[2][1]);
    if (area == 0.0)
    {
      return;
    }
    for (int y = std::max(0, static_cast<int>(std::ceil(low[1])));
         y <= std::min(RaysAcross - 1.0, high[1]); ++y)
    {
      for (int x = std::max(0, static_cast<int>(std::ceil(low[0])));
           x <= std::min(RaysAcross - 1.0, high[0]); ++x)
      {
        const double weights[3] = { side(1, 2, x, y) / area, side(2, 0, x, y) / area,
          side(0, 1, x, y) / area };
        if (std::min({ weights[0], weights[1], weights[2] }) >= Outside)
        {
          const double depth = weights[0] * corners[0][this->Axis] +
            weights[1] * corners[1][this->Axis] + weights[2] * corners[2][this->Axis];
          this->Hits[y * RaysAcross + x].Add(depth, area > 0.0, this->Tolerance);
        }
      }
    }
  }

  bool MeetFronts() const
  {
    return std::all_of(this->Hits.begin(), this->Hits.end(),
      [](const Hit& hit) { return hit.IsEmpty() || (hit.UpAtLast && hit.DownAtFirst); });
  }

private:
  /// By the direction of the axis: a normal along it is up.
  struct Hit
  {
    double First = std::numeric_limits<double>::max();
    double Last = std::numeric_limits<double>::lowest();
    bool DownAtFirst = false;
    bool UpAtLast = false;

    bool IsEmpty() const { return this->First > this->Last; }

    void Add(double depth, bool up, double tolerance)
    {
      // What is so much nearer replaces what was found; in one place either may be seen.
      this->DownAtFirst = depth < this->First - tolerance
        ? !up
        : this->DownAtFirst || (!up && depth <= this->First + tolerance);
      this->UpAtLast = depth > this->Last + tolerance
        ? up
        : this->UpAtLast || (up && depth >= this->Last - tolerance);
      this->First = std::min(this->First, depth);
      this->Last = std::max(this->Last, depth);
    }
  };

  int GetAcross(int i) const { return (this->Axis + 1 + i) % 3; }

  int Axis;
  double Origin[2];
  double Scale[2];
  double Tolerance;
  std::vector<Hit> Hits{ RaysAcross * RaysAcross };
};
}

//------------------------------------------------------------------------------
bool ShowsOnlyFronts(vtkPolyData* surface)
{
  if (surface->GetNumberOfPolys() == 0)
  {
    return false;
  }
  double bounds[6];
  surface->GetBounds(bounds);
  std::array<Rays, 3> rays = { Rays(0, bounds), Rays(1, bounds), Rays(2, bounds) };
  auto iterator = vtk::TakeSmartPointer(surface->GetPolys()->NewIterator());
  for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
  {
    vtkIdType size;
    const vtkIdType* ids;
    iterator->GetCurrentCell(size, ids);
    if (size != 3)
    {
      return false;
    }
    std::array<Point, 3> corners;
    for (int i = 0; i < 3; ++i)
    {
      surface->GetPoint(ids[i], corners[i].data());
    }
    for (Rays& axis : rays)
    {
      axis.Add(corners);
    }
  }
  return std::all_of(rays.begin(), rays.end(), [](const Rays& axis) { return axis.MeetFronts(); });
}

//------------------------------------------------------------------------------
bool IsInFrontOf(vtkCamera* camera, const double bounds[6])
{
  double eye[3];
  double direction[3];
  camera->GetPosition(eye);
  camera->GetDirectionOfProjection(direction);
  for (int corner = 0; corner < 8; ++corner)
  {
    double way[3] = { bounds[corner & 1], bounds[2 + ((corner >> 1) & 1)],
      bounds[4 + ((corner >> 2) & 1)] };
    vtkMath::Subtract(way, eye, way);
    if (!(vtkMath::Dot(way, direction) > camera->GetClippingRange()[0]))
    {
      return false;
    }
  }
  return true;
}
}
