// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRParabolicLines.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkNPRParabolicLines);

//------------------------------------------------------------------------------
vtkNPRParabolicLines::vtkNPRParabolicLines()
  : Superclass(
      "least gradient of the Gaussian curvature, times length scale cubed", 5.0, 10.0, 0.05, 0.3)
{
}
