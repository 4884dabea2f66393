// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkNPRFeatureLinesInternals_h
#define vtkNPRFeatureLinesInternals_h

#include "nprFieldValues.h"
#include "nprLineChains.h"
#include "nprLineClusters.h"
#include "nprLineExtractor.h"
#include "nprLineJoiner.h"
#include "nprLineOutput.h"
#include "nprLineSurface.h"
#include "nprLineView.h"
#include "vtkNPRFeatureLines.h"
#include "vtkNPRLineDefinition.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <chrono>
#include <memory>
#include <vector>

// The definitions, and what is kept from view to view.
class vtkNPRFeatureLines::Internals
{
public:
  struct Entry
  {
    vtkSmartPointer<vtkNPRLineDefinition> Definition;
    vtkMTimeType MTime = 0; // the definition's, when the rest was made
    std::unique_ptr<npr::LineExtractor> Extractor;
    npr::LineChains Chains;
    npr::ChainIds Ids;
    bool IsExtracted = false; // whether the chains are those of the input and the definition
    bool IsWritten = false;   // whether the last output had these chains
  };
  std::vector<Entry> Entries;

  std::unique_ptr<npr::LineSurface> Surface;
  std::unique_ptr<npr::LineClusters> Clusters;
  std::unique_ptr<npr::FieldValues> Values;
  std::unique_ptr<npr::LineJoiner> Joiner;
  npr::LineSegments Segments;
  npr::LinePaths Paths;
  npr::LineOutput Output;
  int NextId = 0;

  // What was made where arrays were missing, and of which input.
  vtkSmartPointer<vtkPolyData> Curvature;
  vtkSmartPointer<vtkPolyData> CurvatureInput;
  vtkMTimeType CurvatureInputMTime = 0;

  vtkSmartPointer<vtkPolyData> Input; // kept, so that no other can have its address
  vtkMTimeType InputMTime = 0;
  double LengthScale = 0.0;
  bool OutputSources = false;
  npr::LineOptions Options; // of the lines that no view changes
  std::array<double, NumberOfStages> StageSeconds = {};

  // Adds the time since it was made to a stage.
  class StageTimer
  {
  public:
    StageTimer(Internals& internal, int stage) : Seconds(internal.StageSeconds[stage]) {}
    ~StageTimer()
    {
      this->Seconds +=
        std::chrono::duration<double>(std::chrono::steady_clock::now() - this->Start).count();
    }

  private:
    double& Seconds;
    const std::chrono::steady_clock::time_point Start = std::chrono::steady_clock::now();
  };

  void Extract(Entry& entry, const npr::LineView& view, const npr::LineOptions& options)
  {
    {
      const StageTimer timer(*this, EXTRACT);
      entry.Definition->BeginView(*this->Surface, view);
      entry.Extractor->Extract(view, options, *this->Values, this->Segments);
      entry.Definition->EndView(*this->Surface);
    }
    {
      const StageTimer timer(*this, JOIN);
      this->Joiner->Join(this->Segments, this->Paths);
    }
    entry.IsExtracted = true;
    entry.IsWritten = false;
    const StageTimer timer(*this, PLACE);
    entry.Chains.Make(*this->Surface, this->Segments, this->Paths, this->OutputSources);
  }

  // What the output says of the levels.
  std::vector<double> GetLevels(const Entry& entry) const
  {
    const std::vector<float>& levels = entry.Extractor->GetLevels();
    std::vector<double> result(levels.begin(), levels.end());
    for (double& level : result)
    {
      level += entry.Definition->GetLevelOffset(*this->Surface);
    }
    return result;
  }

  // Takes the points alone where the triangles are those of the last time.
  void SetSurface(vtkPolyData* input, double lengthScale)
  {
    for (Entry& entry : this->Entries)
    {
      entry.Extractor.reset();
    }
    if (!this->Surface || !this->Surface->Move(input, lengthScale))
    {
      this->Values.reset();
      this->Clusters.reset();
      this->Surface = std::make_unique<npr::LineSurface>(input, lengthScale);
      this->Joiner = std::make_unique<npr::LineJoiner>(*this->Surface);
      this->NextId = 0;
      for (Entry& entry : this->Entries)
      {
        entry.Ids = npr::ChainIds();
      }
    }
    this->Input = input;
    this->InputMTime = input->GetMTime();
    this->LengthScale = lengthScale;
  }

  // Once the normals are there.
  void SetClusters(bool haveMoved)
  {
    if (!this->Clusters)
    {
      this->Clusters = std::make_unique<npr::LineClusters>(*this->Surface);
      this->Values = std::make_unique<npr::FieldValues>(*this->Surface, *this->Clusters);
    }
    else if (haveMoved)
    {
      this->Clusters->UpdateBounds();
    }
  }
};

#endif
