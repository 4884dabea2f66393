// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprStrokeInput.h"

#include "nprArrayNames.h"
#include "nprPageComposer.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <cmath>

namespace npr
{
namespace
{
/// The array of that name, or null; throws if it is not one number for each.
vtkDataArray* GetNumbers(
  vtkFieldData* data, const char* name, vtkIdType count, const std::string& each)
{
  vtkDataArray* const array = data->GetArray(name);
  if (array && (array->GetNumberOfComponents() != 1 || array->GetNumberOfTuples() != count))
  {
    throw DrawingError("The array \"" + std::string(name) + "\" of the strokes has " +
      std::to_string(array->GetNumberOfTuples()) + " tuples of " +
      std::to_string(array->GetNumberOfComponents()) + ", but there are " + std::to_string(count) +
      " " + each + ". Give it one number for each, or remove it.");
  }
  return array;
}
}

//------------------------------------------------------------------------------
StrokeInput::StrokeInput(vtkPolyData* strokes)
  : Strokes(strokes), NumberOfLines(strokes->GetPoints() ? strokes->GetNumberOfLines() : 0),
    FirstCell(strokes->GetNumberOfVerts())
{
  const vtkIdType cells = strokes->GetNumberOfCells();
  const vtkIdType points = strokes->GetNumberOfPoints();
  this->Types = GetNumbers(strokes->GetCellData(), names::LineType, cells, "cells");
  this->Hiding = GetNumbers(strokes->GetCellData(), names::HidingLayers, cells, "cells");
  this->Strengths = GetNumbers(strokes->GetPointData(), names::Strength, points, "points");
  this->Widths = GetNumbers(strokes->GetPointData(), names::Width, points, "points");

  auto* const typeNames =
    vtkStringArray::SafeDownCast(strokes->GetFieldData()->GetAbstractArray(names::LineTypeNames));
  for (vtkIdType i = 0; this->Types && typeNames && i < typeNames->GetNumberOfValues(); ++i)
  {
    this->TypeNames.push_back(typeNames->GetValue(i));
  }
  if (!this->Types)
  {
    this->TypeNames.push_back("lines");
  }
  constexpr int MostTypes = 1000;
  for (vtkIdType line = 0; this->Types && line < this->NumberOfLines; ++line)
  {
    const double type = this->Types->GetComponent(this->FirstCell + line, 0);
    if (!(type >= 0.0 && type < MostTypes))
    {
      throw DrawingError("Line " + std::to_string(line) + " of the strokes has the \"" +
        names::LineType + "\" " + std::to_string(type) + ". It must be the place of a name in \"" +
        names::LineTypeNames + "\", from 0 on.");
    }
    while (static_cast<std::size_t>(type) >= this->TypeNames.size())
    {
      this->TypeNames.push_back("type " + std::to_string(this->TypeNames.size()));
    }
  }
}

//------------------------------------------------------------------------------
int StrokeInput::GetType(vtkIdType line) const
{
  return this->Types ? static_cast<int>(this->Types->GetComponent(this->FirstCell + line, 0)) : 0;
}

bool StrokeInput::IsHidden(vtkIdType line) const
{
  return this->Hiding && this->Hiding->GetComponent(this->FirstCell + line, 0) != 0.0;
}

//------------------------------------------------------------------------------
double StrokeInput::GetWidth(vtkIdType point, const WidthRule& rule) const
{
  double width = rule.Width;
  if (this->Widths)
  {
    width *= this->Widths->GetComponent(point, 0);
  }
  if (this->Strengths && rule.Taper < 1.0)
  {
    const double strength = std::clamp(this->Strengths->GetComponent(point, 0), 0.0, 1.0);
    width *= rule.Taper + (1.0 - rule.Taper) * strength;
  }
  return std::isfinite(width) ? std::max(width, 0.0) : 0.0;
}

//------------------------------------------------------------------------------
void StrokeInput::GetChains(
  vtkIdType line, const WidthRule& rule, vtkIdList* ids, std::vector<Chain>& chains) const
{
  this->Strokes->GetLines()->GetCellAtId(line, ids);
  chains.clear();
  chains.emplace_back();
  bool isCut = false;
  for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
  {
    WorldPoint point;
    this->Strokes->GetPoints()->GetPoint(ids->GetId(i), point.Position.data());
    if (!point.Position.allFinite())
    {
      isCut = true;
      if (!chains.back().Points.empty())
      {
        chains.emplace_back();
      }
      continue;
    }
    std::vector<WorldPoint>& points = chains.back().Points;
    if (points.empty() || points.back().Position != point.Position)
    {
      point.Width = this->GetWidth(ids->GetId(i), rule);
      points.push_back(point);
    }
  }
  std::vector<WorldPoint>& points = chains[0].Points;
  if (!isCut && points.size() > 3 && points.front().Position == points.back().Position)
  {
    points.pop_back();
    chains[0].Closed = true;
  }
}
}
