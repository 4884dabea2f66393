// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprPaperStrokes_h
#define nprPaperStrokes_h

#include <memory>
#include <string>
#include <vector>

class vtkPolyData;

namespace npr
{
class ActorIllustration;

/// The strokes of all actors of an illustration, along the parts of their lines, in one set for a
/// drawing on paper.
/// @param lineNames of the lines that the style draws
void CollectStrokes(const std::vector<std::unique_ptr<ActorIllustration>>& actors,
  const std::vector<std::string>& lineNames, vtkPolyData* strokes);
}

#endif
