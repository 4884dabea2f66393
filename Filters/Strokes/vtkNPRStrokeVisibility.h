// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPRStrokeVisibility
 * @brief Cuts strokes where they pass behind surfaces, and counts the layers that hide each part.
 *
 * Input port 0 takes the strokes: polylines, as they come from vtkNPRFeatureLines or
 * vtkNPRSplineStrokes. Port 1 takes the surfaces that hide, as many as there are; several hide the
 * lines of each other. Strokes and each of the surfaces may have a matrix. Polygons and strips of
 * the surfaces are triangulated; which side of them is in front does not matter.
 *
 * @par Layers
 * The number of hiding layers of a point is how often the straight way from it to the eye (with a
 * parallel projection: from it on, against the direction of projection) goes through a surface. To
 * enter a solid and to leave it are two layers; a way through an edge or a corner of the mesh is
 * one. Where surfaces just touch the point (they are no farther than 1e-5 of the radius of all
 * surfaces together) they are no layer, and what is behind the eye is none. Clipping planes do not
 * count.
 *
 * @par Bodies that touch
 * Where a shaft fills a hole, the triangles of each are chords of one cylinder, and stick out of
 * each other. So a triangle of another body (one that no edges connect with the surface that the
 * stroke lies on) is no layer either where its plane is no farther from the point than the chord
 * errors of both together, at most 4 pixels, and the triangle itself no farther than 5 times that.
 * The chord error of a triangle is the surface's cell array ChordError, as from
 * vtkNPRSurfaceRefinement; or else the farthest that the smooth surface, which the point array
 * Normals describes, is from the middle of one of its edges: an eighth of the edge's length times
 * the angle between the normals. It is 0 without these arrays, of flat faces, and of edges whose
 * normals differ by more than 60 degrees. Both sides of a wall are one body: it hides, however thin
 * it is.
 *
 * @par The surface that a stroke lies on
 * A point lies on the triangle nearest to it if that is within 0.1 of the triangle's size (the root
 * of twice its area), at least within half a pixel, at most within 4. Ways through that triangle,
 * and through those around it that are no farther than twice as far from the point, are no layers.
 * On a smooth surface more are none: a contour is where the interpolated normals are at right
 * angles to the view, so it may run over triangles that turn away, just behind the edge of the
 * polyhedron. Such are ways within the reach of the point, through triangles that are connected
 * with the nearest one by edges, over triangles within reach whose normals turn less than 84
 * degrees from its own (the cosine is at least 0.1). The reach is 5 times the distance from the
 * surface; where the stroke runs inside a triangle (farther from its edges than 1e-6 of the radius,
 * other than creases and contour edges) it is at least 2 pixels, and where the surface is seen
 * nearly edge-on there (the cosine between its normal and the view is no more than 0.25; the normal
 * is the stroke's point array Normals, or else the triangle's) at least 4 sizes of the triangle.
 * Where the stroke runs along an edge, of a triangle whose own cosine is no more than 0.1, it is at
 * least 2 pixels: just before a crease a smooth surface may turn away, and its contour is the
 * crease. Or its contour is just behind the crease: where the stroke runs inside a triangle, these
 * triangles may have an edge in the outline of the mesh (one of its two triangles is seen from the
 * front, the other from the back) no farther than 2 pixels from the point; then what is beyond it,
 * as far as 2 pixels, is no layer either. Beyond a second such edge there is no more, so the two
 * sides of a wall are never taken for one, however thin it is. But behind a cusp a contour is seen
 * from within: the surface is hollow along the sight line, and the way to the eye is inside of the
 * solid (J. Koenderink, "What does the occluding contour tell us about solid shape?", 1984). It is
 * so where the stroke runs inside a triangle, its normal is at right angles to the view, and its
 * left side, where contours have the front, is the farther one (all told by more than a sine of
 * 0.02). There these triangles are no layers only where they are seen from their back, as a sheet
 * is; on the front, the way leaves the solid. A point on a triangle that is seen exactly edge-on
 * (the cosine is no more than 1e-4), as in views along an axis of a machine part, has the lesser
 * number of layers of the two sides of that triangle.
 *
 * @par Where strokes are cut
 * The number of layers changes only where a contour edge or a border of a surface is in front of
 * the stroke, where the stroke goes through a surface, and where it comes to another triangle of
 * its own surface (A. Appel, "The notion of quantitative invisibility and the machine rendering of
 * solids", 1967). Strokes are cut there, by intersecting projected edges, and one ray is traced for
 * each piece (for short ones, when 0.02 pixels have come together): long straight lines cost no
 * more than short ones, and nothing is too narrow to hide them. Pieces inside of triangles,
 * with something just in front of them, are looked at pixel by pixel. Beyond 4 heights of the image
 * from its middle cuts may be missing. Then pieces that are alike are put together, and parts
 * shorter than MinimumLength become part of their neighbours: the shortest first, if both
 * neighbours are alike with both, else with the longer one. A stroke that ends hidden keeps its
 * hidden end, however short.
 *
 * @par Output
 * Polylines in the strokes' own space, without shared points; parts that touch have the same point
 * at their ends, to the last bit. Cell array HidingLayers (int; 0: visible). All numeric point
 * arrays are interpolated linearly where strokes are cut, but integers are those of the nearer
 * point; cell arrays are copied, field data is passed. Point array ArcLength goes on along the
 * original stroke: it is the input's, or else measured. A closed stroke that is cut anywhere has no
 * seam: the part over its first point is whole, and its ArcLength goes on beyond the stroke's
 * length. What is not in front of the eye, or has coordinates that are not numbers, is left out.
 * Vertices, polygons and strips of the strokes are not passed on.
 *
 * What no view changes of the surfaces is kept until one of them or its matrix changes. The result
 * does not depend on the number of threads.
 *
 * @sa vtkNPRFeatureLines, vtkNPRSplineStrokes
 */
#ifndef vtkNPRStrokeVisibility_h
#define vtkNPRStrokeVisibility_h

#include "nprVTKCompat.h"
#include "vtkNPRFiltersStrokesModule.h"
#include <vtkPolyDataAlgorithm.h>
#include <vtkSmartPointer.h>

#include <memory>

VTK_ABI_NAMESPACE_BEGIN
class vtkCamera;
class vtkMatrix4x4;
VTK_ABI_NAMESPACE_END

class VTKNPRFILTERSSTROKES_EXPORT vtkNPRStrokeVisibility : public vtkPolyDataAlgorithm
{
public:
  static vtkNPRStrokeVisibility* New();
  vtkTypeMacro(vtkNPRStrokeVisibility, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Whether this build can find what is hidden: it needs Embree.
  static bool IsAvailable();

  ///@{
  /// The camera that looks at the strokes. Default is none, an error.
  virtual void SetCamera(vtkCamera* camera);
  vtkCamera* GetCamera() const;
  ///@}

  ///@{
  /// Adds a surface that hides, with the matrix that takes it to the world, as
  /// vtkProp3D::GetMatrix(); null is the identity.
  void AddSurfaceConnection(vtkAlgorithmOutput* surface, vtkMatrix4x4* matrix = nullptr);
  void AddSurfaceData(vtkPolyData* surface, vtkMatrix4x4* matrix = nullptr);
  /// Also forgets their matrices.
  void RemoveAllSurfaces();
  int GetNumberOfSurfaces();
  ///@}

  ///@{
  /// The matrix of a surface, by the number of its connection. Null is the identity.
  void SetSurfaceMatrix(int surface, vtkMatrix4x4* matrix);
  vtkMatrix4x4* GetSurfaceMatrix(int surface) const;
  ///@}

  ///@{
  /// Takes the strokes to the world. None is the identity. Default is none.
  virtual void SetStrokeMatrix(vtkMatrix4x4* matrix);
  vtkMatrix4x4* GetStrokeMatrix() const;
  ///@}

  /// Value of MaximumLayers that only tells what is visible (0) from what is not (1): the fastest.
  static constexpr int VISIBLE_ONLY = 1;
  ///@{
  /// No more layers than this are counted. Range [1, VTK_INT_MAX]. Default is VTK_INT_MAX.
  vtkSetClampMacro(MaximumLayers, int, VISIBLE_ONLY, VTK_INT_MAX);
  vtkGetMacro(MaximumLayers, int);
  void SetMaximumLayersToVisibleOnly() { this->SetMaximumLayers(VISIBLE_ONLY); }
  ///@}

  ///@{
  /// How many pixels high the image is: what all lengths in pixels refer to. Range [1, 1e6].
  /// Default is 1000.
  vtkSetClampMacro(ViewportHeight, double, 1.0, 1e6);
  vtkGetMacro(ViewportHeight, double);
  ///@}

  ///@{
  /// Parts that look shorter than this are made part of their neighbours. In pixels, range
  /// [0, 1e6]. Default is 0.5; 0 keeps all.
  vtkSetClampMacro(MinimumLength, double, 0.0, 1e6);
  vtkGetMacro(MinimumLength, double);
  ///@}

  enum StageType
  {
    PREPARE, ///< what no view changes: adjacency and the hierarchy for rays
    EDGES,   ///< the edges that hide, in the image
    SPLIT,   ///< cuts and rays
    WRITE,   ///< the output
    NumberOfStages
  };
  /// @name How long the stages of the last update took
  ///@{
  /// Null when the stage is out of range.
  static const char* GetStageName(int stage);
  /// In seconds.
  double GetStageSeconds(int stage) const;
  ///@}

  /// Also counts the camera and the matrices.
  vtkMTimeType GetMTime() override;

protected:
  vtkNPRStrokeVisibility();
  ~vtkNPRStrokeVisibility() override;

  int FillInputPortInformation(int port, vtkInformation* information) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  bool PrepareSurfaces(vtkInformationVector* surfaces);

  vtkSmartPointer<vtkCamera> Camera;
  vtkSmartPointer<vtkMatrix4x4> StrokeMatrix;
  int MaximumLayers = VTK_INT_MAX;
  double ViewportHeight = 1000.0;
  double MinimumLength = 0.5;

  class Internals;
  std::unique_ptr<Internals> Internal;

  vtkNPRStrokeVisibility(const vtkNPRStrokeVisibility&) = delete;
  void operator=(const vtkNPRStrokeVisibility&) = delete;
};

#endif
