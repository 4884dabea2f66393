// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPRFeatureLines
 * @brief Feature lines of a surface, as chained polylines.
 *
 * Give it one or more line definitions, by object or by name, and for lines that move with the view
 * the camera; when the surface is drawn by a prop with a matrix, that too. The output is in the
 * space of the input, so a prop with the same matrix draws it in its place. The camera's, the
 * matrix's and the definitions' changes count as changes of the filter: Render() alone keeps the
 * lines current.
 *
 * @par Input
 * Triangles with the point arrays that the definitions need (an error names the array and the
 * filter that makes it). WeldedPointIds, from vtkNPRSurfacePreparation, says which points are
 * copies of one where creases split the surface.
 *
 * @par Output
 * Polylines in double precision; a closed one ends with the point it starts with. Each runs through
 * neighbouring triangles or edges with the front (the positive side of its field, or its triangle)
 * on its left, seen from outside. No piece has no length, and none comes twice within one kind.
 * Cell arrays LineType (index into the field data array LineTypeNames) and LineLevel (the value of
 * the field that the line is at, 0 for most kinds) and ChainId (a line keeps its number from view
 * to view where that can be seen); point arrays Strength (in [0, 1]), Normals (the surface's),
 * ArcLength (from the start of the line, in units of the input), with a camera ViewDistance (from
 * the eye, in units of the world), and if wanted SourceCell (the cell of the input that the point
 * is in) and SourceEdge (the points of the input at the ends of the edge that it is on), and the
 * quantities that are asked for. Field data LengthScale tells the length that curvatures have been
 * multiplied by.
 *
 * @par Props with a matrix
 * The eye is brought into the space of the model by the inverse of the matrix. A point is on a
 * contour in the world exactly when it is on one for that eye in the model, for every invertible
 * affine matrix, also with uneven scale or mirrored. Suggestive contours use the curvature of the
 * unscaled model.
 *
 * @par Cost
 * Work that no view changes (adjacency, arrays, triangles that are ruled out, view-independent
 * lines) is kept until the input or a definition changes; what depends on the triangles alone is
 * kept while just the points of the input move.
 *
 * @par Pieces
 * Asks for ghost levels and draws what is in its own triangles; chains end where pieces meet. So N
 * pieces have the segments of the whole, if all have one LengthScale, and levels that do not follow
 * from the range of values in a piece (for lines that are smoothed see vtkNPRZeroCurvatureLines and
 * vtkNPRIsophotes).
 *
 * @sa vtkNPRLineDefinition
 */
#ifndef vtkNPRFeatureLines_h
#define vtkNPRFeatureLines_h

#include "nprVTKCompat.h"
#include "vtkNPRFiltersLinesModule.h"
#include <vtkPolyDataAlgorithm.h>
#include <vtkSmartPointer.h>

#include <memory>

VTK_ABI_NAMESPACE_BEGIN
class vtkCamera;
class vtkMatrix4x4;
VTK_ABI_NAMESPACE_END
class vtkNPRLineDefinition;
namespace npr
{
struct LineOptions;
}

class VTKNPRFILTERSLINES_EXPORT vtkNPRFeatureLines : public vtkPolyDataAlgorithm
{
public:
  static vtkNPRFeatureLines* New();
  vtkTypeMacro(vtkNPRFeatureLines, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// @name Definitions
  /// Which lines to extract. The index of a definition is its LineType. Default is none, an error.
  ///@{
  void AddDefinition(vtkNPRLineDefinition* definition);
  /// Makes one by its name, such as "contours", and returns it; an unknown name is an error, and
  /// returns null.
  vtkNPRLineDefinition* AddDefinition(const char* name);
  void RemoveAllDefinitions();
  int GetNumberOfDefinitions() const;
  /// Null when the index is out of range.
  vtkNPRLineDefinition* GetDefinition(int index) const;
  ///@}

  /// @name Quantities
  /// What points of lines carry of the surface, linear in each triangle: point arrays of the output
  /// with the same names.
  ///@{
  /// A quantity of the surface and the view, as expressions have them: ndotv, sintheta, kr, dwkr,
  /// k1, k2, K, H, P, Q, S, T, e1, e2, n, v, w, p (see vtkNPRExpressionLines; curvatures times the
  /// length scale, which the output's field data LengthScale tells); or else a point array of the
  /// input. What the input lacks is an error, or computed as for definitions. A name that lines
  /// have for something of their own (such as Strength) is an error. What depends on the view needs
  /// a camera.
  void AddQuantity(const char* name);
  void RemoveAllQuantities();
  int GetNumberOfQuantities() const;
  /// Null when the index is out of range.
  const char* GetQuantity(int index) const;
  ///@}

  ///@{
  /// The camera that looks at the lines. Needed for lines that move with the view, and for
  /// MinimumLength. Default is none.
  virtual void SetCamera(vtkCamera* camera);
  vtkCamera* GetCamera() const;
  ///@}

  ///@{
  /// Takes the model to the world, as vtkProp3D::GetMatrix(). None is the identity. Default is
  /// none.
  virtual void SetMatrix(vtkMatrix4x4* matrix);
  vtkMatrix4x4* GetMatrix() const;
  ///@}

  ///@{
  /// The length that curvatures are multiplied by before they meet a threshold. 0 takes the input's
  /// field data LengthScale, or without it the root mean square distance of the surface from its
  /// centroid. Set one value for all frames of an animation. Range [0, infinity), in units of the
  /// input. Default is 0.
  vtkSetClampMacro(LengthScale, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(LengthScale, double);
  ///@}

  ///@{
  /// Chains that look shorter than this fraction of the view's height are left out. A chain's
  /// length is measured as the camera sees it, whether hidden or not. Range [0, infinity). Default
  /// is 0, which keeps all.
  vtkSetClampMacro(MinimumLength, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MinimumLength, double);
  ///@}

  ///@{
  /// Chains whose strength is nowhere as high as this are left out, those that reach it keep their
  /// weak ends (hysteresis). Range [0, 1]. Default is 0, which keeps all.
  vtkSetClampMacro(MinimumStrength, double, 0.0, 1.0);
  vtkGetMacro(MinimumStrength, double);
  ///@}

  ///@{
  /// Chains that run mostly where one ran in the last view are kept down to this much less than
  /// MinimumLength and MinimumStrength, as a share of them, so that lines do not come and go while
  /// the camera moves. Range [0, 1]. Default is 0: a view looks the same whatever was seen before.
  vtkSetClampMacro(Hysteresis, double, 0.0, 1.0);
  vtkGetMacro(Hysteresis, double);
  ///@}

  enum StrategyType
  {
    FULL_TRAVERSAL,
    HIERARCHICAL,
    RANDOM_SEEDS
  };
  ///@{
  /// How the triangles are found that have lines. FULL_TRAVERSAL looks at all that are not ruled
  /// out for all views; HIERARCHICAL finds the same lines, to the last bit, without looking at
  /// clusters of triangles that can not have any in this view; RANDOM_SEEDS looks at some random
  /// triangles and at those of the last view, and follows the lines that are there: it may miss
  /// short ones (Markosian et al., "Real-time nonphotorealistic rendering", SIGGRAPH 1997). Lines
  /// that no view changes are always found in full. Default is HIERARCHICAL.
  vtkSetClampMacro(Strategy, int, FULL_TRAVERSAL, RANDOM_SEEDS);
  vtkGetMacro(Strategy, int);
  ///@}

  ///@{
  /// How many random triangles RANDOM_SEEDS begins at, as a share of all. Range [0, 1]. Default is
  /// 0.005.
  vtkSetClampMacro(SeedShare, double, 0.0, 1.0);
  vtkGetMacro(SeedShare, double);
  ///@}

  enum InterpolationType
  {
    LINEAR,
    HERMITE
  };
  ///@{
  /// Where on an edge a line crosses: LINEAR goes by the values of the field at its ends, HERMITE
  /// also by its slopes there, for definitions that know them (contours, where the input has
  /// CurvatureTensor), which takes out most of the zig-zag of coarse meshes. Default is LINEAR.
  vtkSetClampMacro(Interpolation, int, LINEAR, HERMITE);
  vtkGetMacro(Interpolation, int);
  ///@}

  ///@{
  /// Whether lines that go by the size of derivatives of curvature (suggestive contours and
  /// highlights, demarcating curves, expressions with dwkr or P; not ridges) are also where the
  /// input's point array DerivativeDoubt says that these mean nothing, as on most meshes of CAD
  /// programs. Default is off: there lines fade out. Inputs without the array, which
  /// vtkNPRCurvatureTensor makes, are trusted.
  vtkSetMacro(KeepDoubtful, bool);
  vtkGetMacro(KeepDoubtful, bool);
  vtkBooleanMacro(KeepDoubtful, bool);
  ///@}

  ///@{
  /// Whether points say where on the input they are from: arrays SourceCell and SourceEdge. Default
  /// is off.
  vtkSetMacro(OutputSources, bool);
  vtkGetMacro(OutputSources, bool);
  vtkBooleanMacro(OutputSources, bool);
  ///@}

  ///@{
  /// Whether the curvature of inputs that lack arrays is computed here, as vtkNPRCurvatureTensor
  /// does by itself, instead of refusing them. Default is off.
  vtkSetMacro(ComputeMissingArrays, bool);
  vtkGetMacro(ComputeMissingArrays, bool);
  vtkBooleanMacro(ComputeMissingArrays, bool);
  ///@}

  enum StageType
  {
    PREPARE, ///< what no view changes
    EXTRACT, ///< triangles and edges with lines
    JOIN,    ///< to chains
    PLACE,   ///< the chains' vertices
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

  /// Also counts camera, matrix and definitions.
  vtkMTimeType GetMTime() override;

protected:
  vtkNPRFeatureLines();
  ~vtkNPRFeatureLines() override;

  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkPolyData* GetSurface(vtkPolyData* input);
  bool PrepareSurface(vtkPolyData* input);
  npr::LineOptions GetOptions() const;

  vtkSmartPointer<vtkCamera> Camera;
  vtkSmartPointer<vtkMatrix4x4> Matrix;
  double LengthScale = 0.0;
  double MinimumLength = 0.0;
  double MinimumStrength = 0.0;
  double Hysteresis = 0.0;
  int Strategy = HIERARCHICAL;
  double SeedShare = 0.005;
  int Interpolation = LINEAR;
  bool KeepDoubtful = false;
  bool OutputSources = false;
  bool ComputeMissingArrays = false;

  class Internals;
  std::unique_ptr<Internals> Internal;

  vtkNPRFeatureLines(const vtkNPRFeatureLines&) = delete;
  void operator=(const vtkNPRFeatureLines&) = delete;
};

#endif
