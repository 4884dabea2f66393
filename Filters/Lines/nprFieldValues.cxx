// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprFieldValues.h"

#include "nprArrayNames.h"
#include "vtkNPRLineDefinition.h"

#include <vtkSMPTools.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace npr
{
namespace
{
// Long enough that the call of a definition costs nothing, short enough to balance the threads.
constexpr TriangleMesh::Index BlocksOfSpan = 16;
// From where on doubt counts; at 1 nothing is left of a line.
constexpr float LeastDoubt = 0.8f;
}

//------------------------------------------------------------------------------
FieldValues::FieldValues(const LineSurface& surface, const LineClusters& clusters)
  : Surface(surface), Clusters(clusters), NumberOfPoints(surface.GetMesh().GetNumberOfPoints()),
    NumberOfBlocks(clusters.GetNumberOfBlocks()),
    Blocks(new std::atomic<unsigned char>[NumberOfBlocks] {}),
    TestBlocks(new std::atomic<unsigned char>[NumberOfBlocks] {}),
    TestPoints(new std::atomic<unsigned char>[NumberOfPoints] {}), Field(NumberOfPoints),
    Sides(NumberOfPoints), BlockSides(NumberOfBlocks), Test(NumberOfPoints)
{
}

//------------------------------------------------------------------------------
void FieldValues::Start(const vtkNPRLineDefinition& definition, const LineView& view,
  const std::vector<float>& levels, const float* doubts)
{
  this->Definition = &definition;
  this->View = view;
  this->Levels = &levels;
  this->Doubts = doubts;
  for (Index block = 0; block < this->NumberOfBlocks; ++block)
  {
    this->Blocks[block].store(0, std::memory_order_relaxed);
  }
  this->Axes.reset();
  if (definition.HasViewAxes() || definition.GetAxes())
  {
    this->AxisPoints.resize(this->NumberOfPoints);
    this->Axes = std::make_unique<FieldAxes>(
      this->Surface, this->AxisPoints.data(), definition.HasEvenField());
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
    this->Definition->EvaluateFieldAndAxes(
      this->Surface, this->View, begin, end, this->Field.data(), this->AxisPoints.data());
  }
  else
  {
    this->Definition->EvaluateField(this->Surface, this->View, begin, end, this->Field.data());
  }
  if (this->Axes)
  {
    this->SetAxes(begin, end);
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
// Puts beside the axes what is compared with them.
void FieldValues::SetAxes(Index begin, Index end)
{
  std::array<const float*, 3> normals;
  std::array<const float*, 3> axes = { nullptr, nullptr, nullptr };
  for (int c = 0; c < 3; ++c)
  {
    normals[c] = this->Surface.GetComponent(names::Normals, c);
    if (!this->Definition->HasViewAxes())
    {
      axes[c] = this->Surface.GetComponent(this->Definition->GetAxes(), c);
    }
  }
  const bool isEven = this->Definition->HasEvenField();
  for (Index i = begin; i < end; ++i)
  {
    AxisPoint& point = this->AxisPoints[i];
    point.Normal = { normals[0][i], normals[1][i], normals[2][i] };
    if (axes[0])
    {
      point.Axis = { axes[0][i], axes[1][i], axes[2][i] };
      point.Bound = 1.0f;
    }
    point.Field = FieldAxes::MakeField(this->Field[i], point.Axis, isEven);
  }
}

//------------------------------------------------------------------------------
void FieldValues::SetBlockSide(Index begin, Index end)
{
  bool isMixed = false;
  if (this->Axes)
  {
    isMixed = std::any_of(this->AxisPoints.begin() + begin, this->AxisPoints.begin() + end,
      [](const AxisPoint& point) { return point.Bound > 0.0f; });
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
    : this->Axes                                                  ? Side(0)
                                                                  : this->Sides[begin];
}

//------------------------------------------------------------------------------
bool FieldValues::HasTest() const
{
  return this->Doubts || this->Definition->HasTest();
}

//------------------------------------------------------------------------------
// The fall to a maximum is measured in the triangles around a point.
void FieldValues::RequireAroundTests()
{
  for (Index block = 0; block < this->NumberOfBlocks; ++block)
  {
    if (this->TestBlocks[block].load(std::memory_order_relaxed) != 0)
    {
      for (const Index* near = this->Clusters.BlocksAroundBegin(block);
           near != this->Clusters.BlocksAroundEnd(block); ++near)
      {
        this->Require(*near);
      }
    }
  }
}

//------------------------------------------------------------------------------
void FieldValues::EvaluateTests()
{
  if (this->Axes && this->Definition->IsMaximum())
  {
    this->RequireAroundTests();
    this->Evaluate();
  }
  vtkSMPTools::For(0, (this->NumberOfBlocks + BlocksOfSpan - 1) / BlocksOfSpan,
    [this](vtkIdType begin, vtkIdType end)
    {
      std::array<Index, BlocksOfSpan * LineClusters::PointsOfBlock> points;
      for (Index span = static_cast<Index>(begin); span < end; ++span)
      {
        std::size_t count = 0;
        const Index last = std::min((span + 1) * BlocksOfSpan, this->NumberOfBlocks);
        for (Index block = span * BlocksOfSpan; block < last; ++block)
        {
          count += this->TakeTestPoints(block, points.data() + count);
        }
        if (count != 0)
        {
          this->EvaluateTests(points.data(), count);
        }
      }
    });
}

//------------------------------------------------------------------------------
// Writes the points of a block whose test is required, and forgets that it was. Which these are is
// as good as random, so that branches would be slow.
std::size_t FieldValues::TakeTestPoints(Index block, Index* points)
{
  if (this->TestBlocks[block].load(std::memory_order_relaxed) == 0)
  {
    return 0;
  }
  this->TestBlocks[block].store(0, std::memory_order_relaxed);
  std::size_t count = 0;
  const Index end = std::min((block + 1) * LineClusters::PointsOfBlock, this->NumberOfPoints);
  for (Index point = block * LineClusters::PointsOfBlock; point < end; ++point)
  {
    points[count] = point;
    count += this->TestPoints[point].load(std::memory_order_relaxed);
    this->TestPoints[point].store(0, std::memory_order_relaxed);
  }
  return count;
}

//------------------------------------------------------------------------------
void FieldValues::EvaluateTests(const Index* points, std::size_t count)
{
  std::vector<float> fall;
  if (this->Axes && this->Definition->IsMaximum())
  {
    fall.reserve(count);
    for (std::size_t i = 0; i < count; ++i)
    {
      constexpr std::size_t ahead = 4;
      this->Axes->PrefetchNeighbours(points[std::min(i + ahead, count - 1)]);
      // Where no line may be, the test fails without it.
      fall.push_back(this->Axes->MayBeAt(points[i]) ? this->Axes->ComputeFall(points[i]) : 0.0f);
    }
  }
  std::array<float, BlocksOfSpan * LineClusters::PointsOfBlock> test;
  if (this->Definition->HasTest())
  {
    this->Definition->EvaluateTest(this->Surface, this->View, points, static_cast<vtkIdType>(count),
      fall.empty() ? nullptr : fall.data(), test.data());
  }
  else
  {
    std::fill_n(test.begin(), count, 1.0f);
  }
  if (this->Doubts)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      const float doubt = this->Doubts[points[i]];
      if (doubt > LeastDoubt)
      {
        test[i] = std::min(test[i], (1.0f - doubt) / (1.0f - LeastDoubt));
      }
    }
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    this->Test[points[i]] = test[i];
  }
}
}
