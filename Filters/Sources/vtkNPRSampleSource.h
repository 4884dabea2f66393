// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPRSampleSource
 * @brief The sample of the project: a garden snail, made from formulas.
 *
 * One closed surface of triangles without holes (Euler characteristic 2), facing outwards, with
 * exact normals, the same on every run and for any number of threads. It creeps on the plane y = 0
 * towards +x, y is up, and about four units long. A camera that looks along -z sees its right side
 * in profile, with the spiral of the shell; one from (0.5, 0.4, 1) shows it best.
 *
 * The shell is a tube around a conical logarithmic spiral with growth lines; the body is ellipsoids
 * joined smoothly, with furrows. The field of both is sampled on a grid, its zero set is
 * taken by flying edges, and the points are relaxed along the surface while Newton's steps hold
 * them on it, so that the triangles are even and nothing of the grid shows.
 *
 * The cell array RegionId (integers) tells its parts: 0 the shell, 1 the body, 2 the four horns.
 * The point array DistanceFromApex (floats) has the distance from the tip of the shell.
 *
 * @sa vtkNPRModelImporter
 */
#ifndef vtkNPRSampleSource_h
#define vtkNPRSampleSource_h

#include "vtkNPRFiltersSourcesModule.h"
#include <vtkPolyDataAlgorithm.h>

class VTKNPRFILTERSSOURCES_EXPORT vtkNPRSampleSource : public vtkPolyDataAlgorithm
{
public:
  static vtkNPRSampleSource* New();
  vtkTypeMacro(vtkNPRSampleSource, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// @name Resolution
  /// Grid cells over the snail's length, 120 to 1000; triangles grow with its square. Below 120 the
  /// feelers would come off. Default is 320, about 200 000 triangles.
  ///@{
  vtkSetClampMacro(Resolution, int, 120, 1000);
  vtkGetMacro(Resolution, int);
  ///@}

protected:
  vtkNPRSampleSource();
  ~vtkNPRSampleSource() override;

  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  int Resolution = 320;

private:
  vtkNPRSampleSource(const vtkNPRSampleSource&) = delete;
  void operator=(const vtkNPRSampleSource&) = delete;
};

#endif
