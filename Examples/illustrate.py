# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
# SPDX-License-Identifier: BSD-3-Clause
"""A technical illustration of a vtkPolyData, from Python, without a display."""
import sys

import vtknpr
from vtkmodules.vtkFiltersSources import vtkSuperquadricSource

source = vtkSuperquadricSource()
source.ToroidalOn()
source.SetThetaResolution(128)
source.SetPhiResolution(128)
source.Update()
vtknpr.render(source.GetOutput(), sys.argv[1] if len(sys.argv) > 1 else "illustrate.png", style="technical")
