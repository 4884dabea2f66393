// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPRContourEdges
 * @brief The outline of the mesh itself: edges between a triangle that faces the eye and one that
 * does not, and edges with one triangle.
 *
 * Lee Markosian, Michael A. Kowalski, Samuel J. Trychin, Lubomir D. Bourdev, Daniel Goldstein, John
 * F. Hughes: Real-Time Nonphotorealistic Rendering, SIGGRAPH 1997. What this outlines is the
 * polyhedron that is drawn, to the pixel; the outline of the smooth surface that the mesh stands
 * for is vtkNPROccludingContours.
 *
 * @par Which edges
 * Seen from the eye, each triangle at an edge lies on one of its two sides. The edge is on the
 * outline when there are more on one side than on the other. For two triangles, that is when one
 * faces the eye and one does not; it also settles edges of one, three or more triangles and those
 * whose triangles do not agree about the orientation. Where more than two edges meet, each line
 * goes on around one fan of triangles that face the eye. Thus on a closed surface all chains are
 * closed and have what faces the eye on their left. (But where several would run along one edge of
 * four or more triangles, there is only one.)
 *
 * @par Exactness
 * A triangle that is seen exactly edge-on counts as facing the eye. Each triangle is judged by
 * itself, in double precision, so that all its edges agree; rows of triangles that all face one way
 * by more than any rounding are judged at once, with the same result. Where coordinates are small
 * whole numbers (up to 2^15) nothing is rounded. In parallel projection the direction of the view
 * is a rounded unit vector, so a triangle that is edge-on but for that counts as edge-on.
 *
 * @sa vtkNPRFeatureLines vtkNPROccludingContours vtkNPRBoundaries
 */
#ifndef vtkNPRContourEdges_h
#define vtkNPRContourEdges_h

#include "vtkNPRLineDefinition.h"

class VTKNPRFILTERSLINES_EXPORT vtkNPRContourEdges : public vtkNPRLineDefinition
{
public:
  static vtkNPRContourEdges* New();
  vtkTypeMacro(vtkNPRContourEdges, vtkNPRLineDefinition);

  const char* GetName() const override { return "contour-edges"; }
  const char* GetDescription() const override
  {
    return "outline of the mesh's own facets, along its edges";
  }
  bool IsViewDependent() const override { return true; }

#ifndef __VTK_WRAP__
  EdgeKind GetEdges() const override
  {
    return AllEdges;
  }
  bool ComparesTriangles() const override
  {
    return true;
  }
  void EvaluateTriangles(const npr::LineSurface& surface, const npr::LineView& view,
    vtkIdType begin, vtkIdType end, signed char* values) const override;
  signed char BoundTriangles(
    const npr::PlaneBounds& planes, const npr::LineView& view) const override;
  void CompareTriangles(const npr::LineSurface& surface, const npr::EdgeList& edges,
    vtkIdType begin, vtkIdType end, const signed char* values, float* strength) const override;
#endif

protected:
  vtkNPRContourEdges() = default;
  ~vtkNPRContourEdges() override = default;

private:
  vtkNPRContourEdges(const vtkNPRContourEdges&) = delete;
  void operator=(const vtkNPRContourEdges&) = delete;
};

#endif
