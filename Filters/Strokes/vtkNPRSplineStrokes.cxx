// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRSplineStrokes.h"

#include "nprProgress.h"
#include "nprSplines.h"
#include "nprStrokeSamples.h"
#include "nprStrokeSimplifier.h"

#include <vtkCellArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkInformationVector.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace
{
/// Cosine of the angle by which a -> b -> c turns.
double TurnCosine(const npr::Vector3& a, const npr::Vector3& b, const npr::Vector3& c)
{
  npr::Vector3 in, out;
  vtkMath::Subtract(b.data(), a.data(), in.data());
  vtkMath::Subtract(c.data(), b.data(), out.data());
  const double lengths = vtkMath::Norm(in.data()) * vtkMath::Norm(out.data());
  return lengths > 0 ? vtkMath::Dot(in.data(), out.data()) / lengths : 1.0;
}

/// Moves a place towards another one, at most so far.
void MoveTowards(npr::Vector3& place, const npr::Vector3& goal, double most)
{
  npr::Vector3 way;
  vtkMath::Subtract(goal.data(), place.data(), way.data());
  const double length = vtkMath::Norm(way.data());
  for (int c = 0; c < 3; ++c)
  {
    place[c] = length <= most ? goal[c] : place[c] + most / length * way[c];
  }
}

void Smooth(npr::StrokeChain& chain, int iterations, double maximumShift)
{
  const std::size_t n = chain.Points.size();
  if (n < 3)
  {
    return;
  }
  const std::vector<npr::StrokePoint> original = chain.Points;
  std::vector<npr::Vector3> moved(n);
  for (int iteration = 0; iteration < iterations; ++iteration)
  {
    for (std::size_t i = 0; i < n; ++i)
    {
      const npr::Vector3& here = chain.Points[i].Position;
      if (!chain.Closed && (i == 0 || i == n - 1))
      {
        moved[i] = here;
        continue;
      }
      const npr::Vector3& before = chain.Points[(i + n - 1) % n].Position;
      const npr::Vector3& after = chain.Points[(i + 1) % n].Position;
      for (int c = 0; c < 3; ++c)
      {
        moved[i][c] = 0.25 * (before[c] + 2 * here[c] + after[c]);
      }
    }
    for (std::size_t i = 0; i < n; ++i)
    {
      chain.Points[i].Position = moved[i];
    }
  }
  for (std::size_t i = 0; maximumShift > 0.0 && i < n; ++i)
  {
    const npr::Vector3 goal = chain.Points[i].Position;
    chain.Points[i].Position = original[i].Position;
    MoveTowards(chain.Points[i].Position, goal, maximumShift);
  }
}

class Splines
{
public:
  int Type;
  double Tension;
  int Subdivisions;
  double SegmentLength;
  double ChordError;
  double CornerCosine;
  int SmoothingIterations;
  double MaximumShift;
  double MaximumDeviation;

  void Process(vtkPoints* points, vtkIdList* ids, npr::SampledStrokes& strokes) const
  {
    for (npr::StrokeChain& chain : npr::MakeStrokeChains(points, ids))
    {
      if (chain.Points.size() < 2)
      {
        continue;
      }
      Smooth(chain, this->SmoothingIterations, this->MaximumShift);
      const std::size_t start = strokes.Samples.size();
      const std::vector<std::size_t> corners = this->SampleChain(chain, strokes.Samples);
      npr::MeasureArcLength(strokes.Samples, start);
      if (this->MaximumDeviation > 0.0)
      {
        npr::SimplifyStroke(strokes.Samples, start, corners, chain.Closed, this->MaximumDeviation);
      }
      strokes.Sizes.push_back(static_cast<vtkIdType>(strokes.Samples.size() - start));
    }
  }

private:
  /// Appends the samples of the smooth parts between the corners of the chain. Returns which are
  /// corners.
  std::vector<std::size_t> SampleChain(
    const npr::StrokeChain& chain, std::vector<npr::StrokeSample>& samples) const
  {
    const std::size_t n = chain.Points.size();
    std::vector<std::size_t> corners;
    for (std::size_t i = chain.Closed ? 0 : 1; i < (chain.Closed ? n : n - 1); ++i)
    {
      if (TurnCosine(chain.Points[(i + n - 1) % n].Position, chain.Points[i].Position,
            chain.Points[(i + 1) % n].Position) < this->CornerCosine)
      {
        corners.push_back(i);
      }
    }
    if (chain.Closed && corners.empty())
    {
      this->SamplePart(chain.Points, true, true, samples);
      return {};
    }

    // A closed chain is opened at its first corner.
    const std::size_t begin = chain.Closed ? corners.front() : 0;
    const std::size_t end = chain.Closed ? begin + n : n - 1;
    if (chain.Closed)
    {
      corners.erase(corners.begin());
    }
    corners.push_back(end);
    std::size_t first = begin;
    std::vector<npr::StrokePoint> part;
    std::vector<std::size_t> sampled;
    for (std::size_t corner : corners)
    {
      part.clear();
      for (std::size_t i = first; i <= corner; ++i)
      {
        part.push_back(chain.Points[i % n]);
      }
      this->SamplePart(part, false, first == begin, samples);
      sampled.push_back(samples.size() - 1);
      first = corner;
    }
    return sampled;
  }

  /// Appends the samples of one smooth part; without its first one where that has been the last of
  /// the part before.
  void SamplePart(const std::vector<npr::StrokePoint>& points, bool closed, bool withFirst,
    std::vector<npr::StrokeSample>& samples) const
  {
    const std::ptrdiff_t n = static_cast<std::ptrdiff_t>(points.size());
    auto control = [&](std::ptrdiff_t i) -> const npr::StrokePoint&
    { return points[closed ? (i + n) % n : std::min(std::max<std::ptrdiff_t>(i, 0), n - 1)]; };
    // The B-spline reaches an open end only if that end counts three times: one more span.
    const std::ptrdiff_t more = this->Type == vtkNPRSplineStrokes::B_SPLINE && !closed ? 1 : 0;
    const std::ptrdiff_t begin = -more;
    const std::ptrdiff_t end = (closed ? n : n - 1) + more;
    for (std::ptrdiff_t i = begin; i < end; ++i)
    {
      const npr::CubicSpan span = this->MakeSpan({ control(i - 1).Position, control(i).Position,
        control(i + 1).Position, control(i + 2).Position });
      const int steps = this->GetNumberOfSteps(span);
      for (int step = (i == begin && withFirst) ? 0 : 1; step <= steps; ++step)
      {
        const double t = static_cast<double>(step) / steps;
        samples.push_back({ span.Evaluate(t), 0.0, control(i).Id, control(i + 1).Id, t });
      }
    }
  }

  npr::CubicSpan MakeSpan(const std::array<npr::Vector3, 4>& points) const
  {
    switch (this->Type)
    {
      case vtkNPRSplineStrokes::CATMULL_ROM:
        return npr::CatmullRomSpan(points, this->Tension);
      case vtkNPRSplineStrokes::B_SPLINE:
        return npr::BSplineSpan(points);
      default:
        return npr::LinearSpan(points);
    }
  }

  int GetNumberOfSteps(const npr::CubicSpan& span) const
  {
    if (this->SegmentLength > 0 || this->ChordError > 0)
    {
      return npr::NumberOfSteps(
        span, this->SegmentLength, this->ChordError, vtkNPRSplineStrokes::MaximumSubdivisions);
    }
    return this->Type == vtkNPRSplineStrokes::NONE ? 1 : this->Subdivisions;
  }
};
}

vtkStandardNewMacro(vtkNPRSplineStrokes);

int vtkNPRSplineStrokes::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  output->GetFieldData()->PassData(input->GetFieldData());
  vtkCellArray* lines = input->GetLines();
  const vtkIdType numberOfLines = lines->GetNumberOfCells();
  if (numberOfLines == 0 || !input->GetPoints())
  {
    return 1;
  }

  Splines splines;
  splines.Type = this->SplineType;
  splines.Tension = this->Tension;
  splines.Subdivisions = this->Subdivisions;
  splines.SegmentLength = this->MaximumSegmentLength;
  splines.ChordError = this->MaximumChordError;
  // No turn is a corner at 180 degrees, however the cosine is rounded.
  splines.CornerCosine =
    this->CornerAngle < 180.0 ? std::cos(vtkMath::RadiansFromDegrees(this->CornerAngle)) : -2.0;
  splines.SmoothingIterations = this->SmoothingIterations;
  splines.MaximumShift = this->MaximumShift;
  splines.MaximumDeviation = this->MaximumDeviation;

  vtkPoints* inputPoints = input->GetPoints();
  std::vector<npr::SampledStrokes> strokes(numberOfLines);
  vtkSMPTools::For(0, numberOfLines,
    [&](vtkIdType begin, vtkIdType end)
    {
      vtkNew<vtkIdList> ids;
      for (vtkIdType line = begin; line < end && !this->GetAbortExecute(); ++line)
      {
        lines->GetCellAtId(line, ids);
        splines.Process(inputPoints, ids, strokes[line]);
      }
    });
  this->UpdateProgress(0.5);
  if (npr::IsAborted(this))
  {
    return 1;
  }

  npr::WriteStrokes(input, npr::PointersTo(strokes), output);
  this->UpdateProgress(1.0);
  return 1;
}

void vtkNPRSplineStrokes::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SplineType: " << this->SplineType << "\n";
  os << indent << "Tension: " << this->Tension << "\n";
  os << indent << "Subdivisions: " << this->Subdivisions << "\n";
  os << indent << "MaximumSegmentLength: " << this->MaximumSegmentLength << "\n";
  os << indent << "MaximumChordError: " << this->MaximumChordError << "\n";
  os << indent << "CornerAngle: " << this->CornerAngle << "\n";
  os << indent << "SmoothingIterations: " << this->SmoothingIterations << "\n";
  os << indent << "MaximumShift: " << this->MaximumShift << "\n";
  os << indent << "MaximumDeviation: " << this->MaximumDeviation << "\n";
}
