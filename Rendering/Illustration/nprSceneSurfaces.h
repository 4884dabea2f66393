// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprSceneSurfaces_h
#define nprSceneSurfaces_h

#include <vtkAlgorithmOutput.h>
#include <vtkMapper.h>
#include <vtkMatrix4x4.h>
#include <vtkPlane.h>
#include <vtkSmartPointer.h>

#include <memory>
#include <vector>

class vtkAlgorithm;
class vtkNPRStrokeVisibility;
class vtkRenderer;

namespace npr
{
class ActorIllustration;

/**
 * @class SceneSurfaces
 * @brief The surfaces of a renderer that hide strokes: those of all opaque actors that are shown as
 * surfaces, illustrated or not, parts of assemblies too.
 */
class SceneSurfaces
{
public:
  using Actors = std::vector<std::unique_ptr<ActorIllustration>>;

  /// Gives them to a filter, always the same. Its surfaces are only exchanged when others are
  /// shown; it keeps up with their data and matrices by itself until then.
  /// @param clipped whether what the mappers' clipping planes cut away does not hide
  void GiveTo(
    vtkNPRStrokeVisibility* visibility, const Actors& actors, vtkRenderer* renderer, bool clipped);

private:
  struct Surface
  {
    vtkSmartPointer<vtkAlgorithmOutput> Port;
    vtkSmartPointer<vtkMapper> Converted; // whose input is no vtkPolyData; else null
    std::vector<vtkSmartPointer<vtkPlane>> Planes;
    // A copy: that of a part of an assembly does not last.
    vtkSmartPointer<vtkMatrix4x4> Matrix;

    bool IsSameAs(const Surface& other) const
    {
      return this->Port == other.Port && this->Converted == other.Converted &&
        this->Planes == other.Planes;
    }
  };
  static std::vector<Surface> Gather(const Actors& actors, vtkRenderer* renderer, bool clipped);
  static vtkSmartPointer<vtkAlgorithm> MakeClipped(
    vtkAlgorithmOutput* port, const Surface& surface);

  std::vector<Surface> Surfaces;
};
}

#endif
