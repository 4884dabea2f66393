// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprSurfacePreparation.h"

#include "nprCracks.h"
#include "nprCreases.h"
#include "nprFoldovers.h"
#include "nprHoles.h"
#include "nprLengthScale.h"
#include "nprOrientation.h"
#include "nprPointFans.h"
#include "nprPointWelding.h"
#include "nprPolygonTriangles.h"
#include "nprTriangleCleaning.h"

#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <utility>

namespace npr
{
namespace
{
using Index = TriangleMesh::Index;
using Triangle = TriangleMesh::Triangle;
using Eigen::Vector3d;

//------------------------------------------------------------------------------
std::vector<Vector3d> ReadPoints(vtkPolyData* input)
{
  std::vector<Vector3d> points(input->GetNumberOfPoints());
  vtkSMPTools::For(0, input->GetNumberOfPoints(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        input->GetPoints()->GetPoint(i, points[i].data());
      }
    });
  return points;
}

//------------------------------------------------------------------------------
/// Renumbers the points that triangles use, in the order of the input, and makes a mesh of them.
TriangleMesh MakeMesh(const std::vector<Vector3d>& points, PreparedSurface& surface)
{
  std::vector<Index> numbers(points.size(), 0);
  for (const Triangle& triangle : surface.Triangles)
  {
    for (Index corner : triangle)
    {
      numbers[corner] = 1;
    }
  }
  surface.SourcePoints.clear();
  Vector3d low = Vector3d::Zero();
  Vector3d high = Vector3d::Zero();
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (numbers[i])
    {
      low = surface.SourcePoints.empty() ? points[i] : Vector3d(low.cwiseMin(points[i]));
      high = surface.SourcePoints.empty() ? points[i] : Vector3d(high.cwiseMax(points[i]));
      numbers[i] = static_cast<Index>(surface.SourcePoints.size());
      surface.SourcePoints.push_back(static_cast<vtkIdType>(i));
    }
  }
  for (Triangle& triangle : surface.Triangles)
  {
    for (Index& corner : triangle)
    {
      corner = numbers[corner];
    }
  }
  const Vector3d origin = 0.5 * low + 0.5 * high;
  std::vector<TriangleMesh::Vector> relative(surface.SourcePoints.size());
  for (std::size_t i = 0; i < relative.size(); ++i)
  {
    relative[i] = (points[surface.SourcePoints[i]] - origin).cast<float>();
  }
  return TriangleMesh(std::move(relative), surface.Triangles, origin);
}

//------------------------------------------------------------------------------
/// The steps, in the order in which they are taken. Each leaves the triangles of the surface and
/// those of the mesh the same.
class Preparation
{
public:
  Preparation(vtkPolyData* input, const SurfacePreparationOptions& options)
    : Input(input), Options(options)
  {
  }

  PreparedSurface Run(const Progress& progress)
  {
    using Step = void (Preparation::*)();
    // Each with its share of the time that the whole takes, about.
    const std::pair<Step, double> steps[] = { { &Preparation::Triangulate, 0.15 },
      { &Preparation::Weld, 0.15 }, { &Preparation::Clean, 0.3 },
      { &Preparation::SplitNonManifold, 0.1 }, { &Preparation::Orient, 0.1 },
      { &Preparation::MendFolds, 0.05 }, { &Preparation::Fill, 0.0 },
      { &Preparation::SplitCreases, 0.15 } };
    double done = 0.0;
    for (const auto& [step, share] : steps)
    {
      if (!progress(done))
      {
        return {};
      }
      (this->*step)();
      done += share;
    }
    return progress(1.0) ? std::move(this->Surface) : PreparedSurface();
  }

private:
  void Triangulate()
  {
    this->Points = ReadPoints(this->Input);
    PolygonTriangles polygons = GetPolygonTriangles(this->Input, this->Points);
    this->Surface.Triangles = std::move(polygons.Triangles);
    this->Surface.SourceCells = std::move(polygons.Cells);
    this->Counts.DroppedCells = this->Input->GetNumberOfVerts() + this->Input->GetNumberOfLines();
    this->Counts.TriangulatedCells = polygons.NumberOfTriangulatedCells;
    this->Counts.NonFiniteTriangles = polygons.NumberOfBadTriangles;
  }

  void Weld()
  {
    if (!this->Options.Weld)
    {
      return;
    }
    double tolerance = 0.0;
    if (this->Options.WeldTolerance > 0.0)
    {
      // The scale of the surface as it comes; to weld hardly changes it.
      PreparedSurface unwelded = this->Surface;
      tolerance =
        this->Options.WeldTolerance * GetLengthScale(this->Input, MakeMesh(this->Points, unwelded));
    }
    const std::vector<Index> firsts = FindCoincidentPoints(this->Points, tolerance);
    for (std::size_t i = 0; i < firsts.size(); ++i)
    {
      this->Counts.WeldedPoints += firsts[i] != static_cast<Index>(i);
    }
    for (Triangle& triangle : this->Surface.Triangles)
    {
      triangle = { firsts[triangle[0]], firsts[triangle[1]], firsts[triangle[2]] };
    }
  }

  void Clean()
  {
    this->Counts.DegenerateTriangles = DropCollapsedTriangles(this->Surface);
    this->Mesh = MakeMesh(this->Points, this->Surface);
    MendNeedles(this->Mesh, this->Surface);
    DropDuplicates(this->Mesh, this->Surface);
    DropUnusedPoints(this->Mesh, this->Surface);
    this->Mesh.BuildNeighbours();
    if (this->Options.Weld)
    {
      CloseCracks(this->Mesh, this->Surface);
    }
    this->Surface.LengthScale = this->Mesh.ComputeLengthScale();
    this->NumberOfWeldedPoints = this->Mesh.GetNumberOfPoints();
    this->Counts.UnusedPoints = static_cast<vtkIdType>(this->Points.size()) -
      this->Counts.WeldedPoints - this->NumberOfWeldedPoints;
    this->Surface.WeldedPointIds.resize(this->NumberOfWeldedPoints);
    std::iota(this->Surface.WeldedPointIds.begin(), this->Surface.WeldedPointIds.end(), 0);
  }

  void SplitNonManifold()
  {
    for (Index t = 0; t < this->Mesh.GetNumberOfTriangles(); ++t)
    {
      for (int e = 0; e < 3; ++e)
      {
        this->Counts.BoundaryEdges += this->Mesh.GetNeighbour(t, e) == TriangleMesh::Boundary;
      }
    }
    const NonManifoldCounts found = CountNonManifold(this->Mesh);
    this->Counts.NonManifoldEdges = found.Edges;
    this->Counts.NonManifoldPoints = found.Points;
    if (found.Edges + found.Points > 0)
    {
      this->SplitFans();
    }
  }

  void SplitFans()
  {
    if (this->Options.SplitNonManifold)
    {
      this->Counts.NonManifoldSplitPoints = this->Split({}, false);
      this->RebuildMesh();
    }
  }

  void Orient()
  {
    if (!this->Options.Orient)
    {
      return;
    }
    OrientTriangles(this->Mesh);
    // Those that fill a hole are new, and what is turned twice is as it was.
    this->IsTurned.resize(this->Surface.Triangles.size() - this->Counts.FillingTriangles, 0);
    for (std::size_t t = 0; t < this->IsTurned.size(); ++t)
    {
      this->IsTurned[t] ^=
        this->Surface.Triangles[t] != this->Mesh.GetTriangle(static_cast<Index>(t));
    }
    this->Counts.ReorientedTriangles = std::count(this->IsTurned.begin(), this->IsTurned.end(), 1);
    this->Surface.Triangles = this->Mesh.GetTriangles();
    const EdgeFlags disagreements = FindDisagreements(this->Mesh);
    this->Counts.NonOrientableEdges = CountEdges(disagreements);
    if (this->Options.SplitNonManifold && this->Counts.NonOrientableEdges > 0)
    {
      this->Counts.NonManifoldSplitPoints += this->Split(disagreements, true);
      this->RebuildMesh();
    }
  }

  void MendFolds()
  {
    // What faces backwards is known only where triangles agree.
    if (this->Options.Orient)
    {
      MendFoldovers(this->Mesh, this->Surface);
    }
  }

  void Fill()
  {
    if (this->Options.FillHoles <= 0.0)
    {
      return;
    }
    // Not the slits that splitting made: a hole's border may pass through a bow tie, too.
    this->JoinSplitPoints();
    const HoleFilling filling =
      FillHoles(this->Mesh, this->Options.FillHoles * GetLengthScale(this->Input, this->Mesh));
    this->Counts.FilledHoles = filling.FilledHoles;
    this->Counts.OpenHoles = filling.OpenHoles;
    this->Counts.FillingTriangles = static_cast<vtkIdType>(filling.Triangles.size());
    for (std::size_t i = 0; i < filling.Triangles.size(); ++i)
    {
      this->Surface.Triangles.push_back(filling.Triangles[i]);
      this->Surface.SourceCells.push_back(this->Surface.SourceCells[filling.Neighbours[i]]);
    }
    this->RebuildMesh();
    this->SplitFans();
    // What has been closed now has an outside.
    this->Orient();
  }

  void JoinSplitPoints()
  {
    for (Triangle& triangle : this->Surface.Triangles)
    {
      for (Index& corner : triangle)
      {
        corner = this->Surface.WeldedPointIds[corner];
      }
    }
    this->Surface.SourcePoints.resize(this->NumberOfWeldedPoints);
    this->Surface.WeldedPointIds.resize(this->NumberOfWeldedPoints);
    this->RebuildMesh();
  }

  void SplitCreases()
  {
    if (!this->Options.SplitCreases)
    {
      return;
    }
    const EdgeFlags creases = FindCreases(this->Mesh, this->Options.CreaseAngle);
    this->Counts.CreaseEdges = CountEdges(creases);
    if (this->Counts.CreaseEdges > 0)
    {
      this->Counts.SplitPoints = this->Split(creases, true);
    }
  }

  /// Splits the surface's triangles, and not the mesh. Returns how many points it made.
  vtkIdType Split(const EdgeFlags& cuts, bool onlyAtCuts)
  {
    const std::vector<Index> originals =
      SplitPoints(this->Mesh, cuts, onlyAtCuts, this->Surface.Triangles);
    for (Index original : originals)
    {
      this->Surface.SourcePoints.push_back(this->Surface.SourcePoints[original]);
      // Of a copy of a copy, too, the first of all is known.
      this->Surface.WeldedPointIds.push_back(this->Surface.WeldedPointIds[original]);
    }
    return static_cast<vtkIdType>(originals.size());
  }

  void RebuildMesh()
  {
    std::vector<TriangleMesh::Vector> points = this->Mesh.GetPoints();
    points.resize(std::min(points.size(), this->Surface.WeldedPointIds.size()));
    for (std::size_t i = points.size(); i < this->Surface.WeldedPointIds.size(); ++i)
    {
      points.push_back(points[this->Surface.WeldedPointIds[i]]);
    }
    this->Mesh = TriangleMesh(std::move(points), this->Surface.Triangles, this->Mesh.GetOrigin());
    this->Mesh.BuildNeighbours();
  }

  vtkPolyData* Input;
  const SurfacePreparationOptions& Options;
  PreparedSurface Surface;
  SurfacePreparationCounts& Counts = this->Surface.Counts;
  std::vector<Vector3d> Points;
  TriangleMesh Mesh{ {}, {} };
  Index NumberOfWeldedPoints = 0;
  std::vector<unsigned char> IsTurned; ///< for each triangle of before holes were filled
};
}

//------------------------------------------------------------------------------
PreparedSurface PrepareSurface(
  vtkPolyData* input, const SurfacePreparationOptions& options, const Progress& progress)
{
  return Preparation(input, options).Run(progress);
}
}
