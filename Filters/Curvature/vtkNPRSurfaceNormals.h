// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPRSurfaceNormals
 * @brief Computes the unit normals at the points of a triangle mesh.
 *
 * The normals become the array "Normals" and the active normals of the output. The triangles should
 * be clean and oriented: run vtkNPRSurfacePreparation first. Where that has split the surface along
 * creases, each copy of a point gets the normal of its own patch. On borders the normal is
 * corrected for the missing half of its neighbourhood; where there is no area it still is a unit
 * vector.
 *
 * Pieces of a surface have the normals of the whole: the filter asks for the ghost levels that it
 * needs, and drops them. With smoothing it asks for 24, enough for a radius of four edges, and the
 * input should have the field data LengthScale of the whole; then results differ by what the steps
 * do (see nprSurfaceDiffusion.h). If the filter is aborted the output is the input.
 *
 * N. Max, "Weights for Computing Vertex Normals from Facet Normals", JGT 4(2), 1999.
 * @sa vtkNPRSurfacePreparation vtkNPRCurvatureTensor
 */
#ifndef vtkNPRSurfaceNormals_h
#define vtkNPRSurfaceNormals_h

#include "vtkNPRFiltersCurvatureModule.h"
#include <vtkPolyDataAlgorithm.h>

class VTKNPRFILTERSCURVATURE_EXPORT vtkNPRSurfaceNormals : public vtkPolyDataAlgorithm
{
public:
  static vtkNPRSurfaceNormals* New();
  vtkTypeMacro(vtkNPRSurfaceNormals, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// How much a triangle counts at a point.
  enum WeightingType
  {
    MAX = 0,  ///< area / (product of the squared edges at the point): exact on spheres
    AREA = 1, ///< its area
    ANGLE = 2 ///< its angle at the point
  };
  ///@{
  /// Default is MAX.
  vtkSetClampMacro(Weighting, int, MAX, ANGLE);
  vtkGetMacro(Weighting, int);
  void SetWeightingToMax() { this->SetWeighting(MAX); }
  void SetWeightingToArea() { this->SetWeighting(AREA); }
  void SetWeightingToAngle() { this->SetWeighting(ANGLE); }
  ///@}

  ///@{
  /// Standard deviation of a smoothing of the normals along the surface, as a fraction of the
  /// surface's length scale (see nprSurfaceDiffusion.h). Nothing flows across creases that the
  /// preparation has split. 0 (the default) does not smooth; useful values go up to about 0.1. The
  /// work grows with radius / edge length, and ends at about 100 edges.
  vtkSetClampMacro(SmoothingRadius, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(SmoothingRadius, double);
  ///@}

  ///@{
  /// How well the smoothing keeps ridges and edges: where the surface has a radius of curvature of
  /// (this times the radius of the smoothing), across the bend a third of the flow is left; what
  /// bends more is kept, what bends less is smoothed, and along a ridge the flow is free. No unit;
  /// 0 (the default) smooths everything alike, useful values go up to about 5.
  vtkSetClampMacro(FeaturePreservation, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(FeaturePreservation, double);
  ///@}

  /// @name Scales
  /// Arrays Normals1, Normals2 and so on, each smoother than the one before, for shading that shows
  /// features of every size (S. Rusinkiewicz, M. Burns, D. DeCarlo, "Exaggerated Shading for
  /// Depicting Shape and Detail", SIGGRAPH 2006). Array i is smoothed by ScaleRadius *
  /// ScaleFactor^(i - 1), each from the last one, so that all together cost little more than the
  /// smoothest.
  ///@{
  /// How many. Default is 0.
  vtkSetClampMacro(NumberOfScales, int, 0, 32);
  vtkGetMacro(NumberOfScales, int);
  /// Standard deviation of the first scale's smoothing, as a fraction of the surface's length
  /// scale. Default is 0.01. What is below SmoothingRadius is no smoother than Normals.
  vtkSetClampMacro(ScaleRadius, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(ScaleRadius, double);
  /// From one scale's radius to the next. No unit; default is the square root of 2.
  vtkSetClampMacro(ScaleFactor, double, 1.0, 10.0);
  vtkGetMacro(ScaleFactor, double);
  ///@}

protected:
  vtkNPRSurfaceNormals();
  ~vtkNPRSurfaceNormals() override;

  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkNPRSurfaceNormals(const vtkNPRSurfaceNormals&) = delete;
  void operator=(const vtkNPRSurfaceNormals&) = delete;

  /// False if it was aborted: then the output is unfinished.
  bool Compute(vtkPolyData* input, vtkPolyData* output);

  int Weighting = MAX;
  double SmoothingRadius = 0.0;
  double FeaturePreservation = 0.0;
  int NumberOfScales = 0;
  double ScaleRadius = 0.01;
  double ScaleFactor = 1.4142135623730951;
};

#endif
