// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprStrokeBuffer.h"

#include "nprStrokeReader.h"

#include <vtkCellArray.h>
#include <vtkIdList.h>
#include <vtkMath.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
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

/// The points of one line.
struct LinePoints
{
  vtkIdType Size;
  const vtkIdType* Ids;
};

/// The records of one line after another, as far as they are needed, and their colours.
struct LineRecords
{
  std::vector<StrokeRecord> Records;
  std::vector<unsigned char> Colors;
};

/// Writes records of strokes.
class RecordWriter
{
public:
  /// What is needed for one line after another.
  struct Scratch
  {
    std::vector<StrokeRecord> Records;
    std::vector<unsigned char> Colors;
    std::vector<std::size_t> Kept;
  };

  RecordWriter(const StrokeReader& reader, const StrokeTolerance& tolerance)
    : Reader(reader), Tolerance(tolerance)
  {
  }

  /// Appends the records of a line that are needed.
  void WriteLine(vtkIdType line, const LinePoints& points, Scratch& scratch, LineRecords& to) const
  {
    const bool closed = this->IsClosed(points);
    this->Write(points, scratch.Records);
    this->WriteColors(line, points, scratch);
    std::vector<std::size_t>& kept = scratch.Kept;
    SimplifyStroke(scratch.Records, this->Reader.HasColors() ? scratch.Colors.data() : nullptr,
      this->Tolerance, kept);
    if (closed)
    {
      // The neighbours of the seam.
      kept.insert(kept.begin(), kept[kept.size() - 2]);
      kept.push_back(kept[2]);
    }
    const std::size_t begin = to.Records.size();
    for (const std::size_t index : kept)
    {
      to.Records.push_back(scratch.Records[index]);
      if (this->Reader.HasColors())
      {
        const auto color = scratch.Colors.begin() + static_cast<std::ptrdiff_t>(4 * index);
        to.Colors.insert(to.Colors.end(), color, color + 4);
      }
    }
    StrokeRecord* const first = to.Records.data() + begin;
    StrokeRecord* const end = first + kept.size();
    const int extra = closed ? 1 : 0;
    SetKinds(first + extra, end - extra, closed,
      StrokeNumber * static_cast<int>(line % MostStrokeNumbers) +
        (this->Reader.IsHidden(line) ? Hidden : 0),
      this->Tolerance);
    if (closed)
    {
      first->Kind = (end - 1)->Kind = 0.0f;
    }
  }

private:
  /// Whether the last point is at the place of the first.
  bool IsClosed(const LinePoints& points) const
  {
    const Position first = points.Size > 3 ? this->Reader.GetPlace(points.Ids[0]) : Position();
    return points.Size > 3 && IsFinite(first) &&
      first == this->Reader.GetPlace(points.Ids[points.Size - 1]);
  }

  /// All points of a line, without kinds.
  void Write(const LinePoints& points, std::vector<StrokeRecord>& records) const
  {
    records.clear();
    double measured = 0.0;
    Position last;
    for (vtkIdType i = 0; i < points.Size; ++i)
    {
      const Position x = this->Reader.GetPlace(points.Ids[i]);
      records.push_back(this->Reader.Read(points.Ids[i], x));
      if (!this->Reader.HasArcLengths())
      {
        const double step =
          i > 0 ? std::sqrt(vtkMath::Distance2BetweenPoints(x.data(), last.data())) : 0.0;
        measured += std::isfinite(step) ? step : 0.0;
        records.back().ArcLength = static_cast<float>(measured);
        last = x;
      }
    }
  }

  void WriteColors(vtkIdType line, const LinePoints& points, Scratch& scratch) const
  {
    if (this->Reader.HasColors())
    {
      scratch.Colors.resize(4 * points.Size);
      for (vtkIdType i = 0; i < points.Size; ++i)
      {
        this->Reader.ReadColor(line, points.Ids[i], &scratch.Colors[4 * i]);
      }
    }
  }

  const StrokeReader& Reader;
  const StrokeTolerance& Tolerance;
};

/// Runs of lines of about as many points, which are written at the same time: where each begins,
/// and the end.
std::vector<vtkIdType> MakeRuns(vtkCellArray* lines)
{
  constexpr vtkIdType pointsOfRun = 4096;
  std::vector<vtkIdType> runs{ 0 };
  vtkIdType points = 0;
  for (vtkIdType line = 0; line < lines->GetNumberOfCells(); ++line)
  {
    points += lines->GetCellSize(line);
    if (points >= pointsOfRun)
    {
      runs.push_back(line + 1);
      points = 0;
    }
  }
  if (runs.back() != lines->GetNumberOfCells())
  {
    runs.push_back(lines->GetNumberOfCells());
  }
  return runs;
}
}

//------------------------------------------------------------------------------
StrokeRecords MakeStrokeRecords(vtkPolyData* strokes, vtkUnsignedCharArray* colors, bool ofCells,
  const StrokeTolerance& tolerance)
{
  vtkCellArray* lines = strokes->GetLines();
  if (!lines || lines->GetNumberOfCells() == 0)
  {
    return {};
  }
  const StrokeReader reader(strokes, colors, ofCells);
  if (reader.IsEmpty())
  {
    return {};
  }
  StrokeRecords result = reader.GetFrame();
  const StrokeTolerance relative = tolerance.Relative(result.Origin);
  const RecordWriter writer(reader, relative);
  const std::vector<vtkIdType> runs = MakeRuns(lines);
  const auto numberOfRuns = static_cast<vtkIdType>(runs.size()) - 1;
  std::vector<LineRecords> written(numberOfRuns);
  result.Begins.assign(lines->GetNumberOfCells() + 1, 0); // within their runs, at first
  vtkSMPTools::For(0, numberOfRuns, 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      RecordWriter::Scratch scratch;
      vtkNew<vtkIdList> ids;
      for (vtkIdType run = begin; run < end; ++run)
      {
        for (vtkIdType line = runs[run]; line < runs[run + 1]; ++line)
        {
          lines->GetCellAtId(line, ids);
          const LinePoints points = { ids->GetNumberOfIds(), ids->GetPointer(0) };
          result.Begins[line] = static_cast<std::ptrdiff_t>(written[run].Records.size());
          writer.WriteLine(line, points, scratch, written[run]);
        }
      }
    });
  std::size_t size = 0;
  for (vtkIdType run = 0; run < numberOfRuns; ++run)
  {
    for (vtkIdType line = runs[run]; line < runs[run + 1]; ++line)
    {
      result.Begins[line] += static_cast<std::ptrdiff_t>(size);
    }
    size += written[run].Records.size();
  }
  result.Begins.back() = static_cast<std::ptrdiff_t>(size);
  result.Records.reserve(size);
  result.Colors.reserve(colors ? 4 * size : 0);
  for (const LineRecords& run : written)
  {
    result.Records.insert(result.Records.end(), run.Records.begin(), run.Records.end());
    result.Colors.insert(result.Colors.end(), run.Colors.begin(), run.Colors.end());
  }
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
