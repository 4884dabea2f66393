// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Pieces with as many ghost levels as refinement says that it needs, and not one more, are parted
// as the whole is.
#include "nprAnalyticSurfaces.h"
#include "nprChecks.h"
#include "nprPointValues.h"
#include "nprSurfaceNormals.h"
#include "nprSurfaceRefinement.h"

#include <vtkCellData.h>
#include <vtkExtractPolyDataPiece.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkMinimalStandardRandomSequence.h>
#include <vtkPointData.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

using namespace nprtest;

namespace
{
constexpr const char* Numbers = "Numbers";

/// A flat grid of slivers whose normals stray: where edges move, many parts of triangles would turn
/// away, and what is done to one edge is felt at the next ones.
vtkSmartPointer<vtkPolyData> MakeRough(int seed)
{
  vtkSmartPointer<vtkPolyData> surface = MakeWaves(48).Mesh;
  vtkNew<vtkMinimalStandardRandomSequence> random;
  random->SetSeed(seed);
  const auto next = [&]()
  {
    random->Next();
    return 2.0 * random->GetValue() - 1.0;
  };
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    Vector3d point;
    surface->GetPoint(i, point.data());
    surface->GetPoints()->SetPoint(
      i, 0.1 * (point[0] + 0.01 * next()), point[1] + 0.01 * next(), 0.0);
    const Vector3d normal = Vector3d(0.3 * next(), 0.3 * next(), 1.0).normalized();
    normals->InsertNextTuple3(normal[0], normal[1], normal[2]);
  }
  surface->GetPointData()->AddArray(normals);
  vtkNew<vtkIntArray> numbers;
  numbers->SetName(Numbers);
  for (vtkIdType i = 0; i < surface->GetNumberOfCells(); ++i)
  {
    numbers->InsertNextValue(static_cast<int>(i));
  }
  surface->GetCellData()->AddArray(numbers);
  return surface;
}

/// The corners of the parts of each triangle, in their order.
using Parts = std::map<int, std::vector<npr::TriangleMesh::Vector>>;

void AddParts(vtkPolyData* surface, int levels, Parts& parts)
{
  // All relative to the same origin, so that pieces have the same bits as the whole.
  std::vector<npr::TriangleMesh::Vector> points(surface->GetNumberOfPoints());
  npr::Tuples<3> normals(surface->GetNumberOfPoints());
  std::vector<npr::TriangleMesh::Index> welded(surface->GetNumberOfPoints());
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    Vector3d point;
    surface->GetPoint(i, point.data());
    points[i] = point.cast<float>();
    normals[i] = GetTuple<3>(surface, "Normals", i).cast<float>();
    welded[i] = static_cast<npr::TriangleMesh::Index>(i);
  }
  npr::TriangleMesh mesh(std::move(points), npr::TriangleMesh(surface).GetTriangles());
  mesh.BuildIncidence();
  npr::SurfaceRefinementOptions options;
  options.NumberOfLevels = levels;
  const npr::RefinedSurface refined = npr::RefineSurface(mesh, normals, welded, options);
  vtkDataArray* const numbers = surface->GetCellData()->GetArray(Numbers);
  vtkUnsignedCharArray* const ghosts = surface->GetCellGhostArray();
  for (std::size_t t = 0; t < refined.Triangles.size(); ++t)
  {
    const vtkIdType cell = mesh.GetCellId(refined.SourceTriangles[t]);
    if (!ghosts || ghosts->GetValue(cell) == 0)
    {
      for (npr::TriangleMesh::Index corner : refined.Triangles[t])
      {
        parts[static_cast<int>(numbers->GetComponent(cell, 0))].push_back(refined.Points[corner]);
      }
    }
  }
}
}

int TestRefinementReach(int, char*[])
{
  Checks check;
  for (int trial = 0; trial < 40; ++trial)
  {
    const vtkSmartPointer<vtkPolyData> surface = MakeRough(1 + trial);
    const int levels = trial % 4;
    const std::string what = std::to_string(levels) + " levels";
    Parts whole;
    AddParts(surface, levels, whole);
    Parts found;
    constexpr int pieces = 24;
    for (int piece = 0; piece < pieces; ++piece)
    {
      vtkNew<vtkExtractPolyDataPiece> extract;
      extract->SetInputData(surface);
      extract->UpdatePiece(piece, pieces, npr::GetRefinementReach(levels));
      AddParts(extract->GetOutput(), levels, found);
    }
    check(found.size() == whole.size(), what + ": all triangles");
    int wrong = 0;
    for (const auto& [number, corners] : whole)
    {
      wrong += found[number] != corners;
    }
    std::cout << what << ": " << npr::GetRefinementReach(levels) << " rings, " << wrong
              << " wrong\n";
    check(wrong == 0, what + ": parts are the same", wrong);
  }
  check(npr::GetRefinementReach(0) == 0 && npr::GetRefinementReach(12) == 6 &&
      npr::GetRefinementReach(-1) == 36,
    "rings add up to twice those of a pass where all edges are halved");
  return check.GetResult();
}
