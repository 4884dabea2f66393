// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprTupleArrays.h
 * @brief Between data arrays and the vectors of fixed-size tuples that the kernels take and give.
 */
#ifndef nprTupleArrays_h
#define nprTupleArrays_h

#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkSMPTools.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

#include <Eigen/Core>

#include <algorithm>
#include <vector>

namespace npr
{
template<int Size>
using Tuples = std::vector<Eigen::Matrix<float, Size, 1>>;

/// The array's tuples as floats. It must have `Size` components.
template<int Size>
Tuples<Size> ReadTuples(vtkDataArray* array)
{
  Tuples<Size> tuples(array->GetNumberOfTuples());
  if (auto* floats = vtkFloatArray::FastDownCast(array))
  {
    std::copy_n(
      floats->GetPointer(0), tuples.size() * Size, reinterpret_cast<float*>(tuples.data()));
    return tuples;
  }
  vtkSMPTools::For(0, array->GetNumberOfTuples(),
    [&](vtkIdType begin, vtkIdType end)
    {
      double tuple[Size];
      for (vtkIdType i = begin; i < end; ++i)
      {
        array->GetTuple(i, tuple);
        tuples[i] = Eigen::Map<Eigen::Matrix<double, Size, 1>>(tuple).template cast<float>();
      }
    });
  return tuples;
}

/// A named float array of the tuples.
template<int Size>
vtkSmartPointer<vtkFloatArray> MakeArray(const char* name, const Tuples<Size>& tuples)
{
  static_assert(sizeof(Eigen::Matrix<float, Size, 1>) == Size * sizeof(float), "packed tuples");
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(Size);
  array->SetNumberOfTuples(static_cast<vtkIdType>(tuples.size()));
  std::copy_n(
    reinterpret_cast<const float*>(tuples.data()), tuples.size() * Size, array->GetPointer(0));
  return array;
}

/// A named float array of single values.
inline vtkSmartPointer<vtkFloatArray> MakeArray(const char* name, const std::vector<float>& values)
{
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName(name);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()));
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  return array;
}

/// A named array of flags, 0 or 1.
inline vtkSmartPointer<vtkUnsignedCharArray> MakeFlagArray(
  const char* name, const std::vector<unsigned char>& flags)
{
  auto array = vtkSmartPointer<vtkUnsignedCharArray>::New();
  array->SetName(name);
  array->SetNumberOfTuples(static_cast<vtkIdType>(flags.size()));
  std::copy(flags.begin(), flags.end(), array->GetPointer(0));
  return array;
}
}

#endif
