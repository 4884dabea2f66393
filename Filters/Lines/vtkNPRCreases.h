// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPRCreases
 * @brief Sharp edges: those whose two sides meet at a large angle.
 *
 * Creases belong to the shape, so they stay where they are in all views. Edges are taken on the
 * welded surface, so it does not matter whether the points are split there. Edges of more than two
 * triangles have no one angle; vtkNPRNonManifoldEdges draws them.
 *
 * @par Slivers
 * What triangulators of CAD programs make of flat and gently bent faces has triangles so thin that
 * their normals mean nothing. So it is not enough that the triangles of an edge meet at the angle:
 * the surface on its two sides must, too. The normal of a side is the mean along a straight path
 * from the edge's middle, as far as Tolerance. Slivers, shallow steps and folds that are narrower
 * make no crease; triangles that are higher, as those of scans mostly are, count as they are. Sides
 * that lie on each other, at an angle above 178 degrees, make no crease either.
 *
 * @par Soft creases and coarse rounds
 * A wall may meet a round at a small angle. Where vtkNPRSurfacePreparation has split the surface
 * along an edge, half of the angle suffices if the edge stands out from those beside it: it is bent
 * more than twice as much as the next edges across on both sides together. The other way round,
 * edges that are bent as those on both their sides (to 3/4) are facets of a round face, such as a
 * small hole with eight of them, and no creases below 1.3 times the angle and 50 degrees; unless
 * the facets are wider than 0.05 length scales, as those of a nut or a bar.
 *
 * @sa vtkNPRFeatureLines vtkNPRBoundaries vtkNPRNonManifoldEdges
 */
#ifndef vtkNPRCreases_h
#define vtkNPRCreases_h

#include "vtkNPRLineDefinition.h"

class VTKNPRFILTERSLINES_EXPORT vtkNPRCreases : public vtkNPRLineDefinition
{
public:
  static vtkNPRCreases* New();
  vtkTypeMacro(vtkNPRCreases, vtkNPRLineDefinition);

  const char* GetName() const override { return "creases"; }
  const char* GetDescription() const override { return "sharp edges"; }
  bool IsViewDependent() const override { return false; }

  ///@{
  /// The angle between the normals of its two sides above which an edge is a crease, in degrees;
  /// half of it for soft creases. Range [0, 180]. Default is 40.
  vtkSetClampMacro(Angle, double, 0.0, 180.0);
  vtkGetMacro(Angle, double);
  ///@}

  ///@{
  /// How far from an edge its sides are looked at, in length scales of the surface: what is
  /// narrower can not be seen. They are looked at five times as far, too, so that wrinkles in a
  /// face make no crease. Range [0, 1]; 0 takes the triangles as they are, and has no soft
  /// creases. Default is 0.002.
  vtkSetClampMacro(Tolerance, double, 0.0, 1.0);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /// The least number of edges that make a crease; 1 keeps every sharp edge. Range [1, 1e6].
  /// Default is 3.
  vtkSetClampMacro(LeastEdges, double, 1.0, 1.0e6);
  vtkGetMacro(LeastEdges, double);
  ///@}

#ifndef __VTK_WRAP__
  EdgeKind GetEdges() const override
  {
    return AllEdges;
  }
  void EvaluateEdges(const npr::LineSurface& surface, const npr::LineView& view,
    const npr::EdgeList& edges, vtkIdType begin, vtkIdType end, float* strength) const override;
  double GetLeastRow() const override
  {
    return this->LeastEdges;
  }
#endif

protected:
  vtkNPRCreases();
  ~vtkNPRCreases() override = default;

private:
  double Angle = 40.0;
  double Tolerance = 0.002;
  double LeastEdges = 3.0;

  vtkNPRCreases(const vtkNPRCreases&) = delete;
  void operator=(const vtkNPRCreases&) = delete;
};

#endif
