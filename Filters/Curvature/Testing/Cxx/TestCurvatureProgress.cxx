// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Filters tell how far they are, never backwards, and end soon when they are asked to, with the
// input for their output; then they can be run again.
#include "nprCurvaturePipeline.h"
#include "nprIrregularMeshes.h"
#include "vtkNPRSurfaceRefinement.h"

#include <vtkCallbackCommand.h>

#include <chrono>
#include <string>
#include <vector>

using namespace nprtest;

namespace
{
/// Watches one filter, and aborts it when it has come so far.
class Observer
{
public:
  explicit Observer(vtkAlgorithm* filter) : Filter(filter)
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback(Observer::Call);
    for (unsigned long event :
      { vtkCommand::ProgressEvent, vtkCommand::WarningEvent, vtkCommand::ErrorEvent })
    {
      filter->AddObserver(event, this->Command);
    }
  }
  ~Observer() { this->Filter->RemoveObserver(this->Command); }

  /// Runs the filter. More than 1: to the end.
  double Run(double abortAt)
  {
    this->AbortAt = abortAt;
    this->Values.clear();
    this->ReportsAfterAbort = 0;
    this->Filter->SetAbortExecute(0);
    this->Filter->Modified();
    const auto start = std::chrono::steady_clock::now();
    this->Filter->Update();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }

  std::vector<double> Values;
  int ReportsAfterAbort = 0;
  int Complaints = 0;

private:
  static void Call(vtkObject*, unsigned long event, void* data, void*)
  {
    Observer* self = static_cast<Observer*>(data);
    if (event != vtkCommand::ProgressEvent)
    {
      ++self->Complaints;
      return;
    }
    self->ReportsAfterAbort += self->Filter->GetAbortExecute() != 0;
    self->Values.push_back(self->Filter->GetProgress());
    if (self->Filter->GetProgress() >= self->AbortAt)
    {
      self->Filter->SetAbortExecute(1);
    }
  }

  vtkAlgorithm* Filter;
  vtkNew<vtkCallbackCommand> Command;
  double AbortAt = 2.0;
};

/// @param array what the filter makes
void Test(const std::string& name, vtkPolyDataAlgorithm* filter, vtkPolyData* input,
  const char* array, Checks& check)
{
  filter->SetInputData(input);
  Observer observer(filter);
  const double whole = observer.Run(2.0);
  const std::vector<double>& values = observer.Values;
  check(values.size() >= 4, name + ": tells how far it is", static_cast<double>(values.size()));
  check(std::is_sorted(values.begin(), values.end()), name + ": progress never goes back");
  check(!values.empty() && values.front() >= 0.0 && values.back() == 1.0,
    name + ": progress ends at 1", values.empty() ? -1.0 : values.back());
  check(filter->GetOutput()->GetPointData()->HasArray(array), name + ": makes its array");
  std::cout << name << ": " << values.size() << " reports, " << whole << " s; aborted";
  for (double fraction : { 0.0, 0.25, 0.5, 0.9 })
  {
    const double seconds = observer.Run(fraction);
    std::cout << " at " << fraction << ": " << seconds;
    vtkPolyData* output = filter->GetOutput();
    check(observer.ReportsAfterAbort <= 3, name + ": ends where it is told to",
      observer.ReportsAfterAbort);
    check(output->GetPoints() == input->GetPoints() && output->GetPolys() == input->GetPolys() &&
        output->GetPointData()->GetNumberOfArrays() == input->GetPointData()->GetNumberOfArrays() &&
        output->GetPointData()->GetNormals() == input->GetPointData()->GetNormals(),
      name + ": gives the input when aborted", output->GetPointData()->GetNumberOfArrays());
  }
  std::cout << "\n";
  observer.Run(2.0);
  check(filter->GetOutput()->GetPointData()->HasArray(array), name + ": runs again after");
  check(observer.Complaints == 0, name + ": no warning or error", observer.Complaints);
}
}

int TestCurvatureProgress(int, char*[])
{
  Checks check;
  const auto surface = MakeIrregular(MakeWaves(100), 0.001);
  vtkNew<vtkNPRSurfaceNormals> normals;
  Test("normals", normals, surface, npr::names::Normals, check);
  normals->SetSmoothingRadius(0.05);
  Test("smooth normals", normals, surface, npr::names::Normals, check);
  for (int estimator = 0; estimator < vtkNPRCurvatureTensor::GetNumberOfEstimators(); ++estimator)
  {
    vtkNew<vtkNPRCurvatureTensor> tensor;
    tensor->SetEstimator(estimator);
    const std::string name = vtkNPRCurvatureTensor::GetEstimatorName(estimator);
    Test(name, tensor, surface, npr::names::CurvatureTensor, check);
    tensor->SetSmoothingRadius(0.05);
    Test(name + ", smooth", tensor, surface, npr::names::CurvatureTensor, check);
  }
  vtkNew<vtkNPRCurvatureTensor> tensor;
  tensor->OutputDerivativesOff();
  tensor->SetInputData(surface);
  tensor->Update();
  vtkNew<vtkNPRCurvatureDerivatives> derivatives;
  derivatives->SetSmoothingRadius(0.05);
  Test("derivatives", derivatives, tensor->GetOutput(), npr::names::CurvatureDerivatives, check);
  vtkNew<vtkNPRSurfaceRefinement> refinement;
  refinement->SetMaximumEdgeLength(0.01);
  Test("refinement", refinement, tensor->GetOutput(), npr::names::Normals, check);
  return check.GetResult();
}
