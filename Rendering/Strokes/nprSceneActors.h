// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprSceneActors_h
#define nprSceneActors_h

#include <vtkActor.h>
#include <vtkAssemblyNode.h>
#include <vtkAssemblyPath.h>
#include <vtkPropCollection.h>
#include <vtkRenderer.h>

namespace npr
{
/// Calls `visit(actor, matrix)` for each visible actor with a mapper, parts of assemblies too. The
/// matrix, which takes the actor to the world, does not outlast the call.
template<typename Visit>
void VisitActors(vtkRenderer* renderer, const Visit& visit)
{
  vtkPropCollection* const props = renderer->GetViewProps();
  vtkCollectionSimpleIterator next;
  props->InitTraversal(next);
  while (vtkProp* const prop = props->GetNextProp(next))
  {
    if (!prop->GetVisibility())
    {
      continue;
    }
    prop->InitPathTraversal();
    while (vtkAssemblyPath* const path = prop->GetNextPath())
    {
      vtkAssemblyNode* const node = path->GetLastNode();
      auto* const actor = vtkActor::SafeDownCast(node->GetViewProp());
      if (actor && actor->GetVisibility() && actor->GetMapper())
      {
        visit(actor, node->GetMatrix());
      }
    }
  }
}
}

#endif
