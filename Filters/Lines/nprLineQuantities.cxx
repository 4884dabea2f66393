// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprLineQuantities.h"

#include "nprArrayNames.h"

#include <vtkFloatArray.h>

#include <algorithm>
#include <array>
#include <cstring>

#include <Eigen/Geometry>

namespace npr
{
namespace
{
using Index = TriangleMesh::Index;

/// Where a place lies on a triangle: the shares of its corners. Of a triangle without an area, on
/// its longest edge.
Eigen::Vector3d FindShares(
  const TriangleMesh& mesh, const TriangleMesh::Triangle& corners, const Eigen::Vector3d& place)
{
  std::array<Eigen::Vector3d, 3> points;
  for (int i = 0; i < 3; ++i)
  {
    points[i] = mesh.GetPoint(corners[i]).cast<double>();
  }
  const Eigen::Vector3d across = (points[1] - points[0]).cross(points[2] - points[0]);
  const double square = across.squaredNorm();
  std::array<double, 3> lengths; // squared, of the edges after each corner
  for (int i = 0; i < 3; ++i)
  {
    lengths[i] = (points[(i + 1) % 3] - points[i]).squaredNorm();
  }
  const int longest =
    static_cast<int>(std::max_element(lengths.begin(), lengths.end()) - lengths.begin());
  constexpr double flat = 1e-12;
  Eigen::Vector3d shares = Eigen::Vector3d::Zero();
  if (square > flat * lengths[longest] * lengths[longest])
  {
    for (int i = 0; i < 3; ++i)
    {
      const Eigen::Vector3d& next = points[(i + 1) % 3];
      const Eigen::Vector3d& last = points[(i + 2) % 3];
      shares[i] = std::max((next - place).cross(last - place).dot(across), 0.0);
    }
  }
  if (!(shares.sum() > 0.0))
  {
    const int next = (longest + 1) % 3;
    const double length = std::max(lengths[longest], 1e-300);
    const double t = (place - points[longest]).dot(points[next] - points[longest]) / length;
    shares[next] = std::min(std::max(t, 0.0), 1.0);
    shares[longest] = 1.0 - shares[next];
  }
  shares /= shares.sum();
  // On an edge, the corner across has no share: not even one that is not a number.
  constexpr double least = 1e-9;
  return (shares.array() < least).select(0.0, shares);
}

/// Directions without a sign do not cancel each other out.
bool IsAxis(const std::string& name)
{
  return name == "e1" || name == "e2" || name == names::PrincipalDirection1 ||
    name == names::PrincipalDirection2;
}
}

//------------------------------------------------------------------------------
LineQuantity::LineQuantity(const std::string& name) : Name(name), Quantity(FindViewQuantity(name))
{
}

//------------------------------------------------------------------------------
std::vector<vtkNPRLineDefinition::RequiredArray> LineQuantity::GetRequiredArrays() const
{
  if (this->Quantity)
  {
    return this->Quantity->Arrays;
  }
  return { { this->Name.c_str(), 0, nullptr } };
}

//------------------------------------------------------------------------------
int LineQuantity::GetNumberOfComponents(const LineSurface& surface) const
{
  return this->Quantity ? this->Quantity->Components
                        : surface.GetNumberOfComponents(this->Name.c_str());
}

//------------------------------------------------------------------------------
void LineQuantity::Write(const LineSurface& surface, const LineView& view, const LineChains& chains,
  std::size_t chain, vtkIdType firstPoint, vtkFloatArray* values) const
{
  const TriangleMesh& mesh = surface.GetMesh();
  const std::size_t begin = chains.Begins[chain];
  const std::size_t size = chains.GetSize(chain);
  std::vector<Index> corners; // three for each vertex
  for (std::size_t v = begin; v < begin + size; ++v)
  {
    const TriangleMesh::Triangle& triangle = mesh.GetTriangle(chains.Triangles[v]);
    corners.insert(corners.end(), triangle.begin(), triangle.end());
  }
  const int components = this->GetNumberOfComponents(surface);
  std::vector<std::vector<double>> atCorners(components, std::vector<double>(corners.size()));
  for (int c = 0; c < components; ++c)
  {
    if (this->Quantity)
    {
      const PointSpan points =
        PointSpan::List(corners.data(), static_cast<vtkIdType>(corners.size()));
      this->Quantity->Evaluate(surface, view, points, c, atCorners[c].data());
    }
    else
    {
      const float* const component = surface.GetComponent(this->Name.c_str(), c);
      std::transform(corners.begin(), corners.end(), atCorners[c].begin(),
        [component](Index corner) { return component[corner]; });
    }
  }
  const bool isAxis = IsAxis(this->Name);
  for (std::size_t i = 0; i < size; ++i)
  {
    const Eigen::Vector3d shares =
      FindShares(mesh, mesh.GetTriangle(chains.Triangles[begin + i]), chains.Positions[begin + i]);
    Eigen::Vector3d signs = Eigen::Vector3d::Ones();
    for (int corner = 1; isAxis && corner < 3; ++corner)
    {
      double product = 0.0;
      for (const std::vector<double>& component : atCorners)
      {
        product += component[3 * i] * component[3 * i + corner];
      }
      signs[corner] = product < 0.0 ? -1.0 : 1.0;
    }
    for (int c = 0; c < components; ++c)
    {
      double value = 0.0;
      for (int corner = 0; corner < 3; ++corner)
      {
        value += shares[corner] == 0.0
          ? 0.0
          : shares[corner] * signs[corner] * atCorners[c][3 * i + corner];
      }
      values->SetTypedComponent(
        firstPoint + static_cast<vtkIdType>(i), c, static_cast<float>(value));
    }
  }
}
}
