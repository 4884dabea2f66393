// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprNeighbourhood.h"

#include <vtkSMPTools.h>

#include <algorithm>
#include <cstddef>

namespace npr
{
//------------------------------------------------------------------------------
PointGraph::PointGraph(const TriangleMesh& mesh)
{
  const auto collect = [&mesh](Index point, std::vector<Index>& others)
  {
    others.clear();
    for (const Index* t = mesh.IncidentBegin(point); t != mesh.IncidentEnd(point); ++t)
    {
      for (Index corner : mesh.GetTriangle(*t))
      {
        if (corner != point)
        {
          others.push_back(corner);
        }
      }
    }
    std::sort(others.begin(), others.end());
    others.erase(std::unique(others.begin(), others.end()), others.end());
  };
  const Index size = mesh.GetNumberOfPoints();
  this->Rows.resize(size);
  vtkSMPTools::For(0, size,
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<Index> others;
      for (vtkIdType i = begin; i < end; ++i)
      {
        const auto point = static_cast<Index>(i);
        Row& row = this->Rows[i];
        row.fill(point);
        collect(point, others);
        if (others.size() <= row.size())
        {
          std::copy(others.begin(), others.end(), row.begin());
        }
        else
        {
          row[0] = -1;
        }
      }
    });
  std::vector<Index> others;
  for (Index i = 0; i < size; ++i)
  {
    if (!this->FindRow(i))
    {
      collect(i, others);
      this->Rows[i][0] = -1 - static_cast<Index>(this->Long.size());
      this->Rows[i][1] = static_cast<Index>(others.size());
      this->Long.insert(this->Long.end(), others.begin(), others.end());
    }
  }
}

//------------------------------------------------------------------------------
std::vector<float> ComputeMeanEdges(const TriangleMesh& mesh, const PointGraph& graph)
{
  using Index = TriangleMesh::Index;
  const auto average = [&](const auto& value, bool self)
  {
    std::vector<float> means(mesh.GetNumberOfPoints(), 0.0f);
    vtkSMPTools::For(0, mesh.GetNumberOfPoints(),
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          const auto point = static_cast<Index>(i);
          double sum = self ? value(point, point) : 0.0;
          for (const Index* other = graph.Begin(point); other != graph.End(point); ++other)
          {
            sum += value(point, *other);
          }
          const auto count = graph.End(point) - graph.Begin(point);
          means[i] = count > 0 ? static_cast<float>(sum / (count + self)) : 0.0f;
        }
      });
    return means;
  };
  const std::vector<float> edges = average([&](Index point, Index other)
    { return (mesh.GetPoint(other) - mesh.GetPoint(point)).cast<double>().norm(); },
    false);
  return average([&](Index, Index other) { return static_cast<double>(edges[other]); }, true);
}

//------------------------------------------------------------------------------
std::vector<OrientedPoint> MakeOrientedPoints(const TriangleMesh& mesh, const Tuples<3>& normals)
{
  std::vector<OrientedPoint> points(mesh.GetNumberOfPoints());
  vtkSMPTools::For(0, mesh.GetNumberOfPoints(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        points[i].Place << mesh.GetPoint(static_cast<TriangleMesh::Index>(i)), 0.0f;
        points[i].Normal << normals[i], 0.0f;
      }
    });
  return points;
}

//------------------------------------------------------------------------------
Neighbourhood::Neighbourhood(const PointGraph& graph, const std::vector<OrientedPoint>& points)
  : Graph(&graph), Points(&points)
{
}

//------------------------------------------------------------------------------
std::uint32_t Neighbourhood::NextStamp()
{
  if (++this->Stamp == 0)
  {
    std::fill(this->PointStamps.begin(), this->PointStamps.end(), 0);
    this->Stamp = 1;
  }
  return this->Stamp;
}

//------------------------------------------------------------------------------
void Neighbourhood::Collect(Index centre, double radius, int rings)
{
  // Here, so that copies for threads that never collect take no room.
  this->PointStamps.resize(this->Points->size(), 0);
  this->Candidates.resize(MaximumSize + PointGraph::RowSize);
  const std::uint32_t stamp = this->NextStamp();
  const OrientedPoint origin = (*this->Points)[centre];
  const auto perRadius = static_cast<float>(1.0 / radius);
  this->Members.assign(1, { Eigen::Vector4f::Zero(), 0.0f, 1.0f, centre });
  this->PointStamps[centre] = stamp;
  std::uint32_t* const stamps = this->PointStamps.data();
  int seen = 0;
  std::size_t first = 0;
  for (int ring = 0; ring < rings && first < this->Members.size(); ++ring)
  {
    // Both steps write first and then decide what stays: whether a point is new, and whether it is
    // near, is a toss-up to the processor, which would stumble over half of the branches.
    Index* const candidates = this->Candidates.data();
    int found = 0;
    const std::size_t last = this->Members.size();
    for (; first < last && seen + found < MaximumSize; ++first)
    {
      const Index point = this->Members[first].Point;
      if (const PointGraph::Row* row = this->Graph->FindRow(point))
      {
        // A row's points are all different (but for itself at the end, which is not new), so that
        // all can be read before any is written, and reading waits for little.
        std::array<int, PointGraph::RowSize> isNew;
        for (int i = 0; i < PointGraph::RowSize; ++i)
        {
          isNew[i] = stamps[(*row)[i]] != stamp;
        }
        for (int i = 0; i < PointGraph::RowSize; ++i)
        {
          const Index other = (*row)[i];
          stamps[other] = stamp;
          candidates[found] = other;
          found += isNew[i];
        }
        continue;
      }
      const Index* const begin = this->Graph->Begin(point);
      const Index* const end = begin +
        std::min<std::ptrdiff_t>(this->Graph->End(point) - begin, MaximumSize - seen - found);
      for (const Index* other = begin; other < end; ++other)
      {
        if (stamps[*other] != stamp)
        {
          stamps[*other] = stamp;
          candidates[found++] = *other;
        }
      }
    }
    first = last;
    seen += found;
    this->Members.resize(last + found);
    Member* member = this->Members.data() + last;
    for (const Index* other = candidates; other < candidates + found; ++other)
    {
      const OrientedPoint& point = (*this->Points)[*other];
      const Eigen::Vector4f offset = point.Place - origin.Place;
      const float squaredDistance = (perRadius * offset).squaredNorm();
      const float turn = origin.Normal.dot(point.Normal);
      member->Offset = offset;
      member->SquaredDistance = squaredDistance;
      member->Turn = turn;
      member->Point = *other;
      member += (squaredDistance < 1.0f) & (turn > 0.0f);
    }
    this->Members.resize(member - this->Members.data());
  }
}
}
