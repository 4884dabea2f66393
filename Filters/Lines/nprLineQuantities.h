// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprLineQuantities_h
#define nprLineQuantities_h

#include "nprLineChains.h"
#include "nprLineSurface.h"
#include "nprLineView.h"
#include "nprViewQuantities.h"
#include "vtkNPRFiltersLinesModule.h"

#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkFloatArray;
VTK_ABI_NAMESPACE_END

namespace npr
{
/**
 * @class LineQuantity
 * @brief What the points of lines carry of the surface they are on: a view quantity, or a point
 * array of the surface. Linear in each triangle.
 */
class VTKNPRFILTERSLINES_EXPORT LineQuantity
{
public:
  /// A view quantity of the name, or if there is none a point array, which the surface must load.
  explicit LineQuantity(const std::string& name);

  const std::string& GetName() const { return this->Name; }
  bool IsViewDependent() const { return this->Quantity && this->Quantity->ViewDependent; }
  /// The arrays that the surface must load.
  std::vector<vtkNPRLineDefinition::RequiredArray> GetRequiredArrays() const;
  int GetNumberOfComponents(const LineSurface& surface) const;

  /// Writes the values at the vertices of a chain from a point of the array on.
  void Write(const LineSurface& surface, const LineView& view, const LineChains& chains,
    std::size_t chain, vtkIdType firstPoint, vtkFloatArray* values) const;

private:
  std::string Name;
  const ViewQuantity* Quantity;
};
}

#endif
