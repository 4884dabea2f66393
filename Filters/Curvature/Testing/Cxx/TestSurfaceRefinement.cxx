// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Refined spheres are round, cans have round rims and flat caps, cubes stay cubes; no cracks
// anywhere, nor folds.
#include "nprCurvaturePipeline.h"
#include "nprLengthScale.h"
#include "vtkNPRSurfaceRefinement.h"

#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkMath.h>

#include <map>
#include <set>

using namespace nprtest;

namespace
{
/// Closed once copies are taken for one: each edge has two triangles, in opposite directions.
void CheckClosed(vtkPolyData* surface, const std::string& name, Checks& check)
{
  std::map<std::pair<vtkIdType, vtkIdType>, int> edges;
  npr::TriangleMesh mesh(surface);
  check(mesh.GetNumberOfTriangles() == surface->GetNumberOfCells(), name + ": all are triangles");
  const auto welded = [&](npr::TriangleMesh::Index i)
  { return static_cast<vtkIdType>(GetValue(surface, npr::names::WeldedPointIds, i)); };
  for (const auto& corners : mesh.GetTriangles())
  {
    for (int e = 0; e < 3; ++e)
    {
      ++edges[{ welded(corners[e]), welded(corners[(e + 1) % 3]) }];
    }
  }
  for (const auto& edge : edges)
  {
    const auto opposite = edges.find({ edge.first.second, edge.first.first });
    check(
      edge.second == 1 && opposite != edges.end() && opposite->second == 1, name + ": no cracks");
  }
  std::set<std::vector<double>> places;
  std::set<vtkIdType> ids;
  for (npr::TriangleMesh::Index i = 0; i < mesh.GetNumberOfPoints(); ++i)
  {
    double a[3];
    double b[3];
    surface->GetPoint(i, a);
    surface->GetPoint(welded(i), b);
    check(
      a[0] == b[0] && a[1] == b[1] && a[2] == b[2] && welded(i) <= i, name + ": copies coincide");
    places.insert({ a[0], a[1], a[2] });
    ids.insert(welded(i));
  }
  check(places.size() == ids.size(), name + ": points in one place are copies of one");
}

struct Refined
{
  Pipeline Stages;
  vtkNew<vtkNPRSurfaceRefinement> Refinement;

  explicit Refined(vtkPolyData* mesh, double creaseAngle = 40.0) : Stages(mesh)
  {
    this->Stages.Preparation->SetCreaseAngle(creaseAngle);
    this->Refinement->SetInputConnection(this->Stages.Tensor->GetOutputPort());
  }
  vtkPolyData* Update()
  {
    this->Refinement->Update();
    return this->Refinement->GetOutput();
  }
};

/// Largest distance from the unit sphere, over points and (so chords count) triangles' centres.
double GetSphereError(vtkPolyData* surface)
{
  double error = 0.0;
  npr::TriangleMesh mesh(surface);
  for (const auto& corners : mesh.GetTriangles())
  {
    Vector3d centre = mesh.GetOrigin();
    for (auto corner : corners)
    {
      const Vector3d p = mesh.GetPoint(corner).cast<double>();
      error = std::max(error, std::abs((p + mesh.GetOrigin()).norm() - 1.0));
      centre += p / 3.0;
    }
    error = std::max(error, std::abs(centre.norm() - 1.0));
  }
  return error;
}

void TestSphere(Checks& check)
{
  // 66 points; angles of 22 degrees from edge to edge.
  Refined sphere(MakeOctasphere(1.0, 2));
  double last = 0.0;
  for (int levels : { 0, 1, 2, 3 })
  {
    sphere.Refinement->SetNumberOfLevels(levels);
    vtkPolyData* output = sphere.Update();
    const double error = GetSphereError(output);
    std::cout << "sphere, " << levels << " levels: " << error << "\n";
    check(output->GetNumberOfCells() == 128 << (2 * levels), "levels part into four");
    check(
      levels == 0 || error < 0.3 * last, "each level brings it nearer to the sphere", error / last);
    CheckClosed(output, "sphere", check);
    last = error;
  }
  vtkPolyData* output = sphere.Update();
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    double p[3];
    output->GetPoint(i, p);
    const Vector3d normal = GetTuple<3>(output, npr::names::Normals, i);
    check((normal - Eigen::Map<Vector3d>(p).normalized()).norm() < 1e-4, "new normals are right");
    check(std::abs(GetValue(output, npr::names::PrincipalCurvature1, i) - 1.0) < 1e-3 &&
        std::abs(GetValue(output, npr::names::PrincipalCurvature2, i) - 1.0) < 1e-3,
      "the curvature goes along");
  }
  check(output->GetPointData()->GetNormals() != nullptr, "the normals are active");

  // By the length of edges.
  sphere.Refinement->SetNumberOfLevels(-1);
  sphere.Refinement->SetMaximumEdgeLength(0.05);
  output = sphere.Update();
  check(GetSphereError(output) < 5e-4, "fine edges make a round sphere", GetSphereError(output));
  npr::TriangleMesh mesh(output);
  for (const auto& corners : mesh.GetTriangles())
  {
    check((mesh.GetPoint(corners[0]) - mesh.GetPoint(corners[1])).norm() < 0.05f * 1.01f,
      "edges are short enough");
  }
  CheckClosed(output, "sphere by edge length", check);
  sphere.Refinement->SetMaximumNumberOfTriangles(1000);
  output = sphere.Update();
  check(output->GetNumberOfCells() <= 1000 && output->GetNumberOfCells() > 500, "the cap holds",
    output->GetNumberOfCells());
  CheckClosed(output, "capped sphere", check);
}

/// Edges by how far the surface turns along them: short at the tips of an ellipsoid.
void TestTurn(Checks& check)
{
  vtkSmartPointer<vtkPolyData> mesh = MakeOctasphere(1.0, 2);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double p[3];
    mesh->GetPoint(i, p);
    mesh->GetPoints()->SetPoint(i, p[0], p[1], 4.0 * p[2]);
  }
  Refined ellipsoid(mesh, 180.0);
  ellipsoid.Refinement->SetMaximumEdgeLength(0.0);
  vtkIdType last = 0;
  for (double turn : { 20.0, 10.0, 5.0 })
  {
    ellipsoid.Refinement->SetMaximumTurn(turn);
    vtkPolyData* output = ellipsoid.Update();
    CheckClosed(output, "ellipsoid", check);
    check(output->GetNumberOfCells() > 2 * last && output->GetNumberOfCells() < 10 * 4096,
      "the smaller the turn, the more triangles", output->GetNumberOfCells());
    last = output->GetNumberOfCells();
    npr::TriangleMesh refined(output);
    double largest = 0.0;
    double areas[2] = { 0.0, 0.0 }; // at the tips, and far from them
    int counts[2] = { 0, 0 };
    for (npr::TriangleMesh::Index t = 0; t < refined.GetNumberOfTriangles(); ++t)
    {
      const auto& corners = refined.GetTriangle(t);
      for (int e = 0; e < 3; ++e)
      {
        const Vector3d a = GetTuple<3>(output, npr::names::Normals, corners[e]);
        const Vector3d b = GetTuple<3>(output, npr::names::Normals, corners[(e + 1) % 3]);
        largest = std::max(largest, std::atan2(a.cross(b).norm(), a.dot(b)) * 180.0 / Pi);
      }
      const int where = std::abs(refined.GetPoint(corners[0]).z()) > 3.5f ? 0 : 1;
      areas[where] += 0.5 * refined.GetAreaNormal(t).norm();
      ++counts[where];
    }
    const double ratio = areas[1] / counts[1] / (areas[0] / counts[0]);
    std::cout << "ellipsoid, turn " << turn << ": " << last << " triangles, largest turn "
              << largest << ", triangles at the tips smaller by " << ratio << "\n";
    check(largest <= 1.001 * turn, "no edge turns by more", largest);
    check(ratio > 2.0, "small triangles where it bends", ratio);
  }
}

void TestCan(Checks& check)
{
  Refined can(MakeCan(1.0, 2.0, 12));
  can.Refinement->SetMaximumEdgeLength(0.02);
  vtkPolyData* output = can.Update();
  CheckClosed(output, "can", check);
  double roundness = 0.0;
  double flatness = 0.0;
  int rim = 0;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    double p[3];
    output->GetPoint(i, p);
    const Vector3d normal = GetTuple<3>(output, npr::names::Normals, i);
    if (std::abs(normal.z()) > 0.5)
    {
      flatness = std::max(flatness, std::min(std::abs(p[2]), std::abs(p[2] - 2.0)));
      check(std::abs(normal.z()) > 0.99999, "the caps' normals stay");
    }
    else
    {
      roundness = std::max(roundness, std::abs(std::hypot(p[0], p[1]) - 1.0));
      rim += p[2] > 1.999;
    }
  }
  check(flatness < 1e-6, "the caps stay flat", flatness);
  check(roundness < 1e-4, "the side is round", roundness);
  check(rim >= 192, "and so is its rim", rim);
  check(output->GetNumberOfCells() < 20000, "only what is curved is refined",
    output->GetNumberOfCells());
}

/// Edges by how far they are from the surface: a long can gets no rings around its axis.
void TestChordError(Checks& check)
{
  constexpr int Sides = 12;
  Refined can(MakeCan(1.0, 40.0, Sides));
  can.Refinement->SetMaximumEdgeLength(0.0);
  const double scale = npr::GetLengthScale(can.Update());
  vtkIdType last = 2 * can.Stages.Preparation->GetOutput()->GetNumberOfCells();
  for (const double chordError : { 4e-3, 1e-3, 2.5e-4 })
  {
    can.Refinement->SetMaximumChordError(chordError / scale);
    vtkPolyData* output = can.Update();
    CheckClosed(output, "long can", check);
    npr::TriangleMesh mesh(output);
    double largest = 0.0;
    for (const auto& corners : mesh.GetTriangles())
    {
      for (int e = 0; e < 3; ++e)
      {
        const Vector3d normal = GetTuple<3>(output, npr::names::Normals, corners[e]);
        const Vector3d middle = mesh.GetOrigin() +
          0.5 * (mesh.GetPoint(corners[e]) + mesh.GetPoint(corners[(e + 1) % 3])).cast<double>();
        if (std::abs(normal.z()) < 0.5)
        {
          largest = std::max(largest, std::abs(std::hypot(middle.x(), middle.y()) - 1.0));
        }
      }
    }
    std::cout << "long can, chord error " << chordError << ": " << output->GetNumberOfCells()
              << " triangles, largest error " << largest << "\n";
    // As exact as the normal at the middle of a circle's edge was taken to be.
    check(largest < 1.01 * chordError, "no edge is farther from the can", largest);
    // A quarter of the error takes half of the edges around the can, and no shorter ones along it.
    check(output->GetNumberOfCells() > last && output->GetNumberOfCells() < 5 * last,
      "no more triangles than that needs", output->GetNumberOfCells());
    check(output->GetNumberOfCells() < 4000, "long edges along the can stay",
      output->GetNumberOfCells());
    last = output->GetNumberOfCells();
    // What the can was told by: twelve sides, and flat caps.
    vtkDataArray* const known = output->GetCellData()->GetArray(npr::names::ChordError);
    if (check(known && known->GetNumberOfTuples() == last, "the coarse triangles' errors stay"))
    {
      const double sagitta = 1.0 - std::cos(Pi / Sides);
      const double* const range = known->GetRange();
      check(range[0] == 0.0, "a flat cap is exact", range[0]);
      check(std::abs(range[1] - sagitta) < 0.05 * sagitta, "sides are chords", range[1] / sagitta);
    }
  }
  // Both limits hold together; what is shorter than the least length stays.
  can.Refinement->SetMaximumChordError(1e-3 / scale);
  const vtkIdType without = can.Update()->GetNumberOfCells();
  can.Refinement->SetMaximumTurn(3.0);
  check(can.Update()->GetNumberOfCells() > without, "a turn asks for more");
  can.Refinement->SetMaximumEdgeLength(100.0 / scale);
  check(can.Update()->GetNumberOfCells() == can.Stages.Preparation->GetOutput()->GetNumberOfCells(),
    "no edge is longer than that");
}

void TestFlat(Checks& check)
{
  Refined cube(MakeCube());
  check(cube.Update()->GetNumberOfCells() == 12, "a cube needs no refinement");
  cube.Refinement->SetNumberOfLevels(2);
  vtkPolyData* output = cube.Update();
  check(output->GetNumberOfCells() == 12 * 16, "but gets it when told");
  CheckClosed(output, "cube", check);
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    double p[3];
    output->GetPoint(i, p);
    double off = 1.0;
    for (double c : p)
    {
      off = std::min({ off, std::abs(c), std::abs(c - 1.0) });
      check(c > -1e-6 && c < 1.0 + 1e-6, "no point leaves the cube");
    }
    check(off < 1e-6, "all stay on its faces", off);
  }
  // As one smooth patch its normals differ by more than 60 degrees: no bulging either.
  Refined smooth(MakeCube(), 180.0);
  smooth.Refinement->SetNumberOfLevels(2);
  CheckClosed(smooth.Update(), "smooth cube", check);
}

/// The straight part of a fillet: long edges between finely sampled ends, whose normals lean
/// outwards as they would at the ends of an arc. It must not swell like one.
void TestLongEdges(Checks& check)
{
  constexpr double Length = 10.0;
  constexpr double Breadth = 0.1;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> triangles;
  vtkNew<vtkFloatArray> normals;
  normals->SetName(npr::names::Normals);
  normals->SetNumberOfComponents(3);
  for (int i = 0; i < 4; ++i)
  {
    const bool atEnd = i == 1 || i == 2;
    points->InsertNextPoint(atEnd ? Length : 0.0, i >= 2 ? Breadth : 0.0, 0.0);
    normals->InsertNextTuple3(atEnd ? 0.4 : -0.4, 0.0, std::sqrt(1.0 - 0.4 * 0.4));
  }
  triangles->InsertNextCell({ 0, 1, 2 });
  triangles->InsertNextCell({ 0, 2, 3 });
  vtkNew<vtkPolyData> strip;
  strip->SetPoints(points);
  strip->SetPolys(triangles);
  strip->GetPointData()->SetNormals(normals);
  vtkNew<vtkNPRSurfaceRefinement> refinement;
  refinement->SetInputData(strip);
  refinement->SetNumberOfLevels(3);
  refinement->Update();
  const double* bounds = refinement->GetOutput()->GetBounds();
  check(bounds[5] < Breadth, "long edges between short ones stay nearly straight", bounds[5]);
}

/// Long rows of slivers in a plane, whose normals lean outwards at the ends of some edges.
struct Rows
{
  static constexpr double Breadth = 0.2;
  static constexpr double HalfLength = 1.0;
  static constexpr double Lean = 10.0; // degrees
  vtkNew<vtkNPRSurfaceRefinement> Refinement;

  explicit Rows(const std::vector<bool>& leans)
  {
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> triangles;
    vtkNew<vtkFloatArray> normals;
    normals->SetName(npr::names::Normals);
    normals->SetNumberOfComponents(3);
    for (std::size_t row = 0; row < leans.size(); ++row)
    {
      for (int side : { -1, 1 })
      {
        const double angle = leans[row] ? vtkMath::RadiansFromDegrees(side * Lean) : 0.0;
        points->InsertNextPoint(side * HalfLength, row * Breadth, 0.0);
        normals->InsertNextTuple3(std::sin(angle), 0.0, std::cos(angle));
      }
    }
    for (vtkIdType i = 0; i + 2 < points->GetNumberOfPoints(); i += 2)
    {
      triangles->InsertNextCell({ i, i + 1, i + 3 });
      triangles->InsertNextCell({ i, i + 3, i + 2 });
    }
    vtkNew<vtkPolyData> surface;
    surface->SetPoints(points);
    surface->SetPolys(triangles);
    surface->GetPointData()->SetNormals(normals);
    this->Refinement->SetInputData(surface);
    this->Refinement->SetNumberOfLevels(3);
  }
  vtkPolyData* Update()
  {
    this->Refinement->Update();
    return this->Refinement->GetOutput();
  }
};

/// Of rows of slivers one edge rises, as along a plane that goes over into a fillet: it must not
/// tip the slivers beside it. But where all rise alike, as on an arch, they do become round.
void TestRowsOfSlivers(Checks& check)
{
  Rows uneven({ false, false, true, false, false });
  vtkPolyData* output = uneven.Update();
  const npr::TriangleMesh mesh(output);
  double largest = 0.0;
  for (npr::TriangleMesh::Index t = 0; t < mesh.GetNumberOfTriangles(); ++t)
  {
    const Vector3d area = mesh.GetAreaNormal(t).cast<double>();
    largest = std::max(largest, std::atan2(area.head<2>().norm(), area.z()));
  }
  largest = vtkMath::DegreesFromRadians(largest);
  check(largest < 1.1 * Rows::Lean, "no part turns away farther than the normals do", largest);

  Rows arch({ true, true, true, true, true });
  output = arch.Update();
  const double radius = Rows::HalfLength / std::sin(vtkMath::RadiansFromDegrees(Rows::Lean));
  const double centre = -radius * std::cos(vtkMath::RadiansFromDegrees(Rows::Lean));
  double error = 0.0;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    double p[3];
    output->GetPoint(i, p);
    error = std::max(error, std::abs(std::hypot(p[0], p[2] - centre) - radius));
  }
  check(error < 1e-4, "an arch of slivers becomes round", error);
}

/// A round hole in a plate, and in the plate a point on the circle for each edge of the rim: a
/// sliver is between the two, which the edge must not fold over where it becomes round.
void TestSlivers(Checks& check)
{
  constexpr int Sides = 12;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> triangles;
  const auto add = [&](double radius, double step, double z)
  {
    const double angle = 2.0 * vtkMath::Pi() * step / Sides;
    points->InsertNextPoint(radius * std::cos(angle), radius * std::sin(angle), z);
  };
  for (int i = 0; i < Sides; ++i)
  {
    add(1.0, i, 2.0);
    add(1.0, i + 0.5, 2.0);
    add(2.0, i, 2.0);
    add(1.0, i, 0.0);
  }
  for (vtkIdType i = 0; i < Sides; ++i)
  {
    const vtkIdType rim = 4 * i;
    const vtkIdType near = rim + 1;
    const vtkIdType outer = rim + 2;
    const vtkIdType bottom = rim + 3;
    const vtkIdType next = 4 * ((i + 1) % Sides);
    triangles->InsertNextCell({ rim, near, next });
    triangles->InsertNextCell({ rim, outer, near });
    triangles->InsertNextCell({ near, outer, next + 2 });
    triangles->InsertNextCell({ near, next + 2, next });
    triangles->InsertNextCell({ rim, next, next + 3 });
    triangles->InsertNextCell({ rim, next + 3, bottom });
  }
  vtkNew<vtkPolyData> plate;
  plate->SetPoints(points);
  plate->SetPolys(triangles);
  Refined refined(plate);
  refined.Refinement->SetMaximumEdgeLength(0.02);
  vtkPolyData* output = refined.Update();
  const npr::TriangleMesh mesh(output);
  int flat = 0;
  int folded = 0;
  for (npr::TriangleMesh::Index t = 0; t < mesh.GetNumberOfTriangles(); ++t)
  {
    const auto normal = GetTuple<3>(output, npr::names::Normals, mesh.GetTriangle(t)[0]);
    if (normal.z() > 0.9)
    {
      ++flat;
      folded += mesh.GetAreaNormal(t).z() <= 0.0f;
    }
  }
  check(flat > 10 * Sides, "the plate is parted around the hole", flat);
  check(folded == 0, "no triangle of it is folded over", folded);
}

void TestArrays(Checks& check)
{
  AnalyticSurface waves = MakeWaves(12);
  vtkNew<vtkFloatArray> x;
  x->SetName("X");
  for (const Truth& truth : waves.Truths)
  {
    x->InsertNextValue(static_cast<float>(truth.Point.x()));
  }
  waves.Mesh->GetPointData()->SetScalars(x);
  Refined refined(waves.Mesh);
  refined.Stages.Tensor->OutputPointAreaOn();
  refined.Stages.Tensor->SetEstimatorToJets();
  refined.Refinement->SetNumberOfLevels(0);
  const auto hasDensity = [](vtkPolyData* surface)
  {
    return surface->GetPointData()->HasArray(npr::names::PointArea) &&
      surface->GetFieldData()->HasArray(npr::names::NeighbourhoodRadius);
  };
  check(hasDensity(refined.Update()), "where nothing is parted all arrays hold");
  refined.Refinement->SetNumberOfLevels(2);
  vtkPolyData* output = refined.Update();
  check(output->GetPointData()->GetScalars() != nullptr, "active arrays stay active");
  check(!output->GetPointData()->HasArray(npr::names::PointArea) &&
      !output->GetFieldData()->HasArray(npr::names::NeighbourhoodRadius),
    "what belongs to the coarse triangles is dropped");
  double worst = 0.0;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    double p[3];
    output->GetPoint(i, p);
    worst = std::max(worst, std::abs(GetValue(output, "X", i) - p[0]));
    const Vector3d normal = GetTuple<3>(output, npr::names::Normals, i);
    const Vector3d e1 = GetTuple<3>(output, npr::names::PrincipalDirection1, i);
    const npr::SymmetricTensor tensor = GetTuple<6>(output, npr::names::CurvatureTensor, i);
    check(std::abs(normal.dot(e1)) < 1e-4, "principal directions lie in the tangent plane");
    check(std::abs(npr::Evaluate(tensor, normal, normal)) < 1e-3, "and so does the tensor");
    const bool onBorder = std::abs(std::abs(p[0]) - 1.0) < 1e-3 || p[1] < -0.999 || p[1] > 1.199;
    check(
      (GetValue(output, npr::names::BorderPoints, i) == 1.0) == onBorder, "borders are flagged");
  }
  check(worst < 0.05, "arrays are interpolated", worst);
}

/// Derivatives are as good at midpoints as at the points they come from, whichever way the frames
/// of their parents point.
void TestDerivatives(Checks& check)
{
  AnalyticSurface waves = MakeWaves(48);
  Refined refined(waves.Mesh);
  refined.Stages.Tensor->OutputGaussianCurvatureOff();
  refined.Refinement->SetNumberOfLevels(2);
  vtkPolyData* output = refined.Update();
  vtkPolyData* coarse = refined.Stages.Tensor->GetOutput();
  double worst[2] = { 0.0, 0.0 };
  double largest = 0.0;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    double p[3];
    output->GetPoint(i, p);
    if (std::abs(p[0]) > 0.8 || p[1] < -0.8 || p[1] > 1.0)
    {
      continue;
    }
    const Truth truth = Waves().At(p[0], p[1]);
    const bool isOld = i < coarse->GetNumberOfPoints();
    worst[isOld ? 0 : 1] = std::max(worst[isOld ? 0 : 1], GetErrors(output, i, truth).Cubic);
    largest = std::max(largest, truth.Cubic.norm());
    if (isOld)
    {
      check(std::abs(GetErrors(output, i, truth).Cubic - GetErrors(coarse, i, truth).Cubic) < 1e-4,
        "old points keep what they have");
    }
  }
  check(worst[0] < 0.03 * largest && worst[1] < 0.03 * largest, "midpoints get derivatives",
    worst[1] / largest);
  vtkPointData* const arrays = output->GetPointData();
  check(!arrays->HasArray(npr::names::GaussianCurvature), "nothing is made that was not there");

  // Without directions the frames are those that the tensors have.
  refined.Stages.Tensor->OutputPrincipalDirectionsOff();
  vtkNew<vtkPolyData> before;
  before->DeepCopy(output);
  refined.Update();
  double difference = 0.0;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    difference = std::max(difference,
      (GetTuple<4>(output, npr::names::CurvatureDerivatives, i) -
        GetTuple<4>(before, npr::names::CurvatureDerivatives, i))
        .norm());
  }
  check(difference < 1e-3 * largest, "directions need not be there", difference);
}
}

int TestSurfaceRefinement(int, char*[])
{
  Checks check;
  TestLongEdges(check);
  TestSphere(check);
  TestTurn(check);
  TestCan(check);
  TestChordError(check);
  TestFlat(check);
  TestSlivers(check);
  TestRowsOfSlivers(check);
  TestArrays(check);
  TestDerivatives(check);
  return check.GetResult();
}
