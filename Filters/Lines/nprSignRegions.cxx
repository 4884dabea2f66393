// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprSignRegions.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <numeric>
#include <queue>
#include <utility>

namespace npr
{
namespace
{
using Index = TriangleMesh::Index;

// Sets of numbers, each known by one of them.
class DisjointSets
{
public:
  explicit DisjointSets(std::size_t size) : Parents(size)
  {
    std::iota(this->Parents.begin(), this->Parents.end(), Index(0));
  }
  Index Find(Index member)
  {
    while (this->Parents[member] != member)
    {
      this->Parents[member] = this->Parents[this->Parents[member]];
      member = this->Parents[member];
    }
    return member;
  }
  void Join(Index root, Index other) { this->Parents[other] = root; }

private:
  std::vector<Index> Parents;
};

class SignRegions
{
public:
  SignRegions(
    const LineSurface& surface, const std::vector<float>& density, const std::vector<float>& field)
    : Surface(surface), Field(field)
  {
    this->Find();
    this->Weigh(density);
    this->Connect();
  }

  void Merge(double least)
  {
    using Entry = std::pair<double, Index>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> lightest;
    const auto push = [&](Index region)
    {
      if (this->Weights[region] < least)
      {
        lightest.emplace(this->Weights[region], region);
      }
    };
    for (Index region = 0; region < static_cast<Index>(this->Weights.size()); ++region)
    {
      push(region);
    }
    while (!lightest.empty())
    {
      const auto [weight, region] = lightest.top();
      lightest.pop();
      // Entries of regions that have grown since are followed by others.
      if (this->Merged.Find(region) == region && this->Weights[region] == weight)
      {
        const Index grown = this->MergeAround(region);
        if (grown != region)
        {
          push(grown);
        }
      }
    }
  }

  bool IsPositive(Index point)
  {
    return this->Positive[this->Merged.Find(this->RegionOfPoint[point])] != 0;
  }
  bool HasRegion(Index point) const { return this->RegionOfPoint[point] >= 0; }

private:
  bool IsNumber(Index point) const { return std::isfinite(this->Field[point]); }

  // As the extractor, which counts zeros as above.
  void Find()
  {
    const TriangleMesh& mesh = this->Surface.GetMesh();
    const Index numberOfPoints = mesh.GetNumberOfPoints();
    DisjointSets sets(numberOfPoints);
    for (const TriangleMesh::Triangle& corners : mesh.GetTriangles())
    {
      for (int i = 0; i < 3; ++i)
      {
        const Index a = corners[i];
        const Index b = corners[(i + 1) % 3];
        if (this->IsNumber(a) && this->IsNumber(b) &&
          (this->Field[a] >= 0.0f) == (this->Field[b] >= 0.0f))
        {
          const Index rootA = sets.Find(a);
          const Index rootB = sets.Find(b);
          sets.Join(std::min(rootA, rootB), std::max(rootA, rootB));
        }
      }
    }
    // The root is the first point of its region.
    this->RegionOfPoint.assign(numberOfPoints, -1);
    for (Index point = 0; point < numberOfPoints; ++point)
    {
      if (!this->IsNumber(point))
      {
        continue;
      }
      const Index root = sets.Find(point);
      if (root == point)
      {
        this->RegionOfPoint[point] = static_cast<Index>(this->Positive.size());
        this->Positive.push_back(this->Field[point] >= 0.0f ? 1 : 0);
      }
      this->RegionOfPoint[point] = this->RegionOfPoint[root];
    }
    this->Merged = DisjointSets(this->Positive.size());
  }

  void Weigh(const std::vector<float>& density)
  {
    const TriangleMesh& mesh = this->Surface.GetMesh();
    this->Weights.assign(this->Positive.size(), 0.0);
    for (Index triangle = 0; triangle < mesh.GetNumberOfTriangles(); ++triangle)
    {
      const double third = mesh.GetAreaNormal(triangle).cast<double>().norm() / 6.0;
      for (const Index corner : mesh.GetTriangle(triangle))
      {
        if (this->HasRegion(corner))
        {
          this->Weights[this->RegionOfPoint[corner]] += this->Surface.IsGhost(triangle)
            ? std::numeric_limits<double>::infinity()
            : third * std::abs(double(density[corner]));
        }
      }
    }
  }

  void Connect()
  {
    std::vector<std::pair<Index, Index>> pairs;
    for (const TriangleMesh::Triangle& corners : this->Surface.GetMesh().GetTriangles())
    {
      for (int i = 0; i < 3; ++i)
      {
        const Index a = this->RegionOfPoint[corners[i]];
        const Index b = this->RegionOfPoint[corners[(i + 1) % 3]];
        if (a >= 0 && b >= 0 && a != b)
        {
          pairs.emplace_back(std::min(a, b), std::max(a, b));
        }
      }
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    this->Neighbours.resize(this->Positive.size());
    for (const auto& [a, b] : pairs)
    {
      this->Neighbours[a].push_back(b);
      this->Neighbours[b].push_back(a);
    }
  }

  // Makes a region and all around it, which have the other sign, one of that sign. Returns it, or
  // the region if there is nothing around it.
  Index MergeAround(Index region)
  {
    std::vector<Index> around;
    around.swap(this->Neighbours[region]);
    for (Index& neighbour : around)
    {
      neighbour = this->Merged.Find(neighbour);
    }
    std::sort(around.begin(), around.end());
    around.erase(std::unique(around.begin(), around.end()), around.end());
    // What it has swallowed goes by its name now.
    around.erase(std::remove(around.begin(), around.end(), region), around.end());
    if (around.empty())
    {
      return region;
    }
    // The longest list of neighbours stays where it is.
    const Index host = *std::max_element(around.begin(), around.end(),
      [this](Index a, Index b) { return this->Neighbours[a].size() < this->Neighbours[b].size(); });
    for (const Index neighbour : around)
    {
      if (neighbour != host)
      {
        std::vector<Index>& moved = this->Neighbours[neighbour];
        this->Neighbours[host].insert(this->Neighbours[host].end(), moved.begin(), moved.end());
        std::vector<Index>().swap(moved);
        this->Weights[host] += this->Weights[neighbour];
        this->Merged.Join(host, neighbour);
      }
    }
    this->Weights[host] -= this->Weights[region];
    this->Merged.Join(host, region);
    return host;
  }

  const LineSurface& Surface;
  const std::vector<float>& Field;
  std::vector<Index> RegionOfPoint; // -1 for none
  std::vector<char> Positive;
  std::vector<double> Weights;
  std::vector<std::vector<Index>> Neighbours; // some of them by the numbers that they had before
  DisjointSets Merged = DisjointSets(0);
};
}

//------------------------------------------------------------------------------
void MergeLightRegions(const LineSurface& surface, const std::vector<float>& density, double least,
  std::vector<float>& field)
{
  SignRegions regions(surface, density, field);
  regions.Merge(least);
  for (Index point = 0; point < static_cast<Index>(field.size()); ++point)
  {
    if (regions.HasRegion(point) && regions.IsPositive(point) != (field[point] >= 0.0f))
    {
      // Zero is above.
      field[point] = field[point] == 0.0f ? -std::numeric_limits<float>::min() : -field[point];
    }
  }
}
}
