// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// What lies beside what: the part of TriangleMesh that is built only on demand.
#include "nprTriangleMesh.h"

#include <vtkSMPTools.h>

#include <algorithm>
#include <array>
#include <utility>

namespace npr
{
namespace
{
/// Below this it takes longer to start threads than to count.
constexpr vtkIdType LeastTrianglesOfThread = 50000;
/// Each thread counts for all points: more threads would mean more memory, and time to add up.
constexpr vtkIdType MostThreads = 8;
}

//------------------------------------------------------------------------------
void TriangleMesh::BuildIncidence()
{
  // Each part of the triangles counts for itself; from the counts of all follows where its first
  // triangle at a point goes. So the order is ascending, however many parts there are.
  const vtkIdType numberOfTriangles = this->GetNumberOfTriangles();
  const vtkIdType numberOfParts =
    std::clamp<vtkIdType>(std::min<vtkIdType>(vtkSMPTools::GetEstimatedNumberOfThreads(),
                            numberOfTriangles / LeastTrianglesOfThread),
      1, MostThreads);
  std::vector<std::vector<Index>> next(numberOfParts);
  const auto forEachPart = [&](const auto& function)
  {
    vtkSMPTools::For(0, numberOfParts, 1,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType part = begin; part < end; ++part)
        {
          function(next[part], part * numberOfTriangles / numberOfParts,
            (part + 1) * numberOfTriangles / numberOfParts);
        }
      });
  };
  forEachPart(
    [&](std::vector<Index>& counts, vtkIdType begin, vtkIdType end)
    {
      counts.assign(this->Points.size(), 0);
      for (vtkIdType t = begin; t < end; ++t)
      {
        for (Index corner : this->Triangles[t])
        {
          ++counts[corner];
        }
      }
    });
  this->IncidentOffsets.resize(this->Points.size() + 1);
  Index offset = 0;
  for (std::size_t i = 0; i < this->Points.size(); ++i)
  {
    this->IncidentOffsets[i] = offset;
    for (std::vector<Index>& counts : next)
    {
      offset += std::exchange(counts[i], offset);
    }
  }
  this->IncidentOffsets.back() = offset;
  this->Incident.resize(static_cast<std::size_t>(offset) + LookAhead);
  forEachPart(
    [&](std::vector<Index>& places, vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType t = begin; t < end; ++t)
      {
        for (Index corner : this->Triangles[t])
        {
          this->Incident[places[corner]++] = static_cast<Index>(t);
        }
      }
    });
}

//------------------------------------------------------------------------------
void TriangleMesh::BuildNeighbours()
{
  if (this->IncidentOffsets.empty())
  {
    this->BuildIncidence();
  }
  this->Neighbours.resize(this->Triangles.size());
  vtkSMPTools::For(0, this->GetNumberOfTriangles(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType t = begin; t < end; ++t)
      {
        const Triangle& corners = this->Triangles[t];
        for (int e = 0; e < 3; ++e)
        {
          // The point with fewer triangles is searched: hubs of fans may have thousands.
          Index from = corners[e];
          Index to = corners[(e + 1) % 3];
          if (this->GetNumberOfIncident(to) < this->GetNumberOfIncident(from))
          {
            std::swap(from, to);
          }
          Index neighbour = Boundary;
          for (const Index* other = this->IncidentBegin(from); other != this->IncidentEnd(from);
               ++other)
          {
            const Triangle& o = this->Triangles[*other];
            if (*other != t && (o[0] == to || o[1] == to || o[2] == to))
            {
              neighbour = neighbour == Boundary ? *other : NonManifold;
            }
          }
          this->Neighbours[t][e] = neighbour;
        }
      }
    });
}

//------------------------------------------------------------------------------
int TriangleMesh::CountTrianglesAtEdge(Index from, Index to) const
{
  if (this->GetNumberOfIncident(to) < this->GetNumberOfIncident(from))
  {
    std::swap(from, to);
  }
  int count = 0;
  for (const Index* t = this->IncidentBegin(from); t != this->IncidentEnd(from); ++t)
  {
    const Triangle& corners = this->Triangles[*t];
    count += corners[0] == to || corners[1] == to || corners[2] == to;
  }
  return count;
}

//------------------------------------------------------------------------------
template<int Capacity>
bool TriangleMesh::IsClosedFan(Index point) const
{
  const Index size = this->GetNumberOfIncident(point);
  if (size > Capacity)
  {
    return false;
  }
  std::array<Index, Capacity> enters;
  std::array<Index, Capacity> leaves;
  enters.fill(-1);
  for (Index i = 0; i < size; ++i)
  {
    const Triangle& corners = this->Triangles[this->IncidentBegin(point)[i]];
    const int here = corners[0] == point ? 0 : (corners[1] == point ? 1 : 2);
    enters[i] = corners[here == 2 ? 0 : here + 1];
    leaves[i] = corners[here == 0 ? 2 : here - 1];
  }
  unsigned int followed = 0;
  for (Index i = 0; i < size; ++i)
  {
    unsigned int followers = 0;
    for (int j = 0; j < Capacity; ++j)
    {
      followers |= enters[j] == leaves[i] ? 1u << j : 0u;
    }
    if (followers == 0 || (followers & (followers - 1)) != 0)
    {
      return false;
    }
    followed |= followers;
  }
  return followed == (1u << size) - 1u;
}

//------------------------------------------------------------------------------
bool TriangleMesh::IsBorderPoint(Index point) const
{
  if (this->IsClosedFan<8>(point) || this->IsClosedFan<16>(point))
  {
    return false;
  }
  // Borders, triangles that disagree about the orientation, and hubs of fans.
  for (const Index* t = this->IncidentBegin(point); t != this->IncidentEnd(point); ++t)
  {
    for (Index corner : this->Triangles[*t])
    {
      if (corner != point && this->CountTrianglesAtEdge(point, corner) != 2)
      {
        return true;
      }
    }
  }
  return false;
}

//------------------------------------------------------------------------------
void TriangleMesh::BuildBorder()
{
  if (this->IncidentOffsets.empty())
  {
    this->BuildIncidence();
  }
  this->Border.resize(this->Points.size());
  vtkSMPTools::For(0, this->GetNumberOfPoints(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        this->Border[i] = this->IsBorderPoint(static_cast<Index>(i));
      }
    });
}

//------------------------------------------------------------------------------
void TriangleMesh::BuildEdges()
{
  if (this->IncidentOffsets.empty())
  {
    this->BuildIncidence();
  }
  const Index numberOfPoints = this->GetNumberOfPoints();
  const auto collect = [this](Index point, std::vector<Index>& ends)
  {
    ends.clear();
    for (const Index* t = this->IncidentBegin(point); t != this->IncidentEnd(point); ++t)
    {
      for (Index corner : this->Triangles[*t])
      {
        if (corner > point)
        {
          ends.push_back(corner);
        }
      }
    }
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  };
  this->EdgeOffsets.assign(numberOfPoints + 1, 0);
  vtkSMPTools::For(0, numberOfPoints,
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<Index> ends;
      for (vtkIdType i = begin; i < end; ++i)
      {
        collect(static_cast<Index>(i), ends);
        this->EdgeOffsets[i + 1] = static_cast<Index>(ends.size());
      }
    });
  for (Index i = 0; i < numberOfPoints; ++i)
  {
    this->EdgeOffsets[i + 1] += this->EdgeOffsets[i];
  }
  this->EdgeStarts.resize(this->EdgeOffsets.back());
  this->EdgeEnds.resize(this->EdgeOffsets.back());
  vtkSMPTools::For(0, numberOfPoints,
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<Index> ends;
      for (vtkIdType i = begin; i < end; ++i)
      {
        collect(static_cast<Index>(i), ends);
        const Index offset = this->EdgeOffsets[i];
        std::copy(ends.begin(), ends.end(), this->EdgeEnds.begin() + offset);
        std::fill_n(this->EdgeStarts.begin() + offset, ends.size(), static_cast<Index>(i));
      }
    });
}

//------------------------------------------------------------------------------
TriangleMesh::Index TriangleMesh::FindEdge(Index a, Index b) const
{
  const auto first = this->EdgeEnds.begin() + this->EdgeOffsets[std::min(a, b)];
  const auto last = this->EdgeEnds.begin() + this->EdgeOffsets[std::min(a, b) + 1];
  return static_cast<Index>(std::lower_bound(first, last, std::max(a, b)) - this->EdgeEnds.begin());
}
}
