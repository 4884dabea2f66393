// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPRSurfaceOrder
 * @brief Puts a surface's points and polygons into an order in which neighbours lie close together
 * in memory.
 *
 * Polygons are sorted along a Hilbert curve by the means of their corners, points by their first
 * use, points without a cell last. The surface stays the same, but everything that walks over it
 * does so with fewer misses of the processor's caches: it pays for meshes from tools that shuffle
 * (merging, sorting, streaming), hardly for those from a scanner or a marching-cubes filter, which
 * come in some order of space. Vertices, lines and strips keep their order, and get the new points.
 *
 * All point and cell arrays go with their points and cells; WeldedPointIds are renumbered. The
 * result does not depend on the order of the input but where polygons have the same mean.
 *
 * @sa vtkNPRSurfacePreparation
 */
#ifndef vtkNPRSurfaceOrder_h
#define vtkNPRSurfaceOrder_h

#include "vtkNPRFiltersSurfacesModule.h"
#include <vtkPolyDataAlgorithm.h>

class VTKNPRFILTERSSURFACES_EXPORT vtkNPRSurfaceOrder : public vtkPolyDataAlgorithm
{
public:
  static vtkNPRSurfaceOrder* New();
  vtkTypeMacro(vtkNPRSurfaceOrder, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkNPRSurfaceOrder();
  ~vtkNPRSurfaceOrder() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkNPRSurfaceOrder(const vtkNPRSurfaceOrder&) = delete;
  void operator=(const vtkNPRSurfaceOrder&) = delete;
};

#endif
