// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprStrokePartsOutput.h"

#include "nprArrayNames.h"

#include <vtkArrayListTemplate.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkIdList.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>

#include <array>
#include <cmath>
#include <utility>

namespace npr
{
namespace
{
/// A point of the output: between two of the input.
struct Sample
{
  vtkIdType From;
  vtkIdType To;
  double T;
  double ArcLength;
};

/// One polyline of the input, with the distance of each of its points from the first.
class MeasuredStroke
{
public:
  MeasuredStroke(vtkPolyData* input, vtkIdType line)
  {
    input->GetLines()->GetCellAtId(line, this->Ids);
    vtkDataArray* const given = input->GetPointData()->GetArray(names::ArcLength);
    const bool isGiven = given && given->GetNumberOfComponents() == 1;
    this->ArcLengths.resize(this->Ids->GetNumberOfIds());
    std::array<double, 3> before{};
    for (vtkIdType i = 0; i < this->Ids->GetNumberOfIds(); ++i)
    {
      std::array<double, 3> point;
      input->GetPoint(this->Ids->GetId(i), point.data());
      if (isGiven)
      {
        this->ArcLengths[i] = given->GetComponent(this->Ids->GetId(i), 0);
      }
      else if (i > 0)
      {
        const double step = std::sqrt(vtkMath::Distance2BetweenPoints(before.data(), point.data()));
        this->ArcLengths[i] = this->ArcLengths[i - 1] + (std::isfinite(step) ? step : 0.0);
      }
      before = point;
    }
  }

  /// The points of a part, from its first cut to its last.
  std::vector<Sample> GetSamples(const StrokePart& part) const
  {
    std::vector<Sample> samples = { this->GetSample(part.Begin, 0.0) };
    double place = part.Begin;
    double turn = 0.0;
    if (part.IsOverFirstPoint())
    {
      this->AddSamples(place, static_cast<double>(this->ArcLengths.size() - 1), 0.0, samples);
      place = 0.0;
      turn = this->ArcLengths.back() - this->ArcLengths.front();
    }
    this->AddSamples(place, part.End, turn, samples);
    return samples;
  }

private:
  /// Those after the one place up to the other.
  void AddSamples(double begin, double end, double turn, std::vector<Sample>& samples) const
  {
    for (double place = std::floor(begin) + 1.0; place < end; place += 1.0)
    {
      samples.push_back(this->GetSample(place, turn));
    }
    samples.push_back(this->GetSample(end, turn));
  }

  /// \p turn is added to the distance.
  Sample GetSample(double place, double turn) const
  {
    const auto before = static_cast<vtkIdType>(std::floor(place));
    const double t = place - static_cast<double>(before);
    const vtkIdType after = t > 0.0 ? before + 1 : before;
    return { this->Ids->GetId(before), this->Ids->GetId(after), t,
      this->ArcLengths[before] + t * (this->ArcLengths[after] - this->ArcLengths[before]) + turn };
  }

  vtkNew<vtkIdList> Ids;
  std::vector<double> ArcLengths;
};

bool IsFloating(vtkDataArray* array)
{
  return array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE;
}
}

//------------------------------------------------------------------------------
bool IsClosedStroke(vtkPoints* points, vtkIdList* ids)
{
  const vtkIdType size = ids->GetNumberOfIds();
  if (size < 4)
  {
    return false;
  }
  std::array<double, 3> first;
  std::array<double, 3> last;
  points->GetPoint(ids->GetId(0), first.data());
  points->GetPoint(ids->GetId(size - 1), last.data());
  return first == last;
}

//------------------------------------------------------------------------------
void WriteStrokeParts(
  vtkPolyData* input, const std::vector<std::vector<StrokePart>>& parts, vtkPolyData* output)
{
  const vtkIdType numberOfLines = input->GetLines()->GetNumberOfCells();
  std::vector<std::vector<Sample>> samples(numberOfLines);
  std::vector<std::vector<vtkIdType>> sizes(numberOfLines);
  vtkSMPTools::For(0, numberOfLines,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType line = begin; line < end; ++line)
      {
        const MeasuredStroke stroke(input, line);
        for (const StrokePart& part : parts[line])
        {
          if (part.Layers != StrokePart::Nowhere)
          {
            const std::vector<Sample> more = stroke.GetSamples(part);
            samples[line].insert(samples[line].end(), more.begin(), more.end());
            sizes[line].push_back(static_cast<vtkIdType>(more.size()));
          }
        }
      }
    });

  vtkCellData* const inputCells = input->GetCellData();
  vtkCellData* const outputCells = output->GetCellData();
  outputCells->CopyAllOn();
  outputCells->CopyFieldOff(names::HidingLayers);
  outputCells->CopyAllocate(inputCells, numberOfLines);
  vtkNew<vtkIntArray> layers;
  layers->SetName(names::HidingLayers);
  vtkNew<vtkIdTypeArray> offsets;
  offsets->InsertNextValue(0);
  std::vector<vtkIdType> firstSample(numberOfLines + 1, 0);
  vtkIdType numberOfPoints = 0;
  for (vtkIdType line = 0; line < numberOfLines; ++line)
  {
    firstSample[line] = numberOfPoints;
    std::size_t written = 0;
    for (const StrokePart& part : parts[line])
    {
      if (part.Layers != StrokePart::Nowhere)
      {
        outputCells->CopyData(
          inputCells, input->GetNumberOfVerts() + line, layers->GetNumberOfTuples());
        layers->InsertNextValue(part.Layers);
        numberOfPoints += sizes[line][written++];
        offsets->InsertNextValue(numberOfPoints);
      }
    }
  }

  vtkPoints* const inputPoints = input->GetPoints();
  vtkNew<vtkPoints> points;
  points->SetDataType(inputPoints->GetDataType());
  points->SetNumberOfPoints(numberOfPoints);
  vtkNew<vtkFloatArray> arcLength;
  arcLength->SetName(names::ArcLength);
  arcLength->SetNumberOfValues(numberOfPoints);
  vtkNew<vtkIdTypeArray> connectivity;
  connectivity->SetNumberOfValues(numberOfPoints);
  vtkPointData* const inputPointData = input->GetPointData();
  vtkPointData* const outputPointData = output->GetPointData();
  outputPointData->CopyFieldOff(names::ArcLength);
  outputPointData->InterpolateAllocate(inputPointData, numberOfPoints);
  // Numbers that name something have nothing between them.
  ArrayList mixed;
  ArrayList chosen;
  for (int i = 0; i < inputPointData->GetNumberOfArrays(); ++i)
  {
    if (vtkDataArray* const array = inputPointData->GetArray(i))
    {
      (IsFloating(array) ? chosen : mixed).ExcludeArray(array);
    }
  }
  mixed.AddArrays(numberOfPoints, inputPointData, outputPointData, 0.0, false);
  chosen.AddArrays(numberOfPoints, inputPointData, outputPointData, 0.0, false);
  for (int i = outputPointData->GetNumberOfArrays() - 1; i >= 0; --i)
  {
    if (outputPointData->GetAbstractArray(i)->GetNumberOfTuples() != numberOfPoints)
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
        for (const Sample& sample : samples[line])
        {
          std::array<double, 3> from;
          std::array<double, 3> to;
          inputPoints->GetPoint(sample.From, from.data());
          inputPoints->GetPoint(sample.To, to.data());
          for (int c = 0; c < 3; ++c)
          {
            from[c] += sample.T * (to[c] - from[c]);
          }
          points->SetPoint(id, from.data());
          if (sample.T > 0.0)
          {
            mixed.InterpolateEdge(sample.From, sample.To, sample.T, id);
          }
          else
          {
            mixed.Copy(sample.From, id);
          }
          chosen.Copy(sample.T < 0.5 ? sample.From : sample.To, id);
          arcLength->SetValue(id, static_cast<float>(sample.ArcLength));
          connectivity->SetValue(id, id);
          ++id;
        }
      }
    });

  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, connectivity);
  output->SetPoints(points);
  output->SetLines(cells);
  outputPointData->AddArray(arcLength);
  outputCells->AddArray(layers);
}
}
