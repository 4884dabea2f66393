// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPRCurvatureTensor
 * @brief Estimates the curvature of a triangle mesh, and how it changes along the surface.
 *
 * A sphere of radius r with outward normals has the curvature +1/r: convex is positive. The output
 * has point arrays, each of which can be switched off:
 *
 * | array | components, unit | |
 * | --- | --- | --- |
 * | Normals | 3, unit vectors | what all else refers to |
 * | CurvatureTensor | 6, 1/length | second fundamental form in space: XX YY ZZ XY YZ XZ |
 * | PrincipalCurvature1, PrincipalCurvature2 | 1, 1/length | the first has the larger magnitude |
 * | PrincipalDirection1, PrincipalDirection2 | 3, unit vectors | first x second = normal; arbitrary
 * at umbilics |
 * | MeanCurvature | 1, 1/length | half the sum of the principal curvatures |
 * | GaussianCurvature | 1, 1/length^2 | their product |
 * | CurvatureDerivatives | 4, 1/length^2 | P, Q, S, T: the derivatives of the first principal
 * curvature along the first and the second direction, then of the second one; all change sign when
 * the directions are turned over |
 * | DerivativeDoubt | 1 | how doubtful these derivatives are, 0 to 10, see nprDerivativeDoubt.h |
 * | ShapeIndex | 1 | cup -1, valley -0.5, saddle 0, ridge 0.5, cap 1 (Koenderink, van Doorn 1992);
 * off by default |
 * | Curvedness | 1, 1/length | root mean square of the principal curvatures; off by default |
 * | PointArea | 1, length^2 | the point's share of the surface (mixed Voronoi area, Meyer et al.
 * 2002); off by default |
 * | BorderPoints | 1 | 1 where the estimate is one-sided: at borders, at creases that the
 * preparation has split, and at edges with more than two triangles |
 * | UnknownCurvature | 1 | 1 where there is no estimate, and all curvatures are zero; a warning
 * counts them |
 *
 * From a DerivativeDoubt of 1 on the derivatives mean nothing, as mostly on the long, thin
 * triangles of CAD programs and where several lie in one plane; suggestive contours, parabolic
 * lines and those of zero mean curvature end there. It comes with CurvatureDerivatives only.
 *
 * The input's normals (the active ones, else the array "Normals") are used as they are; what is
 * missing or not finite is computed as vtkNPRSurfaceNormals does, or found by the estimator.
 *
 * Of pieces of a surface, and of what happens if the filter is aborted, the same holds as for
 * vtkNPRSurfaceNormals. An automatic NeighbourhoodRadius is that of the piece, and asks for the
 * ghost levels of the largest: for pieces set it, or bring it as field data.
 * @sa vtkNPRSurfaceNormals vtkNPRCurvatureDerivatives
 */
#ifndef vtkNPRCurvatureTensor_h
#define vtkNPRCurvatureTensor_h

#include "vtkNPRFiltersCurvatureModule.h"
#include <vtkPolyDataAlgorithm.h>

#ifndef __VTK_WRAP__
#include "nprVTKCompat.h"
#include <memory>
namespace npr
{
class CurvatureEstimator;
class TriangleMesh;
}
#endif

class VTKNPRFILTERSCURVATURE_EXPORT vtkNPRCurvatureTensor : public vtkPolyDataAlgorithm
{
public:
  static vtkNPRCurvatureTensor* New();
  vtkTypeMacro(vtkNPRCurvatureTensor, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// How curvature is estimated.
  enum EstimatorType
  {
    /// From the triangles at a point (Rusinkiewicz 2004). The fastest; it converges with the square
    /// of the edge length on regular meshes, and stalls at a few per cent on irregular ones, where
    /// the derivatives do not converge at all.
    PER_FACE = 0,
    /// From measures of the triangles around, with better normals (Lachaud, Romon, Thibert and
    /// Coeurjolly 2020; see nprCorrectedMeasures.h). Converges on irregular meshes, on noisy ones
    /// and at borders, too.
    CORRECTED_MEASURES = 1,
    /// From polynomials fitted to the points around (Cazals and Pouget 2005; see nprJets.h). Both
    /// curvature and its derivatives converge on irregular meshes, on noisy ones and at borders.
    JETS = 2
  };
  ///@{
  /// Default is JETS.
  vtkSetClampMacro(Estimator, int, PER_FACE, JETS);
  vtkGetMacro(Estimator, int);
  void SetEstimatorToPerFace() { this->SetEstimator(PER_FACE); }
  void SetEstimatorToCorrectedMeasures() { this->SetEstimator(CORRECTED_MEASURES); }
  void SetEstimatorToJets() { this->SetEstimator(JETS); }
  ///@}

  ///@{
  /// How far the estimate looks, in the unit of RadiusUnit; PER_FACE always takes one ring. 0 (the
  /// default) chooses by the surface's noise, about 3 mean edges on a clean one (CORRECTED_MEASURES
  /// up to 5); what that came to stands in the output's field data array "NeighbourhoodRadius"
  /// (mean edges), and where the input has that array it holds, so that the parts of a surface and
  /// the frames of an animation can share one: without it, pieces are asked for as many ghost
  /// levels as the greatest choice needs. JETS and CORRECTED_MEASURES take from 1.5 to 40 mean
  /// edges; by themselves they choose at most 28 and 14.
  vtkSetClampMacro(NeighbourhoodRadius, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(NeighbourhoodRadius, double);
  ///@}

  /// What a NeighbourhoodRadius of 1 is.
  enum RadiusUnitType
  {
    /// The mean length of the edges around each point: the radius follows the mesh's density.
    MEAN_EDGE = 0,
    /// The surface's length scale (nprLengthScale.h): the same radius everywhere, on every mesh of
    /// the surface.
    LENGTH_SCALE = 1
  };
  ///@{
  /// Default is MEAN_EDGE.
  vtkSetClampMacro(RadiusUnit, int, MEAN_EDGE, LENGTH_SCALE);
  vtkGetMacro(RadiusUnit, int);
  void SetRadiusUnitToMeanEdge() { this->SetRadiusUnit(MEAN_EDGE); }
  void SetRadiusUnitToLengthScale() { this->SetRadiusUnit(LENGTH_SCALE); }
  ///@}

  ///@{
  /// Degree of the polynomials of JETS, 2 to 4. Default is 4; lower ones are faster and less
  /// accurate, and with 2 the derivatives do not converge.
  vtkSetClampMacro(JetDegree, int, 2, 4);
  vtkGetMacro(JetDegree, int);
  ///@}

  /// The estimators by the names that users write, such as "per-face".
  static int GetNumberOfEstimators();
  /// Null for a number that no estimator has.
  static const char* GetEstimatorName(int estimator);
  /// -1 for a name that no estimator has.
  static int FindEstimator(const char* name);

  ///@{
  /// Standard deviation of a smoothing of the curvature tensor and its derivatives along the
  /// surface, as a fraction of the surface's length scale (see nprSurfaceDiffusion.h). Nothing
  /// flows across creases that the preparation has split. 0 (the default) does not smooth; useful
  /// values go up to about 0.1. The work grows with radius / edge length, and ends at about 100
  /// edges.
  vtkSetClampMacro(SmoothingRadius, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(SmoothingRadius, double);
  ///@}

  ///@{
  /// How well the smoothing keeps ridges and edges apart from what lies beside them: where the
  /// surface has a radius of curvature of (this times the radius of the smoothing), across the bend
  /// a third of the flow is left; what bends more is kept, and along a ridge the flow is free. No
  /// unit; 0 (the default) smooths everything alike, useful values go up to about 5.
  vtkSetClampMacro(FeaturePreservation, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(FeaturePreservation, double);
  ///@}

  /// @name Which arrays the output gets
  /// On by default but for ShapeIndex, Curvedness and PointArea.
  ///@{
  vtkSetMacro(OutputNormals, bool);
  vtkGetMacro(OutputNormals, bool);
  vtkBooleanMacro(OutputNormals, bool);
  vtkSetMacro(OutputTensor, bool);
  vtkGetMacro(OutputTensor, bool);
  vtkBooleanMacro(OutputTensor, bool);
  vtkSetMacro(OutputPrincipalCurvatures, bool);
  vtkGetMacro(OutputPrincipalCurvatures, bool);
  vtkBooleanMacro(OutputPrincipalCurvatures, bool);
  vtkSetMacro(OutputPrincipalDirections, bool);
  vtkGetMacro(OutputPrincipalDirections, bool);
  vtkBooleanMacro(OutputPrincipalDirections, bool);
  vtkSetMacro(OutputMeanCurvature, bool);
  vtkGetMacro(OutputMeanCurvature, bool);
  vtkBooleanMacro(OutputMeanCurvature, bool);
  vtkSetMacro(OutputGaussianCurvature, bool);
  vtkGetMacro(OutputGaussianCurvature, bool);
  vtkBooleanMacro(OutputGaussianCurvature, bool);
  vtkSetMacro(OutputDerivatives, bool);
  vtkGetMacro(OutputDerivatives, bool);
  vtkBooleanMacro(OutputDerivatives, bool);
  vtkSetMacro(OutputDerivativeDoubt, bool);
  vtkGetMacro(OutputDerivativeDoubt, bool);
  vtkBooleanMacro(OutputDerivativeDoubt, bool);
  vtkSetMacro(OutputShapeIndex, bool);
  vtkGetMacro(OutputShapeIndex, bool);
  vtkBooleanMacro(OutputShapeIndex, bool);
  vtkSetMacro(OutputCurvedness, bool);
  vtkGetMacro(OutputCurvedness, bool);
  vtkBooleanMacro(OutputCurvedness, bool);
  vtkSetMacro(OutputPointArea, bool);
  vtkGetMacro(OutputPointArea, bool);
  vtkBooleanMacro(OutputPointArea, bool);
  vtkSetMacro(OutputBorderPoints, bool);
  vtkGetMacro(OutputBorderPoints, bool);
  vtkBooleanMacro(OutputBorderPoints, bool);
  vtkSetMacro(OutputUnknownCurvature, bool);
  vtkGetMacro(OutputUnknownCurvature, bool);
  vtkBooleanMacro(OutputUnknownCurvature, bool);
  ///@}

protected:
  vtkNPRCurvatureTensor();
  ~vtkNPRCurvatureTensor() override;

  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkNPRCurvatureTensor(const vtkNPRCurvatureTensor&) = delete;
  void operator=(const vtkNPRCurvatureTensor&) = delete;

#ifndef __VTK_WRAP__
  /// Without a surface one that reaches as far as any surface might make it.
  std::unique_ptr<npr::CurvatureEstimator> MakeEstimator(
    vtkPolyData* input, const npr::TriangleMesh* mesh) const;
  /// False if it was aborted: then the output is unfinished.
  bool Compute(vtkPolyData* input, vtkPolyData* output);
#endif

  int Estimator = JETS;
  double NeighbourhoodRadius = 0.0;
  int RadiusUnit = MEAN_EDGE;
  int JetDegree = 4;
  double SmoothingRadius = 0.0;
  double FeaturePreservation = 0.0;
  bool OutputNormals = true;
  bool OutputTensor = true;
  bool OutputPrincipalCurvatures = true;
  bool OutputPrincipalDirections = true;
  bool OutputMeanCurvature = true;
  bool OutputGaussianCurvature = true;
  bool OutputDerivatives = true;
  bool OutputDerivativeDoubt = true;
  bool OutputShapeIndex = false;
  bool OutputCurvedness = false;
  bool OutputPointArea = false;
  bool OutputBorderPoints = true;
  bool OutputUnknownCurvature = true;
};

#endif
