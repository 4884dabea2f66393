// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprLineSurface_h
#define nprLineSurface_h

#include "nprAlignedVector.h"
#include "nprLineView.h"
#include "nprTriangleMesh.h"
#include "vtkNPRFiltersLinesModule.h"

#include <vtkCellArray.h>
#include <vtkSmartPointer.h>

#include <array>
#include <map>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;
VTK_ABI_NAMESPACE_END

namespace npr
{
/**
 * @class EdgeList
 * @brief Edges of the welded surface, each with the half-edges (3 * triangle + edge) on it.
 */
class EdgeList
{
public:
  using Index = TriangleMesh::Index;
  Index GetNumberOfEdges() const { return static_cast<Index>(this->Offsets.size()) - 1; }
  /// The half-edges of an edge, in ascending order: [Begin, End).
  const Index* Begin(Index edge) const { return this->HalfEdges.data() + this->Offsets[edge]; }
  const Index* End(Index edge) const { return this->HalfEdges.data() + this->Offsets[edge + 1]; }

  std::vector<Index> HalfEdges;
  std::vector<Index> Offsets = { 0 };
  /// Whether each edge is known to have two half-edges that run in opposite directions.
  bool AreOriented = false;
};

/**
 * @class LineSurface
 * @brief All that lines need to know of a surface and that no view changes: its triangles, their
 * adjacency, and its point arrays as one span of floats for each component.
 *
 * Points and triangles are numbered along a curve that fills space, so that those that lie together
 * have numbers that lie together; GetPointId() and GetCellId() say what they are in the input.
 *
 * A *twin* joins two triangles that share both points of an edge; fields run on across it. All
 * other half-edges stand on *seams*: borders, edges where the preparation split the points of a
 * crease (their points differ, their WeldedPointIds agree), and edges with more than two triangles.
 */
class VTKNPRFILTERSLINES_EXPORT LineSurface
{
public:
  using Index = TriangleMesh::Index;
  static constexpr Index NoTwin = -1;

  /// A given `lengthScale` greater than 0 overrides what the data says.
  explicit LineSurface(vtkPolyData* surface, double lengthScale = 0.0);

  /// @name Pieces
  /// Triangles that another piece of the surface has too, and that are not this piece's to draw.
  ///@{
  bool HasGhosts() const { return !this->Ghosts.empty(); }
  bool IsGhost(Index triangle) const { return this->HasGhosts() && this->Ghosts[triangle]; }
  /// Whether lines along an edge, with the half-edges [begin, end), are this piece's: those along
  /// an edge that several pieces share are of the one that has the first of its triangles in space.
  bool IsOwned(const Index* begin, const Index* end) const;
  ///@}

  /// Takes the points of a surface that has the same triangles, and with them whatever is at the
  /// points: arrays are to be loaded again. False, and nothing has changed, if its triangles are
  /// others.
  bool Move(vtkPolyData* surface, double lengthScale = 0.0);

  const TriangleMesh& GetMesh() const { return this->Mesh; }
  double GetLengthScale() const { return this->LengthScale; }
  vtkIdType GetPointId(Index point) const { return this->PointIds[point]; }
  vtkIdType GetCellId(Index triangle) const { return this->CellIds[triangle]; }

  /// Whether there are points that no triangle has, and whether a point has one.
  bool HasUnusedPoints() const { return !this->UsedPoints.empty(); }
  bool IsUsed(Index point) const { return !this->HasUnusedPoints() || this->UsedPoints[point]; }

  /// @name Point arrays
  ///@{
  /// Takes an array of the surface's point data with so many components, 0 for any. False when it
  /// has none.
  bool LoadArray(vtkPolyData* surface, const char* name, int components);
  /// Adds or replaces an array, made from others: a span over all points for each component.
  void SetArray(const std::string& name, std::vector<AlignedVector<float>> components);
  bool HasArray(const char* name) const { return this->FindArray(name) != nullptr; }
  /// Of an array that was loaded.
  int GetNumberOfComponents(const char* name) const
  {
    return static_cast<int>(this->FindArray(name)->Components.size());
  }
  /// One component of an array that was loaded, over all points.
  const float* GetComponent(const char* name, int component) const
  {
    return this->FindArray(name)->Components[component].data();
  }
  /// The points' coordinates, relative to the origin of the mesh.
  const float* GetCoordinate(int axis) const { return this->Coordinates[axis].data(); }
  ///@}

  /// @name Regions
  /// Which triangles have the same values in an array of the surface's cell data.
  ///@{
  /// False when the surface has no such array of numbers, or one of another size.
  bool LoadRegions(vtkPolyData* surface, const std::string& name);
  /// A number for each triangle, from an array that was loaded: the same where all components are,
  /// and ascending with the components, of which the first counts most. Values that are not
  /// numbers are the same, and come last.
  const std::vector<Index>& GetRegions(const std::string& name) const
  {
    return this->Regions.at(name);
  }
  ///@}

  /// @name Half-edges: 3 * triangle + edge
  ///@{
  Index GetNumberOfHalfEdges() const { return 3 * this->Mesh.GetNumberOfTriangles(); }
  Index GetStart(Index halfEdge) const
  {
    return this->Mesh.GetTriangle(halfEdge / 3)[halfEdge % 3];
  }
  Index GetEnd(Index halfEdge) const
  {
    return this->Mesh.GetTriangle(halfEdge / 3)[(halfEdge + 1) % 3 == 0 ? 0 : halfEdge % 3 + 1];
  }
  Index GetTwin(Index halfEdge) const { return this->Twins[halfEdge]; }
  /// The twin, or where points are split, the one other half-edge of the edge; NoTwin where there
  /// is none, or more than one.
  Index GetOther(Index halfEdge) const;
  /// A point that stands for all copies of one where creases split the surface.
  Index GetWelded(Index point) const
  {
    return this->WeldedPoints.empty() ? point : this->WeldedPoints[point];
  }
  /// The points of a half-edge, in the order of their welded points: the same on all sides of an
  /// edge.
  std::array<Index, 2> GetLowAndHigh(Index halfEdge) const;
  ///@}

  /// The half-edges on the edge of a half-edge without a twin, in ascending order: [first, second).
  /// None where the edge has no length.
  std::pair<const Index*, const Index*> FindSeam(Index halfEdge) const;
  /// Edges that have no twins: with one half-edge at a border, two where points are split. In the
  /// order of their welded points.
  const EdgeList& GetSeams() const { return this->Seams; }
  /// Edges between twins; made by the first call of BuildInnerEdges().
  const EdgeList& GetInnerEdges() const { return this->InnerEdges; }
  void BuildInnerEdges();

  /// The points that share an edge with a point: [Begin, End); made by the first call of
  /// BuildNeighbours().
  const Index* NeighboursBegin(Index point) const
  {
    return this->Neighbours.data() + this->NeighbourOffsets[point];
  }
  const Index* NeighboursEnd(Index point) const
  {
    return this->Neighbours.data() + this->NeighbourOffsets[point + 1];
  }
  void BuildNeighbours();

private:
  struct Array
  {
    std::string Name;
    std::vector<AlignedVector<float>> Components;
  };
  const Array* FindArray(const char* name) const;
  void SetOrder(const TriangleMesh& mesh);
  void SetUsedPoints();
  void SetGhosts(vtkPolyData* surface);
  void SetCoordinates();
  void BuildTwins();
  void BuildSeams();

  TriangleMesh Mesh;
  double LengthScale = 0.0;
  std::vector<Index> PointIds;
  std::vector<vtkIdType> CellIds;
  std::vector<Index> WeldedPoints;       // empty where no point has copies
  std::vector<unsigned char> UsedPoints; // empty where all are
  std::vector<Index> Twins;
  std::unordered_map<Index, Index> OthersAtSeams;
  EdgeList Seams;
  EdgeList InnerEdges;
  std::vector<Index> NeighbourOffsets;
  std::vector<Index> Neighbours;
  std::array<AlignedVector<float>, 3> Coordinates;
  std::vector<Array> Arrays;
  std::map<std::string, std::vector<Index>> Regions;

  std::vector<unsigned char> Ghosts;                // empty where there are none
  std::vector<std::array<double, 3>> GhostsMiddles; // of all triangles, where there are ghosts

  // What the triangles came from, to know them again. Kept, so that no others have their address.
  vtkSmartPointer<vtkCellArray> Polygons;
  vtkMTimeType PolygonsMTime = 0;
  vtkIdType NumberOfCellsBefore = 0;
  std::vector<Index> OriginalWeldedPoints;
};
}

#endif
