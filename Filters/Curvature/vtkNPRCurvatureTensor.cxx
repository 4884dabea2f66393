// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRCurvatureTensor.h"

#include "nprArrayNames.h"
#include "nprCurvature.h"
#include "nprLengthScale.h"
#include "nprSurfaceDiffusion.h"
#include "nprSurfaceNormals.h"
#include "nprTangentArrays.h"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

vtkStandardNewMacro(vtkNPRCurvatureTensor);

//------------------------------------------------------------------------------
vtkNPRCurvatureTensor::vtkNPRCurvatureTensor() = default;
vtkNPRCurvatureTensor::~vtkNPRCurvatureTensor() = default;

//------------------------------------------------------------------------------
int vtkNPRCurvatureTensor::RequestData(
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
  const npr::Tuples<3> normals = npr::GetUnitNormals(mesh, npr::FindNormals(input));
  this->UpdateProgress(0.3);
  npr::Tuples<6> tensors = npr::ComputeCurvatureTensors(mesh, normals);
  if (this->SmoothingRadius > 0.0)
  {
    this->UpdateProgress(0.5);
    npr::SurfaceDiffusion(mesh, normals)
      .SmoothTensors(tensors, this->SmoothingRadius * npr::GetLengthScale(input));
  }
  this->UpdateProgress(0.8);
  output->GetPointData()->SetNormals(npr::MakeArray<3>(npr::names::Normals, normals));
  npr::AddCurvatureArrays(output, tensors, normals);

  const std::vector<unsigned char> border = npr::ComputeBorderPoints(mesh);
  vtkNew<vtkUnsignedCharArray> borderPoints;
  borderPoints->SetName(npr::names::BorderPoints);
  borderPoints->SetNumberOfTuples(static_cast<vtkIdType>(border.size()));
  std::copy(border.begin(), border.end(), borderPoints->GetPointer(0));
  output->GetPointData()->AddArray(borderPoints);
  return 1;
}

//------------------------------------------------------------------------------
void vtkNPRCurvatureTensor::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SmoothingRadius: " << this->SmoothingRadius << "\n";
}
