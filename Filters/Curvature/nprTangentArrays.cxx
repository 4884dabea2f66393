// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprTangentArrays.h"

#include "nprArrayNames.h"
#include "nprCurvature.h"
#include "nprCurvatureDerivatives.h"

#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>

#include <utility>

namespace npr
{
//------------------------------------------------------------------------------
vtkDataArray* FindNormals(vtkPolyData* surface)
{
  vtkDataArray* active = surface->GetPointData()->GetNormals();
  return active ? active : surface->GetPointData()->GetArray(names::Normals);
}

//------------------------------------------------------------------------------
void AddCurvatureArrays(vtkPolyData* surface, Tuples<6> tensors, const Tuples<3>& normals,
  const CurvatureArrays& wanted, Tuples<4> derivatives)
{
  const auto makeTuples = [&](bool isWanted, auto tuples)
  {
    tuples.resize(isWanted ? normals.size() : 0);
    return tuples;
  };
  Tuples<1> k1 = makeTuples(wanted.PrincipalCurvatures, Tuples<1>());
  Tuples<1> k2 = makeTuples(wanted.PrincipalCurvatures, Tuples<1>());
  Tuples<3> e1 = makeTuples(wanted.PrincipalDirections, Tuples<3>());
  Tuples<3> e2 = makeTuples(wanted.PrincipalDirections, Tuples<3>());
  Tuples<1> mean = makeTuples(wanted.MeanCurvature, Tuples<1>());
  Tuples<1> gauss = makeTuples(wanted.GaussianCurvature, Tuples<1>());
  Tuples<1> shapeIndex = makeTuples(wanted.ShapeIndex, Tuples<1>());
  Tuples<1> curvedness = makeTuples(wanted.Curvedness, Tuples<1>());
  // One pass over all points: each principal frame serves all arrays.
  vtkSMPTools::For(0, static_cast<vtkIdType>(normals.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const Eigen::Vector3d normal = normals[i].cast<double>();
        const PrincipalFrame frame = Diagonalise(tensors[i].cast<double>(), normal);
        const float first = static_cast<float>(frame.K1);
        const float second = static_cast<float>(frame.K2);
        const auto set = [i](Tuples<1>& values, float value)
        {
          if (!values.empty())
          {
            values[i][0] = value;
          }
        };
        set(k1, first);
        set(k2, second);
        set(mean, 0.5f * (first + second));
        set(gauss, first * second);
        if (!e1.empty())
        {
          e1[i] = frame.E1.cast<float>();
          e2[i] = frame.E2.cast<float>();
        }
        if (!shapeIndex.empty())
        {
          shapeIndex[i][0] = ComputeShapeIndex(first, second);
        }
        if (!curvedness.empty())
        {
          curvedness[i][0] = ComputeCurvedness(first, second);
        }
        if (!derivatives.empty())
        {
          derivatives[i] = ChangeFrame(
            derivatives[i].cast<double>(), MakeTangentFrame(normal), { frame.E1, frame.E2 })
                             .cast<float>();
        }
      }
    });
  const auto add = [&](const char* name, auto& tuples)
  {
    if (!tuples.empty())
    {
      surface->GetPointData()->AddArray(MakeArray(name, std::move(tuples)));
    }
  };
  if (wanted.Tensor)
  {
    add(names::CurvatureTensor, tensors);
  }
  add(names::PrincipalCurvature1, k1);
  add(names::PrincipalCurvature2, k2);
  add(names::PrincipalDirection1, e1);
  add(names::PrincipalDirection2, e2);
  add(names::MeanCurvature, mean);
  add(names::GaussianCurvature, gauss);
  add(names::ShapeIndex, shapeIndex);
  add(names::Curvedness, curvedness);
  add(names::CurvatureDerivatives, derivatives);
}
}
