// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprChainTesting.h
 * @brief Lines as tests look at them: chains of points, and what holds for all of them.
 */
#ifndef nprChainTesting_h
#define nprChainTesting_h

#include "nprArrayNames.h"
#include "nprChecks.h"
#include "vtkNPRFeatureLines.h"

#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkExecutive.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace nprtest
{
using Vector = Eigen::Vector3d;

/// A chain of the output.
struct Chain
{
  std::vector<Vector> Points; // a closed one does not repeat its first point
  std::vector<Vector> Normals;
  std::vector<double> Strength;
  bool Closed = false;
  int Type = 0;

  std::size_t GetNumberOfSegments() const { return this->Points.size() - (this->Closed ? 0 : 1); }
  const Vector& Next(std::size_t i) const { return this->Points[(i + 1) % this->Points.size()]; }
};

inline std::vector<Chain> GetChains(vtkPolyData* lines)
{
  std::vector<Chain> chains;
  vtkDataArray* strength = lines->GetPointData()->GetArray(npr::names::Strength);
  vtkDataArray* normals = lines->GetPointData()->GetArray(npr::names::Normals);
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < lines->GetNumberOfLines(); ++cell)
  {
    lines->GetLines()->GetCellAtId(cell, ids);
    Chain chain;
    chain.Type =
      static_cast<int>(lines->GetCellData()->GetArray(npr::names::LineType)->GetTuple1(cell));
    chain.Closed = ids->GetId(0) == ids->GetId(ids->GetNumberOfIds() - 1);
    for (vtkIdType i = 0; i < ids->GetNumberOfIds() - (chain.Closed ? 1 : 0); ++i)
    {
      Vector p;
      lines->GetPoint(ids->GetId(i), p.data());
      chain.Points.push_back(p);
      normals->GetTuple(ids->GetId(i), p.data());
      chain.Normals.push_back(p);
      chain.Strength.push_back(strength->GetTuple1(ids->GetId(i)));
    }
    chains.push_back(chain);
  }
  return chains;
}

/// All pieces, each with its lesser end first, in ascending order.
using Segment = std::array<double, 6>;
inline std::vector<Segment> GetSegments(const std::vector<Chain>& chains)
{
  std::vector<Segment> segments;
  for (const Chain& chain : chains)
  {
    for (std::size_t i = 0; i < chain.GetNumberOfSegments(); ++i)
    {
      std::array<double, 3> a = { chain.Points[i][0], chain.Points[i][1], chain.Points[i][2] };
      std::array<double, 3> b = { chain.Next(i)[0], chain.Next(i)[1], chain.Next(i)[2] };
      if (b < a)
      {
        std::swap(a, b);
      }
      segments.push_back({ a[0], a[1], a[2], b[0], b[1], b[2] });
    }
  }
  std::sort(segments.begin(), segments.end());
  return segments;
}

/// What holds for all lines: no piece without length, none twice, strengths in range, unit normals.
inline void CheckSound(const std::vector<Chain>& chains, Checks& check)
{
  int types = 0;
  for (const Chain& chain : chains)
  {
    types = std::max(types, chain.Type + 1);
    check(chain.Points.size() >= 2, "a chain has two points or more");
    for (std::size_t i = 0; i < chain.GetNumberOfSegments(); ++i)
    {
      check(chain.Points[i] != chain.Next(i), "every piece has a length");
    }
    for (std::size_t i = 0; i < chain.Points.size(); ++i)
    {
      check(chain.Strength[i] >= 0.0 && chain.Strength[i] <= 1.0, "strength is in [0, 1]");
      check(std::abs(chain.Normals[i].norm() - 1.0) < 1.0e-5, "normals are unit vectors",
        chain.Normals[i].norm());
    }
  }
  for (int type = 0; type < types; ++type)
  {
    std::vector<Chain> ofType;
    std::copy_if(chains.begin(), chains.end(), std::back_inserter(ofType),
      [type](const Chain& chain) { return chain.Type == type; });
    const auto segments = GetSegments(ofType);
    check(std::adjacent_find(segments.begin(), segments.end()) == segments.end(),
      "no piece comes twice");
  }
}

inline double GetLength(const Chain& chain)
{
  double length = 0.0;
  for (std::size_t i = 0; i < chain.GetNumberOfSegments(); ++i)
  {
    length += (chain.Next(i) - chain.Points[i]).norm();
  }
  return length;
}

/// How far a point is from lines.
inline double GetDistance(const std::vector<Chain>& chains, const Vector& p)
{
  double least = std::numeric_limits<double>::max();
  for (const Chain& chain : chains)
  {
    for (std::size_t i = 0; i < chain.GetNumberOfSegments(); ++i)
    {
      const Vector along = chain.Next(i) - chain.Points[i];
      const double t =
        std::min(1.0, std::max(0.0, (p - chain.Points[i]).dot(along) / along.squaredNorm()));
      least = std::min(least, (p - chain.Points[i] - t * along).norm());
    }
  }
  return least;
}

inline vtkSmartPointer<vtkCamera> MakeCamera(const Vector& position, bool parallel = false)
{
  auto camera = vtkSmartPointer<vtkCamera>::New();
  camera->SetPosition(position[0], position[1], position[2]);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetViewUp(0.1, 0.9, 0.3);
  camera->SetParallelProjection(parallel);
  return camera;
}

/// Extracts lines by their names.
inline std::vector<Chain> Extract(
  vtkPolyData* surface, const std::vector<const char*>& names, vtkCamera* camera)
{
  vtkNew<vtkNPRFeatureLines> lines;
  for (const char* name : names)
  {
    lines->AddDefinition(name);
  }
  lines->SetCamera(camera);
  lines->SetInputData(surface);
  lines->Update();
  return GetChains(lines->GetOutput());
}

/// The text of the errors of one update.
inline std::string GetErrors(vtkNPRFeatureLines* lines)
{
  std::string errors;
  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(&errors);
  observer->SetCallback([](vtkObject*, unsigned long, void* text, void* message)
    { *static_cast<std::string*>(text) += static_cast<const char*>(message); });
  const unsigned long tag = lines->AddObserver(vtkCommand::ErrorEvent, observer);
  // The executive adds that the filter failed.
  const unsigned long executiveTag =
    lines->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, observer);
  lines->Update();
  lines->RemoveObserver(tag);
  lines->GetExecutive()->RemoveObserver(executiveTag);
  return errors;
}

/// Whether a text has a part.
inline bool Contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}
}

#endif
