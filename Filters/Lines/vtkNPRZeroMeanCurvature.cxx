// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRZeroMeanCurvature.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkNPRZeroMeanCurvature);

//------------------------------------------------------------------------------
vtkNPRZeroMeanCurvature::vtkNPRZeroMeanCurvature()
  : Superclass(
      "least gradient of the mean curvature, times length scale squared", 2.0, 4.0, 0.02, 0.3)
{
}
