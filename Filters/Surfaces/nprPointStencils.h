// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprPointStencils.h
 * @brief New points as weighted sums of old ones, and their arrays with them.
 */
#ifndef nprPointStencils_h
#define nprPointStencils_h

#include "nprTriangleMesh.h"
#include "nprVTKCompat.h"

#include <vtkSmartPointer.h>

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkAbstractArray;
class vtkDataSetAttributes;
VTK_ABI_NAMESPACE_END

namespace npr
{
/// For each new point the old points that it comes from. Weights sum up to 1, and may be negative.
struct PointStencils
{
  std::vector<vtkIdType> Offsets{ 0 }; ///< one more than new points
  std::vector<TriangleMesh::Index> Points;
  std::vector<double> Weights;

  vtkIdType GetNumberOfPoints() const { return static_cast<vtkIdType>(this->Offsets.size()) - 1; }
  /// A part of the point that comes next.
  void Add(TriangleMesh::Index point, double weight)
  {
    this->Points.push_back(point);
    this->Weights.push_back(weight);
  }
  /// Ends the point.
  void Close() { this->Offsets.push_back(static_cast<vtkIdType>(this->Points.size())); }
};

/// The array at the new points: weighted sums of real numbers and bytes (rounded, and kept within
/// their range); of others, such as ids and names, the value of the heaviest of the old points.
vtkSmartPointer<vtkAbstractArray> ApplyStencils(
  vtkAbstractArray* array, const PointStencils& stencils);

/// All arrays, with what is active.
void ApplyStencils(
  vtkDataSetAttributes* input, const PointStencils& stencils, vtkDataSetAttributes* output);
}

#endif
