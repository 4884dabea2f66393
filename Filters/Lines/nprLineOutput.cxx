// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprLineOutput.h"

#include "nprArrayNames.h"

#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace npr
{
namespace
{
// An array of so many tuples: the one that there is if nobody else holds it. Whether what was in it
// is there still.
template<typename Array>
bool Prepare(vtkSmartPointer<Array>& array, const char* name, int components, vtkIdType size)
{
  const bool isMine = array && array->GetReferenceCount() == 1;
  if (!isMine)
  {
    array = vtkSmartPointer<Array>::New();
    array->SetName(name);
    array->SetNumberOfComponents(components);
  }
  const auto* const before = array->GetPointer(0);
  array->SetNumberOfTuples(size);
  array->Modified();
  return isMine && array->GetPointer(0) == before;
}
}

//------------------------------------------------------------------------------
bool LineOutput::IsWanted(
  const LineChains& chains, std::size_t chain, const ChainIds::Claim& claim) const
{
  const std::size_t begin = chains.Begins[chain];
  const std::size_t end = chains.Ends[chain];
  const double share =
    2 * claim.Votes > static_cast<int>(end - begin) ? 1.0 - this->Settings.Hysteresis : 1.0;
  const double leastStrength = share * this->Settings.MinimumStrength;
  if (begin == end ||
    (leastStrength > 0.0 &&
      *std::max_element(chains.Strengths.begin() + begin, chains.Strengths.begin() + end) <
        leastStrength))
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
const std::vector<std::string>& LineOutput::GetOwnArrays()
{
  static const std::vector<std::string> arrays{ names::Normals, names::Strength, names::ArcLength,
    names::ViewDistance, names::SourceCell, names::SourceEdge };
  return arrays;
}

//------------------------------------------------------------------------------
void LineOutput::Begin(const Eigen::Vector3d& origin, const Options& options)
{
  // With a minimum length, another view may choose others.
  this->MayKeepLast = origin == this->Origin && options.MinimumLength == 0.0 &&
    this->Settings.MinimumLength == 0.0 &&
    options.MinimumStrength == this->Settings.MinimumStrength;
  this->Origin = origin;
  this->Settings = options;
  this->LastLines.swap(this->Lines);
  this->Lines.clear();
  this->NumberOfPoints = 0;
  this->NumberOfCorners = 0;
}

//------------------------------------------------------------------------------
bool LineOutput::AddLast(const LineChains& chains, int type)
{
  const auto begin = this->LastLines.begin() + this->Lines.size();
  if (!this->MayKeepLast || this->Lines.size() >= this->LastLines.size() || begin->Type != type ||
    begin->FirstPoint != this->NumberOfPoints || begin->FirstCorner != this->NumberOfCorners)
  {
    return false;
  }
  const auto end = std::find_if(
    begin, this->LastLines.end(), [type](const Line& line) { return line.Type != type; });
  for (auto line = begin; line != end; ++line)
  {
    this->Lines.push_back(*line);
    this->Lines.back().Chains = &chains;
    this->Lines.back().IsUnchanged = true;
    const std::size_t size = chains.GetSize(line->Chain);
    this->NumberOfPoints += static_cast<vtkIdType>(size);
    this->NumberOfCorners += static_cast<vtkIdType>(size + (chains.Closed[line->Chain] ? 1 : 0));
  }
  return true;
}

//------------------------------------------------------------------------------
LineChoice LineOutput::Choose(const LineChains& chains, const ChainIds& ids) const
{
  std::vector<char> wanted(chains.GetNumberOfChains());
  std::vector<ChainIds::Claim> claims(wanted.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(wanted.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      ids.GetClaims(chains, begin, end, claims.data() + begin);
      for (vtkIdType chain = begin; chain < end; ++chain)
      {
        wanted[chain] = this->IsWanted(chains, chain, claims[chain]);
      }
    });
  LineChoice choice;
  for (std::size_t chain = 0; chain < wanted.size(); ++chain)
  {
    if (wanted[chain])
    {
      claims[choice.Chains.size()] = claims[chain];
      choice.Chains.push_back(chain);
    }
  }
  claims.resize(choice.Chains.size());
  choice.Ids = ids.Give(claims);
  return choice;
}

//------------------------------------------------------------------------------
void LineOutput::Add(const LineChains& chains, int type, const std::vector<double>& levels,
  LineChoice& choice, int& nextId)
{
  for (std::size_t i = 0; i < choice.Chains.size(); ++i)
  {
    const std::size_t chain = choice.Chains[i];
    int& id = choice.Ids[i];
    id = id == ChainIds::NoId ? nextId++ : id;
    const vtkIdType size = static_cast<vtkIdType>(chains.GetSize(chain));
    this->Lines.push_back({ &chains, chain, this->NumberOfPoints, this->NumberOfCorners,
      levels[chains.Levels[chain]], type, id, false });
    this->NumberOfPoints += size;
    this->NumberOfCorners += size + (chains.Closed[chain] ? 1 : 0);
  }
}

//------------------------------------------------------------------------------
void LineOutput::WriteLines()
{
  const vtkIdType numberOfLines = static_cast<vtkIdType>(this->Lines.size());
  const bool hasSources = std::any_of(this->Lines.begin(), this->Lines.end(),
    [](const Line& line) { return !line.Chains->SourceCells.empty(); });
  Arrays& to = this->Written;
  // What is there already stays only where all of it is.
  bool isKept = true;
  const auto prepare = [&isKept](auto& array, const char* name, int components, vtkIdType size)
  { isKept = Prepare(array, name, components, size) && isKept; };
  prepare(to.Positions, "Points", 3, this->NumberOfPoints);
  prepare(to.Normals, names::Normals, 3, this->NumberOfPoints);
  prepare(to.Strengths, names::Strength, 1, this->NumberOfPoints);
  prepare(to.ArcLengths, names::ArcLength, 1, this->NumberOfPoints);
  prepare(to.SourceCells, names::SourceCell, 1, hasSources ? this->NumberOfPoints : 0);
  prepare(to.SourceEdges, names::SourceEdge, 2, hasSources ? this->NumberOfPoints : 0);
  prepare(to.Types, names::LineType, 1, numberOfLines);
  prepare(to.Levels, names::LineLevel, 1, numberOfLines);
  prepare(to.Ids, names::ChainId, 1, numberOfLines);
  Prepare(to.Offsets, "Offsets", 1, numberOfLines + 1);
  Prepare(to.Corners, "Corners", 1, this->NumberOfCorners);
  vtkIdTypeArray* const offsets = to.Offsets;
  vtkIdTypeArray* const corners = to.Corners;
  offsets->SetValue(numberOfLines, this->NumberOfCorners);
  double* const positions = to.Positions->GetPointer(0);
  float* const normals = to.Normals->GetPointer(0);
  float* const strengths = to.Strengths->GetPointer(0);
  float* const arcLengths = to.ArcLengths->GetPointer(0);

  const auto writeLine = [&](vtkIdType i)
  {
    const Line& line = this->Lines[i];
    this->WriteDistances(line);
    const LineChains& chains = *line.Chains;
    const std::size_t begin = chains.Begins[line.Chain];
    const vtkIdType size = static_cast<vtkIdType>(chains.GetSize(line.Chain));
    offsets->SetValue(i, line.FirstCorner);
    for (vtkIdType k = 0; k < size; ++k)
    {
      corners->SetValue(line.FirstCorner + k, line.FirstPoint + k);
    }
    if (chains.Closed[line.Chain])
    {
      corners->SetValue(line.FirstCorner + size, line.FirstPoint);
    }
    if (isKept && line.IsUnchanged)
    {
      return;
    }
    to.Types->SetValue(i, line.Type);
    to.Levels->SetValue(i, line.Level);
    to.Ids->SetValue(i, line.Id);
    double length = 0.0;
    for (vtkIdType k = 0; k < size; ++k)
    {
      const std::size_t v = begin + k;
      const vtkIdType point = line.FirstPoint + k;
      length += k == 0 ? 0.0 : (chains.Positions[v] - chains.Positions[v - 1]).norm();
      Eigen::Map<Eigen::Vector3d>(positions + 3 * point) = this->Origin + chains.Positions[v];
      Eigen::Map<Eigen::Vector3f>(normals + 3 * point) = chains.Normals[v];
      strengths[point] = chains.Strengths[v];
      arcLengths[point] = static_cast<float>(length);
      if (hasSources)
      {
        to.SourceCells->SetValue(point, chains.SourceCells[v]);
        to.SourceEdges->SetTypedTuple(point, chains.SourceEdges[v].data());
      }
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
  to.Points = vtkSmartPointer<vtkPoints>::New();
  to.Points->SetData(to.Positions);
  to.Cells = vtkSmartPointer<vtkCellArray>::New();
  to.Cells->SetData(offsets, corners);
}

//------------------------------------------------------------------------------
void LineOutput::WriteDistances(const Line& line)
{
  if (this->Settings.Ruler)
  {
    float* distance = this->Written.Distances->GetPointer(line.FirstPoint);
    for (std::size_t v = line.Chains->Begins[line.Chain]; v < line.Chains->Ends[line.Chain]; ++v)
    {
      *distance++ =
        static_cast<float>(this->Settings.Ruler->GetDistance(line.Chains->Positions[v]));
    }
  }
}

//------------------------------------------------------------------------------
void LineOutput::WriteQuantities(const LineSurface& surface, const LineView& view,
  const std::vector<LineQuantity>& quantities, vtkPolyData* output)
{
  auto& arrays = this->Written.Quantities;
  arrays.resize(quantities.size());
  for (std::size_t q = 0; q < quantities.size(); ++q)
  {
    const int components = quantities[q].GetNumberOfComponents(surface);
    if (arrays[q] &&
      (arrays[q]->GetName() != quantities[q].GetName() ||
        arrays[q]->GetNumberOfComponents() != components))
    {
      arrays[q] = nullptr;
    }
    Prepare(arrays[q], quantities[q].GetName().c_str(), components, this->NumberOfPoints);
    vtkSMPTools::For(0, static_cast<vtkIdType>(this->Lines.size()),
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          const Line& line = this->Lines[i];
          quantities[q].Write(surface, view, *line.Chains, line.Chain, line.FirstPoint, arrays[q]);
        }
      });
    output->GetPointData()->AddArray(arrays[q]);
  }
}

//------------------------------------------------------------------------------
void LineOutput::Write(vtkPolyData* output)
{
  if (this->Settings.Ruler)
  {
    Prepare(this->Written.Distances, names::ViewDistance, 1, this->NumberOfPoints);
  }
  const bool isUnchanged = this->Written.Points && this->Lines.size() == this->LastLines.size() &&
    std::all_of(
      this->Lines.begin(), this->Lines.end(), [](const Line& line) { return line.IsUnchanged; });
  if (!isUnchanged)
  {
    // They hold arrays that are to be used again if nobody else holds them.
    this->Written.Points = nullptr;
    this->Written.Cells = nullptr;
    this->WriteLines();
  }
  else
  {
    vtkSMPTools::For(0, static_cast<vtkIdType>(this->Lines.size()),
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          this->WriteDistances(this->Lines[i]);
        }
      });
  }
  const Arrays& from = this->Written;
  output->SetPoints(from.Points);
  output->SetLines(from.Cells);
  vtkPointData* const pointData = output->GetPointData();
  pointData->SetNormals(from.Normals);
  pointData->AddArray(from.Strengths);
  pointData->AddArray(from.ArcLengths);
  if (this->Settings.Ruler)
  {
    pointData->AddArray(from.Distances);
  }
  if (std::any_of(this->Lines.begin(), this->Lines.end(),
        [](const Line& line) { return !line.Chains->SourceCells.empty(); }))
  {
    pointData->AddArray(from.SourceCells);
    pointData->AddArray(from.SourceEdges);
  }
  output->GetCellData()->AddArray(from.Types);
  output->GetCellData()->AddArray(from.Levels);
  output->GetCellData()->AddArray(from.Ids);
}
}
