// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprLineOutput.h"

#include "nprArrayNames.h"
#include "nprLineClusters.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace npr
{
namespace
{
constexpr int NoId = -1;

// A part of the surface that lines are known by.
std::size_t GetPlace(const LineChains& chains, std::size_t vertex)
{
  return static_cast<std::size_t>(chains.Triangles[vertex] / LineClusters::TrianglesOfCluster);
}

// An array of values that are all to be set.
template<typename Array>
vtkSmartPointer<Array> MakeArray(const char* name, int components, vtkIdType size)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(size);
  return array;
}
}

//------------------------------------------------------------------------------
ChainIds::Claim ChainIds::GetClaim(const LineChains& chains, std::size_t chain) const
{
  std::vector<Claim> votes;
  for (std::size_t v = chains.Begins[chain]; v < chains.Ends[chain]; ++v)
  {
    const std::size_t place = GetPlace(chains, v);
    const int id = place < this->LastIds.size() ? this->LastIds[place] : NoId;
    if (id == NoId)
    {
      continue;
    }
    const auto found =
      std::find_if(votes.rbegin(), votes.rend(), [id](const Claim& vote) { return vote.Id == id; });
    if (found == votes.rend())
    {
      votes.push_back({ id, 1 });
    }
    else
    {
      ++found->Votes;
    }
  }
  const auto most = std::max_element(
    votes.begin(), votes.end(), [](const Claim& a, const Claim& b) { return a.Votes < b.Votes; });
  return most == votes.end() ? Claim{ NoId, 0 } : *most;
}

//------------------------------------------------------------------------------
std::vector<int> ChainIds::Update(const LineChains& chains, const std::vector<std::size_t>& chosen,
  const std::vector<Claim>& claims, int& next)
{
  std::vector<std::size_t> order(chosen.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(),
    [&claims](std::size_t a, std::size_t b)
    {
      return claims[a].Id != claims[b].Id    ? claims[a].Id < claims[b].Id
        : claims[a].Votes != claims[b].Votes ? claims[a].Votes > claims[b].Votes
                                             : a < b;
    });
  std::vector<int> ids(chosen.size(), NoId);
  int last = NoId;
  for (const std::size_t i : order)
  {
    if (claims[i].Id != last)
    {
      last = claims[i].Id;
      ids[i] = last;
    }
  }
  std::fill(this->LastIds.begin(), this->LastIds.end(), NoId);
  for (std::size_t i = 0; i < chosen.size(); ++i)
  {
    if (ids[i] == NoId)
    {
      ids[i] = next++;
    }
    for (std::size_t v = chains.Begins[chosen[i]]; v < chains.Ends[chosen[i]]; ++v)
    {
      const std::size_t place = GetPlace(chains, v);
      if (place >= this->LastIds.size())
      {
        this->LastIds.resize(place + 1, NoId);
      }
      this->LastIds[place] = ids[i];
    }
  }
  return ids;
}

//------------------------------------------------------------------------------
bool LineOutput::IsWanted(
  const LineChains& chains, std::size_t chain, const ChainIds::Claim& claim) const
{
  const std::size_t begin = chains.Begins[chain];
  const std::size_t end = chains.Ends[chain];
  const double share = 2 * claim.Votes > end - begin ? 1.0 - this->Settings.Hysteresis : 1.0;
  if (begin == end ||
    *std::max_element(chains.Strengths.begin() + begin, chains.Strengths.begin() + end) <
      share * this->Settings.MinimumStrength)
  {
    return false;
  }
  const double least = share * this->Settings.MinimumLength;
  double length = 0.0;
  for (std::size_t v = begin; v < end && length < least; ++v)
  {
    const std::size_t next = v + 1 < end ? v + 1 : chains.Closed[chain] ? begin : v;
    length += this->Settings.Ruler->Measure(chains.Positions[v], chains.Positions[next]);
  }
  return length >= least;
}

//------------------------------------------------------------------------------
void LineOutput::Add(
  const LineChains& chains, int type, const std::vector<double>& levels, ChainIds& ids, int& nextId)
{
  std::vector<char> wanted(chains.GetNumberOfChains());
  std::vector<ChainIds::Claim> claims(wanted.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(wanted.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType chain = begin; chain < end; ++chain)
      {
        claims[chain] = ids.GetClaim(chains, chain);
        wanted[chain] = this->IsWanted(chains, chain, claims[chain]);
      }
    });
  std::vector<std::size_t> chosen;
  for (std::size_t chain = 0; chain < wanted.size(); ++chain)
  {
    if (wanted[chain])
    {
      claims[chosen.size()] = claims[chain];
      chosen.push_back(chain);
    }
  }
  const std::vector<int> given = ids.Update(chains, chosen, claims, nextId);
  for (std::size_t i = 0; i < chosen.size(); ++i)
  {
    const vtkIdType size = static_cast<vtkIdType>(chains.GetSize(chosen[i]));
    this->Lines.push_back({ &chains, chosen[i], this->NumberOfPoints, this->NumberOfCorners, type,
      given[i], levels[chains.Levels[chosen[i]]] });
    this->NumberOfPoints += size;
    this->NumberOfCorners += size + (chains.Closed[chosen[i]] ? 1 : 0);
  }
}

//------------------------------------------------------------------------------
void LineOutput::Write(vtkPolyData* output) const
{
  const vtkIdType numberOfLines = static_cast<vtkIdType>(this->Lines.size());
  const bool hasSources = std::any_of(this->Lines.begin(), this->Lines.end(),
    [](const Chosen& line) { return !line.Chains->SourceCells.empty(); });
  const auto positions = MakeArray<vtkDoubleArray>("Points", 3, this->NumberOfPoints);
  const auto normals = MakeArray<vtkFloatArray>(names::Normals, 3, this->NumberOfPoints);
  const auto strengths = MakeArray<vtkFloatArray>(names::Strength, 1, this->NumberOfPoints);
  const auto arcLengths = MakeArray<vtkFloatArray>(names::ArcLength, 1, this->NumberOfPoints);
  const auto distances = MakeArray<vtkFloatArray>(
    names::ViewDistance, 1, this->Settings.Ruler ? this->NumberOfPoints : 0);
  const auto cells =
    MakeArray<vtkIdTypeArray>(names::SourceCell, 1, hasSources ? this->NumberOfPoints : 0);
  const auto edges =
    MakeArray<vtkIdTypeArray>(names::SourceEdge, 2, hasSources ? this->NumberOfPoints : 0);
  const auto types = MakeArray<vtkIntArray>(names::LineType, 1, numberOfLines);
  const auto levels = MakeArray<vtkDoubleArray>(names::LineLevel, 1, numberOfLines);
  const auto ids = MakeArray<vtkIntArray>(names::ChainId, 1, numberOfLines);
  const auto offsets = MakeArray<vtkIdTypeArray>("Offsets", 1, numberOfLines + 1);
  const auto corners = MakeArray<vtkIdTypeArray>("Corners", 1, this->NumberOfCorners);
  offsets->SetValue(numberOfLines, this->NumberOfCorners);

  const auto writeLine = [&](vtkIdType i)
  {
    const Chosen& line = this->Lines[i];
    const LineChains& chains = *line.Chains;
    const std::size_t begin = chains.Begins[line.Chain];
    const vtkIdType size = static_cast<vtkIdType>(chains.GetSize(line.Chain));
    types->SetValue(i, line.Type);
    levels->SetValue(i, line.Level);
    ids->SetValue(i, line.Id);
    offsets->SetValue(i, line.FirstCorner);
    double length = 0.0;
    for (vtkIdType k = 0; k < size; ++k)
    {
      const std::size_t v = begin + k;
      const vtkIdType point = line.FirstPoint + k;
      const Eigen::Vector3d position = this->Origin + chains.Positions[v];
      length += k == 0 ? 0.0 : (chains.Positions[v] - chains.Positions[v - 1]).norm();
      positions->SetTypedTuple(point, position.data());
      normals->SetTypedTuple(point, chains.Normals[v].data());
      strengths->SetValue(point, chains.Strengths[v]);
      arcLengths->SetValue(point, static_cast<float>(length));
      corners->SetValue(line.FirstCorner + k, point);
      if (this->Settings.Ruler)
      {
        distances->SetValue(
          point, static_cast<float>(this->Settings.Ruler->GetDistance(chains.Positions[v])));
      }
      if (hasSources)
      {
        cells->SetValue(point, chains.SourceCells[v]);
        edges->SetTypedTuple(point, chains.SourceEdges[v].data());
      }
    }
    if (chains.Closed[line.Chain])
    {
      corners->SetValue(line.FirstCorner + size, line.FirstPoint);
    }
  };
  vtkSMPTools::For(0, numberOfLines,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        writeLine(i);
      }
    });

  vtkNew<vtkPoints> points;
  points->SetData(positions);
  output->SetPoints(points);
  vtkNew<vtkCellArray> lines;
  lines->SetData(offsets, corners);
  output->SetLines(lines);
  output->GetPointData()->SetNormals(normals);
  output->GetPointData()->AddArray(strengths);
  output->GetPointData()->AddArray(arcLengths);
  if (this->Settings.Ruler)
  {
    output->GetPointData()->AddArray(distances);
  }
  if (hasSources)
  {
    output->GetPointData()->AddArray(cells);
    output->GetPointData()->AddArray(edges);
  }
  output->GetCellData()->AddArray(types);
  output->GetCellData()->AddArray(levels);
  output->GetCellData()->AddArray(ids);
}
}
