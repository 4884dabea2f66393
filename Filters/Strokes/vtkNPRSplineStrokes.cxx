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
  if (n < 3 || iterations == 0)
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
      const npr::Vector3& before = chain.Points[i > 0 ? i - 1 : n - 1].Position;
      const npr::Vector3& after = chain.Points[i + 1 < n ? i + 1 : 0].Position;
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
  npr::SplineKind Kind;
  npr::SplineBasis Basis;
  int Subdivisions;
  double SegmentLength;
  double ChordError;
  double CornerCosine;
  double MaximumBulge;
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
  /// Appends the samples of the smooth parts between the corners of the chain; where one ends and
  /// the next begins there is one sample. @returns the samples where parts end
  std::vector<std::size_t> SampleChain(
    const npr::StrokeChain& chain, std::vector<npr::StrokeSample>& samples) const
  {
    std::vector<std::size_t> ends;
    if (samples.empty())
    {
      samples.reserve(chain.Points.size() + 3); // what dense chains need
    }
    bool withFirst = true;
    for (const npr::SplinePart& part :
      npr::SplitAtCorners(chain, this->CornerCosine, this->MaximumBulge))
    {
      const std::ptrdiff_t end = part.GetEndSpan(this->Kind);
      npr::SpanPoints points(part, part.GetFirstSpan(this->Kind));
      for (std::ptrdiff_t i = part.GetFirstSpan(this->Kind); i < end; ++i, points.Advance())
      {
        const npr::CubicSpan span = points.MakeSpan(this->Basis);
        const int steps = this->GetNumberOfSteps(span);
        for (int step = withFirst ? 0 : 1; step <= steps; ++step)
        {
          const double t = static_cast<double>(step) / steps;
          samples.push_back({ span.Evaluate(t), 0.0, points.GetStart().Id, points.GetEnd().Id, t });
        }
        withFirst = false;
      }
      if (!part.IsClosed())
      {
        ends.push_back(samples.size() - 1);
      }
    }
    return ends;
  }

  int GetNumberOfSteps(const npr::CubicSpan& span) const
  {
    if (this->SegmentLength > 0 || this->ChordError > 0)
    {
      return npr::NumberOfSteps(
        span, this->SegmentLength, this->ChordError, vtkNPRSplineStrokes::MaximumSubdivisions);
    }
    return this->Kind == npr::SplineKind::Polyline ? 1 : this->Subdivisions;
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
  splines.Kind = static_cast<npr::SplineKind>(this->SplineType);
  splines.Basis = npr::GetSplineBasis(splines.Kind, this->Tension);
  splines.Subdivisions = this->Subdivisions;
  splines.SegmentLength = this->MaximumSegmentLength;
  splines.ChordError = this->MaximumChordError;
  splines.CornerCosine = npr::GetCornerCosine(this->CornerAngle);
  splines.MaximumBulge = this->SplineType == CATMULL_ROM ? this->MaximumBulge : 0.0;
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
  os << indent << "MaximumBulge: " << this->MaximumBulge << "\n";
  os << indent << "SmoothingIterations: " << this->SmoothingIterations << "\n";
  os << indent << "MaximumShift: " << this->MaximumShift << "\n";
  os << indent << "MaximumDeviation: " << this->MaximumDeviation << "\n";
}
