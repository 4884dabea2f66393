// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRSurfaceNormals.h"

#include "nprArrayNames.h"
#include "nprLengthScale.h"
#include "nprSurfaceDiffusion.h"
#include "nprSurfaceNormals.h"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

vtkStandardNewMacro(vtkNPRSurfaceNormals);

//------------------------------------------------------------------------------
vtkNPRSurfaceNormals::vtkNPRSurfaceNormals() = default;
vtkNPRSurfaceNormals::~vtkNPRSurfaceNormals() = default;

//------------------------------------------------------------------------------
int vtkNPRSurfaceNormals::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  output->ShallowCopy(input);
  if (input->GetNumberOfPoints() == 0)
  {
    return 1;
  }
  npr::TriangleMesh mesh(input);
  mesh.BuildIncidence();
  this->UpdateProgress(0.3);
  npr::Tuples<3> normals =
    npr::ComputeNormals(mesh, static_cast<npr::NormalWeights>(this->Weighting));
  if (this->SmoothingRadius > 0.0)
  {
    this->UpdateProgress(0.5);
    npr::SurfaceDiffusion(mesh, normals)
      .SmoothNormals(normals, this->SmoothingRadius * npr::GetLengthScale(input));
  }
  output->GetPointData()->SetNormals(npr::MakeArray<3>(npr::names::Normals, normals));
  return 1;
}

//------------------------------------------------------------------------------
void vtkNPRSurfaceNormals::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Weighting: " << this->Weighting << "\n";
  os << indent << "SmoothingRadius: " << this->SmoothingRadius << "\n";
}
