// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPROutlineNormals
 * @brief Normals along which enlarged back faces do not come apart at sharp edges.
 *
 * Where a surface is split along its sharp edges, so that it is shaded with several normals there,
 * its back faces leave gaps when they are pushed along these. The output has, besides all of the
 * input, the point array "OutlineNormals" (3, unit): the mean of the normals of all points at the
 * same place. PassTo() has a mapper take it for the outline of a vtkNPRShadingPass.
 *
 * ```
 * normals->SetInputConnection(surface); // with point normals
 * mapper->SetInputConnection(normals->GetOutputPort());
 * vtkNPROutlineNormals::PassTo(mapper);
 * ```
 *
 * @sa vtkNPRShadingPass
 */
#ifndef vtkNPROutlineNormals_h
#define vtkNPROutlineNormals_h

#include "nprVTKCompat.h"
#include "vtkNPRRenderingShadingModule.h"
#include <vtkPolyDataAlgorithm.h>

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyDataMapper;
VTK_ABI_NAMESPACE_END

class VTKNPRRENDERINGSHADING_EXPORT vtkNPROutlineNormals : public vtkPolyDataAlgorithm
{
public:
  static vtkNPROutlineNormals* New();
  vtkTypeMacro(vtkNPROutlineNormals, vtkPolyDataAlgorithm);

  /// Have a mapper, whose input comes from this filter, pass the array on to its shader.
  static void PassTo(vtkPolyDataMapper* mapper);

  /// The name of the vertex attribute in GLSL.
  static const char* GetAttributeName();

protected:
  vtkNPROutlineNormals();
  ~vtkNPROutlineNormals() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkNPROutlineNormals(const vtkNPROutlineNormals&) = delete;
  void operator=(const vtkNPROutlineNormals&) = delete;
};

#endif
