// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprLineJoiner_h
#define nprLineJoiner_h

#include "nprLineSegments.h"
#include "vtkNPRFiltersLinesModule.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace npr
{
/// Ends of segments, one for each vertex of a line: end 2 * s + i is node i of segment s. Path p
/// has those from Offsets[p] to Offsets[p + 1]. Where segments meet at a vertex of the mesh or on a
/// seam, the ends of both are there. A closed path does not come back to its first end.
struct LinePaths
{
  using End = std::int32_t;
  std::vector<End> Ends;
  std::vector<std::size_t> Offsets;
  std::vector<char> Closed;
  std::size_t GetNumberOfPaths() const { return this->Closed.size(); }
};

/**
 * @class LineJoiner
 * @brief Joins segments end to end wherever exactly two ends meet.
 *
 * Where more meet, all lines end, unless the pieces say how they go on (see EdgeFans). A path takes
 * the direction that most of its segments have. The order of the paths follows from that of the
 * segments alone. Keeps its memory from one call to the next.
 */
class VTKNPRFILTERSLINES_EXPORT LineJoiner
{
public:
  using Index = TriangleMesh::Index;
  using End = LinePaths::End;

  /// The surface must outlive this.
  explicit LineJoiner(const LineSurface& surface);

  /// Crossings must be in the order of their triangles. What was in `paths` is dropped.
  void Join(const LineSegments& segments, LinePaths& paths);

private:
  static constexpr End Free = -1;
  static constexpr End Keyed = -2; // at a vertex or on a seam, to be found by its key

  /// What meets an end there stands as a negative number.
  static End JoinByKey(End mate) { return -3 - mate; }
  End GetMate(End end) const
  {
    const End mate = this->Mates[end];
    return mate < Keyed ? -3 - mate : mate;
  }
  void FindMates(const LineSegments& segments);
  End FindMate(const LineSegments& segments, End end) const;
  std::int64_t GetKeyOf(const LineSegments& segments, End end) const;
  void FindMatesByKeys(const LineSegments& segments);
  void Trace(End end);
  void Write(bool closed, LinePaths& paths) const;

  const LineSurface& Surface;
  std::vector<Index> CrossingOfTriangle; // the first; what is there may be old
  std::vector<unsigned char> Counts;     // for each vertex, of ends
  std::vector<End> Sums;                 // for each vertex, of ends
  std::vector<End> Mates;
  std::vector<char> Visited;
  std::vector<End> Path; // the ends that segments are entered by
};
}

#endif
