// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprLineChains_h
#define nprLineChains_h

#include "nprLineJoiner.h"
#include "nprLineSegments.h"
#include "vtkNPRFiltersLinesModule.h"

#include <vtkType.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace npr
{
/**
 * @class LineChains
 * @brief The vertices of lines, along the paths that their segments were joined to.
 *
 * Chain c has the vertices from Begins[c] to Ends[c]; what lies between two chains is not used. A
 * closed chain does not repeat its first vertex. Vertices at one place have become one, so no chain
 * has a piece of no length; of one that has no length at all nothing is left.
 */
class VTKNPRFILTERSLINES_EXPORT LineChains
{
public:
  using Index = TriangleMesh::Index;

  /// What was there is dropped, but not its memory. Cells and edges that vertices are from are
  /// found only on wish.
  void Make(const LineSurface& surface, const LineSegments& segments, const LinePaths& paths,
    bool findSources);

  std::size_t GetNumberOfChains() const { return this->Begins.size(); }
  std::size_t GetSize(std::size_t chain) const { return this->Ends[chain] - this->Begins[chain]; }

  std::vector<std::size_t> Begins;
  std::vector<std::size_t> Ends;
  std::vector<char> Closed;
  std::vector<std::uint16_t> Levels; // of the definition's

  std::vector<Eigen::Vector3d> Positions; // relative to the origin of the surface
  std::vector<Eigen::Vector3f> Normals;
  std::vector<float> Strengths;
  std::vector<Index> Triangles;
  /// Of the input: the cell, and the points at the ends of the edge.
  std::vector<vtkIdType> SourceCells;
  std::vector<std::array<vtkIdType, 2>> SourceEdges;

private:
  void SetVertices(const LineSurface& surface, const LineSegments& segments, const LinePaths& paths,
    bool findSources);
  void MergePlaces(const Eigen::Vector3d& origin);
};
}

#endif
