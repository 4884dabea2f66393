// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprHidingEdges.h"

#include "nprHidingLayers.h"

#include <vtkSMPTools.h>

#include <algorithm>
#include <cmath>

namespace npr
{
namespace
{
/// How far beyond its ends a segment still crosses another, as a share of its length: none must
/// slip through where two edges meet.
constexpr double Slack = 1e-9;
}

//------------------------------------------------------------------------------
HidingEdges::HidingEdges(const HidingSurfaces& surfaces, const ImageProjection& projection,
  const Eigen::AlignedBox2d& bounds)
  : Projection(projection), Bounds(bounds)
{
  if (!bounds.isEmpty())
  {
    this->FindEdges(surfaces);
    this->FillGrid();
  }
}

//------------------------------------------------------------------------------
void HidingEdges::FindEdges(const HidingSurfaces& surfaces)
{
  const vtkIdType numberOfTriangles = surfaces.GetNumberOfTriangles();
  enum : unsigned char
  {
    Back = 0,
    Front = 1,
    FrontBit = 1,
    EdgeOnBit = 2
  };
  std::vector<unsigned char> sides(numberOfTriangles);
  vtkSMPTools::For(0, numberOfTriangles,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (auto t = static_cast<Index>(begin); t < end; ++t)
      {
        const Eigen::Vector3d toEye = this->Projection.GetRayToEye(surfaces.GetCorner(t, 0));
        const Eigen::Vector3d normal = surfaces.GetAreaNormal(t);
        const double product = normal.dot(toEye);
        const bool isEdgeOn = product * product <=
          ExactlyEdgeOn * ExactlyEdgeOn * normal.squaredNorm() * toEye.squaredNorm();
        sides[t] = (product > 0.0 ? Front : Back) | (isEdgeOn ? EdgeOnBit : 0);
      }
    });
  // Parts of a fixed size, so that the order of the edges does not depend on the threads.
  constexpr vtkIdType partSize = 16384;
  std::vector<Part> parts((numberOfTriangles + partSize - 1) / partSize);
  vtkSMPTools::For(0, static_cast<vtkIdType>(parts.size()), 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType part = begin; part < end; ++part)
      {
        const auto last = static_cast<Index>(std::min(numberOfTriangles, (part + 1) * partSize));
        for (auto t = static_cast<Index>(part * partSize); t < last; ++t)
        {
          for (int e = 0; e < 3; ++e)
          {
            const Index other = surfaces.GetNeighbour(t, e);
            if (other < 0 ||
              (other > t &&
                ((sides[t] ^ sides[other]) & FrontBit) == (surfaces.IsAlike(t, e) ? 1 : 0)))
            {
              this->AddEdge(surfaces, t, e, parts[part].Edges);
            }
            if (sides[t] & EdgeOnBit)
            {
              this->AddEdge(surfaces, t, e, parts[part].EdgeOn);
            }
          }
        }
      }
    });
  for (const Part& part : parts)
  {
    this->Edges.insert(this->Edges.end(), part.Edges.begin(), part.Edges.end());
    this->EdgeOn.insert(this->EdgeOn.end(), part.EdgeOn.begin(), part.EdgeOn.end());
  }
}

//------------------------------------------------------------------------------
void HidingEdges::AddEdge(
  const HidingSurfaces& surfaces, Index triangle, int edge, std::vector<Edge>& edges)
{
  Eigen::Vector3d from = surfaces.GetCorner(triangle, edge);
  Eigen::Vector3d to = surfaces.GetCorner(triangle, (edge + 1) % 3);
  const ImageProjection& projection = this->Projection;
  ImageProjection::Place start = projection.Project(from);
  ImageProjection::Place end = projection.Project(to);
  const bool isStartSeen = projection.IsInFront(start.Depth);
  const bool isEndSeen = projection.IsInFront(end.Depth);
  if (!isStartSeen && !isEndSeen)
  {
    return;
  }
  if (!isStartSeen || !isEndSeen)
  {
    // Twice the least depth, for what is cut at the least may come out behind it.
    const double t = (2.0 * projection.GetNearest() - start.Depth) / (end.Depth - start.Depth);
    const Eigen::Vector3d cut = from + std::clamp(t, 0.0, 1.0) * (to - from);
    (isStartSeen ? end : start) = projection.Project(cut);
  }
  Eigen::AlignedBox2d box(start.Pixel);
  box.extend(end.Pixel);
  if (box.intersects(this->Bounds))
  {
    edges.push_back({ start, end });
  }
}

//------------------------------------------------------------------------------
int HidingEdges::GetColumn(double x) const
{
  return static_cast<int>(
    std::clamp((x - this->Bounds.min().x()) / this->CellSize, 0.0, this->Size[0] - 1.0));
}

//------------------------------------------------------------------------------
int HidingEdges::GetRow(double y) const
{
  return static_cast<int>(
    std::clamp((y - this->Bounds.min().y()) / this->CellSize, 0.0, this->Size[1] - 1.0));
}

//------------------------------------------------------------------------------
template<typename Visitor>
void HidingEdges::VisitCells(
  const Eigen::Vector2d& from, const Eigen::Vector2d& to, const Visitor& visit) const
{
  const Eigen::Vector2d& low = from.y() <= to.y() ? from : to;
  const Eigen::Vector2d& high = from.y() <= to.y() ? to : from;
  // Whatever is rounded, a cell too many is visited rather than one too few.
  const double margin = Slack * this->CellSize * (this->Size[0] + this->Size[1]);
  const int firstRow = this->GetRow(low.y() - margin);
  const int lastRow = this->GetRow(high.y() + margin);
  const double rise = high.y() - low.y();
  for (int row = firstRow; row <= lastRow; ++row)
  {
    // The first and the last row of the grid go on to infinity.
    double start = 0.0;
    double end = 1.0;
    const double bottom = this->Bounds.min().y() + row * this->CellSize - margin;
    if (row > 0 && bottom > low.y() && rise > 0.0)
    {
      start = std::min(1.0, (bottom - low.y()) / rise);
    }
    const double top = bottom + this->CellSize + 2.0 * margin;
    if (row < this->Size[1] - 1 && top < high.y() && rise > 0.0)
    {
      end = std::max(0.0, (top - low.y()) / rise);
    }
    double left = low.x() + start * (high.x() - low.x());
    double right = low.x() + end * (high.x() - low.x());
    if (left > right)
    {
      std::swap(left, right);
    }
    const int lastColumn = this->GetColumn(right + margin);
    for (int column = this->GetColumn(left - margin); column <= lastColumn; ++column)
    {
      visit(static_cast<std::size_t>(row) * this->Size[0] + column);
    }
  }
}

//------------------------------------------------------------------------------
void HidingEdges::FillGrid()
{
  // About two cells an edge, but no more than make sense in an image.
  constexpr double mostCells = 4e6;
  const Eigen::Vector2d extent = this->Bounds.sizes().cwiseMax(1.0);
  const double cells = std::clamp(2.0 * static_cast<double>(this->Edges.size()), 1.0, mostCells);
  this->CellSize = std::max(
    { std::sqrt(extent.x() * extent.y() / cells), extent.x() / cells, extent.y() / cells });
  this->Size = { static_cast<int>(extent.x() / this->CellSize) + 1,
    static_cast<int>(extent.y() / this->CellSize) + 1 };
  const std::size_t numberOfCells = static_cast<std::size_t>(this->Size[0]) * this->Size[1];
  this->Offsets.assign(numberOfCells + 1, 0);
  for (const Edge& edge : this->Edges)
  {
    this->VisitCells(
      edge.From.Pixel, edge.To.Pixel, [this](std::size_t cell) { ++this->Offsets[cell + 1]; });
  }
  for (std::size_t cell = 0; cell < numberOfCells; ++cell)
  {
    this->Offsets[cell + 1] += this->Offsets[cell];
  }
  this->Entries.resize(this->Offsets.back());
  std::vector<std::uint32_t> next(this->Offsets.begin(), this->Offsets.end() - 1);
  for (std::size_t edge = 0; edge < this->Edges.size(); ++edge)
  {
    this->VisitCells(this->Edges[edge].From.Pixel, this->Edges[edge].To.Pixel,
      [&](std::size_t cell) { this->Entries[next[cell]++] = static_cast<std::uint32_t>(edge); });
  }
  this->IsEdgeOn.assign(numberOfCells, 0);
  for (const Edge& edge : this->EdgeOn)
  {
    this->VisitCells(
      edge.From.Pixel, edge.To.Pixel, [this](std::size_t cell) { this->IsEdgeOn[cell] = 1; });
  }
}

//------------------------------------------------------------------------------
bool HidingEdges::MayBeEdgeOn(
  const ImageProjection::Place& from, const ImageProjection::Place& to) const
{
  bool mayBe = false;
  if (!this->EdgeOn.empty())
  {
    this->VisitCells(
      from.Pixel, to.Pixel, [&](std::size_t cell) { mayBe = mayBe || this->IsEdgeOn[cell] != 0; });
  }
  return mayBe;
}

//------------------------------------------------------------------------------
void HidingEdges::FindCrossings(const ImageProjection::Place& from,
  const ImageProjection::Place& to, std::vector<double>& places) const
{
  if (this->Edges.empty())
  {
    return;
  }
  const Eigen::Vector2d along = to.Pixel - from.Pixel;
  const auto cross = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b)
  { return a.x() * b.y() - a.y() * b.x(); };
  this->VisitCells(from.Pixel, to.Pixel,
    [&](std::size_t cell)
    {
      for (std::uint32_t i = this->Offsets[cell]; i < this->Offsets[cell + 1]; ++i)
      {
        const Edge& edge = this->Edges[this->Entries[i]];
        const Eigen::Vector2d edgeAlong = edge.To.Pixel - edge.From.Pixel;
        const double area = cross(along, edgeAlong);
        if (area == 0.0)
        {
          continue; // along each other: other edges tell where something begins
        }
        const Eigen::Vector2d between = edge.From.Pixel - from.Pixel;
        const double here = cross(between, edgeAlong) / area;
        const double there = cross(between, along) / area;
        if (!(here > 0.0 && here < 1.0 && there >= -Slack && there <= 1.0 + Slack))
        {
          continue;
        }
        const double place = this->Projection.UndoPerspective(here, from.Depth, to.Depth);
        const double edgePlace =
          this->Projection.UndoPerspective(there, edge.From.Depth, edge.To.Depth);
        const double depth = from.Depth + place * (to.Depth - from.Depth);
        const double edgeDepth = edge.From.Depth + edgePlace * (edge.To.Depth - edge.From.Depth);
        if (edgeDepth <= depth)
        {
          places.push_back(place);
        }
      }
    });
}
}
