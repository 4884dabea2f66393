// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprFieldValues_h
#define nprFieldValues_h

#include "nprAlignedVector.h"
#include "nprFieldAxes.h"
#include "nprLineClusters.h"
#include "nprLineSurface.h"
#include "vtkNPRFiltersLinesModule.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <vector>

class vtkNPRLineDefinition;

namespace npr
{
/**
 * @class FieldValues
 * @brief The field and the test of a definition at the points of a surface, where they are wanted.
 *
 * First whoever looks for lines says what is required, from as many threads as there are; then all
 * of it is evaluated at once. A value does not depend on what else is required, so that lines are
 * the same however they are looked for. Start() serves one definition after another with the same
 * memory.
 */
class VTKNPRFILTERSLINES_EXPORT FieldValues
{
public:
  using Index = TriangleMesh::Index;
  /// How many levels are not above a value, the lowest first.
  using Side = std::uint16_t;
  static constexpr Side NotANumber = 0xffff;
  static constexpr Side Mixed = 0xfffe;

  /// Both must outlive this.
  FieldValues(const LineSurface& surface, const LineClusters& clusters);

  /// Forgets what was. The levels, in ascending order, must stay while this is used, and so must
  /// doubts: of all points, or null for none.
  void Start(const vtkNPRLineDefinition& definition, const LineView& view,
    const std::vector<float>& levels, const float* doubts);

  /// The axes that the field's sign belongs to; null where it has one value.
  const FieldAxes* GetAxes() const { return this->Axes.get(); }

  /// @name The field
  ///@{
  void Require(Index block)
  {
    if (this->Blocks[block].load(std::memory_order_relaxed) == 0)
    {
      this->Blocks[block].store(1, std::memory_order_relaxed);
    }
  }
  void Evaluate();
  /// At once; for one thread alone.
  void EvaluateNow(Index block);
  const float* Get() const { return this->Field.data(); }
  float operator[](Index point) const { return this->Field[point]; }
  Side GetSide(Index point) const { return this->Sides[point]; }
  const Side* GetSides() const { return this->Sides.data(); }
  /// The side that all points of a block have, or Mixed. Where the field's sign belongs to an axis,
  /// any other than Mixed where no line may be.
  Side GetSideOfBlock(Index block) const { return this->BlockSides[block]; }
  ///@}

  /// @name The test
  /// The definition's, and where points are in doubt what is left of it: the strength fades out
  /// while the doubt grows to 1.
  ///@{
  bool HasTest() const;
  void RequireTest(Index point)
  {
    this->TestPoints[point].store(1, std::memory_order_relaxed);
    this->TestBlocks[point / LineClusters::PointsOfBlock].store(1, std::memory_order_relaxed);
  }
  /// Forgets what was required. Evaluates the field around the points where it is to have a
  /// maximum.
  void EvaluateTests();
  float GetTest(Index point) const { return this->Test[point]; }
  ///@}

private:
  using Flags = std::unique_ptr<std::atomic<unsigned char>[]>;

  void EvaluateSpan(Index begin, Index end);
  void SetAxes(Index begin, Index end);
  void SetBlockSide(Index begin, Index end);
  void RequireAroundTests();
  std::size_t TakeTestPoints(Index block, Index* points);
  void EvaluateTests(const Index* points, std::size_t count);

  const LineSurface& Surface;
  const LineClusters& Clusters;
  const vtkNPRLineDefinition* Definition = nullptr;
  LineView View;
  const std::vector<float>* Levels = nullptr;
  const float* Doubts = nullptr;
  std::unique_ptr<FieldAxes> Axes;
  const Index NumberOfPoints;
  const Index NumberOfBlocks;
  Flags Blocks;     // 1 required, 2 evaluated
  Flags TestBlocks; // whether any of their points has a flag
  Flags TestPoints;
  AlignedVector<float> Field;
  AlignedVector<Side> Sides;
  std::vector<Side> BlockSides;
  AlignedVector<float> Test;
  AlignedVector<AxisPoint> AxisPoints;
};
}

#endif
