// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprStrokeBuffer.h"

#include "nprStrokeReader.h"

#include <vtkCellArray.h>
#include <vtkIdList.h>
#include <vtkMath.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
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
using Position = std::array<double, 3>;

/// From whether a point is finite to what it is on its stroke. A neighbour stands before the first
/// and after the last record of a closed stroke.
void SetKinds(
  StrokeRecord* begin, StrokeRecord* end, bool closed, int base, const StrokeTolerance& tolerance)
{
  bool before = closed;
  bool steepBefore = closed && IsSteep(*(begin - 1), *begin, tolerance);
  for (StrokeRecord* record = begin; record != end; ++record)
  {
    const bool finite = record->Kind != 0.0f;
    const bool isLast = record + 1 == end;
    const bool after = isLast ? closed : (record + 1)->Kind != 0.0f;
    const bool steepAfter = after && IsSteep(*record, *(record + 1), tolerance);
    record->Kind =
      static_cast<float>(finite ? base + (!isLast && after ? Drawn : 0) + (before ? HasBefore : 0) +
            (after ? HasAfter : 0) + (steepBefore || steepAfter ? Steep : 0)
                                : 0);
    before = finite;
    steepBefore = steepAfter;
  }
}

/// Writes records of strokes.
class RecordWriter
{
public:
  /// What is needed for one line after another.
  struct Scratch
  {
    vtkNew<vtkIdList> Ids;
    std::vector<StrokeRecord> Records;
    std::vector<unsigned char> Colors;
    std::vector<std::size_t> Kept;
  };

  RecordWriter(vtkPolyData* strokes, const StrokeReader& reader, const StrokeTolerance& tolerance)
    : Strokes(strokes), Points(strokes->GetPoints()), Reader(reader), Tolerance(tolerance)
  {
  }

  /// The records of a line that are needed, and their colours. @returns how many
  std::ptrdiff_t WriteLine(
    vtkIdType line, Scratch& scratch, StrokeRecord* to, unsigned char* toColors) const
  {
    this->Strokes->GetLines()->GetCellAtId(line, scratch.Ids);
    const bool closed = this->IsClosed(scratch.Ids);
    this->Write(scratch.Ids, scratch.Records);
    this->WriteColors(line, scratch);
    std::vector<std::size_t>& kept = scratch.Kept;
    SimplifyStroke(scratch.Records, this->Reader.HasColors() ? scratch.Colors.data() : nullptr,
      this->Tolerance, kept);
    if (closed)
    {
      // The neighbours of the seam.
      kept.insert(kept.begin(), kept[kept.size() - 2]);
      kept.push_back(kept[2]);
    }
    for (std::size_t i = 0; i < kept.size(); ++i)
    {
      to[i] = scratch.Records[kept[i]];
      if (this->Reader.HasColors())
      {
        std::copy_n(&scratch.Colors[4 * kept[i]], 4, toColors + 4 * i);
      }
    }
    StrokeRecord* const end = to + kept.size();
    const int extra = closed ? 1 : 0;
    SetKinds(to + extra, end - extra, closed,
      StrokeNumber * static_cast<int>(line % MostStrokeNumbers) +
        (this->Reader.IsHidden(line) ? Hidden : 0),
      this->Tolerance);
    if (closed)
    {
      to->Kind = (end - 1)->Kind = 0.0f;
    }
    return end - to;
  }

private:
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

  /// All points of a line, without kinds.
  void Write(vtkIdList* ids, std::vector<StrokeRecord>& records) const
  {
    records.resize(ids->GetNumberOfIds());
    double measured = 0.0;
    Position last;
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      const vtkIdType id = ids->GetId(i);
      const Position x = this->GetPoint(id);
      StrokeRecord& record = records[i];
      record = this->Reader.Read(id, x);
      if (i > 0)
      {
        const double step = std::sqrt(vtkMath::Distance2BetweenPoints(x.data(), last.data()));
        measured += std::isfinite(step) ? step : 0.0;
      }
      last = x;
      if (!this->Reader.HasArcLengths())
      {
        record.ArcLength = static_cast<float>(measured);
      }
    }
  }

  void WriteColors(vtkIdType line, Scratch& scratch) const
  {
    if (this->Reader.HasColors())
    {
      const vtkIdType size = scratch.Ids->GetNumberOfIds();
      scratch.Colors.resize(4 * size);
      for (vtkIdType i = 0; i < size; ++i)
      {
        this->Reader.ReadColor(line, scratch.Ids->GetId(i), &scratch.Colors[4 * i]);
      }
    }
  }

  vtkPolyData* Strokes;
  vtkPoints* Points;
  const StrokeReader& Reader;
  const StrokeTolerance& Tolerance;
};

/// Takes the room out that lines were given for records that were not needed.
void MoveTogether(StrokeRecords& strokes, const std::vector<std::ptrdiff_t>& room,
  const std::vector<std::ptrdiff_t>& counts)
{
  const bool colored = !strokes.Colors.empty();
  strokes.Begins.assign(room.size(), 0);
  for (std::size_t i = 0; i < counts.size(); ++i)
  {
    const std::ptrdiff_t to = strokes.Begins[i];
    std::copy_n(strokes.Records.begin() + room[i], counts[i], strokes.Records.begin() + to);
    if (colored)
    {
      std::copy_n(
        strokes.Colors.begin() + 4 * room[i], 4 * counts[i], strokes.Colors.begin() + 4 * to);
    }
    strokes.Begins[i + 1] = to + counts[i];
  }
  strokes.Records.resize(strokes.Begins.back());
  strokes.Records.shrink_to_fit();
  strokes.Colors.resize(colored ? 4 * strokes.Begins.back() : 0);
}
}

//------------------------------------------------------------------------------
StrokeRecords MakeStrokeRecords(vtkPolyData* strokes, vtkUnsignedCharArray* colors, bool ofCells,
  const StrokeTolerance& tolerance)
{
  vtkCellArray* lines = strokes->GetLines();
  const vtkIdType numberOfLines = lines ? lines->GetNumberOfCells() : 0;
  if (numberOfLines == 0)
  {
    return {};
  }
  const StrokeReader reader(strokes, colors, ofCells);
  if (reader.IsEmpty())
  {
    return {};
  }
  StrokeRecords result = reader.GetFrame();

  // Room for all points of each line, and for the neighbours of a seam.
  std::vector<std::ptrdiff_t> room(numberOfLines + 1, 0);
  for (vtkIdType i = 0; i < numberOfLines; ++i)
  {
    room[i + 1] = room[i] + lines->GetCellSize(i) + 2;
  }
  result.Records.resize(room.back());
  result.Colors.resize(colors ? 4 * room.back() : 0);
  std::vector<std::ptrdiff_t> counts(numberOfLines, 0);
  const RecordWriter writer(strokes, reader, tolerance);
  vtkSMPTools::For(0, numberOfLines,
    [&](vtkIdType begin, vtkIdType end)
    {
      RecordWriter::Scratch scratch;
      for (vtkIdType i = begin; i < end; ++i)
      {
        counts[i] = writer.WriteLine(i, scratch, result.Records.data() + room[i],
          colors ? result.Colors.data() + 4 * room[i] : nullptr);
      }
    });
  MoveTogether(result, room, counts);
  if (reader.HasWidths())
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
std::vector<unsigned char> NumberCells(const StrokeRecords& records, std::ptrdiff_t otherCells)
{
  std::vector<unsigned char> cells;
  cells.reserve(4 * records.Records.size());
  for (std::size_t line = 0; line + 1 < records.Begins.size(); ++line)
  {
    const std::ptrdiff_t number = otherCells +
      (records.Lines.empty() ? static_cast<std::ptrdiff_t>(line) : records.Lines[line]);
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
std::array<int, 4> FindInkBounds(
  const StrokeRecords& records, vtkMatrix4x4* toDevice, const float viewportSize[2], double reach)
{
  double low[2] = { viewportSize[0], viewportSize[1] };
  double high[2] = { 0.0, 0.0 };
  for (int corner = 0; corner < 8; ++corner)
  {
    double clip[4];
    for (int c = 0; c < 4; ++c)
    {
      clip[c] = toDevice->GetElement(3, c);
      for (int i = 0; i < 3; ++i)
      {
        const double place = ((corner >> i) & 1) != 0 ? records.HalfSize[i] : -records.HalfSize[i];
        clip[c] += place * toDevice->GetElement(i, c);
      }
    }
    for (int c = 0; c < 2; ++c)
    {
      const double pixel = viewportSize[c] * (0.5 * clip[c] / clip[3] + 0.5);
      // What reaches behind the eye may be anywhere.
      low[c] = clip[3] > 0.0 ? std::min(low[c], pixel - reach) : 0.0;
      high[c] = clip[3] > 0.0 ? std::max(high[c], pixel + reach) : viewportSize[c];
    }
  }
  std::array<int, 4> bounds;
  for (int c = 0; c < 2; ++c)
  {
    const double first = std::floor(std::max(low[c], 0.0));
    const double end = std::ceil(std::min(high[c], static_cast<double>(viewportSize[c])));
    bounds[c] = static_cast<int>(first);
    bounds[2 + c] = static_cast<int>(std::max(end - first, 0.0));
  }
  return bounds;
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
