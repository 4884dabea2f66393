// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprTangentArrays.h"

#include "nprArrayNames.h"
#include "nprCurvature.h"

#include <vtkPointData.h>
#include <vtkPolyData.h>

namespace npr
{
//------------------------------------------------------------------------------
vtkDataArray* FindNormals(vtkPolyData* surface)
{
  vtkDataArray* active = surface->GetPointData()->GetNormals();
  return active ? active : surface->GetPointData()->GetArray(names::Normals);
}

//------------------------------------------------------------------------------
void AddCurvatureArrays(vtkPolyData* surface, const Tuples<6>& tensors, const Tuples<3>& normals)
{
  const PrincipalFrames frames = ComputePrincipalFrames(tensors, normals);
  std::vector<float> mean(tensors.size());
  std::vector<float> gaussian(tensors.size());
  for (std::size_t i = 0; i < tensors.size(); ++i)
  {
    mean[i] = 0.5f * (frames.K1[i] + frames.K2[i]);
    gaussian[i] = frames.K1[i] * frames.K2[i];
  }
  vtkPointData* pointData = surface->GetPointData();
  pointData->AddArray(MakeArray<6>(names::CurvatureTensor, tensors));
  pointData->AddArray(MakeArray(names::PrincipalCurvature1, frames.K1));
  pointData->AddArray(MakeArray(names::PrincipalCurvature2, frames.K2));
  pointData->AddArray(MakeArray<3>(names::PrincipalDirection1, frames.E1));
  pointData->AddArray(MakeArray<3>(names::PrincipalDirection2, frames.E2));
  pointData->AddArray(MakeArray(names::MeanCurvature, mean));
  pointData->AddArray(MakeArray(names::GaussianCurvature, gaussian));
}
}
