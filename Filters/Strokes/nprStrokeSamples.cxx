// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprStrokeSamples.h"

#include "nprArrayNames.h"

#include <vtkArrayListTemplate.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>

#include <cmath>

namespace npr
{
//------------------------------------------------------------------------------
void MeasureArcLength(std::vector<StrokeSample>& samples, std::size_t start)
{
  for (std::size_t i = start + 1; i < samples.size(); ++i)
  {
    samples[i].ArcLength = samples[i - 1].ArcLength +
      std::sqrt(vtkMath::Distance2BetweenPoints(
        samples[i - 1].Position.data(), samples[i].Position.data()));
  }
}

//------------------------------------------------------------------------------
void WriteStrokes(
  vtkPolyData* input, const std::vector<const SampledStrokes*>& strokes, vtkPolyData* output)
{
  const vtkIdType numberOfLines = static_cast<vtkIdType>(strokes.size());
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
      firstSample[line] + static_cast<vtkIdType>(strokes[line]->Samples.size());
    for (vtkIdType size : strokes[line]->Sizes)
    {
      outputCells->CopyData(inputCells, firstLineCell + line, offsets->GetNumberOfTuples() - 1);
      offsets->InsertNextValue(offsets->GetValue(offsets->GetNumberOfTuples() - 1) + size);
    }
  }
  const vtkIdType numberOfSamples = firstSample[numberOfLines];

  vtkNew<vtkPoints> points;
  points->SetDataType(input->GetPoints()->GetDataType());
  points->SetNumberOfPoints(numberOfSamples);
  vtkNew<vtkFloatArray> arcLength;
  arcLength->SetName(names::ArcLength);
  arcLength->SetNumberOfValues(numberOfSamples);
  vtkNew<vtkIdTypeArray> connectivity;
  connectivity->SetNumberOfValues(numberOfSamples);
  vtkPointData* outputPointData = output->GetPointData();
  outputPointData->CopyFieldOff(names::ArcLength);
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
        for (const StrokeSample& sample : strokes[line]->Samples)
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
}
}
