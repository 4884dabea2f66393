// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprStrokeReader.h"

#include "nprArrayNames.h"

#include <vtkBoundingBox.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>

namespace npr
{
namespace
{
using Position = std::array<double, 3>;

vtkDataArray* GetPointScalars(vtkPolyData* strokes, const char* name)
{
  vtkDataArray* array = strokes->GetPointData()->GetArray(name);
  const bool fits = array && array->GetNumberOfComponents() == 1 &&
    array->GetNumberOfTuples() == strokes->GetNumberOfPoints();
  return fits ? array : nullptr;
}

float GetFactor(const StrokeNumbers& numbers, vtkIdType id)
{
  const double value = numbers.Exist() ? numbers.Get(id, 0) : 1.0;
  return std::isfinite(value) ? static_cast<float>(std::max(value, 0.0)) : 0.0f;
}

/// The bounds of the points that are finite.
vtkBoundingBox FindBounds(vtkPoints* points)
{
  // Those of all, which are known already, unless some reach to infinity.
  const double* const all = points->GetBounds();
  if (std::all_of(all, all + 6, [](double x) { return std::isfinite(x); }))
  {
    return vtkBoundingBox(all);
  }
  vtkBoundingBox box;
  Position point;
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    points->GetPoint(i, point.data());
    if (IsFinite(point))
    {
      box.AddPoint(point.data());
    }
  }
  return box;
}
}

//------------------------------------------------------------------------------
bool IsFinite(const Position& x)
{
  return std::isfinite(x[0]) && std::isfinite(x[1]) && std::isfinite(x[2]);
}

//------------------------------------------------------------------------------
StrokeNumbers::StrokeNumbers(vtkDataArray* array) : Array(array)
{
  if (vtkFloatArray* const floats = vtkFloatArray::FastDownCast(array))
  {
    this->Values = floats->GetPointer(0);
    this->Components = floats->GetNumberOfComponents();
  }
}

double StrokeNumbers::Get(vtkIdType tuple, int component) const
{
  return this->Values ? this->Values[tuple * this->Components + component]
                      : this->Array->GetComponent(tuple, component);
}

//------------------------------------------------------------------------------
StrokeReader::StrokeReader(vtkPolyData* strokes, vtkUnsignedCharArray* colors, bool ofCells)
  : Strokes(strokes), Places(strokes->GetPoints() ? strokes->GetPoints()->GetData() : nullptr),
    Widths(GetPointScalars(strokes, names::Width)),
    Strengths(GetPointScalars(strokes, names::Strength)),
    Opacities(GetPointScalars(strokes, names::Opacity)),
    ArcLengths(GetPointScalars(strokes, names::ArcLength)),
    Layers(strokes->GetCellData()->GetArray(names::HidingLayers)), Colors(colors),
    ColorsOfCells(ofCells)
{
  if (this->Layers && this->Layers->GetNumberOfTuples() != strokes->GetNumberOfCells())
  {
    this->Layers = nullptr;
  }
  if (!strokes->GetPoints())
  {
    return;
  }
  const vtkBoundingBox box = FindBounds(strokes->GetPoints());
  this->Empty = !box.IsValid();
  if (!this->Empty)
  {
    box.GetCenter(this->Frame.Origin.data());
    box.GetLengths(this->Frame.HalfSize.data());
    for (double& size : this->Frame.HalfSize)
    {
      size *= 0.5;
    }
  }
}

//------------------------------------------------------------------------------
Position StrokeReader::GetPlace(vtkIdType id) const
{
  return { this->Places.Get(id, 0), this->Places.Get(id, 1), this->Places.Get(id, 2) };
}

//------------------------------------------------------------------------------
StrokeRecord StrokeReader::Read(vtkIdType id, const Position& place) const
{
  StrokeRecord record;
  const bool finite = IsFinite(place);
  for (int c = 0; c < 3; ++c)
  {
    record.Position[c] = finite ? static_cast<float>(place[c] - this->Frame.Origin[c]) : 0.0f;
  }
  record.Width = GetFactor(this->Widths, id);
  record.Strength = GetFactor(this->Strengths, id);
  record.Opacity = std::min(GetFactor(this->Opacities, id), 1.0f);
  record.ArcLength = this->ArcLengths.Exist() ? GetFactor(this->ArcLengths, id) : 0.0f;
  record.Kind = finite ? 1.0f : 0.0f;
  return record;
}

//------------------------------------------------------------------------------
void StrokeReader::ReadColor(vtkIdType line, vtkIdType id, unsigned char* color) const
{
  this->Colors->GetTypedTuple(
    this->ColorsOfCells ? this->Strokes->GetNumberOfVerts() + line : id, color);
}

//------------------------------------------------------------------------------
bool StrokeReader::IsHidden(vtkIdType line) const
{
  return this->Layers &&
    this->Layers->GetComponent(this->Strokes->GetNumberOfVerts() + line, 0) > 0.0;
}
}
