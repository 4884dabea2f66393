// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPRImplicitCurvature
 * @brief Curvature at points of a surface that is known as an implicit function.
 *
 * Each point of the input gets the normal, the curvature and its derivatives of the function's
 * level set that runs through it, whatever the cells are: exact normals, and curvatures without the
 * errors of a mesh. The output has the point arrays of vtkNPRCurvatureTensor, with the same names,
 * units and signs: Normals, CurvatureTensor, PrincipalCurvature1 and 2, PrincipalDirection1 and 2,
 * MeanCurvature, GaussianCurvature, UnknownCurvature and, if wanted, CurvatureDerivatives,
 * ShapeIndex and Curvedness.
 *
 * The outside is where the function grows, as in vtkSphere, so that a sphere has the curvature +1/r
 * with normals outwards. The function's transform counts.
 *
 * @par Accuracy
 * The function's gradient is taken as it is, and differentiated by central differences. Where it is
 * smooth and in double precision, as in vtkSphere, vtkCylinder, vtkCone and vtkQuadric, curvatures
 * are right to 1e-10 and derivatives to 1e-7 or better with the default step; functions that are
 * interpolated, such as vtkImplicitVolume, want a step of some voxels. Within two steps of a kink,
 * as unions have, the values mean nothing. Where the gradient vanishes or turns within two steps,
 * as at the tip of a cone, there is no curvature: UnknownCurvature is 1 there, all else is zero,
 * the normal is that of the input or its triangles, and a warning counts such points.
 * @sa vtkNPRCurvatureTensor
 */
#ifndef vtkNPRImplicitCurvature_h
#define vtkNPRImplicitCurvature_h

#include "nprVTKCompat.h"
#include "vtkNPRFiltersCurvatureModule.h"
#include <vtkPolyDataAlgorithm.h>
#include <vtkSmartPointer.h>

VTK_ABI_NAMESPACE_BEGIN
class vtkImplicitFunction;
VTK_ABI_NAMESPACE_END

class VTKNPRFILTERSCURVATURE_EXPORT vtkNPRImplicitCurvature : public vtkPolyDataAlgorithm
{
public:
  static vtkNPRImplicitCurvature* New();
  vtkTypeMacro(vtkNPRImplicitCurvature, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The function whose level sets are measured. There is none by default, and no output without.
  virtual void SetImplicitFunction(vtkImplicitFunction* function);
  vtkImplicitFunction* GetImplicitFunction() const;
  ///@}

  ///@{
  /// The step of the differences, as a fraction of the surface's length scale (see
  /// nprLengthScale.h; without triangles a quarter of the diagonal of the bounds). Features of this
  /// size are lost. Default is 0.001.
  vtkSetClampMacro(StepSize, double, 1e-9, 1.0);
  vtkGetMacro(StepSize, double);
  ///@}

  ///@{
  /// Whether the outside is where the function falls, as for densities. Default is off.
  vtkSetMacro(FlipNormals, bool);
  vtkGetMacro(FlipNormals, bool);
  vtkBooleanMacro(FlipNormals, bool);
  ///@}

  /// @name Which arrays the output gets besides
  /// CurvatureDerivatives are on, ShapeIndex and Curvedness off by default.
  ///@{
  vtkSetMacro(OutputDerivatives, bool);
  vtkGetMacro(OutputDerivatives, bool);
  vtkBooleanMacro(OutputDerivatives, bool);
  vtkSetMacro(OutputShapeIndex, bool);
  vtkGetMacro(OutputShapeIndex, bool);
  vtkBooleanMacro(OutputShapeIndex, bool);
  vtkSetMacro(OutputCurvedness, bool);
  vtkGetMacro(OutputCurvedness, bool);
  vtkBooleanMacro(OutputCurvedness, bool);
  ///@}

  /// Counts the function's.
  vtkMTimeType GetMTime() override;

protected:
  vtkNPRImplicitCurvature();
  ~vtkNPRImplicitCurvature() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkNPRImplicitCurvature(const vtkNPRImplicitCurvature&) = delete;
  void operator=(const vtkNPRImplicitCurvature&) = delete;

  vtkSmartPointer<vtkImplicitFunction> ImplicitFunction;
  double StepSize = 0.001;
  bool FlipNormals = false;
  bool OutputDerivatives = true;
  bool OutputShapeIndex = false;
  bool OutputCurvedness = false;
};

#endif
