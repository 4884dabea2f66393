// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprRandomSeeds.h"

#include "nprArrayNames.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Core>

namespace npr
{
namespace
{
constexpr int MostSteps = 16; // downhill from one seed
constexpr double LeastChance = 1.0e-4;
}

//------------------------------------------------------------------------------
RandomSeeds::RandomSeeds(const LineSurface& surface, const std::vector<Index>& candidates)
  : Surface(surface), Candidates(candidates), Found(surface.GetMesh().GetNumberOfTriangles(), 0)
{
  const bool hasNormals = surface.HasArray(names::Normals);
  const auto getNormal = [&surface](Index point) -> Eigen::Vector3d
  {
    return { surface.GetComponent(names::Normals, 0)[point],
      surface.GetComponent(names::Normals, 1)[point],
      surface.GetComponent(names::Normals, 2)[point] };
  };
  double sum = 0.0;
  this->Chances.reserve(candidates.size());
  for (const Index t : candidates)
  {
    double turn = 1.0;
    if (hasNormals)
    {
      const TriangleMesh::Triangle& c = surface.GetMesh().GetTriangle(t);
      const std::array<Eigen::Vector3d, 3> n = { getNormal(c[0]), getNormal(c[1]),
        getNormal(c[2]) };
      turn = std::max({ (n[0] - n[1]).norm(), (n[1] - n[2]).norm(), (n[2] - n[0]).norm() });
    }
    sum += std::isfinite(turn) ? std::max(turn, LeastChance) : LeastChance;
    this->Chances.push_back(sum);
  }
}

//------------------------------------------------------------------------------
const std::vector<RandomSeeds::Index>& RandomSeeds::Find(std::size_t count, const Ask& ask)
{
  std::vector<Index> last;
  last.swap(this->Triangles);
  for (const Index triangle : last)
  {
    this->Follow(triangle, ask);
  }
  const double all = this->Chances.empty() ? 0.0 : this->Chances.back();
  std::uniform_real_distribution<double> pick(0.0, all);
  for (std::size_t i = 0; i < count && all > 0.0; ++i)
  {
    const auto place =
      std::upper_bound(this->Chances.begin(), std::prev(this->Chances.end()), pick(this->Random));
    Index triangle = this->Candidates[place - this->Chances.begin()];
    for (int step = 0; step < MostSteps; ++step)
    {
      const Answer answer = ask(triangle);
      if (answer.IsCrossed)
      {
        this->Follow(triangle, ask);
        break;
      }
      // Away from the corner that is farthest from a line.
      const int farthest =
        static_cast<int>(std::max_element(answer.Distances.begin(), answer.Distances.end()) -
          answer.Distances.begin());
      const Index twin = this->Surface.GetTwin(3 * triangle + (farthest + 1) % 3);
      if (twin == LineSurface::NoTwin)
      {
        break;
      }
      triangle = twin / 3;
    }
  }
  for (const Index triangle : this->Triangles)
  {
    this->Found[triangle] = 0;
  }
  std::sort(this->Triangles.begin(), this->Triangles.end());
  return this->Triangles;
}

//------------------------------------------------------------------------------
void RandomSeeds::Follow(Index first, const Ask& ask)
{
  this->Open.assign(1, first);
  while (!this->Open.empty())
  {
    const Index triangle = this->Open.back();
    this->Open.pop_back();
    if (this->Found[triangle] || !ask(triangle).IsCrossed)
    {
      continue;
    }
    this->Found[triangle] = 1;
    this->Triangles.push_back(triangle);
    for (int e = 0; e < 3; ++e)
    {
      const Index twin = this->Surface.GetTwin(3 * triangle + e);
      if (twin != LineSurface::NoTwin && !this->Found[twin / 3])
      {
        this->Open.push_back(twin / 3);
      }
    }
  }
}
}
