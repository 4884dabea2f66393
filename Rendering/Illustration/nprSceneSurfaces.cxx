// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprSceneSurfaces.h"

#include "nprActorIllustration.h"
#include "nprSceneActors.h"
#include "nprSurfaceSource.h"
#include "vtkNPRStrokeMapper.h"
#include "vtkNPRStrokeVisibility.h"

#include <vtkClipPolyData.h>
#include <vtkImplicitBoolean.h>
#include <vtkMatrixToLinearTransform.h>
#include <vtkPlaneCollection.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>

#include <algorithm>

namespace npr
{
namespace
{
bool IsHiding(vtkActor* actor)
{
  return !vtkNPRStrokeMapper::SafeDownCast(actor->GetMapper()) &&
    actor->GetMapper()->GetNumberOfInputConnections(0) > 0 &&
    actor->GetProperty()->GetRepresentation() == VTK_SURFACE &&
    !actor->HasTranslucentPolygonalGeometry();
}

std::vector<vtkSmartPointer<vtkPlane>> GetPlanes(vtkMapper* mapper)
{
  std::vector<vtkSmartPointer<vtkPlane>> planes;
  if (vtkPlaneCollection* const collection = mapper->GetClippingPlanes())
  {
    vtkCollectionSimpleIterator next;
    collection->InitTraversal(next);
    while (vtkPlane* const plane = collection->GetNextPlane(next))
    {
      planes.emplace_back(plane);
    }
  }
  return planes;
}
}

//------------------------------------------------------------------------------
std::vector<SceneSurfaces::Surface> SceneSurfaces::Gather(
  const Actors& actors, vtkRenderer* renderer, bool clipped)
{
  std::vector<Surface> surfaces;
  VisitActors(renderer,
    [&](vtkActor* actor, vtkMatrix4x4* matrix)
    {
      if (!IsHiding(actor))
      {
        return;
      }
      vtkMapper* const mapper = actor->GetMapper();
      Surface surface;
      const auto found = std::find_if(actors.begin(), actors.end(),
        [actor](const auto& ours) { return ours->GetActor() == actor && ours->IsShown(); });
      if (found != actors.end())
      {
        // What is shown may be another surface, for its texture; lines lie on this one.
        surface.Port = (*found)->GetPipeline().GetSurfacePort();
      }
      else
      {
        mapper->GetInputAlgorithm()->Update();
        surface.Port = mapper->GetInputConnection(0, 0);
        surface.Converted =
          vtkPolyData::SafeDownCast(mapper->GetInputDataObject(0, 0)) ? nullptr : mapper;
      }
      if (clipped)
      {
        surface.Planes = GetPlanes(mapper);
      }
      surface.Matrix = vtkSmartPointer<vtkMatrix4x4>::New();
      surface.Matrix->DeepCopy(matrix);
      surfaces.push_back(surface);
    });
  return surfaces;
}

//------------------------------------------------------------------------------
// What is on the positive side of all planes, which are in the world.
vtkSmartPointer<vtkAlgorithm> SceneSurfaces::MakeClipped(
  vtkAlgorithmOutput* port, const Surface& surface)
{
  vtkNew<vtkMatrixToLinearTransform> toWorld;
  toWorld->SetInput(surface.Matrix);
  vtkNew<vtkImplicitBoolean> inside;
  inside->SetOperationTypeToUnion(); // the least of the values
  inside->SetTransform(toWorld);
  for (vtkPlane* const plane : surface.Planes)
  {
    inside->AddFunction(plane);
  }
  auto clip = vtkSmartPointer<vtkClipPolyData>::New();
  clip->SetInputConnection(port);
  clip->SetClipFunction(inside);
  return clip;
}

//------------------------------------------------------------------------------
void SceneSurfaces::GiveTo(
  vtkNPRStrokeVisibility* visibility, const Actors& actors, vtkRenderer* renderer, bool clipped)
{
  const std::vector<Surface> wanted = Gather(actors, renderer, clipped);
  const auto isSame = [](const Surface& a, const Surface& b) { return a.IsSameAs(b); };
  if (visibility->GetNumberOfSurfaces() > 0 &&
    std::equal(wanted.begin(), wanted.end(), this->Surfaces.begin(), this->Surfaces.end(), isSame))
  {
    for (std::size_t i = 0; i < wanted.size(); ++i)
    {
      vtkMatrix4x4* const matrix = this->Surfaces[i].Matrix;
      if (!std::equal(matrix->GetData(), matrix->GetData() + 16, wanted[i].Matrix->GetData()))
      {
        matrix->DeepCopy(wanted[i].Matrix);
      }
    }
    return;
  }
  this->Surfaces = wanted;
  visibility->RemoveAllSurfaces();
  for (const Surface& surface : this->Surfaces)
  {
    const auto source = surface.Converted ? MakeSurfaceSource(surface.Converted) : nullptr;
    vtkAlgorithmOutput* port = surface.Port;
    if (surface.Converted)
    {
      if (!source)
      {
        continue;
      }
      port = source->GetOutputPort();
    }
    const auto clip = surface.Planes.empty() ? nullptr : MakeClipped(port, surface);
    visibility->AddSurfaceConnection(clip ? clip->GetOutputPort() : port, surface.Matrix);
  }
  if (visibility->GetNumberOfSurfaces() == 0)
  {
    vtkNew<vtkPolyData> nothing; // hides nothing
    visibility->AddSurfaceData(nothing);
  }
}
}
