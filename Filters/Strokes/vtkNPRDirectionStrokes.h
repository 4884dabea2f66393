// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPRDirectionStrokes
 * @brief Covers a surface with short strokes along a field of directions, as an illustrator
 * hatches.
 *
 * The field is a point array of 3 components, by default PrincipalDirection1
 * (SetInputArrayToProcess(0, ...)). Its vectors are axes: their signs play no part. Strokes follow
 * it along the surface from triangle to triangle, and end where neighbours disagree by more than 45
 * degrees, at borders and creases, and where they would come too near to another stroke on the same
 * side of the surface.
 *
 * A point array named by StrengthArray, in [0, 1], says where there shall be strokes: there are
 * none where it is below 0.05. Without it they are everywhere, with strength 1.
 *
 * Output: polylines with the point arrays `Strength`, which falls to 0 at the ends, so that strokes
 * can taper, and `Normals`, those of the triangles. The result depends on nothing but the input and
 * the parameters.
 *
 * @par Thanks:
 * The spacing of streamlines: B. Jobard, W. Lefer: Creating Evenly-Spaced Streamlines of Arbitrary
 * Density, 1997.
 *
 * @sa vtkNPRCurvatureTensor vtkNPRStrokeMapper
 */
#ifndef vtkNPRDirectionStrokes_h
#define vtkNPRDirectionStrokes_h

#include "vtkNPRFiltersStrokesModule.h"
#include <vtkPolyDataAlgorithm.h>

class VTKNPRFILTERSSTROKES_EXPORT vtkNPRDirectionStrokes : public vtkPolyDataAlgorithm
{
public:
  static vtkNPRDirectionStrokes* New();
  vtkTypeMacro(vtkNPRDirectionStrokes, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Distance between strokes, as a fraction of the surface's length scale, [1e-4, 1]. Strokes may
   * come as near as half of it before they end. Default: 0.04.
   */
  vtkSetClampMacro(Spacing, double, 1e-4, 1.0);
  vtkGetMacro(Spacing, double);
  ///@}

  ///@{
  /** Length of the longest strokes, in Spacings, [0.5, 1000]. Default: 6. */
  vtkSetClampMacro(Length, double, 0.5, 1000.0);
  vtkGetMacro(Length, double);
  ///@}

  ///@{
  /** Point array that says where strokes are wanted. Default: none. */
  vtkSetStringMacro(StrengthArray);
  vtkGetStringMacro(StrengthArray);
  ///@}

protected:
  vtkNPRDirectionStrokes();
  ~vtkNPRDirectionStrokes() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  double Spacing = 0.04;
  double Length = 6.0;
  char* StrengthArray = nullptr;

private:
  vtkNPRDirectionStrokes(const vtkNPRDirectionStrokes&) = delete;
  void operator=(const vtkNPRDirectionStrokes&) = delete;
};

#endif
