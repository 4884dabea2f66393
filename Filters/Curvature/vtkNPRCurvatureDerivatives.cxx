// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRCurvatureDerivatives.h"

#include "nprArrayNames.h"
#include "nprCurvature.h"
#include "nprCurvatureDerivatives.h"
#include "nprDerivativeDoubt.h"
#include "nprFaceCurvature.h"
#include "nprGhostLevels.h"
#include "nprLengthScale.h"
#include "nprProgress.h"
#include "nprSurfaceDiffusion.h"
#include "nprSurfaceNormals.h"
#include "nprTangentArrays.h"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>

#include <cmath>

vtkStandardNewMacro(vtkNPRCurvatureDerivatives);

namespace
{
/// The derivatives over MakeTangentFrame(normal), from P, Q, S and T.
npr::Tuples<4> ToTangentFrames(
  const npr::Tuples<4>& derivatives, const npr::Tuples<3>& normals, const npr::Tuples<3>& e1)
{
  npr::Tuples<4> cubics(derivatives.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(cubics.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const Eigen::Vector3d normal = normals[i].cast<double>();
        const Eigen::Vector3d u = e1[i].cast<double>();
        cubics[i] = npr::ChangeFrame(
          derivatives[i].cast<double>(), { u, normal.cross(u) }, npr::MakeTangentFrame(normal))
                      .cast<float>();
      }
    });
  return cubics;
}
}

//------------------------------------------------------------------------------
vtkNPRCurvatureDerivatives::vtkNPRCurvatureDerivatives() = default;
vtkNPRCurvatureDerivatives::~vtkNPRCurvatureDerivatives() = default;

//------------------------------------------------------------------------------
int vtkNPRCurvatureDerivatives::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  const int smoothing = this->SmoothingRadius > 0.0 ? npr::DiffusionReach : 0;
  npr::RequestGhostLevels(inputs[0]->GetInformationObject(0), outputs->GetInformationObject(0),
    npr::FaceCurvature().GetReach() + npr::NormalsReach + smoothing + npr::DoubtReach);
  return this->Superclass::RequestUpdateExtent(request, inputs, outputs);
}

//------------------------------------------------------------------------------
int vtkNPRCurvatureDerivatives::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  output->ShallowCopy(input);
  vtkDataArray* tensors = input->GetPointData()->GetArray(npr::names::CurvatureTensor);
  if (input->GetNumberOfPoints() > 0 &&
    (!tensors || tensors->GetNumberOfComponents() != 6 ||
      tensors->GetNumberOfTuples() != input->GetNumberOfPoints()))
  {
    vtkErrorMacro("The input has no point array "
      << npr::names::CurvatureTensor << " of 6 components: run vtkNPRCurvatureTensor first.");
    return 0;
  }
  if (input->GetNumberOfPoints() > 0 && !this->Compute(input, output))
  {
    output->ShallowCopy(input);
  }
  npr::DropExtraGhostLevels(output, outputs->GetInformationObject(0));
  return 1;
}

//------------------------------------------------------------------------------
bool vtkNPRCurvatureDerivatives::Compute(vtkPolyData* input, vtkPolyData* output)
{
  const npr::Progress progress = npr::ReportTo(this);
  vtkDataArray* tensorArray = input->GetPointData()->GetArray(npr::names::CurvatureTensor);
  npr::TriangleMesh mesh(input);
  mesh.BuildIncidence();
  const npr::Tuples<3> normals = npr::GetUnitNormals(mesh, npr::FindNormals(input));
  npr::Tuples<6> tensors = npr::ReadTuples<6>(tensorArray);
  for (auto& tensor : tensors)
  {
    if (!tensor.allFinite())
    {
      tensor.setZero();
    }
  }
  vtkDataArray* directions = input->GetPointData()->GetArray(npr::names::PrincipalDirection1);
  if (!directions || directions->GetNumberOfComponents() != 3 ||
    directions->GetNumberOfTuples() != input->GetNumberOfPoints())
  {
    npr::AddCurvatureArrays(output, tensors, normals);
    directions = output->GetPointData()->GetArray(npr::names::PrincipalDirection1);
  }
  npr::Tuples<3> e1 = npr::ReadTuples<3>(directions);
  bool isMended = false;
  for (std::size_t i = 0; i < e1.size(); ++i)
  {
    if (!(std::abs(e1[i].squaredNorm() - 1.0f) < 1e-3f))
    {
      e1[i] =
        npr::Diagonalise(tensors[i].cast<double>(), normals[i].cast<double>()).E1.cast<float>();
      isMended = true;
    }
  }
  if (isMended)
  {
    output->GetPointData()->AddArray(npr::MakeArray<3>(npr::names::PrincipalDirection1, e1));
  }
  if (!progress(0.3))
  {
    return false;
  }
  npr::Tuples<4> derivatives = npr::ComputeCurvatureDerivatives(mesh, tensors, normals, e1);
  for (auto& derivative : derivatives)
  {
    if (!derivative.allFinite())
    {
      derivative.setZero();
    }
  }
  if (this->SmoothingRadius > 0.0)
  {
    npr::SurfaceDiffusion(mesh, normals)
      .SmoothCubics(derivatives, e1, this->SmoothingRadius * npr::GetLengthScale(input, mesh),
        npr::PartOf(progress, 0.6, 0.95));
  }
  if (!progress(0.95))
  {
    return false;
  }
  output->GetPointData()->AddArray(npr::MakeArray(npr::names::DerivativeDoubt,
    npr::ComputeDerivativeDoubt(
      mesh, normals, tensors, ToTangentFrames(derivatives, normals, e1))));
  output->GetPointData()->AddArray(
    npr::MakeArray<4>(npr::names::CurvatureDerivatives, derivatives));
  return true;
}

//------------------------------------------------------------------------------
void vtkNPRCurvatureDerivatives::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SmoothingRadius: " << this->SmoothingRadius << "\n";
}
