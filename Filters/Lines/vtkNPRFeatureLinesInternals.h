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
    npr::LineChoice Choice;
    bool IsExtracted = false; // whether the chains are those of the input and the definition
    bool IsWritten = false;   // whether the last output had these chains
  };
  std::vector<Entry> Entries;
  std::vector<npr::LineQuantity> Quantities;

  std::unique_ptr<npr::LineSurface> Surface;
  std::unique_ptr<npr::LineClusters> Clusters;
  std::unique_ptr<npr::FieldValues> Values;
  // What definitions are joined with that are joined at the same time.
  struct Bench
  {
    npr::LineSegments Segments;
    npr::LinePaths Paths;
    std::unique_ptr<npr::LineJoiner> Joiner;
  };
  std::array<Bench, 4> Benches;
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

  // Of as many entries as there are benches, or fewer. Parts of joining can not be shared out among
  // threads, so different definitions are joined at once.
  void Extract(const std::vector<Entry*>& entries, const npr::LineView& view);
  // Adds what these entries have to the output, whose last chains still stand where nothing has
  // changed.
  void Add(const std::vector<Entry*>& entries, const std::vector<Entry*>& changed);
  // Takes the points alone where the triangles are those of the last time.
  void SetSurface(vtkPolyData* input, double lengthScale);
  // Once the normals are there.
  void SetClusters(bool haveMoved);

private:
  template<typename Work>
  void ForEach(const std::vector<Entry*>& entries, const Work& work);
  std::vector<double> GetLevels(const Entry& entry) const;
};

#endif
