// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprCurvatureDerivatives.h"

#include "nprCurvature.h"
#include "nprFaceAverages.h"
#include "nprFaceFits.h"

#include <vtkSMPTools.h>

namespace npr
{
using Eigen::Vector4d;

//------------------------------------------------------------------------------
Vector4d ChangeFrame(const Vector4d& cubic, const TangentFrame& from, const TangentFrame& to)
{
  const double u1 = to.U.dot(from.U);
  const double v1 = to.U.dot(from.V);
  const double u2 = to.V.dot(from.U);
  const double v2 = to.V.dot(from.V);
  // C(a, a, .) and so on, as pairs over (u, v).
  const double aau = cubic[0] * u1 * u1 + 2.0 * cubic[1] * u1 * v1 + cubic[2] * v1 * v1;
  const double aav = cubic[1] * u1 * u1 + 2.0 * cubic[2] * u1 * v1 + cubic[3] * v1 * v1;
  const double bbu = cubic[0] * u2 * u2 + 2.0 * cubic[1] * u2 * v2 + cubic[2] * v2 * v2;
  const double bbv = cubic[1] * u2 * u2 + 2.0 * cubic[2] * u2 * v2 + cubic[3] * v2 * v2;
  return { aau * u1 + aav * v1, aau * u2 + aav * v2, bbu * u1 + bbv * v1, bbu * u2 + bbv * v2 };
}

//------------------------------------------------------------------------------
Tuples<4> ComputeCurvatureDerivatives(
  const TriangleMesh& mesh, const Tuples<6>& tensors, const Tuples<3>& normals, const Tuples<3>& e1)
{
  const std::vector<float> areas = ComputePointAreas(mesh);
  const float unit = mesh.GetUnit();
  Tuples<4> forms(tensors.size());
  vtkSMPTools::For(0, mesh.GetNumberOfPoints(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const Eigen::Vector3f form =
          ToFrame(tensors[i].cast<double>(), MakeTangentFrame(normals[i].cast<double>()))
            .cast<float>();
        forms[i] = { areas[i] / (unit * unit), 0.5f * unit * (form[0] + form[2]),
          0.5f * unit * (form[0] - form[2]), unit * form[1] };
      }
    });
  Tuples<4> derivatives = FaceAverages(mesh, normals).AverageDerivatives(forms);
  vtkSMPTools::For(0, mesh.GetNumberOfPoints(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const Eigen::Vector3f u = MakeTangent<float>(normals[i]);
        const Complex<float> axis = { e1[i].dot(u), e1[i].dot(normals[i].cross(u)) };
        derivatives[i] = GetComponents(ReadCubic(derivatives[i]), axis) / (unit * unit);
      }
    });
  return derivatives;
}
}
