// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPROutlineNormals.h"

#include <vtkDataObject.h>
#include <vtkFloatArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

vtkStandardNewMacro(vtkNPROutlineNormals);

namespace
{
const char* const ArrayName = "OutlineNormals";
const char* const AttributeName = "nprOutlineNormal";
}

//------------------------------------------------------------------------------
vtkNPROutlineNormals::vtkNPROutlineNormals() = default;
vtkNPROutlineNormals::~vtkNPROutlineNormals() = default;

//------------------------------------------------------------------------------
void vtkNPROutlineNormals::PassTo(vtkPolyDataMapper* mapper)
{
  mapper->MapDataArrayToVertexAttribute(
    AttributeName, ArrayName, vtkDataObject::FIELD_ASSOCIATION_POINTS, -1);
}

//------------------------------------------------------------------------------
const char* vtkNPROutlineNormals::GetAttributeName()
{
  return AttributeName;
}

//------------------------------------------------------------------------------
int vtkNPROutlineNormals::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  output->ShallowCopy(input);
  const vtkIdType count = input->GetNumberOfPoints();
  vtkDataArray* normals = input->GetPointData()->GetNormals();
  if (count == 0)
  {
    return 1;
  }
  if (!normals)
  {
    vtkErrorMacro("the input has no point normals, of which there could be a mean; put a "
                  "vtkPolyDataNormals or vtkNPRSurfaceNormals before this filter");
    return 0;
  }

  using Place = std::array<double, 3>;
  std::vector<Place> places(count);
  std::vector<vtkIdType> order(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    input->GetPoint(i, places[i].data());
  }
  std::iota(order.begin(), order.end(), vtkIdType(0));
  std::sort(order.begin(), order.end(),
    [&](vtkIdType a, vtkIdType b)
    { return places[a] != places[b] ? places[a] < places[b] : a < b; });

  vtkNew<vtkFloatArray> means;
  means->SetName(ArrayName);
  means->SetNumberOfComponents(3);
  means->SetNumberOfTuples(count);
  for (auto first = order.begin(); first != order.end();)
  {
    const auto end =
      std::find_if(first, order.end(), [&](vtkIdType id) { return places[id] != places[*first]; });
    Place mean = { 0.0, 0.0, 0.0 };
    for (auto i = first; i != end; ++i)
    {
      vtkMath::Add(mean.data(), normals->GetTuple3(*i), mean.data());
    }
    // Of opposite normals there is no mean; each point keeps its own.
    const bool hasMean = vtkMath::Normalize(mean.data()) > 1.0e-6;
    for (auto i = first; i != end; ++i)
    {
      means->SetTuple(*i, hasMean ? mean.data() : normals->GetTuple3(*i));
    }
    first = end;
  }
  output->GetPointData()->AddArray(means);
  return 1;
}
