// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRSplineStrokes.h"

#include "nprArrayNames.h"
#include "nprSplines.h"
#include "nprVTKCompat.h"

#include <vtkArrayListTemplate.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkIdList.h>
#include <vtkIdTypeArray.h>
#include <vtkInformationVector.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace
{
struct ControlPoint
{
  npr::Vector3 Position;
  vtkIdType Id;
};

struct Sample
{
  npr::Vector3 Position;
  double ArcLength;
  // The control points around the sample, and where it lies between them.
  vtkIdType From;
  vtkIdType To;
  double T;
};

/// What one input polyline turns into: strokes one after another.
struct Strokes
{
  std::vector<Sample> Samples;
  std::vector<vtkIdType> Sizes;
};

struct Chain
{
  std::vector<ControlPoint> Points;
  bool Closed = false; // the last point then joins the first, which is not repeated
};

double SquaredDistance(const npr::Vector3& a, const npr::Vector3& b)
{
  return vtkMath::Distance2BetweenPoints(a.data(), b.data());
}

/// Cosine of the angle by which a -> b -> c turns.
double TurnCosine(const npr::Vector3& a, const npr::Vector3& b, const npr::Vector3& c)
{
  npr::Vector3 in, out;
  vtkMath::Subtract(b.data(), a.data(), in.data());
  vtkMath::Subtract(c.data(), b.data(), out.data());
  const double lengths = vtkMath::Norm(in.data()) * vtkMath::Norm(out.data());
  return lengths > 0 ? vtkMath::Dot(in.data(), out.data()) / lengths : 1.0;
}

/// The finite runs of a polyline, without repeated points.
std::vector<Chain> MakeChains(vtkPoints* points, vtkIdList* ids)
{
  std::vector<Chain> chains(1);
  bool cut = false;
  for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
  {
    ControlPoint point;
    point.Id = ids->GetId(i);
    points->GetPoint(point.Id, point.Position.data());
    if (!std::isfinite(point.Position[0]) || !std::isfinite(point.Position[1]) ||
      !std::isfinite(point.Position[2]))
    {
      cut = true;
      if (!chains.back().Points.empty())
      {
        chains.emplace_back();
      }
      continue;
    }
    std::vector<ControlPoint>& chain = chains.back().Points;
    if (chain.empty() || SquaredDistance(chain.back().Position, point.Position) > 0)
    {
      chain.push_back(point);
    }
  }
  if (!cut && chains[0].Points.size() > 3 &&
    SquaredDistance(chains[0].Points.front().Position, chains[0].Points.back().Position) == 0)
  {
    chains[0].Points.pop_back();
    chains[0].Closed = true;
  }
  return chains;
}

void Smooth(Chain& chain, int iterations)
{
  const std::size_t n = chain.Points.size();
  if (n < 3)
  {
    return;
  }
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

  void Process(vtkPoints* points, vtkIdList* ids, Strokes& strokes) const
  {
    for (Chain& chain : MakeChains(points, ids))
    {
      if (chain.Points.size() < 2)
      {
        continue;
      }
      Smooth(chain, this->SmoothingIterations);
      const std::size_t start = strokes.Samples.size();
      this->SampleChain(chain, strokes.Samples);
      MeasureArcLength(strokes.Samples, start);
      strokes.Sizes.push_back(static_cast<vtkIdType>(strokes.Samples.size() - start));
    }
  }

private:
  static void MeasureArcLength(std::vector<Sample>& samples, std::size_t start)
  {
    for (std::size_t i = start + 1; i < samples.size(); ++i)
    {
      samples[i].ArcLength = samples[i - 1].ArcLength +
        std::sqrt(SquaredDistance(samples[i - 1].Position, samples[i].Position));
    }
  }

  /// Appends the samples of the smooth parts between the corners of the chain.
  void SampleChain(const Chain& chain, std::vector<Sample>& samples) const
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
      return;
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
    std::vector<ControlPoint> part;
    for (std::size_t corner : corners)
    {
      part.clear();
      for (std::size_t i = first; i <= corner; ++i)
      {
        part.push_back(chain.Points[i % n]);
      }
      this->SamplePart(part, false, first == begin, samples);
      first = corner;
    }
  }

  /// Appends the samples of one smooth part; without its first one where that has been the last of
  /// the part before.
  void SamplePart(const std::vector<ControlPoint>& points, bool closed, bool withFirst,
    std::vector<Sample>& samples) const
  {
    const std::ptrdiff_t n = static_cast<std::ptrdiff_t>(points.size());
    auto control = [&](std::ptrdiff_t i) -> const ControlPoint&
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

bool IsAborted(vtkAlgorithm* algorithm)
{
#if NPR_VTK_AT_LEAST(9, 3)
  return algorithm->CheckAbort();
#else
  return algorithm->GetAbortExecute() != 0;
#endif
}
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

  vtkPoints* inputPoints = input->GetPoints();
  std::vector<Strokes> strokes(numberOfLines);
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
  if (IsAborted(this))
  {
    return 1;
  }

  std::vector<vtkIdType> firstSample(numberOfLines + 1, 0);
  vtkNew<vtkIdTypeArray> offsets;
  offsets->InsertNextValue(0);
  vtkCellData* inputCells = input->GetCellData();
  vtkCellData* outputCells = output->GetCellData();
  outputCells->CopyAllOn();
  outputCells->CopyAllocate(inputCells, numberOfLines);
  const vtkIdType firstLineCell = input->GetNumberOfVerts();
  for (vtkIdType line = 0; line < numberOfLines; ++line)
  {
    firstSample[line + 1] =
      firstSample[line] + static_cast<vtkIdType>(strokes[line].Samples.size());
    for (vtkIdType size : strokes[line].Sizes)
    {
      outputCells->CopyData(inputCells, firstLineCell + line, offsets->GetNumberOfTuples() - 1);
      offsets->InsertNextValue(offsets->GetValue(offsets->GetNumberOfTuples() - 1) + size);
    }
  }
  const vtkIdType numberOfSamples = firstSample[numberOfLines];

  vtkNew<vtkPoints> points;
  points->SetDataType(inputPoints->GetDataType());
  points->SetNumberOfPoints(numberOfSamples);
  vtkNew<vtkFloatArray> arcLength;
  arcLength->SetName(npr::names::ArcLength);
  arcLength->SetNumberOfValues(numberOfSamples);
  vtkNew<vtkIdTypeArray> connectivity;
  connectivity->SetNumberOfValues(numberOfSamples);
  vtkPointData* outputPointData = output->GetPointData();
  outputPointData->CopyFieldOff(npr::names::ArcLength);
  outputPointData->InterpolateAllocate(input->GetPointData(), numberOfSamples);
  ArrayList arrays;
  arrays.AddArrays(numberOfSamples, input->GetPointData(), outputPointData, 0.0, false);
  // What can't be interpolated (strings) has no place on the samples.
  for (int i = outputPointData->GetNumberOfArrays() - 1; i >= 0; --i)
  {
    if (outputPointData->GetAbstractArray(i)->GetNumberOfTuples() != numberOfSamples)
    {
      outputPointData->RemoveArray(i);
    }
  }
  vtkSMPTools::For(0, numberOfLines,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType line = begin; line < end; ++line)
      {
        vtkIdType id = firstSample[line];
        for (const Sample& sample : strokes[line].Samples)
        {
          points->SetPoint(id, sample.Position.data());
          arcLength->SetValue(id, static_cast<float>(sample.ArcLength));
          connectivity->SetValue(id, id);
          arrays.InterpolateEdge(sample.From, sample.To, sample.T, id);
          ++id;
        }
      }
    });

  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, connectivity);
  output->SetPoints(points);
  output->SetLines(cells);
  outputPointData->AddArray(arcLength);
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
}
