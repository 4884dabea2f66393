// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprStrokeBuffer.h"

#include "nprArrayNames.h"

#include <vtkBoundingBox.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkMath.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>

namespace npr
{
namespace
{
vtkDataArray* GetPointScalars(vtkPolyData* strokes, const char* name)
{
  vtkDataArray* array = strokes->GetPointData()->GetArray(name);
  const bool fits = array && array->GetNumberOfComponents() == 1 &&
    array->GetNumberOfTuples() == strokes->GetNumberOfPoints();
  return fits ? array : nullptr;
}

float GetFactor(vtkDataArray* array, vtkIdType id)
{
  const double value = array ? array->GetComponent(id, 0) : 1.0;
  return std::isfinite(value) ? static_cast<float>(std::max(value, 0.0)) : 0.0f;
}

using Position = std::array<double, 3>;

bool IsFinite(const Position& x)
{
  return std::isfinite(x[0]) && std::isfinite(x[1]) && std::isfinite(x[2]);
}

/// Writes records of strokes.
class RecordWriter
{
public:
  RecordWriter(vtkPolyData* strokes, const Position& origin)
    : Points(strokes->GetPoints()), Origin(origin), Widths(GetPointScalars(strokes, names::Width)),
      Strengths(GetPointScalars(strokes, names::Strength)),
      Opacities(GetPointScalars(strokes, names::Opacity)),
      ArcLengths(GetPointScalars(strokes, names::ArcLength))
  {
  }

  bool HasWidths() const { return this->Widths != nullptr; }

  Position GetPoint(vtkIdType id) const
  {
    Position x;
    this->Points->GetPoint(id, x.data());
    return x;
  }

  /// Whether the last point is at the place of the first.
  bool IsClosed(vtkIdList* ids) const
  {
    const vtkIdType size = ids->GetNumberOfIds();
    return size > 3 && IsFinite(this->GetPoint(ids->GetId(0))) &&
      this->GetPoint(ids->GetId(0)) == this->GetPoint(ids->GetId(size - 1));
  }

  /// The points of a line, without kinds. @returns the record after the last
  StrokeRecord* Write(vtkIdList* ids, StrokeRecord* record) const
  {
    double measured = 0.0;
    Position last;
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i, ++record)
    {
      const vtkIdType id = ids->GetId(i);
      const Position x = this->GetPoint(id);
      const bool finite = IsFinite(x);
      for (int c = 0; c < 3; ++c)
      {
        record->Position[c] = finite ? static_cast<float>(x[c] - this->Origin[c]) : 0.0f;
      }
      record->Width = GetFactor(this->Widths, id);
      record->Strength = GetFactor(this->Strengths, id);
      record->Opacity = std::min(GetFactor(this->Opacities, id), 1.0f);
      if (i > 0)
      {
        const double step = std::sqrt(vtkMath::Distance2BetweenPoints(x.data(), last.data()));
        measured += std::isfinite(step) ? step : 0.0;
      }
      last = x;
      record->ArcLength =
        this->ArcLengths ? GetFactor(this->ArcLengths, id) : static_cast<float>(measured);
      record->Kind = finite ? 1.0f : 0.0f;
    }
    return record;
  }

private:
  vtkPoints* Points;
  Position Origin;
  vtkDataArray* Widths;
  vtkDataArray* Strengths;
  vtkDataArray* Opacities;
  vtkDataArray* ArcLengths;
};

/// From whether a point is finite to what it is on its stroke. A neighbour stands before the first
/// and after the last record of a closed stroke.
void SetKinds(StrokeRecord* begin, StrokeRecord* end, bool closed, int base)
{
  bool before = closed;
  for (StrokeRecord* record = begin; record != end; ++record)
  {
    const bool finite = record->Kind != 0.0f;
    const bool isLast = record + 1 == end;
    const bool after = isLast ? closed : (record + 1)->Kind != 0.0f;
    record->Kind = static_cast<float>(finite
        ? base + (!isLast && after ? Drawn : 0) + (before ? HasBefore : 0) + (after ? HasAfter : 0)
        : 0);
    before = finite;
  }
}
}

StrokeRecords MakeStrokeRecords(vtkPolyData* strokes)
{
  StrokeRecords result;
  vtkCellArray* lines = strokes->GetLines();
  vtkPoints* points = strokes->GetPoints();
  const vtkIdType numberOfLines = lines ? lines->GetNumberOfCells() : 0;
  if (numberOfLines == 0 || !points)
  {
    return result;
  }
  vtkBoundingBox box;
  double point[3];
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    points->GetPoint(i, point);
    if (std::isfinite(point[0]) && std::isfinite(point[1]) && std::isfinite(point[2]))
    {
      box.AddPoint(point);
    }
  }
  if (!box.IsValid())
  {
    return result;
  }
  box.GetCenter(result.Origin.data());

  const RecordWriter writer(strokes, result.Origin);
  vtkDataArray* layers = strokes->GetCellData()->GetArray(names::HidingLayers);
  layers = layers && layers->GetNumberOfTuples() == strokes->GetNumberOfCells() ? layers : nullptr;
  result.Begins.assign(numberOfLines + 1, 0);
  vtkNew<vtkIdList> line;
  for (vtkIdType i = 0; i < numberOfLines; ++i)
  {
    lines->GetCellAtId(i, line);
    result.Begins[i + 1] =
      result.Begins[i] + line->GetNumberOfIds() + (writer.IsClosed(line) ? 2 : 0);
  }
  result.Records.resize(result.Begins.back());
  vtkSMPTools::For(0, numberOfLines,
    [&](vtkIdType begin, vtkIdType end)
    {
      vtkNew<vtkIdList> ids;
      for (vtkIdType i = begin; i < end; ++i)
      {
        lines->GetCellAtId(i, ids);
        const bool closed = writer.IsClosed(ids);
        const bool hidden =
          layers && layers->GetComponent(strokes->GetNumberOfVerts() + i, 0) > 0.0;
        StrokeRecord* const first = result.Records.data() + result.Begins[i] + (closed ? 1 : 0);
        StrokeRecord* const last = writer.Write(ids, first);
        SetKinds(first, last, closed,
          StrokeNumber * static_cast<int>(i % MostStrokeNumbers) + (hidden ? Hidden : 0));
        if (closed)
        {
          *(first - 1) = *(last - 2);
          *last = *(first + 1);
          (first - 1)->Kind = last->Kind = 0.0f;
        }
      }
    });
  if (writer.HasWidths())
  {
    result.MaximumWidth = 0;
    for (const StrokeRecord& record : result.Records)
    {
      result.MaximumWidth = std::max(result.MaximumWidth, record.Width);
    }
  }
  return result;
}

//------------------------------------------------------------------------------
std::vector<unsigned char> OrderColors(
  const StrokeRecords& records, vtkPolyData* strokes, vtkUnsignedCharArray* colors, bool ofCells)
{
  std::vector<unsigned char> ordered(4 * records.Records.size());
  const vtkIdType firstLine = strokes->GetNumberOfVerts();
  vtkSMPTools::For(0, static_cast<vtkIdType>(records.Begins.size()) - 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      vtkNew<vtkIdList> ids;
      for (vtkIdType line = begin; line < end; ++line)
      {
        strokes->GetLines()->GetCellAtId(line, ids);
        const vtkIdType size = ids->GetNumberOfIds();
        const std::ptrdiff_t extra = records.Begins[line + 1] - records.Begins[line] - size;
        unsigned char* to = ordered.data() + 4 * (records.Begins[line] + extra / 2);
        for (vtkIdType i = 0; i < size; ++i, to += 4)
        {
          colors->GetTypedTuple(ofCells ? firstLine + line : ids->GetId(i), to);
        }
      }
    });
  return ordered;
}

//------------------------------------------------------------------------------
std::vector<unsigned char> NumberCells(const StrokeRecords& records, std::ptrdiff_t otherCells)
{
  std::vector<unsigned char> cells;
  cells.reserve(4 * records.Records.size());
  for (std::size_t line = 0; line + 1 < records.Begins.size(); ++line)
  {
    const std::ptrdiff_t number = otherCells + static_cast<std::ptrdiff_t>(line);
    for (std::ptrdiff_t i = records.Begins[line]; i < records.Begins[line + 1]; ++i)
    {
      for (int byte = 0; byte < 4; ++byte)
      {
        cells.push_back(static_cast<unsigned char>(number >> (8 * byte) & 0xff));
      }
    }
  }
  return cells;
}

//------------------------------------------------------------------------------
std::vector<float> MeasurePageLengths(
  const StrokeRecords& records, vtkMatrix4x4* toDevice, const float viewportSize[2])
{
  std::vector<float> lengths(records.Records.size(), 0.0f);
  const auto project = [&](const StrokeRecord& record, double pixel[2])
  {
    double clip[4];
    for (int c = 0; c < 4; ++c)
    {
      clip[c] = toDevice->GetElement(3, c);
      for (int i = 0; i < 3; ++i)
      {
        clip[c] += record.Position[i] * toDevice->GetElement(i, c);
      }
    }
    pixel[0] = 0.5 * viewportSize[0] * clip[0] / clip[3];
    pixel[1] = 0.5 * viewportSize[1] * clip[1] / clip[3];
    return clip[3] > 0.0;
  };
  vtkSMPTools::For(0, static_cast<vtkIdType>(records.Begins.size()) - 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType stroke = begin; stroke < end; ++stroke)
      {
        double length = 0.0;
        double last[2] = { 0.0, 0.0 };
        bool connected = false;
        for (std::ptrdiff_t i = records.Begins[stroke]; i < records.Begins[stroke + 1]; ++i)
        {
          double pixel[2];
          const bool visible = project(records.Records[i], pixel);
          if (visible && connected)
          {
            length += std::hypot(pixel[0] - last[0], pixel[1] - last[1]);
          }
          lengths[i] = static_cast<float>(length);
          connected = visible && (static_cast<int>(records.Records[i].Kind) & Drawn) != 0;
          std::copy_n(pixel, 2, last);
        }
      }
    });
  return lengths;
}
}
