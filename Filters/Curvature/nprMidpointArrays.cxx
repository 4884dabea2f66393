// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprMidpointArrays.h"

#include "nprCurvatureDerivatives.h"
#include "nprTangentFrame.h"

#include <vtkDataArray.h>
#include <vtkSMPTools.h>

namespace npr
{
namespace
{
using Index = TriangleMesh::Index;

/// Calls function(midpoint, its parents), such that parents are always done before.
template<typename Function>
void ForMidpoints(const RefinedSurface& refined, const Function& function)
{
  const Index first = static_cast<Index>(refined.Points.size() - refined.Parents.size());
  for (std::size_t level = 0; level + 1 < refined.LevelStarts.size(); ++level)
  {
    vtkSMPTools::For(refined.LevelStarts[level], refined.LevelStarts[level + 1],
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          function(first + i, refined.Parents[i]);
        }
      });
  }
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkAbstractArray> ExtendArray(
  vtkAbstractArray* array, const RefinedSurface& refined)
{
  const vtkIdType total = static_cast<vtkIdType>(refined.Points.size());
  auto extended = vtk::TakeSmartPointer(array->NewInstance());
  extended->DeepCopy(array);
  extended->Resize(total);
  extended->SetNumberOfTuples(total);
  if (auto* floats = vtkFloatArray::FastDownCast(extended))
  {
    const int size = floats->GetNumberOfComponents();
    float* const values = floats->GetPointer(0);
    ForMidpoints(refined,
      [=](vtkIdType point, const std::array<Index, 2>& ends)
      {
        for (int c = 0; c < size; ++c)
        {
          // Not half of the sum, which may be too large for a number.
          values[point * size + c] = 0.5f * values[static_cast<vtkIdType>(ends[0]) * size + c] +
            0.5f * values[static_cast<vtkIdType>(ends[1]) * size + c];
        }
      });
    return extended;
  }
  const int type = array->GetDataType();
  const bool isBlended = type == VTK_FLOAT || type == VTK_DOUBLE || type == VTK_UNSIGNED_CHAR;
  vtkIdType point = total - static_cast<vtkIdType>(refined.Parents.size());
  for (const std::array<Index, 2>& ends : refined.Parents)
  {
    if (isBlended)
    {
      extended->InterpolateTuple(point++, ends[0], extended, ends[1], extended, 0.5);
    }
    else
    {
      extended->SetTuple(point++, ends[0], extended);
    }
  }
  return extended;
}

//------------------------------------------------------------------------------
Tuples<6> ExtendTensors(const Tuples<6>& tensors, const RefinedSurface& refined)
{
  Tuples<6> extended = tensors;
  extended.resize(refined.Points.size());
  ForMidpoints(refined,
    [&](vtkIdType point, const std::array<Index, 2>& ends)
    {
      const Eigen::Vector3d normal = refined.Normals[point].cast<double>();
      const TangentFrame frame = MakeTangentFrame(normal);
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      for (Index end : ends)
      {
        const MinimalRotation rotation(normal, refined.Normals[end].cast<double>());
        if (rotation.IsValid())
        {
          sum += 0.5 * ToFrame(extended[end].cast<double>(), rotation(frame));
        }
      }
      extended[point] = FromFrame(sum, frame).cast<float>();
    });
  return extended;
}

//------------------------------------------------------------------------------
Tuples<4> ExtendDerivatives(
  const Tuples<4>& derivatives, const Tuples<3>& e1, const RefinedSurface& refined)
{
  Tuples<4> extended(refined.Points.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(derivatives.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const Eigen::Vector3d normal = refined.Normals[i].cast<double>();
        const Eigen::Vector3d u = e1[i].cast<double>();
        extended[i] = ChangeFrame(
          derivatives[i].cast<double>(), { u, normal.cross(u) }, MakeTangentFrame(normal))
                        .cast<float>();
      }
    });
  ForMidpoints(refined,
    [&](vtkIdType point, const std::array<Index, 2>& ends)
    {
      const Eigen::Vector3d normal = refined.Normals[point].cast<double>();
      Eigen::Vector4d sum = Eigen::Vector4d::Zero();
      for (Index end : ends)
      {
        const Eigen::Vector3d from = refined.Normals[end].cast<double>();
        const MinimalRotation rotation(from, normal);
        if (rotation.IsValid())
        {
          sum += 0.5 *
            ChangeFrame(extended[end].cast<double>(), rotation(MakeTangentFrame(from)),
              MakeTangentFrame(normal));
        }
      }
      extended[point] = sum.cast<float>();
    });
  return extended;
}
}
