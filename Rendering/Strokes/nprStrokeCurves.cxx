// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprStrokeCurves.h"

#include "nprStrokeChains.h"
#include "nprStrokeReader.h"
#include "vtkNPRSplineStrokes.h"

#include <vtkCellArray.h>
#include <vtkIdList.h>
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
// Bounds the memory where the camera is amid the strokes.
constexpr vtkIdType MostPoints = 1 << 24;
// Work is shared out by so many lines, however many threads there are.
constexpr vtkIdType LinesAtOnce = 64;

/// What becomes of some lines, one after another.
struct CurveBlock
{
  std::vector<StrokeRecord> Controls;
  std::vector<unsigned char> Colors;
  std::vector<CurvePoint> Points;
  std::vector<std::ptrdiff_t> Begins; // of the points of each line
  Vector3 HalfSize = { 0, 0, 0 };
};

/// What lies between two records, but for its kind.
StrokeRecord Between(const StrokeRecord& a, const StrokeRecord& b, float t)
{
  StrokeRecord record = a;
  for (int c = 0; c < 3; ++c)
  {
    record.Position[c] += t * (b.Position[c] - a.Position[c]);
  }
  record.Width += t * (b.Width - a.Width);
  record.Strength += t * (b.Strength - a.Strength);
  record.Opacity += t * (b.Opacity - a.Opacity);
  return record;
}

/// Writes the curves of lines into a block.
class CurveWriter
{
public:
  CurveWriter(vtkPolyData* strokes, const StrokeReader& reader, const StrokeTolerance& tolerance,
    const CurveSettings& settings, CurveBlock& block)
    : Strokes(strokes), Reader(reader), Tolerance(tolerance), Kind(settings.Kind),
      Basis(GetSplineBasis(settings.Kind, SplineTension)),
      CornerCosine(GetCornerCosine(settings.CornerAngle)),
      ChordError(settings.ChordError * tolerance.Length), Block(block)
  {
    const vtkIdType most =
      MostPoints / std::max<vtkIdType>(strokes->GetLines()->GetNumberOfConnectivityIds(), 1);
    this->MostSteps = static_cast<int>(
      std::min<vtkIdType>(vtkNPRSplineStrokes::MaximumSubdivisions, std::max<vtkIdType>(most, 1)));
  }

  void WriteLine(vtkIdType line)
  {
    this->Block.Begins.push_back(static_cast<std::ptrdiff_t>(this->Block.Points.size()));
    this->Strokes->GetLines()->GetCellAtId(line, this->Ids);
    for (const StrokeChain& chain : MakeStrokeChains(this->Strokes->GetPoints(), this->Ids))
    {
      if (chain.Points.size() > 1)
      {
        this->WriteSpans(chain, line);
        this->WritePoints();
        this->SetKinds(chain.Closed, line);
      }
    }
  }

private:
  /// The control points of a chain, and the ends of its spans.
  void WriteSpans(const StrokeChain& chain, vtkIdType line)
  {
    this->Ends.clear();
    this->EndColors.clear();
    this->Spans.clear();
    this->Steps.clear();
    for (const SplinePart& part : SplitAtCorners(chain, this->CornerCosine))
    {
      const std::ptrdiff_t first = part.GetFirstSpan(this->Kind);
      const std::ptrdiff_t end = part.GetEndSpan(this->Kind);
      std::size_t number = this->Block.Controls.size() + 1;
      for (std::ptrdiff_t i = first - 1; i <= end + 1; ++i)
      {
        this->WriteControl(part.GetPoint(i), line);
      }
      SpanPoints points(part, first);
      for (std::ptrdiff_t i = first; i < end; ++i, ++number, points.Advance())
      {
        const CubicSpan span = points.MakeSpan(this->Basis);
        this->AddToSize(span);
        if (this->Ends.empty())
        {
          this->AddEnd(number, span.Evaluate(0.0));
        }
        this->AddEnd(number + 1, span.Evaluate(1.0));
        this->Spans.push_back(number);
        const bool flat = DistanceFromChord(span) <= this->ChordError && this->IsEven();
        this->Steps.push_back(
          flat ? 1 : NumberOfSteps(span, 0.0, this->ChordError, this->MostSteps));
      }
    }
  }

  void WriteControl(const StrokePoint& point, vtkIdType line)
  {
    this->Block.Controls.push_back(this->Reader.Read(point.Id, point.Position));
    if (this->Reader.HasColors())
    {
      unsigned char color[4];
      this->Reader.ReadColor(line, point.Id, color);
      this->Block.Colors.insert(this->Block.Colors.end(), color, color + 4);
    }
  }

  /// An end of a span has what its control point has, but for the place.
  void AddEnd(std::size_t control, const Vector3& place)
  {
    StrokeRecord record = this->Block.Controls[control];
    for (int c = 0; c < 3; ++c)
    {
      record.Position[c] = static_cast<float>(place[c] - this->Reader.GetFrame().Origin[c]);
    }
    record.ArcLength = 0.0f;
    this->Ends.push_back(record);
    if (this->Reader.HasColors())
    {
      const unsigned char* const color = &this->Block.Colors[4 * control];
      this->EndColors.insert(this->EndColors.end(), color, color + 4);
    }
  }

  /// Whether the last span is as wide, strong, opaque and coloured at its end as at its start: then
  /// it doesn't matter how fast it is passed.
  bool IsEven() const
  {
    const StrokeRecord& a = *(this->Ends.end() - 2);
    const StrokeRecord& b = this->Ends.back();
    return std::abs(a.Width - b.Width) <= this->Tolerance.Width &&
      std::abs(a.Strength - b.Strength) <= this->Tolerance.Strength &&
      std::abs(a.Opacity - b.Opacity) <= this->Tolerance.Opacity &&
      (this->EndColors.empty() ||
        std::equal(
          this->EndColors.end() - 8, this->EndColors.end() - 4, this->EndColors.end() - 4));
  }

  /// A span is within the hull of its control points as a Bezier curve.
  void AddToSize(const CubicSpan& span)
  {
    const std::array<Vector3, 4>& k = span.Coefficients;
    for (int c = 0; c < 3; ++c)
    {
      const double first = k[0][c] - this->Reader.GetFrame().Origin[c];
      for (const double place : { first, first + k[1][c] / 3.0,
             first + (2.0 * k[1][c] + k[2][c]) / 3.0, first + k[1][c] + k[2][c] + k[3][c] })
      {
        this->Block.HalfSize[c] = std::max(this->Block.HalfSize[c], std::abs(place));
      }
    }
  }

  /// The points of the spans that were written last, without kinds.
  void WritePoints()
  {
    this->Begin = this->Block.Points.size();
    this->SteepBefore.assign(1, false);
    this->Block.Points.push_back({ static_cast<float>(this->Spans[0]), 0.0f, 0.0f });
    for (std::size_t i = 0; i < this->Spans.size();)
    {
      std::size_t end = i;
      while (end < this->Spans.size() && this->Steps[end] == 1)
      {
        ++end;
      }
      if (end == i)
      {
        const StrokeRecord next =
          Between(this->Ends[i], this->Ends[i + 1], 1.0f / static_cast<float>(this->Steps[i]));
        const bool steep = IsSteep(this->Ends[i], next, this->Tolerance);
        for (int step = 1; step <= this->Steps[i]; ++step)
        {
          this->AddPoint(i, static_cast<float>(step) / static_cast<float>(this->Steps[i]), steep);
        }
        ++i;
        continue;
      }
      this->Run.assign(this->Ends.begin() + i, this->Ends.begin() + end + 1);
      SimplifyStroke(this->Run, this->EndColors.empty() ? nullptr : &this->EndColors[4 * i],
        this->Tolerance, this->Kept);
      for (std::size_t k = 1; k < this->Kept.size(); ++k)
      {
        this->AddPoint(i + this->Kept[k] - 1, 1.0f,
          IsSteep(this->Run[this->Kept[k - 1]], this->Run[this->Kept[k]], this->Tolerance));
      }
      i = end;
    }
  }

  void AddPoint(std::size_t span, float t, bool steep)
  {
    this->Block.Points.push_back({ static_cast<float>(this->Spans[span]), t, 0.0f });
    this->SteepBefore.push_back(steep);
  }

  /// What the points that were written last are on their stroke; with the neighbours of the seam
  /// where it is closed.
  void SetKinds(bool closed, vtkIdType line)
  {
    std::vector<CurvePoint>& points = this->Block.Points;
    const int base = StrokeNumber * static_cast<int>(line % MostStrokeNumbers) +
      (this->Reader.IsHidden(line) ? Hidden : 0);
    const std::size_t count = this->SteepBefore.size();
    this->SteepBefore.push_back(closed && this->SteepBefore[1]);
    this->SteepBefore[0] = closed && this->SteepBefore[count - 1];
    for (std::size_t i = 0; i < count; ++i)
    {
      const bool isFirst = i == 0;
      const bool isLast = i + 1 == count;
      points[this->Begin + i].Kind = static_cast<float>(base + (isLast ? 0 : Drawn) +
        (isFirst && !closed ? 0 : HasBefore) + (isLast && !closed ? 0 : HasAfter) +
        (this->SteepBefore[i] || this->SteepBefore[i + 1] ? Steep : 0));
    }
    if (closed)
    {
      CurvePoint before = points[points.size() - 2];
      CurvePoint after = points[this->Begin + 1];
      before.Kind = after.Kind = 0.0f;
      points.insert(points.begin() + static_cast<std::ptrdiff_t>(this->Begin), before);
      points.push_back(after);
    }
  }

  vtkPolyData* Strokes;
  const StrokeReader& Reader;
  const StrokeTolerance& Tolerance;
  SplineKind Kind;
  SplineBasis Basis;
  double CornerCosine;
  double ChordError;
  int MostSteps;
  CurveBlock& Block;

  vtkNew<vtkIdList> Ids;
  // Of one chain: the ends of its spans, the numbers of the spans, and of their parts.
  std::vector<StrokeRecord> Ends;
  std::vector<unsigned char> EndColors;
  std::vector<std::size_t> Spans;
  std::vector<int> Steps;
  std::vector<StrokeRecord> Run;
  std::vector<std::size_t> Kept;
  // Its points: the first one, and whether the segment before each is steep.
  std::size_t Begin = 0;
  std::vector<bool> SteepBefore;
};

void Append(const CurveBlock& block, StrokeCurves& curves)
{
  StrokeRecords& strokes = curves.Strokes;
  const auto controls = static_cast<float>(strokes.Records.size());
  const auto points = static_cast<std::ptrdiff_t>(curves.Points.size());
  for (CurvePoint point : block.Points)
  {
    point.Span += controls;
    curves.Points.push_back(point);
  }
  for (const std::ptrdiff_t begin : block.Begins)
  {
    strokes.Begins.push_back(points + begin);
  }
  strokes.Records.insert(strokes.Records.end(), block.Controls.begin(), block.Controls.end());
  strokes.Colors.insert(strokes.Colors.end(), block.Colors.begin(), block.Colors.end());
  for (int c = 0; c < 3; ++c)
  {
    strokes.HalfSize[c] = std::max(strokes.HalfSize[c], block.HalfSize[c]);
  }
}
}

//------------------------------------------------------------------------------
bool CurveSettings::operator==(const CurveSettings& other) const
{
  return this->Kind == other.Kind && this->CornerAngle == other.CornerAngle &&
    this->ChordError == other.ChordError && this->Measured == other.Measured;
}

//------------------------------------------------------------------------------
StrokeCurves MakeStrokeCurves(vtkPolyData* strokes, vtkUnsignedCharArray* colors, bool ofCells,
  const StrokeTolerance& tolerance, const CurveSettings& settings)
{
  StrokeCurves curves;
  curves.Basis = GetSplineBasis(settings.Kind, SplineTension);
  const vtkIdType numberOfLines = strokes->GetLines()->GetNumberOfCells();
  const StrokeReader reader(strokes, colors, ofCells);
  if (numberOfLines == 0 || reader.IsEmpty())
  {
    return curves;
  }
  std::vector<CurveBlock> blocks((numberOfLines + LinesAtOnce - 1) / LinesAtOnce);
  vtkSMPTools::For(0, static_cast<vtkIdType>(blocks.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        CurveWriter writer(strokes, reader, tolerance, settings, blocks[i]);
        const vtkIdType last = std::min((i + 1) * LinesAtOnce, numberOfLines);
        for (vtkIdType line = i * LinesAtOnce; line < last; ++line)
        {
          writer.WriteLine(line);
        }
      }
    });

  curves.Strokes.Origin = reader.GetFrame().Origin;
  std::size_t sizes[2] = { 0, 0 };
  for (const CurveBlock& block : blocks)
  {
    sizes[0] += block.Controls.size();
    sizes[1] += block.Points.size();
  }
  curves.Strokes.Records.reserve(sizes[0]);
  curves.Points.reserve(sizes[1]);
  for (CurveBlock& block : blocks)
  {
    Append(block, curves);
    block = CurveBlock();
  }
  curves.Strokes.Begins.push_back(static_cast<std::ptrdiff_t>(curves.Points.size()));
  if (reader.HasWidths())
  {
    curves.Strokes.MaximumWidth = 0;
    for (const StrokeRecord& control : curves.Strokes.Records)
    {
      curves.Strokes.MaximumWidth = std::max(curves.Strokes.MaximumWidth, control.Width);
    }
  }
  return curves;
}
}
