// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprSurfaceSource_h
#define nprSurfaceSource_h

#include <vtkSmartPointer.h>

class vtkAlgorithm;
class vtkMapper;

namespace npr
{
/// What gives the surface of a mapper's input where that is no vtkPolyData; null where it is one,
/// or nothing with a surface.
vtkSmartPointer<vtkAlgorithm> MakeSurfaceSource(vtkMapper* mapper);
}

#endif
