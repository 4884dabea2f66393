// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprFaceCurvature.h"

#include "nprCurvature.h"
#include "nprCurvatureDerivatives.h"

#include <vtkSMPTools.h>

namespace npr
{
//------------------------------------------------------------------------------
CurvatureEstimate FaceCurvature::Estimate(const TriangleMesh& mesh, const Tuples<3>& normals,
  bool derivatives, const Progress& progress) const
{
  CurvatureEstimate estimate;
  estimate.Normals = normals;
  if (!progress(0.0))
  {
    return estimate;
  }
  estimate.Tensors = ComputeCurvatureTensors(mesh, normals, estimate.Unknown);
  if (!progress(0.4) || !derivatives)
  {
    return estimate;
  }
  Tuples<3> u(normals.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(u.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        u[i] = MakeTangentFrame(normals[i].cast<double>()).U.cast<float>();
      }
    });
  estimate.Derivatives = ComputeCurvatureDerivatives(mesh, estimate.Tensors, normals, u);
  progress(1.0);
  return estimate;
}
}
