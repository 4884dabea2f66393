// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRSurfaceNormals.h"

#include "nprArrayNames.h"
#include "nprGhostLevels.h"
#include "nprLengthScale.h"
#include "nprProgress.h"
#include "nprSurfaceDiffusion.h"
#include "nprSurfaceNormals.h"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <cmath>
#include <string>

vtkStandardNewMacro(vtkNPRSurfaceNormals);

//------------------------------------------------------------------------------
vtkNPRSurfaceNormals::vtkNPRSurfaceNormals() = default;
vtkNPRSurfaceNormals::~vtkNPRSurfaceNormals() = default;

//------------------------------------------------------------------------------
int vtkNPRSurfaceNormals::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  const int smoothing =
    this->SmoothingRadius > 0.0 || this->NumberOfScales > 0 ? npr::DiffusionReach : 0;
  npr::RequestGhostLevels(inputs[0]->GetInformationObject(0), outputs->GetInformationObject(0),
    npr::NormalsReach + smoothing);
  return this->Superclass::RequestUpdateExtent(request, inputs, outputs);
}

//------------------------------------------------------------------------------
int vtkNPRSurfaceNormals::RequestData(
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
bool vtkNPRSurfaceNormals::Compute(vtkPolyData* input, vtkPolyData* output)
{
  const npr::Progress progress = npr::ReportTo(this);
  npr::TriangleMesh mesh(input);
  mesh.BuildIncidence();
  if (!progress(0.3))
  {
    return false;
  }
  npr::Tuples<3> normals =
    npr::ComputeNormals(mesh, static_cast<npr::NormalWeights>(this->Weighting));
  const double lengthScale = npr::GetLengthScale(input, mesh);
  double smoothed = this->SmoothingRadius * lengthScale;
  const npr::SurfaceDiffusion plain = this->SmoothingRadius > 0.0 || this->NumberOfScales > 0
    ? npr::SurfaceDiffusion(mesh, normals)
    : npr::SurfaceDiffusion();
  // By `radius`, which brings them to `scale` in all.
  const auto smooth = [&](double radius, double scale, double begin, double end)
  {
    if (this->FeaturePreservation > 0.0)
    {
      npr::SurfaceDiffusion preserving = plain;
      preserving.PreserveFeatures(mesh, this->FeaturePreservation, scale);
      preserving.SmoothNormals(normals, radius, npr::PartOf(progress, begin, end));
    }
    else
    {
      plain.SmoothNormals(normals, radius, npr::PartOf(progress, begin, end));
    }
  };
  if (smoothed > 0.0)
  {
    smooth(smoothed, smoothed, 0.4, 0.5);
  }
  if (!progress(0.5))
  {
    return false;
  }
  vtkPointData* const pointData = output->GetPointData();
  pointData->SetNormals(npr::MakeArray<3>(npr::names::Normals, normals));
  for (int scale = 1; scale <= this->NumberOfScales; ++scale)
  {
    const double begin = 0.5 + 0.45 * (scale - 1) / this->NumberOfScales;
    const double end = 0.5 + 0.45 * scale / this->NumberOfScales;
    const double wanted = lengthScale * this->ScaleRadius * std::pow(this->ScaleFactor, scale - 1);
    if (wanted > smoothed)
    {
      // Variances add up.
      smooth(std::sqrt((wanted - smoothed) * (wanted + smoothed)), wanted, begin, end);
      smoothed = wanted;
    }
    if (!progress(end))
    {
      return false;
    }
    const std::string name = npr::names::ScaleNormalsPrefix + std::to_string(scale);
    pointData->AddArray(npr::MakeArray<3>(name.c_str(), normals));
  }
  return progress(0.95);
}

//------------------------------------------------------------------------------
void vtkNPRSurfaceNormals::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Weighting: " << this->Weighting << "\n";
  os << indent << "SmoothingRadius: " << this->SmoothingRadius << "\n";
  os << indent << "FeaturePreservation: " << this->FeaturePreservation << "\n";
  os << indent << "NumberOfScales: " << this->NumberOfScales << "\n";
  os << indent << "ScaleRadius: " << this->ScaleRadius << "\n";
  os << indent << "ScaleFactor: " << this->ScaleFactor << "\n";
}
