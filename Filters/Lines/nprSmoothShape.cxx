// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprSmoothShape.h"

#include "nprArrayNames.h"
#include "nprSurfaceDiffusion.h"

#include <algorithm>
#include <complex>

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
    Tensors(GetTuples<6>(surface, names::CurvatureTensor)), IsNumber(Tensors.size()),
    Radius(smoothing * surface.GetLengthScale())
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
  this->Diffusion = std::make_unique<SurfaceDiffusion>(mesh, this->Normals);
  this->Diffusion->SmoothTensors(this->Tensors, this->Radius);
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
    this->Diffusion->SmoothNormals(smooth, this->Radius);
    for (std::size_t i = 0; i < smooth.size(); ++i)
    {
      this->Normals[i] = this->IsNumber[i] ? smooth[i] : this->Normals[i];
    }
  }
}

//------------------------------------------------------------------------------
SmoothShape::~SmoothShape() = default;

//------------------------------------------------------------------------------
void SmoothShape::Smooth(std::vector<float>& values, double radius) const
{
  if (!this->Diffusion)
  {
    return;
  }
  SurfaceDiffusion::Field field(values.begin(), values.end());
  this->Diffusion->Smooth(field, 0, radius * this->Radius);
  std::transform(field.begin(), field.end(), values.begin(),
    [](const std::complex<float>& value) { return value.real(); });
}
}
