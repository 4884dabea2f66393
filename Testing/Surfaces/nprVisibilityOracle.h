// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprVisibilityOracle.h
 * @brief What hides a point, by brute force: every triangle whose image is there is looked at.
 */
#ifndef nprVisibilityOracle_h
#define nprVisibilityOracle_h

#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkIdList.h>
#include <vtkMath.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace nprtest
{
/**
 * @class VisibilityOracle
 * @brief Counts hiding layers as vtkNPRStrokeVisibility defines them, but shares no code with it.
 *
 * In double precision, without rays, hierarchies or contour edges: all triangles are projected, and
 * those whose image has the point's image in it are compared with it by depth. The image is divided
 * into squares only to find these triangles faster. Triangles are neighbours if they have two
 * places in common. The eye must be outside of the bounds of the surfaces.
 */
class VisibilityOracle
{
public:
  using Vector = Eigen::Vector3d;

  void AddSurface(vtkPolyData* surface, const Eigen::Matrix4d& toWorld)
  {
    struct Less
    {
      bool operator()(const Vector& a, const Vector& b) const
      {
        return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
      }
    };
    std::map<Vector, int, Less> places;
    std::vector<int> ids(surface->GetNumberOfPoints());
    for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
    {
      Vector point;
      surface->GetPoint(i, point.data());
      const auto [found, isNew] = places.emplace(point, static_cast<int>(this->Points.size()));
      if (isNew)
      {
        this->Points.push_back((toWorld * point.homogeneous()).head<3>());
      }
      ids[i] = found->second;
    }
    vtkDataArray* const normals = surface->GetPointData()->GetArray("Normals");
    vtkDataArray* const exactness = surface->GetCellData()->GetArray("ChordError");
    vtkNew<vtkIdList> corners;
    for (vtkIdType cell = 0; cell < surface->GetNumberOfPolys(); ++cell)
    {
      surface->GetPolys()->GetCellAtId(cell, corners);
      this->ChordErrors.push_back(exactness ? exactness->GetComponent(cell, 0)
          : normals                         ? GetChordError(surface, normals, corners, toWorld)
                                            : 0.0);
      this->Triangles.push_back(
        { ids[corners->GetId(0)], ids[corners->GetId(1)], ids[corners->GetId(2)] });
    }
  }

  /// Once all surfaces are there; then once for each view.
  void Prepare() { this->FindNeighbours(); }

  void SetView(vtkCamera* camera, double height)
  {
    const Eigen::Matrix4d toView = Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(
      camera->GetModelViewTransformMatrix()->GetData());
    this->ToView = toView;
    this->IsParallel = camera->GetParallelProjection() != 0;
    this->Scale = 0.5 * height /
      (this->IsParallel ? camera->GetParallelScale()
                        : std::tan(0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle())));
    this->Seen.resize(this->Points.size());
    Eigen::AlignedBox2d box;
    for (std::size_t i = 0; i < this->Points.size(); ++i)
    {
      this->Seen[i] = this->See(this->Points[i]);
      box.extend(this->Seen[i].head<2>());
    }
    this->Low = box.min();
    this->Columns = static_cast<int>(box.sizes().x() / CellSize) + 1;
    this->Rows = static_cast<int>(box.sizes().y() / CellSize) + 1;
    this->Cells.assign(static_cast<std::size_t>(this->Columns) * this->Rows, {});
    for (std::size_t t = 0; t < this->Triangles.size(); ++t)
    {
      Eigen::AlignedBox2d bounds;
      for (const int corner : this->Triangles[t])
      {
        bounds.extend(this->Seen[corner].head<2>());
      }
      this->VisitCells(
        bounds, [&](std::size_t cell) { this->Cells[cell].push_back(static_cast<int>(t)); });
    }
  }

  /// x and y in pixels from the middle of the image, and the depth.
  Vector See(const Vector& point) const
  {
    const Eigen::Vector4d seen = this->ToView * point.homogeneous();
    const double depth = -seen.z();
    const double scale = this->IsParallel ? this->Scale : this->Scale / depth;
    return { scale * seen.x(), scale * seen.y(), depth };
  }

  /// \p normal of the smooth surface in the world, or zero; \p along the stroke, in any length.
  int CountLayers(const Vector& point, const Vector& normal, const Vector& along)
  {
    Vector edgeOn = Vector::Zero();
    int layers = this->CountLayersAt(point, normal, along, edgeOn);
    if (edgeOn.squaredNorm() > 0.0)
    {
      const Vector aside = 4e-5 * this->Radius * edgeOn.normalized();
      Vector ignored;
      layers = std::min(this->CountLayersAt(point + aside, normal, along, ignored),
        this->CountLayersAt(point - aside, normal, along, ignored));
    }
    return layers;
  }

private:
  struct OwnSurface
  {
    std::set<int> Sources;
    std::map<int, Vector> Around; // with the first triangle's normal, turned alike
    std::set<int> InFront;        // of a contour that is behind its own surface
    double Reach = 0.0;
    double ChordError = 0.0; // of those that are as near as the nearest
  };

  /// Also the normal of a triangle that is seen edge-on under the point, where there is one.
  int CountLayersAt(
    const Vector& point, const Vector& normal, const Vector& along, Vector& edgeOn) const
  {
    const Vector seen = this->See(point);
    const Eigen::Vector2d pixel = seen.head<2>();
    // How far it is to the eye for each unit of depth.
    const double slope =
      this->IsParallel ? 1.0 : Vector(pixel.x(), pixel.y(), this->Scale).norm() / this->Scale;
    const double touching = 1e-5 * this->Radius;
    std::vector<std::pair<double, int>> hits;
    this->VisitCells(Eigen::AlignedBox2d(pixel, pixel),
      [&](std::size_t cell)
      {
        for (const int t : this->Cells[cell])
        {
          const double depth = this->GetDepthAt(t, pixel);
          const double distance = slope * (seen.z() - depth);
          if (distance > touching)
          {
            hits.emplace_back(distance, t);
          }
        }
      });
    const OwnSurface own = this->FindOwnSurface(point, seen, normal, along, touching);
    const Vector toEye = this->GetDirectionToEye(point);
    for (const int source : own.Sources)
    {
      const Vector area = this->GetAreaNormal(source);
      if (std::abs(area.dot(toEye)) <= 1e-4 * area.norm())
      {
        edgeOn = area;
        break;
      }
    }
    return static_cast<int>(std::count_if(hits.begin(), hits.end(),
      [&](const std::pair<double, int>& hit)
      {
        return own.Sources.count(hit.second) == 0 &&
          !(hit.first <= own.Reach && own.Around.count(hit.second) != 0 &&
            own.InFront.count(hit.second) == 0) &&
          !this->TouchesBody(own, point, seen.z(), hit);
      }));
  }

  /// Curves that leave the ends of an edge at right angles to their normals are so far from it: to
  /// first order an eighth of its length times the angle between the normals in its direction.
  static double GetChordError(
    vtkPolyData* surface, vtkDataArray* normals, vtkIdList* corners, const Eigen::Matrix4d& toWorld)
  {
    double largest = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      const vtkIdType a = corners->GetId(i);
      const vtkIdType b = corners->GetId((i + 1) % 3);
      Vector from, to, n, m;
      surface->GetPoint(a, from.data());
      surface->GetPoint(b, to.data());
      normals->GetTuple(a, n.data());
      normals->GetTuple(b, m.data());
      if (n.dot(m) > 0.5)
      {
        const double sum = (n + m).norm();
        const Vector move = ((to - from).dot(m) * m - (to - from).dot(n) * n) / (sum * (2.0 + sum));
        largest = std::max(largest, (toWorld.topLeftCorner<3, 3>() * move).norm());
      }
    }
    return largest;
  }

  /// Whether another body than the own one touches it there, as far as chords can tell.
  bool TouchesBody(const OwnSurface& own, const Vector& point, double depth,
    const std::pair<double, int>& hit) const
  {
    if (own.Around.empty() || this->Bodies[hit.second] == this->Bodies[own.Around.begin()->first])
    {
      return false;
    }
    double touching = this->ChordErrors[hit.second] + own.ChordError;
    touching = std::min(touching, 4.0 * (this->IsParallel ? 1.0 : depth) / this->Scale);
    const double cosine =
      std::abs(this->GetAreaNormal(hit.second).normalized().dot(this->GetDirectionToEye(point)));
    return hit.first * cosine <= touching && this->GetDistance(point, hit.second) <= 5.0 * touching;
  }

  static constexpr double CellSize = 3.0;

  template<typename Visitor>
  void VisitCells(const Eigen::AlignedBox2d& box, const Visitor& visit) const
  {
    const auto place = [](double x, double low)
    { return static_cast<int>(std::floor((x - low) / CellSize)); };
    const int right = std::min(place(box.max().x(), this->Low.x()), this->Columns - 1);
    const int top = std::min(place(box.max().y(), this->Low.y()), this->Rows - 1);
    for (int y = std::max(0, place(box.min().y(), this->Low.y())); y <= top; ++y)
    {
      for (int x = std::max(0, place(box.min().x(), this->Low.x())); x <= right; ++x)
      {
        visit(static_cast<std::size_t>(y) * this->Columns + x);
      }
    }
  }

  /// Infinity where the triangle's image does not have the pixel in it.
  double GetDepthAt(int triangle, const Eigen::Vector2d& pixel) const
  {
    constexpr double nowhere = std::numeric_limits<double>::infinity();
    std::array<Eigen::Vector2d, 3> corners;
    std::array<double, 3> depths;
    for (int i = 0; i < 3; ++i)
    {
      const Vector& seen = this->Seen[this->Triangles[triangle][i]];
      corners[i] = seen.head<2>() - pixel;
      depths[i] = seen.z();
    }
    const auto cross = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b)
    { return a.x() * b.y() - a.y() * b.x(); };
    const std::array<double, 3> areas = { cross(corners[1], corners[2]),
      cross(corners[2], corners[0]), cross(corners[0], corners[1]) };
    const double sum = areas[0] + areas[1] + areas[2];
    if (sum == 0.0)
    {
      return nowhere;
    }
    for (int i = 0; i < 3; ++i)
    {
      // What is exactly on an edge is in one of its two triangles.
      const Eigen::Vector2d along = corners[(i + 2) % 3] - corners[(i + 1) % 3];
      const bool isForwards = along.y() > 0.0 || (along.y() == 0.0 && along.x() > 0.0);
      if (areas[i] == 0.0 ? isForwards != (sum > 0.0) : areas[i] / sum < 0.0)
      {
        return nowhere;
      }
    }
    double depth = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      depth += areas[i] / sum * (this->IsParallel ? depths[i] : 1.0 / depths[i]);
    }
    return this->IsParallel ? depth : 1.0 / depth;
  }

  Vector GetDirectionToEye(const Vector& point) const
  {
    const Eigen::Matrix3d turn = this->ToView.topLeftCorner<3, 3>();
    const Vector seen = (this->ToView * point.homogeneous()).head<3>();
    return this->IsParallel ? Vector(turn.row(2)) : Vector(-(turn.transpose() * seen).normalized());
  }

  Vector GetAreaNormal(int triangle) const
  {
    const auto& corners = this->Triangles[triangle];
    return (this->Points[corners[1]] - this->Points[corners[0]])
      .cross(this->Points[corners[2]] - this->Points[corners[0]]);
  }

  /// By the regions of C. Ericson, Real-Time Collision Detection, 2005, section 5.1.5.
  double GetDistance(const Vector& p, int triangle) const
  {
    const auto& corners = this->Triangles[triangle];
    const Vector a = this->Points[corners[0]];
    const Vector b = this->Points[corners[1]];
    const Vector c = this->Points[corners[2]];
    const Vector ab = b - a;
    const Vector ac = c - a;
    const double d1 = ab.dot(p - a), d2 = ac.dot(p - a);
    const double d3 = ab.dot(p - b), d4 = ac.dot(p - b);
    const double d5 = ab.dot(p - c), d6 = ac.dot(p - c);
    if (d1 <= 0.0 && d2 <= 0.0)
    {
      return (p - a).norm();
    }
    if (d3 >= 0.0 && d4 <= d3)
    {
      return (p - b).norm();
    }
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0)
    {
      return (p - a - d1 / (d1 - d3) * ab).norm();
    }
    if (d6 >= 0.0 && d5 <= d6)
    {
      return (p - c).norm();
    }
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0)
    {
      return (p - a - d2 / (d2 - d6) * ac).norm();
    }
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0)
    {
      return (p - b - (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b)).norm();
    }
    const double sum = va + vb + vc;
    return (p - a - vb / sum * ab - vc / sum * ac).norm();
  }

  double GetDistanceFromBorder(const Vector& p, int triangle) const
  {
    double distance = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3; ++i)
    {
      distance = std::min(distance, this->GetDistanceFromEdge(p, triangle, i));
    }
    return distance;
  }

  double GetDistanceFromEdge(const Vector& p, int triangle, int edge) const
  {
    const Vector a = this->Points[this->Triangles[triangle][edge]];
    const Vector along = this->Points[this->Triangles[triangle][(edge + 1) % 3]] - a;
    const double t = std::clamp((p - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
    return (p - a - t * along).norm();
  }

  OwnSurface FindOwnSurface(const Vector& point, const Vector& seen, const Vector& normal,
    const Vector& along, double touching) const
  {
    OwnSurface own;
    const double pixelSize = (this->IsParallel ? 1.0 : seen.z()) / this->Scale;
    const double farthest = std::max(4.0 * pixelSize, touching);
    const Eigen::Vector2d around = Eigen::Vector2d::Constant(2.0 * farthest / pixelSize + 1.0);
    double gap = farthest;
    int nearest = -1;
    this->VisitCells(Eigen::AlignedBox2d(seen.head<2>() - around, seen.head<2>() + around),
      [&](std::size_t cell)
      {
        for (const int t : this->Cells[cell])
        {
          const double distance = this->GetDistance(point, t);
          if (distance < gap || (distance == gap && t < nearest))
          {
            gap = distance;
            nearest = t;
          }
          if (distance <= touching)
          {
            own.Sources.insert(t);
          }
        }
      });
    if (nearest < 0)
    {
      return own;
    }
    const Vector area = this->GetAreaNormal(nearest);
    const double size = std::sqrt(area.norm());
    if (gap > std::max({ touching, 0.5 * pixelSize, 0.1 * size }))
    {
      return own;
    }
    own.Reach = 5.0 * gap;
    const Vector toEye = this->GetDirectionToEye(point);
    const auto isEdgeOn = [&toEye](const Vector& direction, double most)
    { return std::abs(direction.normalized().dot(toEye)) <= most; };
    const bool isInside = this->GetDistanceFromBorder(point, nearest) > 0.1 * touching;
    if (isInside)
    {
      own.Reach = std::max(own.Reach, 2.0 * pixelSize);
      if (isEdgeOn(normal.squaredNorm() > 0.0 ? normal : area, 0.25))
      {
        own.Reach = std::max(own.Reach, 4.0 * size);
      }
    }
    // A contour has the front on its left. Where that is the farther side, it is seen from within.
    const bool isWithin = isInside && normal.squaredNorm() > 0.0 && isEdgeOn(normal, 0.02) &&
      normal.normalized().cross(along.normalized()).dot(toEye) < -0.02;
    // Connected ones that are as near as the nearest, then those around each of them.
    std::vector<int> sources = { nearest };
    for (std::size_t i = 0; i < sources.size(); ++i)
    {
      own.Sources.insert(sources[i]);
      for (const int next : this->Neighbours[sources[i]])
      {
        if (next >= 0 && std::find(sources.begin(), sources.end(), next) == sources.end() &&
          this->GetDistance(point, next) <= 2.0 * gap + touching)
        {
          sources.push_back(next);
        }
      }
    }
    const bool isOnEdge = gap <= touching && !isInside;
    std::vector<int> queue;
    for (const int source : sources)
    {
      own.Around[source] = this->GetAreaNormal(source).normalized();
      own.ChordError = std::max(own.ChordError, this->ChordErrors[source]);
      if (isOnEdge && isEdgeOn(own.Around[source], 0.1))
      {
        own.Reach = std::max(own.Reach, 2.0 * pixelSize);
      }
      queue.push_back(source);
    }
    std::set<int> beyond; // folds that are outlines
    for (std::size_t i = 0; i < queue.size(); ++i)
    {
      const bool isBeyond = beyond.count(queue[i]) != 0;
      for (int e = 0; e < 3; ++e)
      {
        const int next = this->Neighbours[queue[i]][e];
        if (next < 0 || own.Around.count(next) != 0)
        {
          continue;
        }
        const double sign = this->RunTheSameWay(queue[i], next) ? -1.0 : 1.0;
        const Vector there = this->GetAreaNormal(next).normalized();
        if (there.dot(sign * own.Around[queue[i]]) >= 0.1 &&
          this->GetDistance(point, next) <= (isBeyond ? 2.0 * pixelSize : own.Reach))
        {
          own.Around[next] = sign * own.Around[queue[i]];
          queue.push_back(next);
          if (isBeyond)
          {
            beyond.insert(next);
          }
        }
        else if (isInside && !isWithin && !isBeyond &&
          (this->GetAreaNormal(queue[i]).dot(toEye) < 0.0) != (sign * there.dot(toEye) < 0.0) &&
          this->GetDistanceFromEdge(point, queue[i], e) <= 2.0 * pixelSize)
        {
          own.Around[next] = there;
          queue.push_back(next);
          beyond.insert(next);
        }
      }
    }
    for (const auto& [triangle, turned] : own.Around)
    {
      const double outwards = turned.dot(normal) < 0.0 ? -1.0 : 1.0;
      if (isWithin && outwards * this->GetAreaNormal(triangle).dot(toEye) > 0.0)
      {
        own.InFront.insert(triangle);
      }
    }
    return own;
  }

  /// Whether two neighbours run along their edge in the same direction: then their normals point to
  /// different sides.
  bool RunTheSameWay(int a, int b) const
  {
    for (int i = 0; i < 3; ++i)
    {
      for (int j = 0; j < 3; ++j)
      {
        if (this->Triangles[a][i] == this->Triangles[b][j] &&
          this->Triangles[a][(i + 1) % 3] == this->Triangles[b][(j + 1) % 3])
        {
          return true;
        }
      }
    }
    return false;
  }

  void FindNeighbours()
  {
    std::map<std::pair<int, int>, std::vector<int>> edges;
    for (std::size_t t = 0; t < this->Triangles.size(); ++t)
    {
      for (int i = 0; i < 3; ++i)
      {
        const int a = this->Triangles[t][i];
        const int b = this->Triangles[t][(i + 1) % 3];
        edges[std::minmax(a, b)].push_back(static_cast<int>(t));
      }
    }
    this->Neighbours.assign(this->Triangles.size(), { -1, -1, -1 });
    for (std::size_t t = 0; t < this->Triangles.size(); ++t)
    {
      for (int i = 0; i < 3; ++i)
      {
        const int a = this->Triangles[t][i];
        const int b = this->Triangles[t][(i + 1) % 3];
        const std::vector<int>& both = edges[std::minmax(a, b)];
        if (both.size() == 2)
        {
          this->Neighbours[t][i] = both[0] == static_cast<int>(t) ? both[1] : both[0];
        }
      }
    }
    this->Bodies.assign(this->Triangles.size(), -1);
    for (std::size_t t = 0; t < this->Triangles.size(); ++t)
    {
      std::vector<int> found = { static_cast<int>(t) };
      while (!found.empty())
      {
        const int next = found.back();
        found.pop_back();
        if (next >= 0 && this->Bodies[next] < 0)
        {
          this->Bodies[next] = static_cast<int>(t);
          found.insert(found.end(), this->Neighbours[next].begin(), this->Neighbours[next].end());
        }
      }
    }
    Eigen::AlignedBox3d box;
    for (const Vector& point : this->Points)
    {
      box.extend(point);
    }
    this->Radius = 0.0;
    for (const Vector& point : this->Points)
    {
      this->Radius = std::max(this->Radius, (point - box.center()).norm());
    }
  }

  std::vector<Vector> Points;
  std::vector<std::array<int, 3>> Triangles;
  std::vector<std::array<int, 3>> Neighbours;
  std::vector<double> ChordErrors; // of the triangles
  std::vector<int> Bodies;         // the same number for all that are connected
  double Radius = 0.0;             // around the middle of their bounds
  Eigen::Matrix4d ToView = Eigen::Matrix4d::Identity();
  double Scale = 1.0;
  bool IsParallel = false;
  std::vector<Vector> Seen; // x, y in pixels, depth
  Eigen::Vector2d Low;
  int Columns = 0;
  int Rows = 0;
  std::vector<std::vector<int>> Cells;
};
}

#endif
