// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprSmoothShape.h"

#include "nprArrayNames.h"
#include "nprSurfaceDiffusion.h"

namespace npr
{
namespace
{
template<int Size>
Tuples<Size> GetTuples(const LineSurface& surface, const char* name)
{
  Tuples<Size> tuples(surface.GetMesh().GetNumberOfPoints());
  for (int c = 0; c < Size; ++c)
  {
    const float* component = surface.GetComponent(name, c);
    for (std::size_t i = 0; i < tuples.size(); ++i)
    {
      tuples[i][c] = component[i];
    }
  }
  return tuples;
}
}

//------------------------------------------------------------------------------
SmoothShape::SmoothShape(const LineSurface& surface, double smoothing, bool withNormals)
  : Normals(GetTuples<3>(surface, names::Normals)),
    Tensors(GetTuples<6>(surface, names::CurvatureTensor)), IsNumber(Tensors.size())
{
  const double scale = surface.GetLengthScale();
  for (std::size_t i = 0; i < this->Tensors.size(); ++i)
  {
    // Without a unit, so that nothing vanishes on huge surfaces.
    this->Tensors[i] *= static_cast<float>(scale);
    this->IsNumber[i] = this->Tensors[i].allFinite() && this->Normals[i].allFinite();
    if (!this->IsNumber[i])
    {
      this->Tensors[i].setZero();
    }
  }
  if (!(smoothing > 0.0))
  {
    return;
  }
  TriangleMesh mesh = surface.GetMesh();
  mesh.BuildIncidence();
  const SurfaceDiffusion diffusion(mesh, this->Normals);
  diffusion.SmoothTensors(this->Tensors, smoothing * scale);
  if (withNormals)
  {
    Tuples<3> smooth = this->Normals;
    for (std::size_t i = 0; i < smooth.size(); ++i)
    {
      if (!this->IsNumber[i])
      {
        smooth[i].setZero();
      }
    }
    diffusion.SmoothNormals(smooth, smoothing * scale);
    for (std::size_t i = 0; i < smooth.size(); ++i)
    {
      this->Normals[i] = this->IsNumber[i] ? smooth[i] : this->Normals[i];
    }
  }
}
}
