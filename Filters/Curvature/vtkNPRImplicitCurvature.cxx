// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRImplicitCurvature.h"

#include "nprArrayNames.h"
#include "nprCurvatureDerivatives.h"
#include "nprCurvatureEstimator.h"
#include "nprImplicitCurvature.h"
#include "nprLengthScale.h"
#include "nprProgress.h"
#include "nprSurfaceNormals.h"
#include "nprTangentArrays.h"
#include "nprTangentFrame.h"

#include <vtkImplicitFunction.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <utility>

vtkStandardNewMacro(vtkNPRImplicitCurvature);
vtkCxxSetSmartPointerMacro(vtkNPRImplicitCurvature, ImplicitFunction, vtkImplicitFunction);

namespace
{
double GetSize(vtkPolyData* surface, const npr::TriangleMesh& mesh)
{
  const double scale = npr::GetLengthScale(surface, mesh);
  if (scale > 0.0)
  {
    return scale;
  }
  const double quarter = 0.25 * surface->GetLength();
  return quarter > 0.0 && std::isfinite(quarter) ? quarter : 1.0;
}
}

//------------------------------------------------------------------------------
vtkNPRImplicitCurvature::vtkNPRImplicitCurvature() = default;
vtkNPRImplicitCurvature::~vtkNPRImplicitCurvature() = default;

//------------------------------------------------------------------------------
vtkImplicitFunction* vtkNPRImplicitCurvature::GetImplicitFunction() const
{
  return this->ImplicitFunction;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkNPRImplicitCurvature::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->ImplicitFunction ? std::max(own, this->ImplicitFunction->GetMTime()) : own;
}

//------------------------------------------------------------------------------
int vtkNPRImplicitCurvature::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  if (!this->ImplicitFunction)
  {
    vtkErrorMacro("There is no implicit function: call SetImplicitFunction first.");
    return 0;
  }
  output->ShallowCopy(input);
  const vtkIdType size = input->GetNumberOfPoints();
  if (size == 0)
  {
    return 1;
  }
  npr::TriangleMesh mesh(input);
  mesh.BuildIncidence();
  const double step = this->StepSize * GetSize(input, mesh);
  const double sign = this->FlipNormals ? -1.0 : 1.0;
  const auto gradient = [&](const Eigen::Vector3d& point)
  {
    Eigen::Vector3d value;
    this->ImplicitFunction->FunctionGradient(point.data(), value.data());
    return Eigen::Vector3d(sign * value);
  };
  npr::CurvatureEstimate estimate;
  estimate.Normals = npr::GetUnitNormals(mesh, npr::FindNormals(input));
  estimate.Tensors.assign(size, npr::Tuples<6>::value_type::Zero());
  estimate.Derivatives.assign(
    this->OutputDerivatives ? size : 0, npr::Tuples<4>::value_type::Zero());
  estimate.Unknown.assign(size, 1);

  // One point after the other: implicit functions need not stand several threads at a time.
  constexpr vtkIdType part = 10000;
  const npr::Progress progress = npr::ReportTo(this, 0.1, 0.9);
  for (vtkIdType i = 0; i < size; ++i)
  {
    if (i % part == 0 && !progress(static_cast<double>(i) / size))
    {
      return 1;
    }
    Eigen::Vector3d point;
    input->GetPoint(i, point.data());
    npr::LevelSetJet jet;
    if (point.allFinite() && npr::ComputeLevelSetJet(gradient, point, step, jet))
    {
      estimate.Unknown[i] = 0;
      estimate.Normals[i] = jet.Normal.cast<float>();
      estimate.Tensors[i] =
        npr::FromFrame(jet.Form, npr::MakeTangentFrame(jet.Normal)).cast<float>();
      if (this->OutputDerivatives)
      {
        estimate.Derivatives[i] = npr::ChangeFrame(jet.Cubic, npr::MakeTangentFrame(jet.Normal),
          npr::MakeTangentFrame(estimate.Normals[i].cast<double>()))
                                    .cast<float>();
      }
    }
  }

  vtkPointData* const pointData = output->GetPointData();
  pointData->RemoveArray(npr::names::DerivativeDoubt); // of a mesh's derivatives
  pointData->SetNormals(npr::MakeArray<3>(npr::names::Normals, estimate.Normals));
  npr::AddCurvatureArrays(output, std::move(estimate.Tensors), estimate.Normals,
    { true, true, true, true, true, this->OutputShapeIndex, this->OutputCurvedness },
    std::move(estimate.Derivatives));
  pointData->AddArray(npr::MakeFlagArray(npr::names::UnknownCurvature, estimate.Unknown));
  const auto unknown = std::count(estimate.Unknown.begin(), estimate.Unknown.end(), 1);
  if (unknown > 0)
  {
    vtkWarningMacro("There is no curvature at "
      << unknown << " of " << size
      << " points, where the function's gradient vanishes, is not finite, or turns within two "
         "steps of "
      << step << ": it is zero there, and the array " << npr::names::UnknownCurvature
      << " says where.");
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkNPRImplicitCurvature::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ImplicitFunction: " << this->ImplicitFunction.Get() << "\n";
  os << indent << "StepSize: " << this->StepSize << "\n";
  os << indent << "FlipNormals: " << this->FlipNormals << "\n";
  os << indent << "OutputDerivatives: " << this->OutputDerivatives << "\n";
  os << indent << "OutputShapeIndex: " << this->OutputShapeIndex << "\n";
  os << indent << "OutputCurvedness: " << this->OutputCurvedness << "\n";
}
