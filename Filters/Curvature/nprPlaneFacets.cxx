// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprPlaneFacets.h"

#include "nprForAll.h"
#include "nprRingMeans.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace npr
{
namespace
{
using Index = TriangleMesh::Index;
using Eigen::Vector3d;

constexpr double LargestTurn = 0.02; // of the quadratic mean
constexpr double TurnByRounding = 1.0e-4;

/// Across the edges of the triangles, the edge after each corner: the square of the turn, and
/// infinite where there is no triangle on the other side, or more than one.
class Turns
{
public:
  explicit Turns(const TriangleMesh& mesh) : Mesh(mesh), Squares(mesh.GetNumberOfTriangles())
  {
    ForAll(this->Squares.size(),
      [this](Index t)
      {
        for (int edge = 0; edge < 3; ++edge)
        {
          this->Squares[t][edge] = this->Measure(t, edge);
        }
      });
  }

  /// At each point the mean over its triangles, by their areas, and then over the rings around.
  /// getMean(point, squares) is that of the edges of one triangle.
  template<typename Function>
  std::vector<float> Average(const Function& getMean) const
  {
    std::vector<float> means(this->Mesh.GetNumberOfPoints());
    ForAll(means.size(),
      [&](Index point)
      {
        double sum = 0.0;
        double areas = 0.0;
        for (const Index* t = this->Mesh.IncidentBegin(point); t != this->Mesh.IncidentEnd(point);
             ++t)
        {
          const double area = this->Mesh.GetAreaNormal(*t).cast<double>().norm();
          sum += area * getMean(point, this->Squares[*t]);
          areas += area;
        }
        means[point] = areas > 0.0 ? static_cast<float>(sum / areas) : 0.0f;
      });
    AverageOverRings(this->Mesh, FacetRings, means);
    return means;
  }

private:
  float Measure(Index triangle, int edge) const
  {
    const TriangleMesh::Triangle& corners = this->Mesh.GetTriangle(triangle);
    Index a = corners[edge];
    Index b = corners[(edge + 1) % 3];
    if (this->Mesh.GetNumberOfIncident(b) < this->Mesh.GetNumberOfIncident(a))
    {
      std::swap(a, b);
    }
    Index other = triangle;
    int count = 0;
    for (const Index* t = this->Mesh.IncidentBegin(a); t != this->Mesh.IncidentEnd(a); ++t)
    {
      const TriangleMesh::Triangle& candidate = this->Mesh.GetTriangle(*t);
      if (*t != triangle && std::find(candidate.begin(), candidate.end(), b) != candidate.end())
      {
        other = *t;
        ++count;
      }
    }
    const Vector3d here = this->Mesh.GetAreaNormal(triangle).cast<double>();
    const Vector3d there = this->Mesh.GetAreaNormal(other).cast<double>();
    const double area = here.norm();
    const double areaThere = there.norm();
    return count == 1 && area > 0.0 && areaThere > 0.0
      ? static_cast<float>((here / area - there / areaThere).squaredNorm())
      : std::numeric_limits<float>::infinity();
  }

  const TriangleMesh& Mesh;
  std::vector<std::array<float, 3>> Squares;
};
}

//------------------------------------------------------------------------------
std::vector<float> MeasurePlaneFacets(const TriangleMesh& mesh)
{
  const Turns turns(mesh);
  const std::vector<float> means = turns.Average(
    [](Index, const std::array<float, 3>& squares)
    {
      double sum = 0.0;
      int count = 0;
      for (const float square : squares)
      {
        sum += std::isfinite(square) ? square : 0.0;
        count += std::isfinite(square) ? 1 : 0;
      }
      return sum / std::max(count, 1);
    });
  return turns.Average(
    [&](Index point, const std::array<float, 3>& squares)
    {
      const double limit = std::max(LargestTurn * LargestTurn * static_cast<double>(means[point]),
        TurnByRounding * TurnByRounding);
      return std::count_if(
               squares.begin(), squares.end(), [limit](float square) { return square <= limit; }) /
        3.0;
    });
}
}
