// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRCurvatureDerivatives.h"

#include "nprArrayNames.h"
#include "nprCurvatureDerivatives.h"
#include "nprLengthScale.h"
#include "nprSurfaceDiffusion.h"
#include "nprSurfaceNormals.h"
#include "nprTangentArrays.h"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

vtkStandardNewMacro(vtkNPRCurvatureDerivatives);

//------------------------------------------------------------------------------
vtkNPRCurvatureDerivatives::vtkNPRCurvatureDerivatives() = default;
vtkNPRCurvatureDerivatives::~vtkNPRCurvatureDerivatives() = default;

//------------------------------------------------------------------------------
int vtkNPRCurvatureDerivatives::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  output->ShallowCopy(input);
  if (input->GetNumberOfPoints() == 0)
  {
    return 1;
  }
  vtkDataArray* tensorArray = input->GetPointData()->GetArray(npr::names::CurvatureTensor);
  if (!tensorArray || tensorArray->GetNumberOfComponents() != 6)
  {
    vtkErrorMacro("The input has no point array "
      << npr::names::CurvatureTensor << " of 6 components: run vtkNPRCurvatureTensor first.");
    return 0;
  }
  npr::TriangleMesh mesh(input);
  mesh.BuildIncidence();
  const npr::Tuples<3> normals = npr::GetUnitNormals(mesh, npr::FindNormals(input));
  const npr::Tuples<6> tensors = npr::ReadTuples<6>(tensorArray);
  vtkDataArray* directions = input->GetPointData()->GetArray(npr::names::PrincipalDirection1);
  if (!directions || directions->GetNumberOfComponents() != 3)
  {
    npr::AddCurvatureArrays(output, tensors, normals);
    directions = output->GetPointData()->GetArray(npr::names::PrincipalDirection1);
  }
  const npr::Tuples<3> e1 = npr::ReadTuples<3>(directions);
  this->UpdateProgress(0.3);
  npr::Tuples<4> derivatives = npr::ComputeCurvatureDerivatives(mesh, tensors, normals, e1);
  if (this->SmoothingRadius > 0.0)
  {
    this->UpdateProgress(0.6);
    npr::SurfaceDiffusion(mesh, normals)
      .SmoothCubics(derivatives, e1, this->SmoothingRadius * npr::GetLengthScale(input));
  }
  output->GetPointData()->AddArray(
    npr::MakeArray<4>(npr::names::CurvatureDerivatives, derivatives));
  return 1;
}

//------------------------------------------------------------------------------
void vtkNPRCurvatureDerivatives::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SmoothingRadius: " << this->SmoothingRadius << "\n";
}
