// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprRemeshing.h
 * @brief What the tests of filters that make other meshes of a mesh have in common.
 */
#ifndef nprRemeshing_h
#define nprRemeshing_h

#include "nprAnalyticSurfaces.h"
#include "nprArrayNames.h"
#include "nprTriangleMesh.h"
#include "vtkNPRSurfacePreparation.h"

#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkMath.h>
#include <vtkMinimalStandardRandomSequence.h>
#include <vtkPointData.h>
#include <vtkPolyDataAlgorithm.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

namespace nprtest
{
using Index = npr::TriangleMesh::Index;

inline Vector3d GetPoint(vtkPolyData* mesh, vtkIdType point)
{
  Vector3d p;
  mesh->GetPoint(point, p.data());
  return p;
}

inline vtkSmartPointer<vtkPolyData> Copy(vtkPolyData* mesh)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->DeepCopy(mesh);
  return copy;
}

inline vtkSmartPointer<vtkPolyData> Prepare(vtkPolyData* mesh, bool splitCreases)
{
  vtkNew<vtkNPRSurfacePreparation> preparation;
  preparation->SetInputData(mesh);
  preparation->SetSplitCreases(splitCreases);
  preparation->Update();
  return preparation->GetOutput();
}

/// With points in double precision.
inline vtkSmartPointer<vtkPolyData> MakeSphere(double r, int level)
{
  vtkSmartPointer<vtkPolyData> mesh = Prepare(MakeOctasphere(r, level), false);
  mesh->GetPointData()->RemoveArray(npr::names::WeldedPointIds);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->DeepCopy(mesh->GetPoints());
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    const Vector3d p = r * GetPoint(mesh, i).normalized();
    points->SetPoint(i, p.data());
  }
  mesh->SetPoints(points);
  return mesh;
}

/// Moves each point by up to a distance, in any direction.
inline void Shake(vtkPolyData* mesh, double distance)
{
  vtkNew<vtkMinimalStandardRandomSequence> random;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    Vector3d p = GetPoint(mesh, i);
    for (double& c : p)
    {
      random->Next();
      c += distance * (2.0 * random->GetValue() - 1.0);
    }
    mesh->GetPoints()->SetPoint(i, p.data());
  }
}

inline vtkSmartPointer<vtkPolyData> Transform(
  vtkPolyData* mesh, double scale, const Vector3d& offset)
{
  vtkSmartPointer<vtkPolyData> result = Copy(mesh);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const Vector3d p = scale * GetPoint(mesh, i) + offset;
    result->GetPoints()->SetPoint(i, p.data());
  }
  return result;
}

/// Coordinates, PointNumbers, PointNames and the active scalars Colours; CellNumbers.
inline void AddArrays(vtkPolyData* mesh)
{
  vtkNew<vtkDoubleArray> coordinates;
  coordinates->SetName("Coordinates");
  coordinates->SetNumberOfComponents(3);
  vtkNew<vtkIntArray> numbers;
  numbers->SetName("PointNumbers");
  vtkNew<vtkStringArray> names;
  names->SetName("PointNames");
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetName("Colours");
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    coordinates->InsertNextTuple(mesh->GetPoint(i));
    numbers->InsertNextValue(static_cast<int>(i));
    names->InsertNextValue("point " + std::to_string(i));
    colours->InsertNextValue(static_cast<unsigned char>(i % 2 ? 255 : 0));
  }
  mesh->GetPointData()->AddArray(coordinates);
  mesh->GetPointData()->AddArray(numbers);
  mesh->GetPointData()->AddArray(names);
  mesh->GetPointData()->SetScalars(colours);
  vtkNew<vtkIntArray> cells;
  cells->SetName("CellNumbers");
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    cells->InsertNextValue(static_cast<int>(i));
  }
  mesh->GetCellData()->AddArray(cells);
}

/// Normals and what else a filter that moves points must drop.
inline void AddShapeArrays(vtkPolyData* mesh)
{
  vtkNew<vtkFloatArray> normals;
  normals->SetName("MyNormals");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(mesh->GetNumberOfPoints());
  normals->Fill(1.0);
  mesh->GetPointData()->SetNormals(normals);
  for (const char* scale : { "Normals1", "Normals2" })
  {
    vtkNew<vtkFloatArray> smooth;
    smooth->DeepCopy(normals);
    smooth->SetName(scale);
    mesh->GetPointData()->AddArray(smooth);
  }
  vtkNew<vtkFloatArray> curvature;
  curvature->SetName(npr::names::PrincipalCurvature1);
  curvature->SetNumberOfTuples(mesh->GetNumberOfPoints());
  curvature->Fill(1.0);
  mesh->GetPointData()->AddArray(curvature);
  vtkNew<vtkDoubleArray> radius;
  radius->SetName(npr::names::NeighbourhoodRadius);
  radius->InsertNextValue(3.0);
  mesh->GetFieldData()->AddArray(radius);
}

struct Topology
{
  int Euler = 0;   ///< characteristic, of the points that triangles use
  int Borders = 0; ///< edges with one triangle
  int Bad = 0;     ///< edges with more than two
};

inline Topology GetTopology(vtkPolyData* surface)
{
  npr::TriangleMesh mesh(surface);
  mesh.BuildIncidence();
  mesh.BuildEdges();
  Topology topology;
  for (Index i = 0; i < mesh.GetNumberOfPoints(); ++i)
  {
    topology.Euler += mesh.GetNumberOfIncident(i) > 0;
  }
  topology.Euler += mesh.GetNumberOfTriangles() - mesh.GetNumberOfEdges();
  for (Index e = 0; e < mesh.GetNumberOfEdges(); ++e)
  {
    const auto ends = mesh.GetEdge(e);
    const int count = mesh.CountTrianglesAtEdge(ends[0], ends[1]);
    topology.Borders += count == 1;
    topology.Bad += count > 2;
  }
  return topology;
}

/// Calls function(a, b, c) with the corners of each cell.
template<typename Function>
void ForTriangles(vtkPolyData* mesh, const Function& function)
{
  vtkNew<vtkIdList> ids;
  for (vtkIdType c = 0; c < mesh->GetNumberOfCells(); ++c)
  {
    mesh->GetCellPoints(c, ids);
    function(ids->GetId(0), ids->GetId(1), ids->GetId(2));
  }
}

inline double GetSmallestAngle(vtkPolyData* mesh)
{
  double smallest = 180.0;
  ForTriangles(mesh,
    [&](vtkIdType a, vtkIdType b, vtkIdType c)
    {
      const Vector3d p[3] = { GetPoint(mesh, a), GetPoint(mesh, b), GetPoint(mesh, c) };
      for (int i = 0; i < 3; ++i)
      {
        const Vector3d u = p[(i + 1) % 3] - p[i];
        const Vector3d v = p[(i + 2) % 3] - p[i];
        smallest =
          std::min(smallest, vtkMath::DegreesFromRadians(std::atan2(u.cross(v).norm(), u.dot(v))));
      }
    });
  return smallest;
}

inline double GetArea(vtkPolyData* mesh)
{
  double area = 0.0;
  ForTriangles(mesh,
    [&](vtkIdType a, vtkIdType b, vtkIdType c)
    {
      const Vector3d p = GetPoint(mesh, a);
      area += 0.5 * (GetPoint(mesh, b) - p).cross(GetPoint(mesh, c) - p).norm();
    });
  return area;
}

/// The largest |function(p)| over points of the triangles: corners, middles, and in between.
template<typename Function>
double GetLargestDistance(vtkPolyData* mesh, const Function& function)
{
  double largest = 0.0;
  ForTriangles(mesh,
    [&](vtkIdType a, vtkIdType b, vtkIdType c)
    {
      constexpr int n = 4;
      for (int i = 0; i <= n; ++i)
      {
        for (int j = 0; i + j <= n; ++j)
        {
          const Vector3d p =
            (i * GetPoint(mesh, a) + j * GetPoint(mesh, b) + (n - i - j) * GetPoint(mesh, c)) / n;
          largest = std::max(largest, std::abs(function(p)));
        }
      }
    });
  return largest;
}

/// The errors that a filter reports.
class Errors : public vtkCommand
{
public:
  static Errors* New() { return new Errors; }
  void Execute(vtkObject*, unsigned long, void* text) override
  {
    this->Text += static_cast<const char*>(text);
  }
  std::string Text;
};

/// What filters that want a manifold must do with what is none.
inline void TestObstacles(Checks& check, vtkPolyDataAlgorithm* filter)
{
  const double NaN = std::numeric_limits<double>::quiet_NaN();
  const double coordinates[][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
    { 0, -1, 0 }, { -1, 0, 0 }, { NaN, 0, 0 } };
  using Cells = std::vector<std::vector<vtkIdType>>;
  const auto test = [&](const Cells& polygons, bool isGood, const char* what)
  {
    vtkNew<vtkPolyData> mesh;
    vtkNew<vtkPoints> points;
    for (const auto& c : coordinates)
    {
      points->InsertNextPoint(c);
    }
    vtkNew<vtkCellArray> cells;
    for (const auto& polygon : polygons)
    {
      cells->InsertNextCell(static_cast<vtkIdType>(polygon.size()), polygon.data());
    }
    mesh->SetPoints(points);
    mesh->SetPolys(cells);
    vtkNew<Errors> errors;
    const unsigned long tag = filter->AddObserver(vtkCommand::ErrorEvent, errors);
    filter->SetInputData(mesh);
    filter->Update();
    filter->RemoveObserver(tag);
    check(errors->Text.empty() == isGood, what);
    if (!isGood)
    {
      check(errors->Text.find("vtkNPRSurfacePreparation") != std::string::npos,
        std::string("the error says what to do: ") + what);
    }
    else if (!polygons.empty())
    {
      check(filter->GetOutput()->GetNumberOfCells() > 0, what);
      ForTriangles(filter->GetOutput(),
        [&](vtkIdType a, vtkIdType b, vtkIdType c)
        {
          for (vtkIdType corner : { a, b, c })
          {
            check(GetPoint(filter->GetOutput(), corner).allFinite(), what);
          }
        });
    }
  };
  test({}, true, "points without cells");
  test({ { 0, 1, 2 } }, true, "one triangle");
  test({ { 0, 1, 2 }, { 0, 1, 3 } }, false, "neighbours oriented against each other");
  test({ { 0, 1, 2 }, { 1, 0, 3 }, { 0, 1, 4 } }, false, "an edge with three triangles");
  test({ { 0, 1, 2 }, { 0, 4, 3 } }, false, "fans that share a point");
  test({ { 0, 1, 2 }, { 0, 1, 2 } }, false, "duplicate triangles");
  test({ { 0, 1, 2 }, { 0, 2, 6 } }, false, "a point that is no number");
  test({ { 0, 1, 2 }, { 0, 3, 3 } }, false, "two corners in one point");
  test({ { 0, 1, 2, 3 } }, false, "a quadrilateral");

  vtkNew<vtkPolyData> empty;
  filter->SetInputData(empty);
  filter->Update();
  check(filter->GetOutput()->GetNumberOfPoints() == 0, "nothing becomes nothing");
}
}

#endif
