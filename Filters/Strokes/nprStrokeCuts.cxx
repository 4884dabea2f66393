// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprStrokeCuts.h"

#include "nprArrayNames.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace npr
{
//------------------------------------------------------------------------------
vtkDataArray* GetCellNumbers(vtkPolyData* strokes, const char* name)
{
  vtkDataArray* array = strokes->GetCellData()->GetArray(name);
  const bool fits = array && array->GetNumberOfComponents() == 1 &&
    array->GetNumberOfTuples() == strokes->GetNumberOfCells();
  return fits ? array : nullptr;
}

//------------------------------------------------------------------------------
StrokeCuts::StrokeCuts(vtkPolyData* strokes)
  : Layers(GetCellNumbers(strokes, names::HidingLayers)),
    ChainIds(GetCellNumbers(strokes, names::ChainId)), FirstCell(strokes->GetNumberOfVerts())
{
  if (!this->Layers)
  {
    return;
  }
  constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();
  const Vector3 noPlace = { nowhere, nowhere, nowhere };
  this->Places.assign(strokes->GetNumberOfLines(), { noPlace, noPlace });
  vtkNew<vtkIdList> ids;
  for (vtkIdType line = 0; line < strokes->GetNumberOfLines(); ++line)
  {
    strokes->GetLines()->GetCellAtId(line, ids);
    if (ids->GetNumberOfIds() == 0)
    {
      continue;
    }
    for (const int end : { 0, 1 })
    {
      Vector3& place = this->Places[line][end];
      strokes->GetPoint(ids->GetId(end == 0 ? 0 : ids->GetNumberOfIds() - 1), place.data());
      if (std::isfinite(place[0]) && std::isfinite(place[1]) && std::isfinite(place[2]))
      {
        this->Ends[place].push_back(line);
      }
    }
  }
}

//------------------------------------------------------------------------------
double StrokeCuts::Get(vtkDataArray* array, vtkIdType line) const
{
  return array->GetComponent(this->FirstCell + line, 0);
}

//------------------------------------------------------------------------------
bool StrokeCuts::IsCut(vtkIdType line, const Vector3& place) const
{
  const auto found = this->Ends.find(place);
  return found != this->Ends.end() &&
    std::any_of(found->second.begin(), found->second.end(),
      [&](vtkIdType other)
      {
        return this->Get(this->Layers, other) != this->Get(this->Layers, line) &&
          (!this->ChainIds || this->Get(this->ChainIds, other) == this->Get(this->ChainIds, line));
      });
}
//------------------------------------------------------------------------------
bool StrokeCuts::Continues(vtkIdType line, vtkIdType other) const
{
  return !this->Places.empty() && this->Places[line][0] == this->Places[other][1] &&
    (!this->ChainIds || this->Get(this->ChainIds, line) == this->Get(this->ChainIds, other));
}
}
