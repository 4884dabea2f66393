// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprLineExtractor_h
#define nprLineExtractor_h

#include "nprCrossingMaker.h"
#include "nprFieldValues.h"
#include "nprLineClusters.h"
#include "nprLineSegments.h"
#include "nprLineSurface.h"
#include "nprRandomSeeds.h"
#include "vtkNPRFiltersLinesModule.h"

#include <memory>
#include <vector>

class vtkNPRLineDefinition;

namespace npr
{
class EdgePieces;

/// How triangles with lines are found. The first two find the same lines, to the last bit.
enum class LineStrategy
{
  Full,         ///< looks at all triangles that the definition does not rule out for all views
  Hierarchical, ///< and not at clusters that can not have lines in this view
  Random        ///< looks at random triangles and those of the last view, and follows their lines
};

struct LineOptions
{
  LineStrategy Strategy = LineStrategy::Hierarchical;
  /// Whether crossings are placed by the slopes of the field at the ends of an edge, where the
  /// definition knows them, and not by its values alone.
  bool UseSlopes = false;
  /// Whether lines from derivatives of curvature are also where these are in doubt.
  bool KeepsDoubtful = false;
  /// How many of the triangles the strategy Random begins at.
  double SeedShare = 0.005;
};

/**
 * @class LineExtractor
 * @brief Takes the segments of one line definition from a surface.
 *
 * In a triangle the field is linear between its corners; a corner where it is exactly at a level
 * counts as above, everywhere (where the field has axes, see FieldAxes; there a line ends in a
 * triangle whose edges it crosses an odd number of times: it surrounds a point where the axes have
 * no direction). A point of the line that is a vertex is known as that vertex by all its triangles,
 * so a line through vertices or along edges is neither lost nor doubled. Segments have the positive
 * side on their left, seen from outside the surface.
 *
 * Parts of fixed size are worked on in parallel and put together in their order: the result does
 * not depend on the number of threads.
 */
class VTKNPRFILTERSLINES_EXPORT LineExtractor
{
public:
  using Index = TriangleMesh::Index;

  /// All must outlive the extractor. Finds, once for all views, the triangles that can not be ruled
  /// out.
  LineExtractor(const LineSurface& surface, const LineClusters& clusters,
    const vtkNPRLineDefinition& definition);
  ~LineExtractor();

  const std::vector<float>& GetLevels() const { return this->Levels; }

  /// All segments of the lines seen so. Views do not matter to a definition that depends on none.
  /// What was in `segments` is dropped, but not its memory.
  void Extract(
    const LineView& view, const LineOptions& options, FieldValues& values, LineSegments& segments);

private:
  /// Some groups of clusters, and what was found there.
  struct Part
  {
    std::vector<Index> Clusters;
    std::vector<CrossedTriangle> Crossed;
    std::vector<LineCrossing> Crossings;
  };

  void FindCandidates();
  void RequireSeams(FieldValues& values) const;
  void FindClusters(const LineView& view, LineStrategy strategy, FieldValues& values);
  bool IsOnOneSide(Index cluster, const FieldValues& values) const;
  const float* GetDoubts(const LineOptions& options) const;
  void AddCrossings(
    const LineView& view, const LineOptions& options, FieldValues& values, LineSegments& segments);
  void FindCrossed(const FieldValues& values, Part& part) const;
  void FindCrossedAtRandom(double share, FieldValues& values);
  void DropGhosts(std::vector<CrossedTriangle>& crossed) const;
  void RequireTests(const std::vector<CrossedTriangle>& crossed, FieldValues& values) const;

  const LineSurface& Surface;
  const LineClusters& Clusters;
  const vtkNPRLineDefinition& Definition;
  std::vector<float> Levels;
  bool HasSlopes = false;
  bool HasCandidates = false; ///< else all triangles are
  std::vector<Index> Candidates;
  std::vector<Index> CandidateOffsets; ///< for each cluster
  std::vector<Part> Parts;
  std::unique_ptr<RandomSeeds> Seeds;
  std::unique_ptr<EdgePieces> Edges;
};
}

#endif
