// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprPostponedStrokes_h
#define nprPostponedStrokes_h

#include "nprVTKCompat.h"

#include <vtkActor.h>
#include <vtkRenderer.h>
#include <vtkWeakPointer.h>

#include <vector>

namespace npr
{
/// What a mapper still has to draw when everything else of a renderer is drawn.
struct PostponedStrokes
{
  std::vector<vtkWeakPointer<vtkActor>> Actors;
  vtkWeakPointer<vtkRenderer> Renderer;
  unsigned long Observer = 0;
};
}

#endif
