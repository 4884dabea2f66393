// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprTriangleMesh_h
#define nprTriangleMesh_h

#include "nprVTKCompat.h"
#include "vtkNPRFiltersCoreModule.h"
#include <vtkType.h>

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;
VTK_ABI_NAMESPACE_END

namespace npr
{
/**
 * @class TriangleMesh
 * @brief The triangles of a vtkPolyData as flat arrays, with their adjacency.
 *
 * Points are kept as floats relative to the middle of the surface (Origin), so that nothing is lost
 * far from the origin of the coordinates. Only the triangles among the polygons are taken, and of
 * those only the ones with three different, finite points; each remembers its cell. A triangle's
 * edge e runs from its corner e to its corner (e + 1) % 3.
 */
class VTKNPRFILTERSCORE_EXPORT TriangleMesh
{
public:
  using Index = std::int32_t;
  using Triangle = std::array<Index, 3>;
  using Vector = Eigen::Vector3f;

  /// Values of GetNeighbour() where there is not exactly one triangle on the other side.
  static constexpr Index Boundary = -1;
  static constexpr Index NonManifold = -2;

  explicit TriangleMesh(vtkPolyData* surface);
  /// Takes points (relative to `origin`) and triangles as they are; GetCellId() is then the
  /// triangle.
  TriangleMesh(std::vector<Vector> points, std::vector<Triangle> triangles,
    const Eigen::Vector3d& origin = Eigen::Vector3d::Zero());

  Index GetNumberOfPoints() const { return static_cast<Index>(this->Points.size()); }
  Index GetNumberOfTriangles() const { return static_cast<Index>(this->Triangles.size()); }
  const Vector& GetPoint(Index point) const { return this->Points[point]; }
  const Triangle& GetTriangle(Index triangle) const { return this->Triangles[triangle]; }
  /// What was subtracted from the points.
  const Eigen::Vector3d& GetOrigin() const { return this->Origin; }
  /// A power of two about as large as the largest coordinate (1 if all are zero). Lengths divided
  /// by it are exact, and products of several neither vanish nor overflow in single precision,
  /// whatever the unit of the coordinates.
  float GetUnit() const { return this->Unit; }
  /// Whether all coordinates are numbers.
  bool HasFinitePoints() const { return this->IsFinite; }
  /// The cell of the vtkPolyData that the triangle is.
  vtkIdType GetCellId(Index triangle) const
  {
    return this->CellIds.empty() ? triangle : this->CellIds[triangle];
  }

  const std::vector<Vector>& GetPoints() const { return this->Points; }
  const std::vector<Triangle>& GetTriangles() const { return this->Triangles; }

  /// Normal of the triangle by the right-hand rule, as long as twice its area.
  Vector GetAreaNormal(Index triangle) const;

  /// Root mean square distance of the surface from its centroid: a length that depends on the
  /// shape alone, not on its tessellation, place or rotation. Zero without area.
  double ComputeLengthScale() const;

  /// Takes other points, as many as there are, and leaves the triangles and their adjacency.
  void MovePoints(std::vector<Vector> points, const Eigen::Vector3d& origin);

  /// Turns the triangle over: swaps its last two corners, and its neighbours where they are built.
  void Flip(Index triangle);

  /// @name Adjacency
  /// Call the Build function before the first of its Get functions.
  ///@{
  void BuildNeighbours();
  /// The triangle across edge e, or Boundary or NonManifold.
  Index GetNeighbour(Index triangle, int edge) const { return this->Neighbours[triangle][edge]; }
  /// Gives back their memory.
  void ReleaseNeighbours() { std::vector<Triangle>().swap(this->Neighbours); }

  void BuildIncidence();
  /// The triangles around a point, in ascending order: [Begin, End).
  const Index* IncidentBegin(Index point) const
  {
    return this->Incident.data() + this->IncidentOffsets[point];
  }
  const Index* IncidentEnd(Index point) const
  {
    return this->Incident.data() + this->IncidentOffsets[point + 1];
  }
  Index GetNumberOfIncident(Index point) const
  {
    return this->IncidentOffsets[point + 1] - this->IncidentOffsets[point];
  }
  /// From any place in the list of triangles around points, one may look so far ahead, into the
  /// lists of the next points, to load what will be needed; after the last there are zeros.
  static constexpr int LookAhead = 16;

  /// How many triangles have an edge between two points (needs the incidence).
  int CountTrianglesAtEdge(Index from, Index to) const;

  /// Whether an edge at the point has another number of triangles than two (needs the incidence).
  bool IsBorderPoint(Index point) const;
  /// Finds IsBorderPoint() for all points, and builds the incidence where it is not.
  void BuildBorder();
  /// 1 for border points, else 0.
  const std::vector<unsigned char>& GetBorder() const { return this->Border; }

  /// Numbers the edges: ascending by their lower, then by their higher point.
  void BuildEdges();
  Index GetNumberOfEdges() const { return static_cast<Index>(this->EdgeEnds.size()); }
  /// The edge between two points that share a triangle.
  Index FindEdge(Index a, Index b) const;
  /// The lower and the higher point of an edge.
  std::array<Index, 2> GetEdge(Index edge) const
  {
    return { this->EdgeStarts[edge], this->EdgeEnds[edge] };
  }
  ///@}

private:
  void ReadPoints(vtkPolyData* surface);
  void ReadTriangles(vtkPolyData* surface);
  /// The triangles of a surface that has no other cells, as nearly all have. False if one of them
  /// can not be taken, or the ids are not of this type.
  template<typename Ids>
  bool ReadAllTriangles(vtkPolyData* surface);
  template<typename Id>
  bool IsUsable(const Id* corners) const;
  /// Whether each triangle around a point is followed by just one other: where one edge at the
  /// point leaves a triangle, it enters the next. Says false where there are more than `Capacity`.
  template<int Capacity>
  bool IsClosedFan(Index point) const;
  /// Sets the unit and whether all coordinates are numbers.
  void MeasurePoints();

  std::vector<Vector> Points;
  std::vector<Triangle> Triangles;
  std::vector<vtkIdType> CellIds; // empty where the triangles are the cells
  Eigen::Vector3d Origin = Eigen::Vector3d::Zero();
  float Unit = 1.0f;
  bool IsFinite = true;
  std::vector<Triangle> Neighbours;
  std::vector<Index> IncidentOffsets;
  std::vector<Index> Incident;
  std::vector<unsigned char> Border;
  std::vector<Index> EdgeOffsets;
  std::vector<Index> EdgeStarts;
  std::vector<Index> EdgeEnds;
};
}

#endif
