// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPRSurfaceSmoothing
 * @brief Moves the points of a triangle mesh towards their neighbours, by OpenMesh's Jacobi
 * smoothing.
 *
 * Points on borders stay, and so do creases that vtkNPRSurfacePreparation has split. Triangles stay
 * as they are, too; only points move. Point and cell arrays pass, but for normals, curvatures and
 * what else belongs to the old shape, which is dropped: compute it anew.
 *
 * This changes the mesh. To smooth what is drawn from it, such as normals or curvature, see
 * vtkNPRSurfaceNormals and vtkNPRCurvatureTensor::SetSmoothingRadius.
 *
 * The input must be an oriented manifold of triangles, else there is an error that says so: run
 * vtkNPRSurfacePreparation first.
 * @sa vtkNPRSurfacePreparation
 */
#ifndef vtkNPRSurfaceSmoothing_h
#define vtkNPRSurfaceSmoothing_h

#include "vtkNPRFiltersSurfacesModule.h"
#include <vtkPolyDataAlgorithm.h>

class VTKNPRFILTERSSURFACES_EXPORT vtkNPRSurfaceSmoothing : public vtkPolyDataAlgorithm
{
public:
  static vtkNPRSurfaceSmoothing* New();
  vtkTypeMacro(vtkNPRSurfaceSmoothing, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum ComponentType
  {
    /// Along the surface only: triangles become more alike, the shape hardly changes. All
    /// neighbours weigh the same.
    TANGENTIAL = 0,
    /// Mostly across the surface: noise goes, triangles keep their shapes. Neighbours weigh by the
    /// cotangents of the angles opposite.
    NORMAL = 1,
    /// Both. All neighbours weigh the same.
    TANGENTIAL_AND_NORMAL = 2
  };
  ///@{
  /// Default is TANGENTIAL_AND_NORMAL.
  vtkSetClampMacro(Component, int, TANGENTIAL, TANGENTIAL_AND_NORMAL);
  vtkGetMacro(Component, int);
  void SetComponentToTangential() { this->SetComponent(TANGENTIAL); }
  void SetComponentToNormal() { this->SetComponent(NORMAL); }
  void SetComponentToTangentialAndNormal() { this->SetComponent(TANGENTIAL_AND_NORMAL); }
  ///@}

  ///@{
  /// 0 smooths towards the least area, which shrinks round shapes; 1 towards the least bending,
  /// which keeps their size better, goes smoothly over into what is fixed, and keeps the neighbours
  /// of the border fixed, too. Default is 1.
  vtkSetClampMacro(Continuity, int, 0, 1);
  vtkGetMacro(Continuity, int);
  ///@}

  ///@{
  /// Default is 10.
  vtkSetClampMacro(NumberOfIterations, int, 0, VTK_INT_MAX);
  vtkGetMacro(NumberOfIterations, int);
  ///@}

  ///@{
  /// Points on edges whose triangles' normals differ by more stay where they are; degrees, 0 to
  /// 180. Default is 180: no such edges. Lone sharp edges are taken for noise: see
  /// npr::FindCreases.
  vtkSetClampMacro(FeatureAngle, double, 0.0, 180.0);
  vtkGetMacro(FeatureAngle, double);
  ///@}

  ///@{
  /// How far a point may move along its old normal, as a fraction of the surface's length scale.
  /// 0, the default, is no limit.
  vtkSetClampMacro(MaximumMove, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumMove, double);
  ///@}

protected:
  vtkNPRSurfaceSmoothing();
  ~vtkNPRSurfaceSmoothing() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkNPRSurfaceSmoothing(const vtkNPRSurfaceSmoothing&) = delete;
  void operator=(const vtkNPRSurfaceSmoothing&) = delete;

  int Component = TANGENTIAL_AND_NORMAL;
  int Continuity = 1;
  int NumberOfIterations = 10;
  double FeatureAngle = 180.0;
  double MaximumMove = 0.0;
};

#endif
