// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprLineClusters.h"

#include "nprArrayNames.h"
#include "nprLanes.h"

#include <vtkSMPTools.h>

#include <algorithm>
#include <cmath>

#include <Eigen/Core>

namespace npr
{
namespace
{
// More than single precision can be wrong by in a bound of n.v.
constexpr float Margin = 1.0e-4f;
}

//------------------------------------------------------------------------------
LineClusters::LineClusters(const LineSurface& surface)
  : Surface(surface),
    NumberOfClusters(
      (surface.GetMesh().GetNumberOfTriangles() + TrianglesOfCluster - 1) / TrianglesOfCluster),
    NumberOfGroups((NumberOfClusters + ClustersOfGroup - 1) / ClustersOfGroup),
    NumberOfBlocks((surface.GetMesh().GetNumberOfPoints() + PointsOfBlock - 1) / PointsOfBlock)
{
  this->FindBlocks();
  this->FindBlocksAround();
  this->Clusters.Resize(this->NumberOfClusters);
  this->Groups.Resize(this->NumberOfGroups);
  this->UpdateBounds();
}

//------------------------------------------------------------------------------
LineClusters::Index LineClusters::GetTriangleEnd(Index cluster) const
{
  return std::min(
    (cluster + 1) * TrianglesOfCluster, this->Surface.GetMesh().GetNumberOfTriangles());
}

//------------------------------------------------------------------------------
void LineClusters::FindBlocks()
{
  this->BlockOffsets.assign(1, 0);
  std::vector<Index> blocks;
  for (Index cluster = 0; cluster < this->NumberOfClusters; ++cluster)
  {
    blocks.clear();
    for (Index t = this->GetFirstTriangle(cluster); t < this->GetTriangleEnd(cluster); ++t)
    {
      for (const Index point : this->Surface.GetMesh().GetTriangle(t))
      {
        const Index block = point / PointsOfBlock;
        if (std::find(blocks.rbegin(), blocks.rend(), block) == blocks.rend())
        {
          blocks.push_back(block);
        }
      }
    }
    this->Blocks.insert(this->Blocks.end(), blocks.begin(), blocks.end());
    this->BlockOffsets.push_back(static_cast<Index>(this->Blocks.size()));
  }
}

//------------------------------------------------------------------------------
// Neighbours share a triangle, and so a cluster.
void LineClusters::FindBlocksAround()
{
  std::vector<std::vector<Index>> around(this->NumberOfBlocks);
  for (Index cluster = 0; cluster < this->NumberOfClusters; ++cluster)
  {
    for (const Index* block = this->BlocksBegin(cluster); block != this->BlocksEnd(cluster);
         ++block)
    {
      around[*block].insert(
        around[*block].end(), this->BlocksBegin(cluster), this->BlocksEnd(cluster));
    }
  }
  this->AroundOffsets.assign(1, 0);
  for (std::vector<Index>& blocks : around)
  {
    std::sort(blocks.begin(), blocks.end());
    blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
    this->BlocksAround.insert(this->BlocksAround.end(), blocks.begin(), blocks.end());
    this->AroundOffsets.push_back(static_cast<Index>(this->BlocksAround.size()));
  }
}

//------------------------------------------------------------------------------
void LineClusters::UpdateBounds()
{
  vtkSMPTools::For(0, this->NumberOfGroups,
    [this](vtkIdType begin, vtkIdType end)
    {
      for (Index group = static_cast<Index>(begin); group < end; ++group)
      {
        const Index first = group * ClustersOfGroup;
        const Index last = std::min(first + ClustersOfGroup, this->NumberOfClusters);
        for (Index cluster = first; cluster < last; ++cluster)
        {
          this->Clusters.Measure(
            this->Surface, this->GetFirstTriangle(cluster), this->GetTriangleEnd(cluster), cluster);
        }
        this->Groups.Measure(
          this->Surface, this->GetFirstTriangle(first), this->GetTriangleEnd(last - 1), group);
      }
    });
}

//------------------------------------------------------------------------------
void LineClusters::Bounds::Resize(std::size_t size)
{
  for (int i = 0; i < 3; ++i)
  {
    this->Centres[i].resize(size);
    this->Axes[i].resize(size);
  }
  this->Radii.resize(size);
  this->Cosines.resize(size);
  this->Sines.resize(size);
}

//------------------------------------------------------------------------------
void LineClusters::Bounds::Measure(const LineSurface& surface, Index begin, Index end, Index place)
{
  const TriangleMesh& mesh = surface.GetMesh();
  std::array<const float*, 3> normals = { nullptr, nullptr, nullptr };
  if (surface.HasArray(names::Normals))
  {
    for (int i = 0; i < 3; ++i)
    {
      normals[i] = surface.GetComponent(names::Normals, i);
    }
  }
  const auto getNormal = [&normals](Index point) -> Eigen::Vector3f {
    return { normals[0][point], normals[1][point], normals[2][point] };
  };

  Eigen::Vector3f low = mesh.GetPoint(mesh.GetTriangle(begin)[0]);
  Eigen::Vector3f high = low;
  Eigen::Vector3f axis = Eigen::Vector3f::Zero();
  bool isKnown = normals[0] != nullptr;
  for (Index t = begin; t < end; ++t)
  {
    for (const Index point : mesh.GetTriangle(t))
    {
      low = low.cwiseMin(mesh.GetPoint(point));
      high = high.cwiseMax(mesh.GetPoint(point));
      if (isKnown)
      {
        axis += getNormal(point);
      }
    }
  }
  const Eigen::Vector3f centre = low + 0.5f * (high - low);
  axis.normalize();
  isKnown = isKnown && axis.allFinite();
  float square = 0.0f;
  float cosine = 1.0f;
  for (Index t = begin; t < end; ++t)
  {
    for (const Index point : mesh.GetTriangle(t))
    {
      square = std::max(square, (mesh.GetPoint(point) - centre).squaredNorm());
      if (isKnown)
      {
        const Eigen::Vector3f normal = getNormal(point);
        const float length = normal.norm();
        // Written so that what is not a number makes the cone unknown.
        const float here = normal.dot(axis) / length;
        isKnown = here >= -1.01f;
        cosine = std::min(cosine, here);
      }
    }
  }
  cosine = isKnown ? std::max(cosine, -1.0f) : -1.0f;
  for (int i = 0; i < 3; ++i)
  {
    this->Centres[i][place] = centre[i];
    this->Axes[i][place] = isKnown ? axis[i] : 0.0f;
  }
  this->Radii[place] = std::sqrt(square);
  this->Cosines[place] = cosine;
  this->Sines[place] = std::sqrt(std::max(0.0f, 1.0f - cosine * cosine));
}

//------------------------------------------------------------------------------
// Appends those from begin to end where n.v may be in the range.
void LineClusters::Bounds::FindFacing(const LineView& view, const std::array<float, 2>& range,
  Index begin, Index end, std::vector<Index>& found) const
{
  for (Index first = begin; first < end; first += NumberOfLanes)
  {
    const int count = static_cast<int>(std::min<Index>(NumberOfLanes, end - first));
    std::array<float, NumberOfLanes> may;
    Store(this->MayFace(view, range,
            [first, count](const std::vector<float>& values)
            {
              return count == NumberOfLanes ? Load<Lanes>(values.data() + first)
                                            : LoadFirst<Lanes>(values.data() + first, count);
            }),
      may.data());
    for (int i = 0; i < count; ++i)
    {
      if (may[i] != 0.0f)
      {
        found.push_back(first + i);
      }
    }
  }
}

//------------------------------------------------------------------------------
// Not 0 in the lanes where n.v may be in the range. Comparisons are written so that what is not a
// number may be anything.
template<typename Loader>
Lanes LineClusters::Bounds::MayFace(
  const LineView& view, const std::array<float, 2>& range, const Loader& load) const
{
  const Lanes zero = {};
  const Lanes one = zero + 1.0f;
  const Vector3<Lanes> eye = { view.Eye[0] - view.Perspective * load(this->Centres[0]),
    view.Eye[1] - view.Perspective * load(this->Centres[1]),
    view.Eye[2] - view.Perspective * load(this->Centres[2]) };
  const Vector3<Lanes> axis = { load(this->Axes[0]), load(this->Axes[1]), load(this->Axes[2]) };
  const Lanes cosineOfCone = load(this->Cosines);
  const Lanes sineOfCone = load(this->Sines);
  const Lanes distance = SquareRoot(Dot(eye, eye));
  const Lanes radius = view.Perspective * load(this->Radii);
  const Lanes perDistance = 1.0f / distance;
  // How far a normal may be from the axis, and the direction of the eye from that at the centre, in
  // sum; and how far apart the axis and the eye are at the centre.
  const Lanes spreadSine = radius * perDistance;
  const Lanes spreadRest = one - spreadSine * spreadSine;
  const Lanes spreadCosine = SquareRoot(Lanes(spreadRest > zero ? spreadRest : zero));
  const Lanes cosine = cosineOfCone * spreadCosine - sineOfCone * spreadSine;
  const Lanes sine = sineOfCone * spreadCosine + cosineOfCone * spreadSine;
  const Lanes middle = Dot(axis, eye) * perDistance;
  const Lanes acrossRest = one - middle * middle;
  const Lanes across = SquareRoot(Lanes(acrossRest > zero ? acrossRest : zero));
  const Lanes low = middle <= -cosine ? -one : Lanes(middle * cosine - across * sine);
  const Lanes high = middle >= cosine ? one : Lanes(middle * cosine + across * sine);
  const Lanes inRange =
    low <= range[1] + Margin ? Lanes(high >= range[0] - Margin ? one : zero) : zero;
  const Lanes known =
    distance > radius ? Lanes(cosineOfCone > -one ? Lanes(sine >= zero ? one : zero) : zero) : zero;
  return known > zero ? inRange : one;
}

//------------------------------------------------------------------------------
void LineClusters::FindFacing(const LineView& view, const std::array<float, 2>& range,
  Index firstGroup, Index lastGroup, std::vector<Index>& clusters) const
{
  std::vector<Index> groups;
  this->Groups.FindFacing(view, range, firstGroup, lastGroup, groups);
  for (const Index group : groups)
  {
    const Index first = group * ClustersOfGroup;
    this->Clusters.FindFacing(
      view, range, first, std::min(first + ClustersOfGroup, this->NumberOfClusters), clusters);
  }
}
}
