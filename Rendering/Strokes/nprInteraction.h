// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprInteraction_h
#define nprInteraction_h

#include <vtkRenderWindow.h>

namespace npr
{
/// Whether something in a window moves: interactors then ask for some frames a second, and for a
/// still picture for one in an hour.
inline bool IsInteractive(vtkRenderWindow* window)
{
  return window->GetDesiredUpdateRate() >= 1.0;
}
}

#endif
