// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprFieldValues.h"

#include "vtkNPRLineDefinition.h"

#include <vtkSMPTools.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace npr
{
namespace
{
// Long enough that the call of a definition costs nothing, short enough to balance the threads.
constexpr TriangleMesh::Index BlocksOfSpan = 16;
}

//------------------------------------------------------------------------------
FieldValues::FieldValues(const LineSurface& surface, const LineClusters& clusters)
  : Surface(surface), NumberOfPoints(surface.GetMesh().GetNumberOfPoints()),
    NumberOfBlocks(clusters.GetNumberOfBlocks()),
    NumberOfParts((NumberOfPoints + PointsOfPart - 1) / PointsOfPart),
    Blocks(new std::atomic<unsigned char>[NumberOfBlocks] {}),
    TestParts(new std::atomic<unsigned char>[NumberOfParts] {}),
    TestPoints(new std::atomic<unsigned char>[NumberOfPoints] {}), Field(NumberOfPoints),
    Sides(NumberOfPoints), BlockSides(NumberOfBlocks), Test(NumberOfPoints)
{
}

//------------------------------------------------------------------------------
void FieldValues::Start(
  const vtkNPRLineDefinition& definition, const LineView& view, const std::vector<float>& levels)
{
  this->Definition = &definition;
  this->View = view;
  this->Levels = &levels;
  for (Index block = 0; block < this->NumberOfBlocks; ++block)
  {
    this->Blocks[block].store(0, std::memory_order_relaxed);
  }
  this->Axes.reset();
  this->TestBounds.clear();
  std::array<const float*, 3> axes;
  for (int i = 0; i < 3; ++i)
  {
    if (definition.HasViewAxes())
    {
      this->ViewAxes[i].resize(this->NumberOfPoints);
      axes[i] = this->ViewAxes[i].data();
    }
    else if (definition.GetAxes())
    {
      axes[i] = this->Surface.GetComponent(definition.GetAxes(), i);
    }
  }
  if (definition.HasViewAxes())
  {
    this->TestBounds.resize(this->NumberOfPoints);
  }
  if (definition.HasViewAxes() || definition.GetAxes())
  {
    this->Axes = std::make_unique<FieldAxes>(this->Surface, axes, definition.HasEvenField());
  }
}

//------------------------------------------------------------------------------
void FieldValues::Evaluate()
{
  constexpr unsigned char required = 1;
  constexpr unsigned char evaluated = 2;
  std::vector<std::pair<Index, Index>> spans;
  for (Index block = 0; block < this->NumberOfBlocks; ++block)
  {
    if (this->Blocks[block].load(std::memory_order_relaxed) != required)
    {
      continue;
    }
    this->Blocks[block].store(evaluated, std::memory_order_relaxed);
    if (spans.empty() || spans.back().second != block || block - spans.back().first >= BlocksOfSpan)
    {
      spans.emplace_back(block, block);
    }
    spans.back().second = block + 1;
  }
  vtkSMPTools::For(0, static_cast<vtkIdType>(spans.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        this->EvaluateSpan(spans[i].first * LineClusters::PointsOfBlock,
          std::min(spans[i].second * LineClusters::PointsOfBlock, this->NumberOfPoints));
      }
    });
}

//------------------------------------------------------------------------------
void FieldValues::EvaluateNow(Index block)
{
  if (this->Blocks[block].load(std::memory_order_relaxed) == 0)
  {
    this->Blocks[block].store(2, std::memory_order_relaxed);
    this->EvaluateSpan(block * LineClusters::PointsOfBlock,
      std::min((block + 1) * LineClusters::PointsOfBlock, this->NumberOfPoints));
  }
}

//------------------------------------------------------------------------------
void FieldValues::EvaluateSpan(Index begin, Index end)
{
  if (this->Definition->HasViewAxes())
  {
    this->Definition->EvaluateFieldAndAxes(this->Surface, this->View, begin, end,
      this->Field.data(),
      { this->ViewAxes[0].data(), this->ViewAxes[1].data(), this->ViewAxes[2].data() },
      this->TestBounds.data());
  }
  else
  {
    this->Definition->EvaluateField(this->Surface, this->View, begin, end, this->Field.data());
  }
  const float* const field = this->Field.data();
  Side* const sides = this->Sides.data();
  std::fill(sides + begin, sides + end, Side(0));
  for (const float level : *this->Levels)
  {
    for (Index i = begin; i < end; ++i)
    {
      sides[i] = static_cast<Side>(sides[i] + (field[i] >= level ? 1 : 0));
    }
  }
  for (Index i = begin; i < end; ++i)
  {
    sides[i] = std::abs(field[i]) <= std::numeric_limits<float>::max() ? sides[i] : NotANumber;
  }
  for (Index first = begin; first < end; first += LineClusters::PointsOfBlock)
  {
    this->SetBlockSide(first, std::min(first + LineClusters::PointsOfBlock, end));
  }
}

//------------------------------------------------------------------------------
void FieldValues::SetBlockSide(Index begin, Index end)
{
  bool isMixed = false;
  if (!this->TestBounds.empty())
  {
    isMixed = std::any_of(this->TestBounds.begin() + begin, this->TestBounds.begin() + end,
      [](float bound) { return bound > 0.0f; });
  }
  else if (this->Axes)
  {
    isMixed = true;
  }
  else
  {
    unsigned int differences = 0;
    for (Index i = begin; i < end; ++i)
    {
      differences |= static_cast<unsigned int>(this->Sides[i] ^ this->Sides[begin]);
    }
    isMixed = differences != 0;
  }
  this->BlockSides[begin / LineClusters::PointsOfBlock] = isMixed ? Mixed
    : this->TestBounds.empty()                                    ? this->Sides[begin]
                                                                  : Side(0);
}

//------------------------------------------------------------------------------
// The fall to a maximum is measured in the triangles around a point.
void FieldValues::RequireAroundTests()
{
  const TriangleMesh& mesh = this->Surface.GetMesh();
  vtkSMPTools::For(0, this->NumberOfPoints,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (Index point = static_cast<Index>(begin); point < end; ++point)
      {
        if (this->TestPoints[point].load(std::memory_order_relaxed) == 0)
        {
          continue;
        }
        for (const Index* t = mesh.IncidentBegin(point); t != mesh.IncidentEnd(point); ++t)
        {
          for (const Index corner : mesh.GetTriangle(*t))
          {
            this->Require(corner / LineClusters::PointsOfBlock);
          }
        }
      }
    });
}

//------------------------------------------------------------------------------
void FieldValues::EvaluateTests()
{
  if (this->Axes && this->Definition->IsMaximum())
  {
    this->RequireAroundTests();
    this->Evaluate();
  }
  vtkSMPTools::For(0, this->NumberOfParts,
    [this](vtkIdType begin, vtkIdType end)
    {
      std::vector<Index> points;
      std::vector<float> fall;
      std::vector<float> test;
      for (Index part = static_cast<Index>(begin); part < end; ++part)
      {
        if (this->TestParts[part].load(std::memory_order_relaxed) == 0)
        {
          continue;
        }
        this->TestParts[part].store(0, std::memory_order_relaxed);
        points.clear();
        const Index last = std::min((part + 1) * PointsOfPart, this->NumberOfPoints);
        for (Index point = part * PointsOfPart; point < last; ++point)
        {
          if (this->TestPoints[point].load(std::memory_order_relaxed) != 0)
          {
            this->TestPoints[point].store(0, std::memory_order_relaxed);
            points.push_back(point);
          }
        }
        const vtkIdType count = static_cast<vtkIdType>(points.size());
        test.resize(points.size());
        const bool isMaximum = this->Axes && this->Definition->IsMaximum();
        if (isMaximum)
        {
          fall.clear();
          for (const Index point : points)
          {
            // Where no line may be, the test fails without it.
            fall.push_back(
              this->MayBeAt(point) ? this->Axes->ComputeFall(point, this->Field.data()) : 0.0f);
          }
        }
        this->Definition->EvaluateTest(this->Surface, this->View, points.data(), count,
          isMaximum ? fall.data() : nullptr, test.data());
        for (vtkIdType i = 0; i < count; ++i)
        {
          this->Test[points[i]] = test[i];
        }
      }
    });
}
}
