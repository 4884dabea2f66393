// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprPointValues.h
 * @brief What the point arrays of a surface say at one point.
 */
#ifndef nprPointValues_h
#define nprPointValues_h

#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <Eigen/Core>

namespace nprtest
{
/// Zero where there is no such array of that many components.
template<int Size>
Eigen::Matrix<double, Size, 1> GetTuple(vtkPolyData* surface, const char* name, vtkIdType point)
{
  Eigen::Matrix<double, Size, 1> tuple = Eigen::Matrix<double, Size, 1>::Zero();
  vtkDataArray* array = surface->GetPointData()->GetArray(name);
  if (array && array->GetNumberOfComponents() == Size)
  {
    array->GetTuple(point, tuple.data());
  }
  return tuple;
}

inline double GetValue(vtkPolyData* surface, const char* name, vtkIdType point)
{
  return GetTuple<1>(surface, name, point)[0];
}
}

#endif
