// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprFaceCurvature.h"

#include "nprFaceAverages.h"
#include "nprFaceFits.h"
#include "nprTangentFrame.h"

#include <vtkSMPTools.h>

namespace npr
{
namespace
{
/// A form over MakeTangent(normal) as a tensor in space.
Eigen::Matrix<float, 6, 1> MakeTensor(
  const QuadraticForm<float>& form, const Eigen::Vector3f& normal)
{
  const Eigen::Vector3f u = MakeTangent(normal);
  const Eigen::Vector3f v = normal.cross(u);
  const Eigen::Vector3f a = (form.Mean + form.Rest.Re) * u + form.Rest.Im * v;
  const Eigen::Vector3f b = form.Rest.Im * u + (form.Mean - form.Rest.Re) * v;
  Eigen::Matrix<float, 6, 1> tensor;
  tensor << a.x() * u.x() + b.x() * v.x(), a.y() * u.y() + b.y() * v.y(),
    a.z() * u.z() + b.z() * v.z(), a.x() * u.y() + b.x() * v.y(), a.y() * u.z() + b.y() * v.z(),
    a.x() * u.z() + b.x() * v.z();
  return tensor;
}
}

//------------------------------------------------------------------------------
CurvatureEstimate FaceCurvature::Estimate(const TriangleMesh& mesh, const Tuples<3>& normals,
  bool derivatives, const Progress& progress) const
{
  CurvatureEstimate estimate;
  if (!progress(0.0))
  {
    return estimate;
  }
  Tuples<4> forms;
  {
    // What the averages need most memory for is given back before the results take theirs.
    FaceAverages averages(mesh, normals);
    forms = averages.AverageForms();
    if (!progress(0.4))
    {
      return estimate;
    }
    if (derivatives)
    {
      estimate.Derivatives = averages.AverageDerivatives(forms);
    }
  }
  progress(0.9);
  estimate.Normals = normals;
  estimate.Tensors.resize(forms.size());
  estimate.Unknown.resize(forms.size());
  const float perUnit = 1.0f / mesh.GetUnit();
  vtkSMPTools::For(0, mesh.GetNumberOfPoints(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        estimate.Unknown[i] = !(forms[i][0] > 0.0f);
        estimate.Tensors[i] = perUnit * MakeTensor(ReadQuadratic(forms[i]), normals[i]);
        if (derivatives)
        {
          estimate.Derivatives[i] =
            perUnit * perUnit * GetComponents(ReadCubic(estimate.Derivatives[i]));
        }
      }
    });
  progress(1.0);
  return estimate;
}
}
