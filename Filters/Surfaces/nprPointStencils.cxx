// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprPointStencils.h"

#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkSMPTools.h>

#include <algorithm>

namespace npr
{
namespace
{
//------------------------------------------------------------------------------
template<typename Array>
void SumUp(Array* array, const PointStencils& stencils, Array* result)
{
  const int size = array->GetNumberOfComponents();
  const auto* const from = array->GetPointer(0);
  auto* const to = result->GetPointer(0);
  vtkSMPTools::For(0, stencils.GetNumberOfPoints(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        for (int c = 0; c < size; ++c)
        {
          double sum = 0.0;
          for (vtkIdType s = stencils.Offsets[i]; s < stencils.Offsets[i + 1]; ++s)
          {
            sum +=
              stencils.Weights[s] * from[static_cast<vtkIdType>(stencils.Points[s]) * size + c];
          }
          to[i * size + c] = static_cast<typename Array::ValueType>(sum);
        }
      }
    });
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkAbstractArray> ApplyStencils(
  vtkAbstractArray* array, const PointStencils& stencils)
{
  auto result = vtk::TakeSmartPointer(array->NewInstance());
  result->SetName(array->GetName());
  result->SetNumberOfComponents(array->GetNumberOfComponents());
  result->CopyComponentNames(array);
  result->SetNumberOfTuples(stencils.GetNumberOfPoints());
  if (auto* floats = vtkFloatArray::FastDownCast(array))
  {
    SumUp(floats, stencils, vtkFloatArray::FastDownCast(result));
    return result;
  }
  if (auto* doubles = vtkDoubleArray::FastDownCast(array))
  {
    SumUp(doubles, stencils, vtkDoubleArray::FastDownCast(result));
    return result;
  }
  const int type = array->GetDataType();
  const bool isBlended = type == VTK_FLOAT || type == VTK_DOUBLE || type == VTK_UNSIGNED_CHAR;
  vtkNew<vtkIdList> sources;
  std::vector<double> weights;
  for (vtkIdType i = 0; i < stencils.GetNumberOfPoints(); ++i)
  {
    const auto begin = stencils.Weights.begin() + stencils.Offsets[i];
    const auto end = stencils.Weights.begin() + stencils.Offsets[i + 1];
    if (!isBlended)
    {
      const auto heaviest = std::max_element(begin, end) - stencils.Weights.begin();
      result->SetTuple(i, stencils.Points[heaviest], array);
      continue;
    }
    weights.assign(begin, end);
    sources->Reset();
    for (vtkIdType s = stencils.Offsets[i]; s < stencils.Offsets[i + 1]; ++s)
    {
      sources->InsertNextId(stencils.Points[s]);
    }
    result->InterpolateTuple(i, sources, array, weights.data());
  }
  return result;
}

//------------------------------------------------------------------------------
void ApplyStencils(
  vtkDataSetAttributes* input, const PointStencils& stencils, vtkDataSetAttributes* output)
{
  for (int i = 0; i < input->GetNumberOfArrays(); ++i)
  {
    const int index = output->AddArray(ApplyStencils(input->GetAbstractArray(i), stencils));
    const int attribute = input->IsArrayAnAttribute(i);
    if (attribute >= 0)
    {
      output->SetActiveAttribute(index, attribute);
    }
  }
}
}
