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
  this->Offsets.assign(size + 1, 0);
  vtkSMPTools::For(0, size,
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<Index> others;
      for (vtkIdType i = begin; i < end; ++i)
      {
        collect(static_cast<Index>(i), others);
        this->Offsets[i + 1] = static_cast<Index>(others.size());
      }
    });
  for (Index i = 0; i < size; ++i)
  {
    this->Offsets[i + 1] += this->Offsets[i];
  }
  this->Neighbours.resize(this->Offsets.back());
  vtkSMPTools::For(0, size,
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<Index> others;
      for (vtkIdType i = begin; i < end; ++i)
      {
        collect(static_cast<Index>(i), others);
        std::copy(others.begin(), others.end(), this->Neighbours.begin() + this->Offsets[i]);
      }
    });
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
Neighbourhood::Neighbourhood(
  const TriangleMesh& mesh, const PointGraph& graph, const Tuples<3>& normals)
  : Mesh(&mesh), Graph(&graph), Normals(&normals)
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
  this->PointStamps.resize(this->Mesh->GetNumberOfPoints(), 0);
  const std::uint32_t stamp = this->NextStamp();
  const TriangleMesh::Vector origin = this->Mesh->GetPoint(centre);
  const Eigen::Vector3f normal = (*this->Normals)[centre];
  const double squaredRadius = radius * radius;
  this->Members.assign(1, { centre, 1.0f, Eigen::Vector3d::Zero(), 0.0 });
  this->Candidates.resize(MaximumSize);
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
    for (; first < last; ++first)
    {
      const Index point = this->Members[first].Point;
      const Index* const begin = this->Graph->Begin(point);
      const auto size =
        std::min<std::ptrdiff_t>(this->Graph->End(point) - begin, MaximumSize - seen - found);
      for (const Index* other = begin; other < begin + size; ++other)
      {
        candidates[found] = *other;
        found += stamps[*other] != stamp;
        stamps[*other] = stamp;
      }
    }
    seen += found;
    this->Members.resize(last + found);
    Member* member = this->Members.data() + last;
    for (const Index* other = candidates; other < candidates + found; ++other)
    {
      const Eigen::Vector3d offset = (this->Mesh->GetPoint(*other) - origin).cast<double>();
      const double squaredDistance = offset.squaredNorm();
      const float turn = normal.dot((*this->Normals)[*other]);
      *member = { *other, turn, offset, squaredDistance };
      member += (squaredDistance < squaredRadius) & (turn > 0.0f);
    }
    this->Members.resize(member - this->Members.data());
  }
}
}
