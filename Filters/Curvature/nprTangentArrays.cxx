// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprTangentArrays.h"

#include "nprArrayNames.h"
#include "nprCurvature.h"
#include "nprCurvatureDerivatives.h"
#include "nprCurvatureEstimator.h"

#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>

namespace npr
{
//------------------------------------------------------------------------------
vtkDataArray* FindNormals(vtkPolyData* surface)
{
  vtkDataArray* active = surface->GetPointData()->GetNormals();
  return active ? active : surface->GetPointData()->GetArray(names::Normals);
}

//------------------------------------------------------------------------------
void AddCurvatureArrays(vtkPolyData* surface, const Tuples<6>& tensors, const Tuples<3>& normals,
  const CurvatureArrays& wanted)
{
  const PrincipalFrames frames = ComputePrincipalFrames(tensors, normals);
  vtkPointData* pointData = surface->GetPointData();
  const auto addValues = [&](bool isWanted, const char* name, const auto& compute)
  {
    if (isWanted)
    {
      std::vector<float> values(tensors.size());
      for (std::size_t i = 0; i < values.size(); ++i)
      {
        values[i] = compute(frames.K1[i], frames.K2[i]);
      }
      pointData->AddArray(MakeArray(name, values));
    }
  };
  if (wanted.Tensor)
  {
    pointData->AddArray(MakeArray<6>(names::CurvatureTensor, tensors));
  }
  if (wanted.PrincipalCurvatures)
  {
    pointData->AddArray(MakeArray(names::PrincipalCurvature1, frames.K1));
    pointData->AddArray(MakeArray(names::PrincipalCurvature2, frames.K2));
  }
  if (wanted.PrincipalDirections)
  {
    pointData->AddArray(MakeArray<3>(names::PrincipalDirection1, frames.E1));
    pointData->AddArray(MakeArray<3>(names::PrincipalDirection2, frames.E2));
  }
  addValues(wanted.MeanCurvature, names::MeanCurvature,
    [](float k1, float k2) { return 0.5f * (k1 + k2); });
  addValues(
    wanted.GaussianCurvature, names::GaussianCurvature, [](float k1, float k2) { return k1 * k2; });
  addValues(wanted.ShapeIndex, names::ShapeIndex, ComputeShapeIndex);
  addValues(wanted.Curvedness, names::Curvedness, ComputeCurvedness);
}

//------------------------------------------------------------------------------
Tuples<4> ToPrincipalFrames(const CurvatureEstimate& estimate)
{
  Tuples<4> derivatives(estimate.Derivatives.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(derivatives.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const Eigen::Vector3d normal = estimate.Normals[i].cast<double>();
        const PrincipalFrame frame = Diagonalise(estimate.Tensors[i].cast<double>(), normal);
        derivatives[i] = ChangeFrame(
          estimate.Derivatives[i].cast<double>(), MakeTangentFrame(normal), { frame.E1, frame.E2 })
                           .cast<float>();
      }
    });
  return derivatives;
}
}
