// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprLineClusters_h
#define nprLineClusters_h

#include "nprLanes.h"
#include "nprLineSurface.h"
#include "vtkNPRFiltersLinesModule.h"

#include <array>
#include <vector>

namespace npr
{
/**
 * @class LineClusters
 * @brief Triangles that lie together, in groups of groups, and what a view can say of all at once.
 *
 * A cluster is a row of triangles in the order of the LineSurface, a group a row of clusters. Each
 * has a ball around its points and a cone around their normals, from which bounds of n.v follow:
 * P. Sander, X. Gu, S. Gortler, H. Hoppe, J. Snyder, "Silhouette clipping", SIGGRAPH 2000.
 *
 * Fields are evaluated over blocks of points; each cluster knows the blocks that hold its points.
 */
class VTKNPRFILTERSLINES_EXPORT LineClusters
{
public:
  using Index = TriangleMesh::Index;
  static constexpr Index TrianglesOfCluster = 32;
  static constexpr Index ClustersOfGroup = 16;
  static constexpr Index PointsOfBlock = 64;

  /// The surface must outlive this; normals are used if it has loaded them.
  explicit LineClusters(const LineSurface& surface);
  /// Finds balls and cones anew, for points or normals that have changed.
  void UpdateBounds();

  Index GetNumberOfClusters() const { return this->NumberOfClusters; }
  Index GetNumberOfGroups() const { return this->NumberOfGroups; }
  Index GetNumberOfBlocks() const { return this->NumberOfBlocks; }
  Index GetFirstTriangle(Index cluster) const { return cluster * TrianglesOfCluster; }
  /// One more than the last triangle.
  Index GetTriangleEnd(Index cluster) const;

  /// The blocks that hold points of a cluster: [Begin, End).
  const Index* BlocksBegin(Index cluster) const
  {
    return this->Blocks.data() + this->BlockOffsets[cluster];
  }
  const Index* BlocksEnd(Index cluster) const
  {
    return this->Blocks.data() + this->BlockOffsets[cluster + 1];
  }

  /// The blocks that hold points of a block and, among others, all their neighbours: [Begin, End).
  const Index* BlocksAroundBegin(Index block) const
  {
    return this->BlocksAround.data() + this->AroundOffsets[block];
  }
  const Index* BlocksAroundEnd(Index block) const
  {
    return this->BlocksAround.data() + this->AroundOffsets[block + 1];
  }

  /// Appends the clusters of groups where n.v may be somewhere in [range[0], range[1]].
  void FindFacing(const LineView& view, const std::array<float, 2>& range, Index firstGroup,
    Index lastGroup, std::vector<Index>& clusters) const;

private:
  /// Of all clusters, or of all groups.
  struct Bounds
  {
    std::array<std::vector<float>, 3> Centres;
    std::vector<float> Radii;
    std::array<std::vector<float>, 3> Axes;
    std::vector<float> Cosines; // of the cone's angle; -1 where nothing is known
    std::vector<float> Sines;
    void Resize(std::size_t size);
    void Measure(const LineSurface& surface, Index begin, Index end, Index place);
    void FindFacing(const LineView& view, const std::array<float, 2>& range, Index begin, Index end,
      std::vector<Index>& found) const;
    template<typename Loader>
    Lanes MayFace(
      const LineView& view, const std::array<float, 2>& range, const Loader& load) const;
  };
  void FindBlocks();
  void FindBlocksAround();

  const LineSurface& Surface;
  Index NumberOfClusters;
  Index NumberOfGroups;
  Index NumberOfBlocks;
  std::vector<Index> BlockOffsets;
  std::vector<Index> Blocks;
  std::vector<Index> AroundOffsets;
  std::vector<Index> BlocksAround;
  Bounds Clusters;
  Bounds Groups;
};
}

#endif
