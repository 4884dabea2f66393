// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Every filter gives the same bits for every number of threads, whoever makes them.
#include "nprCurvaturePipeline.h"
#include "nprIrregularMeshes.h"
#include "vtkNPRSurfaceRefinement.h"

#include <vtkSMPTools.h>

#include <cstring>
#include <string>
#include <thread>

using namespace nprtest;

namespace
{
struct Threads
{
  const char* Backend;
  int Number;
};

bool AreEqual(vtkAbstractArray* a, vtkAbstractArray* b)
{
  return a && b && a->GetDataType() == b->GetDataType() && a->GetDataSize() == b->GetDataSize() &&
    a->GetNumberOfTuples() == b->GetNumberOfTuples() &&
    std::memcmp(a->GetVoidPointer(0), b->GetVoidPointer(0),
      a->GetNumberOfTuples() * a->GetNumberOfComponents() * a->GetDataTypeSize()) == 0;
}

void CheckEqual(vtkPolyData* a, vtkPolyData* b, const std::string& what, Checks& check)
{
  check(AreEqual(a->GetPoints()->GetData(), b->GetPoints()->GetData()), what + ": points");
  check(AreEqual(a->GetPolys()->GetConnectivityArray(), b->GetPolys()->GetConnectivityArray()),
    what + ": triangles");
  vtkPointData* expected = a->GetPointData();
  check(expected->GetNumberOfArrays() == b->GetPointData()->GetNumberOfArrays() &&
      expected->GetNumberOfArrays() >= 13,
    what + ": has all arrays", expected->GetNumberOfArrays());
  for (int i = 0; i < expected->GetNumberOfArrays(); ++i)
  {
    const char* name = expected->GetArrayName(i);
    check(AreEqual(expected->GetArray(i), b->GetPointData()->GetArray(name)),
      what + ": the same bits of " + name);
  }
}

vtkSmartPointer<vtkPolyData> Compute(vtkPolyData* surface, int estimator)
{
  Pipeline pipeline(surface);
  pipeline.Normals->SetSmoothingRadius(0.03);
  pipeline.Tensor->SetEstimator(estimator);
  pipeline.Tensor->SetSmoothingRadius(0.05);
  pipeline.Tensor->OutputShapeIndexOn();
  pipeline.Tensor->OutputCurvednessOn();
  pipeline.Tensor->OutputPointAreaOn();
  vtkNew<vtkNPRSurfaceRefinement> refinement;
  refinement->SetNumberOfLevels(1);
  refinement->SetInputConnection(pipeline.Tensor->GetOutputPort());
  pipeline.Derivatives->SetInputConnection(refinement->GetOutputPort());
  pipeline.Derivatives->SetSmoothingRadius(0.05);
  return pipeline.Update();
}
}

int TestCurvatureThreads(int, char*[])
{
  Checks check;
  // With a border, and many times the size that one thread takes at a time.
  const auto surface = MakeIrregular(MakeWaves(48), 0.004);
  const std::string before = vtkSMPTools::GetBackend();
  for (int estimator = 0; estimator < vtkNPRCurvatureTensor::GetNumberOfEstimators(); ++estimator)
  {
    vtkSMPTools::SetBackend("Sequential");
    const vtkSmartPointer<vtkPolyData> expected = Compute(surface, estimator);
    for (const Threads& threads : { Threads{ "TBB", 2 }, Threads{ "STDThread", 1 },
           Threads{ "STDThread", 2 }, Threads{ "STDThread", 5 } })
    {
      vtkSMPTools::SetBackend(threads.Backend);
      if (std::string(vtkSMPTools::GetBackend()) != threads.Backend)
      {
        continue; // this VTK was built without
      }
      vtkSMPTools::Initialize(threads.Number);
      const std::string what = std::string(vtkNPRCurvatureTensor::GetEstimatorName(estimator)) +
        ", " + threads.Backend + " " + std::to_string(threads.Number);
      check(std::strcmp(threads.Backend, "STDThread") != 0 ||
          vtkSMPTools::GetEstimatedNumberOfThreads() == threads.Number ||
          static_cast<int>(std::thread::hardware_concurrency()) < threads.Number,
        what + ": as many as asked for", vtkSMPTools::GetEstimatedNumberOfThreads());
      CheckEqual(expected, Compute(surface, estimator), what, check);
    }
  }
  vtkSMPTools::SetBackend(before.c_str());
  return check.GetResult();
}
