// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprShadingSteps_h
#define nprShadingSteps_h

#include <vtkSmartPointer.h>

#include <functional>

class vtkRenderPass;

namespace npr
{
/// The steps of a frame as VTK has them; `afterOpaque` is called between opaque and translucent
/// props.
vtkSmartPointer<vtkRenderPass> MakeShadingSteps(std::function<void()> afterOpaque);
}

#endif
