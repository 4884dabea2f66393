// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprLineSurface.h"

#include "nprArrayNames.h"
#include "nprHilbertOrder.h"
#include "nprLengthScale.h"
#include "nprWeldedPoints.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

namespace npr
{
//------------------------------------------------------------------------------
LineSurface::LineSurface(vtkPolyData* surface, double lengthScale)
  : Mesh({}, {}), Polygons(surface->GetPolys()), PolygonsMTime(Polygons->GetMTime()),
    NumberOfCellsBefore(surface->GetNumberOfVerts() + surface->GetNumberOfLines())
{
  const TriangleMesh mesh(surface);
  this->LengthScale = lengthScale > 0.0 ? lengthScale : npr::GetLengthScale(surface, mesh);
  if (surface->GetPointData()->HasArray(names::WeldedPointIds))
  {
    this->OriginalWeldedPoints = GetWeldedPoints(surface);
  }
  this->SetOrder(mesh);
  this->SetUsedPoints();
  this->SetCoordinates();
  this->SetGhosts(surface);
  this->BuildTwins();
  this->BuildSeams();
}

//------------------------------------------------------------------------------
void LineSurface::SetGhosts(vtkPolyData* surface)
{
  this->Ghosts.clear();
  this->GhostsMiddles.clear();
  vtkUnsignedCharArray* const flags = surface->GetCellGhostArray();
  if (!flags || flags->GetNumberOfValues() < surface->GetNumberOfCells())
  {
    return;
  }
  std::vector<unsigned char> ghosts(this->CellIds.size());
  for (std::size_t t = 0; t < ghosts.size(); ++t)
  {
    constexpr unsigned char others = vtkDataSetAttributes::DUPLICATECELL |
      vtkDataSetAttributes::REFINEDCELL | vtkDataSetAttributes::HIDDENCELL;
    ghosts[t] = (flags->GetValue(this->CellIds[t]) & others) != 0;
  }
  if (std::find(ghosts.begin(), ghosts.end(), 1) == ghosts.end())
  {
    return;
  }
  this->Ghosts = std::move(ghosts);
  // From the points as the input has them: the same bits in each piece.
  this->GhostsMiddles.resize(this->CellIds.size());
  for (std::size_t t = 0; t < this->CellIds.size(); ++t)
  {
    std::array<double, 3>& middle = this->GhostsMiddles[t];
    middle.fill(0.0);
    for (const Index corner : this->Mesh.GetTriangle(static_cast<Index>(t)))
    {
      double point[3];
      surface->GetPoint(this->GetPointId(corner), point);
      for (int i = 0; i < 3; ++i)
      {
        middle[i] += point[i];
      }
    }
  }
}

//------------------------------------------------------------------------------
bool LineSurface::IsOwned(const Index* begin, const Index* end) const
{
  if (!this->HasGhosts())
  {
    return true;
  }
  const Index first = *std::min_element(begin, end,
    [this](Index a, Index b) { return this->GhostsMiddles[a / 3] < this->GhostsMiddles[b / 3]; });
  return !this->Ghosts[first / 3];
}

//------------------------------------------------------------------------------
bool LineSurface::Move(vtkPolyData* surface, double lengthScale)
{
  if (surface->GetPolys() != this->Polygons ||
    surface->GetPolys()->GetMTime() != this->PolygonsMTime ||
    surface->GetNumberOfVerts() + surface->GetNumberOfLines() != this->NumberOfCellsBefore ||
    surface->GetNumberOfPoints() != this->Mesh.GetNumberOfPoints() || !this->Mesh.HasFinitePoints())
  {
    return false;
  }
  const TriangleMesh mesh(surface);
  const bool isWelded = surface->GetPointData()->HasArray(names::WeldedPointIds);
  if (!mesh.HasFinitePoints() || mesh.GetNumberOfTriangles() != this->Mesh.GetNumberOfTriangles() ||
    this->OriginalWeldedPoints != (isWelded ? GetWeldedPoints(surface) : std::vector<Index>()))
  {
    return false;
  }
  this->LengthScale = lengthScale > 0.0 ? lengthScale : npr::GetLengthScale(surface, mesh);
  std::vector<TriangleMesh::Vector> points(this->PointIds.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    points[i] = mesh.GetPoint(this->PointIds[i]);
  }
  this->Mesh.MovePoints(std::move(points), mesh.GetOrigin());
  this->SetCoordinates();
  this->SetGhosts(surface);
  this->Arrays.clear();
  this->Regions.clear();
  return true;
}

//------------------------------------------------------------------------------
// Points follow the curve, triangles their first points on it.
void LineSurface::SetOrder(const TriangleMesh& mesh)
{
  const Index numberOfPoints = mesh.GetNumberOfPoints();
  const Index numberOfTriangles = mesh.GetNumberOfTriangles();
  {
    std::vector<Eigen::Vector3d> points(numberOfPoints);
    for (Index i = 0; i < numberOfPoints; ++i)
    {
      points[i] = mesh.GetPoint(i).cast<double>();
    }
    const std::vector<vtkIdType> order = GetHilbertOrder(points);
    this->PointIds.assign(order.begin(), order.end());
  }
  std::vector<Index> places(numberOfPoints);
  std::vector<TriangleMesh::Vector> points(numberOfPoints);
  for (Index i = 0; i < numberOfPoints; ++i)
  {
    places[this->PointIds[i]] = i;
    points[i] = mesh.GetPoint(this->PointIds[i]);
  }
  std::vector<Index> next(static_cast<std::size_t>(numberOfPoints) + 1, 0);
  const auto getFirst = [&](Index t)
  {
    const TriangleMesh::Triangle& c = mesh.GetTriangle(t);
    return std::min({ places[c[0]], places[c[1]], places[c[2]] });
  };
  for (Index t = 0; t < numberOfTriangles; ++t)
  {
    ++next[getFirst(t) + 1];
  }
  std::partial_sum(next.begin(), next.end(), next.begin());
  std::vector<TriangleMesh::Triangle> triangles(numberOfTriangles);
  this->CellIds.resize(numberOfTriangles);
  for (Index t = 0; t < numberOfTriangles; ++t)
  {
    const Index place = next[getFirst(t)]++;
    const TriangleMesh::Triangle& c = mesh.GetTriangle(t);
    triangles[place] = { places[c[0]], places[c[1]], places[c[2]] };
    this->CellIds[place] = mesh.GetCellId(t);
  }
  if (!this->OriginalWeldedPoints.empty())
  {
    this->WeldedPoints.resize(numberOfPoints);
    for (Index i = 0; i < numberOfPoints; ++i)
    {
      this->WeldedPoints[i] = places[this->OriginalWeldedPoints[this->PointIds[i]]];
    }
  }
  this->Mesh = TriangleMesh(std::move(points), std::move(triangles), mesh.GetOrigin());
}

//------------------------------------------------------------------------------
void LineSurface::SetUsedPoints()
{
  std::vector<unsigned char> used(this->Mesh.GetNumberOfPoints(), 0);
  for (const TriangleMesh::Triangle& corners : this->Mesh.GetTriangles())
  {
    for (const Index corner : corners)
    {
      used[corner] = 1;
    }
  }
  if (std::find(used.begin(), used.end(), 0) != used.end())
  {
    this->UsedPoints = std::move(used);
  }
}

//------------------------------------------------------------------------------
void LineSurface::SetCoordinates()
{
  const Index numberOfPoints = this->Mesh.GetNumberOfPoints();
  for (int axis = 0; axis < 3; ++axis)
  {
    AlignedVector<float>& coordinates = this->Coordinates[axis];
    coordinates.resize(numberOfPoints);
    for (Index i = 0; i < numberOfPoints; ++i)
    {
      coordinates[i] = this->Mesh.GetPoint(i)[axis];
    }
  }
}

//------------------------------------------------------------------------------
std::array<LineSurface::Index, 2> LineSurface::GetLowAndHigh(Index halfEdge) const
{
  const Index start = this->GetStart(halfEdge);
  const Index end = this->GetEnd(halfEdge);
  return this->GetWelded(start) < this->GetWelded(end) ? std::array<Index, 2>{ start, end }
                                                       : std::array<Index, 2>{ end, start };
}

//------------------------------------------------------------------------------
void LineSurface::BuildTwins()
{
  this->Mesh.BuildNeighbours();
  this->Twins.assign(this->GetNumberOfHalfEdges(), NoTwin);
  vtkSMPTools::For(0, this->GetNumberOfHalfEdges(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (Index h = static_cast<Index>(begin); h < end; ++h)
      {
        const Index neighbour = this->Mesh.GetNeighbour(h / 3, h % 3);
        if (neighbour < 0)
        {
          continue;
        }
        const Index from = this->GetStart(h);
        const Index to = this->GetEnd(h);
        for (Index other = 3 * neighbour; other < 3 * neighbour + 3; ++other)
        {
          const Index start = this->GetStart(other);
          const Index end2 = this->GetEnd(other);
          // Either direction: triangles with opposite windings are still neighbours. Both sides
          // must agree, which they do not where a triangle uses a point twice.
          if (((start == to && end2 == from) || (start == from && end2 == to)) &&
            this->Mesh.GetNeighbour(neighbour, other % 3) == h / 3)
          {
            this->Twins[h] = other;
          }
        }
      }
    });
  this->Mesh.ReleaseNeighbours();
}

//------------------------------------------------------------------------------
void LineSurface::BuildSeams()
{
  struct Side
  {
    Index Low, High, HalfEdge;
    bool operator<(const Side& other) const
    {
      return std::tie(this->Low, this->High, this->HalfEdge) <
        std::tie(other.Low, other.High, other.HalfEdge);
    }
  };
  std::vector<Side> sides;
  for (Index h = 0; h < this->GetNumberOfHalfEdges(); ++h)
  {
    if (this->Twins[h] == NoTwin)
    {
      const Index start = this->GetWelded(this->GetStart(h));
      const Index end = this->GetWelded(this->GetEnd(h));
      if (start != end)
      {
        sides.push_back({ std::min(start, end), std::max(start, end), h });
      }
    }
  }
  std::sort(sides.begin(), sides.end());
  for (std::size_t i = 0; i < sides.size(); ++i)
  {
    this->Seams.HalfEdges.push_back(sides[i].HalfEdge);
    if (i + 1 == sides.size() || sides[i].Low != sides[i + 1].Low ||
      sides[i].High != sides[i + 1].High)
    {
      this->Seams.Offsets.push_back(static_cast<Index>(i + 1));
    }
  }
  for (Index edge = 0; edge < this->Seams.GetNumberOfEdges(); ++edge)
  {
    const Index* const side = this->Seams.Begin(edge);
    if (this->Seams.End(edge) - side == 2)
    {
      this->OthersAtSeams[side[0]] = side[1];
      this->OthersAtSeams[side[1]] = side[0];
    }
  }
}

//------------------------------------------------------------------------------
std::pair<const LineSurface::Index*, const LineSurface::Index*> LineSurface::FindSeam(
  Index halfEdge) const
{
  const auto getPoints = [this](Index side)
  {
    const auto [low, high] = this->GetLowAndHigh(side);
    return std::array<Index, 2>{ this->GetWelded(low), this->GetWelded(high) };
  };
  const std::array<Index, 2> points = getPoints(halfEdge);
  const auto& sides = this->Seams.HalfEdges;
  const auto first = std::partition_point(
    sides.begin(), sides.end(), [&](Index side) { return getPoints(side) < points; });
  const auto last =
    std::find_if(first, sides.end(), [&](Index side) { return getPoints(side) != points; });
  return { sides.data() + (first - sides.begin()), sides.data() + (last - sides.begin()) };
}

//------------------------------------------------------------------------------
LineSurface::Index LineSurface::GetOther(Index halfEdge) const
{
  if (this->Twins[halfEdge] != NoTwin)
  {
    return this->Twins[halfEdge];
  }
  const auto found = this->OthersAtSeams.find(halfEdge);
  return found == this->OthersAtSeams.end() ? NoTwin : found->second;
}

//------------------------------------------------------------------------------
void LineSurface::BuildInnerEdges()
{
  if (!this->InnerEdges.HalfEdges.empty())
  {
    return;
  }
  this->InnerEdges.AreOriented = true;
  for (Index h = 0; h < this->GetNumberOfHalfEdges(); ++h)
  {
    if (this->Twins[h] > h)
    {
      this->InnerEdges.AreOriented =
        this->InnerEdges.AreOriented && this->GetStart(h) == this->GetEnd(this->Twins[h]);
      this->InnerEdges.HalfEdges.push_back(h);
      this->InnerEdges.HalfEdges.push_back(this->Twins[h]);
      this->InnerEdges.Offsets.push_back(static_cast<Index>(this->InnerEdges.HalfEdges.size()));
    }
  }
}

//------------------------------------------------------------------------------
void LineSurface::BuildNeighbours()
{
  if (!this->NeighbourOffsets.empty())
  {
    return;
  }
  const Index size = this->Mesh.GetNumberOfPoints();
  this->NeighbourOffsets.assign(1, 0);
  this->NeighbourOffsets.reserve(size + 1);
  this->Neighbours.reserve(this->GetNumberOfHalfEdges() + this->Seams.HalfEdges.size());
  for (Index point = 0; point < size; ++point)
  {
    for (const Index* t = this->Mesh.IncidentBegin(point); t != this->Mesh.IncidentEnd(point); ++t)
    {
      // The next corner of each triangle: around a point these are all neighbours, each once, but
      // for a last one at a seam.
      const TriangleMesh::Triangle& c = this->Mesh.GetTriangle(*t);
      constexpr std::array<int, 5> ring = { 0, 1, 2, 0, 1 };
      const int corner = (c[1] == point ? 1 : 0) + (c[2] == point ? 2 : 0);
      const int last = ring[corner + 2];
      this->Neighbours.push_back(c[ring[corner + 1]]);
      if (this->Twins[3 * *t + last] == NoTwin)
      {
        this->Neighbours.push_back(c[last]);
      }
    }
    this->NeighbourOffsets.push_back(static_cast<Index>(this->Neighbours.size()));
  }
}
}
