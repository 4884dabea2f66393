// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprLineExtractor_h
#define nprLineExtractor_h

#include "nprFieldAxes.h"
#include "nprLineSegments.h"
#include "nprLineSurface.h"
#include "vtkNPRFiltersLinesModule.h"

#include <cstdint>
#include <memory>
#include <vector>

class vtkNPRLineDefinition;

namespace npr
{
/**
 * @class LineExtractor
 * @brief Takes the segments of one line definition from a surface.
 *
 * Goes through all triangles that the definition does not rule out. In a triangle the field is
 * linear between its corners; a corner where it is exactly 0 counts as positive, everywhere (where
 * the field has axes, see FieldAxes; there a line ends in a triangle whose edges it crosses an odd
 * number of times: it surrounds a point where the axes have no direction). A
 * point of the line that is a vertex is known as that vertex by all its triangles, so a line
 * through vertices or along edges is neither lost nor doubled. Segments have the positive side on
 * their left, seen from outside the surface.
 *
 * Blocks of fixed size are worked on in parallel and put together in their order: the result does
 * not depend on the number of threads.
 */
class VTKNPRFILTERSLINES_EXPORT LineExtractor
{
public:
  using Index = TriangleMesh::Index;

  /// Both must outlive the extractor. Finds, once for all views, the triangles that can not be
  /// ruled out.
  LineExtractor(const LineSurface& surface, const vtkNPRLineDefinition& definition);

  /// All segments of the lines seen so at one level of the field; edges have but one. Views do not
  /// matter to a definition that depends on none.
  std::vector<LineSegment> Extract(const LineView& view, float level);

  std::size_t GetNumberOfCandidates() const { return this->Candidates.size(); }

private:
  struct Node;
  bool IsCrossed(Index halfEdge, const float* field) const;
  Node CrossEdge(Index halfEdge, const float* field) const;
  Node AtVertex(Index point) const;
  LineVertex GetVertex(const Node& node) const;
  LineSegment GetEdgeSegment(const Node& from, const Node& to, const Index* sides, const Index* end,
    double fromLow, double toLow, float strength) const;
  LineSegment GetWholeEdge(const Index* sides, const Index* end, float strength) const;
  /// The points of a half-edge, in the order of their welded ids: the same on all sides of an edge.
  std::array<Index, 2> GetLowAndHigh(Index halfEdge) const;
  Eigen::Vector3f GetNormal(Index point) const;

  std::vector<float> EvaluateField(const LineView& view, float level) const;
  void SetViewAxes(const LineView& view);
  void ExtractField(
    const LineView& view, const float* field, std::vector<LineSegment>& segments) const;
  void ExtractJumps(const float* field, std::vector<LineSegment>& segments) const;
  void ExtractEdges(
    const LineView& view, const EdgeList& edges, std::vector<LineSegment>& segments) const;

  const LineSurface& Surface;
  const vtkNPRLineDefinition& Definition;
  std::unique_ptr<FieldAxes> Axes; ///< null where the field has one value
  std::array<std::vector<float>, 3> ViewAxes;
  std::vector<Index> Candidates;
  std::array<const float*, 3> Normals = { nullptr, nullptr, nullptr };
  std::int64_t FirstVertexKey;
  std::int64_t FirstCutKey;
};
}

#endif
