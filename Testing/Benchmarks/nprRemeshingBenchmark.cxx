// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the order of a mesh's points and triangles costs those who walk over it, and what it costs
 * to make other meshes of a mesh, in one run:
 *
 *   nprRemeshingBenchmark MODEL [--runs N]
 *
 * Times are processor seconds, the least of several runs (--runs; 3), and Hausdorff distances are
 * those of the model's points from the result, in length scales.
 */
#include "nprBenchmarkCost.h"
#include "nprBenchmarkModel.h"
#include "nprTriangleMesh.h"
#include "vtkNPRCurvatureTensor.h"
#include "vtkNPRFeatureLines.h"
#include "vtkNPRSurfaceDecimation.h"
#include "vtkNPRSurfaceOrder.h"
#include "vtkNPRSurfaceSmoothing.h"
#include "vtkNPRSurfaceSubdivision.h"

#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCellLocator.h>
#include <vtkGenericCell.h>
#include <vtkIdList.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkQuadricDecimation.h>
#include <vtkSmartPointer.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <numeric>
#include <random>
#include <vector>

namespace
{
using namespace nprbench;
using Surface = vtkSmartPointer<vtkPolyData>;

//------------------------------------------------------------------------------
Surface Shuffle(vtkPolyData* surface)
{
  std::mt19937 random(1); // the same everywhere
  std::vector<vtkIdType> points(surface->GetNumberOfPoints());
  std::vector<vtkIdType> cells(surface->GetNumberOfCells());
  for (auto* ids : { &points, &cells })
  {
    std::iota(ids->begin(), ids->end(), 0);
    for (std::size_t i = ids->size(); i > 1; --i)
    {
      std::swap((*ids)[i - 1], (*ids)[random() % i]);
    }
  }
  vtkNew<vtkPoints> newPoints;
  newPoints->SetNumberOfPoints(surface->GetNumberOfPoints());
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    newPoints->SetPoint(points[i], surface->GetPoint(i));
  }
  vtkNew<vtkCellArray> newCells;
  vtkNew<vtkIdList> ids;
  for (const vtkIdType cell : cells)
  {
    surface->GetCellPoints(cell, ids);
    for (vtkIdType& id : *ids)
    {
      id = points[id];
    }
    newCells->InsertNextCell(ids);
  }
  auto result = Surface::New();
  result->SetPoints(newPoints);
  result->SetPolys(newCells);
  return result;
}

//------------------------------------------------------------------------------
double MeasureRun(int runs, vtkPolyDataAlgorithm* filter, vtkPolyData* surface)
{
  filter->SetInputData(surface);
  return Measure(runs,
    [&]()
    {
      filter->Modified();
      filter->Update();
    })
    .Processor;
}

//------------------------------------------------------------------------------
void PrintOrders(int runs, vtkPolyData* surface)
{
  const Surface shuffled = Shuffle(surface);
  vtkNew<vtkNPRSurfaceOrder> order;
  const double cost = MeasureRun(runs, order, shuffled);
  const struct
  {
    const char* Name;
    Surface Mesh;
  } orders[] = { { "as in the file", surface }, { "at random", shuffled },
    { "vtkNPRSurfaceOrder", order->GetOutput() } };
  std::printf("processor seconds, and ratio to the file's order\n%-24s %18s %18s %18s\n",
    "order of the triangles", "curvature", "a view's lines", "both");
  double first[2] = { 0.0, 0.0 };
  for (const auto& row : orders)
  {
    vtkNew<vtkNPRCurvatureTensor> curvature;
    curvature->SetEstimator(vtkNPRCurvatureTensor::PER_FACE);
    double seconds[2];
    seconds[0] = MeasureRun(runs, curvature, row.Mesh);
    vtkNew<vtkNPRFeatureLines> lines;
    vtkNew<vtkCamera> camera;
    double bounds[6];
    surface->GetBounds(bounds);
    const double middle[3] = { 0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]),
      0.5 * (bounds[4] + bounds[5]) };
    camera->SetFocalPoint(middle);
    camera->SetPosition(middle[0], middle[1], middle[2] + 3.0 * surface->GetLength());
    lines->AddDefinition("contours");
    lines->AddDefinition("suggestive");
    lines->SetCamera(camera);
    lines->SetInputData(curvature->GetOutput());
    lines->Update();
    seconds[1] = Measure(runs,
      [&]()
      {
        camera->Azimuth(3.0); // what a surface remembers from view to view, it may
        lines->Update();
      }).Processor;
    if (first[0] == 0.0)
    {
      std::copy_n(seconds, 2, first);
    }
    std::printf("%-24s %9.4f %8.2f %9.4f %8.2f %9.4f %8.2f\n", row.Name, seconds[0],
      seconds[0] / first[0], seconds[1], seconds[1] / first[1], seconds[0] + seconds[1],
      (seconds[0] + seconds[1]) / (first[0] + first[1]));
    std::fflush(stdout);
  }
  std::printf("%-24s %9.4f %8.2f\n\n", "to order it", cost, cost / first[0]);
}

//------------------------------------------------------------------------------
/// Degrees: the smallest angle, and the mean of the triangles' smallest.
std::pair<double, double> GetAngles(vtkPolyData* surface)
{
  const npr::TriangleMesh mesh(surface);
  double smallest = 180.0;
  double sum = 0.0;
  for (const auto& corners : mesh.GetTriangles())
  {
    double least = 180.0;
    for (int i = 0; i < 3; ++i)
    {
      const Eigen::Vector3f u = mesh.GetPoint(corners[(i + 1) % 3]) - mesh.GetPoint(corners[i]);
      const Eigen::Vector3f v = mesh.GetPoint(corners[(i + 2) % 3]) - mesh.GetPoint(corners[i]);
      least = std::min<double>(
        least, vtkMath::DegreesFromRadians(std::atan2(u.cross(v).norm(), u.dot(v))));
    }
    smallest = std::min(smallest, least);
    sum += least;
  }
  return { smallest, sum / mesh.GetNumberOfTriangles() };
}

//------------------------------------------------------------------------------
/// Root mean square and maximum.
std::pair<double, double> GetDistances(vtkPolyData* points, vtkPolyData* surface)
{
  vtkNew<vtkCellLocator> locator;
  locator->SetDataSet(surface);
  locator->BuildLocator();
  vtkNew<vtkGenericCell> cell;
  double largest = 0.0;
  double sum = 0.0;
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double closest[3];
    vtkIdType id;
    int part;
    double squared;
    locator->FindClosestPoint(points->GetPoint(i), closest, cell, id, part, squared);
    largest = std::max(largest, squared);
    sum += squared;
  }
  const double unit = npr::TriangleMesh(points).ComputeLengthScale();
  return { std::sqrt(sum / points->GetNumberOfPoints()) / unit, std::sqrt(largest) / unit };
}

//------------------------------------------------------------------------------
void PrintFilters(vtkPolyData* surface)
{
  std::printf("%-44s %9s %9s %8s %8s %9s %9s\n", "other meshes of it", "seconds", "triangles",
    "smallest", "mean", "distance", "largest");
  const auto row = [&](const char* name, vtkPolyDataAlgorithm* filter, bool hasDistance = true)
  {
    const double seconds = MeasureRun(1, filter, surface);
    vtkPolyData* const output = filter->GetOutput();
    const auto angles = GetAngles(output);
    std::printf("%-44s %9.3f %9lld %8.2f %8.2f", name, seconds,
      static_cast<long long>(output->GetNumberOfCells()), angles.first, angles.second);
    if (hasDistance)
    {
      const auto distances = GetDistances(surface, output);
      std::printf(" %9.6f %9.6f", distances.first, distances.second);
    }
    std::printf("\n");
    std::fflush(stdout);
  };
  vtkNew<vtkQuadricDecimation> quadric;
  quadric->SetTargetReduction(0.9);
  row("vtkQuadricDecimation, 0.9", quadric);
  vtkNew<vtkNPRSurfaceDecimation> decimation;
  row("vtkNPRSurfaceDecimation, 0.9", decimation);
  decimation->SetMinimumAngle(0.0);
  row("vtkNPRSurfaceDecimation, 0.9, any angle", decimation);
  decimation->SetMinimumAngle(20.0);
  row("vtkNPRSurfaceDecimation, 0.9, 20 degrees", decimation);
  decimation->SetMinimumAngle(10.0);
  decimation->SetTargetReduction(1.0);
  decimation->SetMaximumError(0.001);
  row("vtkNPRSurfaceDecimation, error 0.001", decimation);
  vtkNew<vtkNPRSurfaceSmoothing> smoothing;
  row("vtkNPRSurfaceSmoothing, 10 iterations", smoothing);
  vtkNew<vtkNPRSurfaceSubdivision> subdivision;
  row("vtkNPRSurfaceSubdivision, Loop", subdivision);
  subdivision->SetSchemeToButterfly();
  row("vtkNPRSurfaceSubdivision, butterfly", subdivision, false); // goes through all points
}
}

int main(int argc, char* argv[])
{
  int runs = 3;
  const char* model = nullptr;
  for (int i = 1; i < argc; ++i)
  {
    if (std::strcmp(argv[i], "--runs") == 0 && i + 1 < argc)
    {
      runs = std::max(1, std::atoi(argv[++i]));
    }
    else
    {
      model = argv[i];
    }
  }
  if (!model)
  {
    std::fprintf(stderr, "usage: nprRemeshingBenchmark MODEL [--runs N]\n");
    return EXIT_FAILURE;
  }
  const Surface surface = ReadModel(model);
  if (!surface)
  {
    return EXIT_FAILURE;
  }
  const auto angles = GetAngles(surface);
  std::printf("%s: %lld triangles, smallest angle %.2f, mean %.2f degrees\n\n", model,
    static_cast<long long>(surface->GetNumberOfCells()), angles.first, angles.second);
  PrintOrders(runs, surface);
  PrintFilters(surface);
  return EXIT_SUCCESS;
}
