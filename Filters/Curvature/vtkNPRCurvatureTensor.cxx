// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRCurvatureTensor.h"

#include "nprArrayNames.h"
#include "nprCorrectedMeasures.h"
#include "nprCurvature.h"
#include "nprCurvatureDerivatives.h"
#include "nprDerivativeDoubt.h"
#include "nprFaceCurvature.h"
#include "nprGhostLevels.h"
#include "nprJets.h"
#include "nprLengthScale.h"
#include "nprSurfaceDiffusion.h"
#include "nprSurfaceNormals.h"
#include "nprTangentArrays.h"

#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkNPRCurvatureTensor);

namespace
{
constexpr std::array<const char*, 3> EstimatorNames = { "per-face", "corrected-measures", "jets" };

/// The radius that comes with the surface, in mean edges; 0 where there is none.
double GetStoredRadius(vtkPolyData* surface)
{
  vtkDataArray* array = surface->GetFieldData()->GetArray(npr::names::NeighbourhoodRadius);
  const double radius = array && array->GetNumberOfTuples() > 0 ? array->GetComponent(0, 0) : 0.0;
  return radius > 0.0 && std::isfinite(radius) ? radius : 0.0;
}

void StoreRadius(vtkPolyData* surface, double radius)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(npr::names::NeighbourhoodRadius);
  array->InsertNextValue(radius);
  surface->GetFieldData()->AddArray(array);
}

/// Numbers that are none, such as those of areas beyond single precision, say that nothing is
/// known.
void DropNonFinite(const npr::Tuples<3>& normals, npr::CurvatureEstimate& estimate)
{
  const bool hasDerivatives = !estimate.Derivatives.empty();
  vtkSMPTools::For(0, static_cast<vtkIdType>(normals.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        if (estimate.Normals[i].allFinite() && estimate.Tensors[i].allFinite() &&
          (!hasDerivatives || estimate.Derivatives[i].allFinite()))
        {
          continue;
        }
        estimate.Normals[i] = normals[i];
        estimate.Tensors[i].setZero();
        if (hasDerivatives)
        {
          estimate.Derivatives[i].setZero();
        }
        estimate.Unknown[i] = 1;
      }
    });
}

/// The estimate in the tangent planes of other normals, for users who bring theirs.
void TurnTo(const npr::Tuples<3>& normals, npr::CurvatureEstimate& estimate)
{
  vtkSMPTools::For(0, static_cast<vtkIdType>(normals.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const Eigen::Vector3d from = estimate.Normals[i].cast<double>();
        const Eigen::Vector3d to = normals[i].cast<double>();
        const npr::MinimalRotation rotation(from, to);
        if (!rotation.IsValid())
        {
          continue;
        }
        const npr::TangentFrame frame = npr::MakeTangentFrame(from);
        const npr::TangentFrame turned = rotation(frame);
        const Eigen::Vector3d form = npr::ToFrame(estimate.Tensors[i].cast<double>(), frame);
        estimate.Tensors[i] = npr::FromFrame(form, turned).cast<float>();
        if (!estimate.Derivatives.empty())
        {
          estimate.Derivatives[i] = npr::ChangeFrame(
            estimate.Derivatives[i].cast<double>(), turned, npr::MakeTangentFrame(to))
                                      .cast<float>();
        }
        estimate.Normals[i] = normals[i];
      }
    });
}
}

//------------------------------------------------------------------------------
vtkNPRCurvatureTensor::vtkNPRCurvatureTensor() = default;
vtkNPRCurvatureTensor::~vtkNPRCurvatureTensor() = default;

//------------------------------------------------------------------------------
int vtkNPRCurvatureTensor::GetNumberOfEstimators()
{
  return static_cast<int>(EstimatorNames.size());
}

//------------------------------------------------------------------------------
const char* vtkNPRCurvatureTensor::GetEstimatorName(int estimator)
{
  return estimator >= 0 && estimator < GetNumberOfEstimators() ? EstimatorNames[estimator]
                                                               : nullptr;
}

//------------------------------------------------------------------------------
int vtkNPRCurvatureTensor::FindEstimator(const char* name)
{
  const auto found = std::find_if(EstimatorNames.begin(), EstimatorNames.end(),
    [name](const char* known) { return name && std::strcmp(name, known) == 0; });
  return found == EstimatorNames.end() ? -1 : static_cast<int>(found - EstimatorNames.begin());
}

//------------------------------------------------------------------------------
std::unique_ptr<npr::CurvatureEstimator> vtkNPRCurvatureTensor::MakeEstimator(
  vtkPolyData* input, const npr::TriangleMesh* mesh) const
{
  if (this->Estimator == PER_FACE)
  {
    return std::make_unique<npr::FaceCurvature>();
  }
  double radius = 0.0;
  double length = 0.0;
  if (this->NeighbourhoodRadius <= 0.0)
  {
    radius = input ? GetStoredRadius(input) : 0.0;
  }
  else if (this->RadiusUnit == LENGTH_SCALE)
  {
    length = this->NeighbourhoodRadius * (input ? npr::GetLengthScale(input, *mesh) : 1.0);
  }
  else
  {
    radius = this->NeighbourhoodRadius;
  }
  if (this->Estimator == CORRECTED_MEASURES)
  {
    return std::make_unique<npr::CorrectedMeasures>(
      npr::CorrectedMeasures::Options{ radius, length });
  }
  return std::make_unique<npr::Jets>(npr::Jets::Options{ this->JetDegree, radius, length });
}

//------------------------------------------------------------------------------
int vtkNPRCurvatureTensor::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  const int smoothing = this->SmoothingRadius > 0.0 ? npr::DiffusionReach : 0;
  npr::RequestGhostLevels(inputs[0]->GetInformationObject(0), outputs->GetInformationObject(0),
    this->MakeEstimator(nullptr, nullptr)->GetReach() + npr::NormalsReach + smoothing +
      (this->OutputDerivatives && this->OutputDerivativeDoubt ? npr::DoubtReach : 0));
  return this->Superclass::RequestUpdateExtent(request, inputs, outputs);
}

//------------------------------------------------------------------------------
int vtkNPRCurvatureTensor::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  output->ShallowCopy(input);
  if (input->GetNumberOfPoints() > 0 && !this->Compute(input, output))
  {
    output->ShallowCopy(input);
  }
  npr::DropExtraGhostLevels(output, outputs->GetInformationObject(0));
  return 1;
}

//------------------------------------------------------------------------------
bool vtkNPRCurvatureTensor::Compute(vtkPolyData* input, vtkPolyData* output)
{
  const npr::Progress progress = npr::ReportTo(this);
  npr::TriangleMesh mesh(input);
  if (!progress(0.1))
  {
    return false;
  }
  mesh.BuildBorder();
  vtkDataArray* const given = npr::FindNormals(input);
  const npr::Tuples<3> normals = npr::GetUnitNormals(mesh, given);
  if (!progress(0.2))
  {
    return false;
  }
  const auto estimator = this->MakeEstimator(input, &mesh);
  npr::CurvatureEstimate estimate =
    estimator->Estimate(mesh, normals, this->OutputDerivatives, npr::PartOf(progress, 0.2, 0.8));
  if (!progress(0.8))
  {
    return false;
  }
  if (estimate.Radius > 0.0)
  {
    StoreRadius(output, estimate.Radius);
  }
  DropNonFinite(normals, estimate);
  if (given && estimator->FindsNormals())
  {
    TurnTo(normals, estimate);
  }
  if (this->SmoothingRadius > 0.0)
  {
    npr::SurfaceDiffusion diffusion(mesh, estimate.Normals);
    const double radius = this->SmoothingRadius * npr::GetLengthScale(input, mesh);
    diffusion.PreserveFeatures(mesh, this->FeaturePreservation, radius);
    diffusion.SmoothTensors(estimate.Tensors, radius, npr::PartOf(progress, 0.8, 0.85));
    if (this->OutputDerivatives)
    {
      npr::Tuples<3> u(estimate.Normals.size());
      for (std::size_t i = 0; i < u.size(); ++i)
      {
        u[i] = npr::MakeTangentFrame(estimate.Normals[i].cast<double>()).U.cast<float>();
      }
      diffusion.SmoothCubics(estimate.Derivatives, u, radius, npr::PartOf(progress, 0.85, 0.9));
    }
  }
  if (!progress(0.9))
  {
    return false;
  }

  vtkPointData* const pointData = output->GetPointData();
  pointData->RemoveArray(npr::names::DerivativeDoubt); // of other derivatives
  if (this->OutputDerivativeDoubt && this->OutputDerivatives)
  {
    pointData->AddArray(npr::MakeArray(npr::names::DerivativeDoubt,
      npr::ComputeDerivativeDoubt(mesh, estimate.Normals, estimate.Tensors, estimate.Derivatives)));
  }
  npr::AddCurvatureArrays(output, std::move(estimate.Tensors), estimate.Normals,
    { this->OutputTensor, this->OutputPrincipalCurvatures, this->OutputPrincipalDirections,
      this->OutputMeanCurvature, this->OutputGaussianCurvature, this->OutputShapeIndex,
      this->OutputCurvedness },
    std::move(estimate.Derivatives));
  if (this->OutputNormals)
  {
    pointData->SetNormals(npr::MakeArray(npr::names::Normals, std::move(estimate.Normals)));
  }
  if (this->OutputPointArea)
  {
    std::vector<float> areas = npr::ComputePointAreas(mesh);
    for (float& area : areas)
    {
      area = std::min(area, std::numeric_limits<float>::max());
    }
    pointData->AddArray(npr::MakeArray(npr::names::PointArea, areas));
  }
  if (this->OutputBorderPoints)
  {
    pointData->AddArray(npr::MakeFlagArray(npr::names::BorderPoints, mesh.GetBorder()));
  }
  if (this->OutputUnknownCurvature)
  {
    pointData->AddArray(npr::MakeFlagArray(npr::names::UnknownCurvature, estimate.Unknown));
  }
  const auto unknown = std::count(estimate.Unknown.begin(), estimate.Unknown.end(), 1);
  if (unknown > 0)
  {
    vtkWarningMacro("There is no curvature at "
      << unknown << " of " << estimate.Unknown.size()
      << " points, which have no triangle with an area: it is zero there, and the array "
      << npr::names::UnknownCurvature
      << " says where. vtkNPRSurfacePreparation drops such points.");
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkNPRCurvatureTensor::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Estimator: " << GetEstimatorName(this->Estimator) << "\n";
  os << indent << "NeighbourhoodRadius: " << this->NeighbourhoodRadius << "\n";
  os << indent << "RadiusUnit: " << (this->RadiusUnit == MEAN_EDGE ? "mean edge" : "length scale")
     << "\n";
  os << indent << "JetDegree: " << this->JetDegree << "\n";
  os << indent << "SmoothingRadius: " << this->SmoothingRadius << "\n";
  os << indent << "FeaturePreservation: " << this->FeaturePreservation << "\n";
  os << indent << "OutputNormals: " << this->OutputNormals << "\n";
  os << indent << "OutputTensor: " << this->OutputTensor << "\n";
  os << indent << "OutputPrincipalCurvatures: " << this->OutputPrincipalCurvatures << "\n";
  os << indent << "OutputPrincipalDirections: " << this->OutputPrincipalDirections << "\n";
  os << indent << "OutputMeanCurvature: " << this->OutputMeanCurvature << "\n";
  os << indent << "OutputGaussianCurvature: " << this->OutputGaussianCurvature << "\n";
  os << indent << "OutputDerivatives: " << this->OutputDerivatives << "\n";
  os << indent << "OutputDerivativeDoubt: " << this->OutputDerivativeDoubt << "\n";
  os << indent << "OutputShapeIndex: " << this->OutputShapeIndex << "\n";
  os << indent << "OutputCurvedness: " << this->OutputCurvedness << "\n";
  os << indent << "OutputPointArea: " << this->OutputPointArea << "\n";
  os << indent << "OutputBorderPoints: " << this->OutputBorderPoints << "\n";
  os << indent << "OutputUnknownCurvature: " << this->OutputUnknownCurvature << "\n";
}
