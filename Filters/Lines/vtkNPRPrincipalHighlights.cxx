// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRPrincipalHighlights.h"

#include "nprArrayNames.h"
#include "nprLanes.h"

#include <vtkObjectFactory.h>

#include <array>
#include <cmath>
#include <limits>

vtkStandardNewMacro(vtkNPRPrincipalHighlights);

namespace
{
// The product of the unit vector to the eye and a vector array.
class EyeProduct
{
public:
  EyeProduct(const npr::LineSurface& surface, const npr::LineView& view, const char* vectors)
    : View(view)
  {
    for (int i = 0; i < 3; ++i)
    {
      this->Points[i] = surface.GetCoordinate(i);
      this->Vectors[i] = surface.GetComponent(vectors, i);
    }
  }

  float operator()(vtkIdType i) const
  {
    float product = 0.0f;
    // At the eye itself the direction is 0.
    float square = std::numeric_limits<float>::min();
    for (int axis = 0; axis < 3; ++axis)
    {
      const float x = this->View.Eye[axis] - this->View.Perspective * this->Points[axis][i];
      square += x * x;
      product += x * this->Vectors[axis][i];
    }
    return product / npr::SquareRoot(square);
  }

private:
  const npr::LineView View;
  std::array<const float*, 3> Points;
  std::array<const float*, 3> Vectors;
};
}

//------------------------------------------------------------------------------
vtkNPRPrincipalHighlights::vtkNPRPrincipalHighlights()
{
  this->AddParameter("threshold",
    "least difference of the curvatures' squares, times the cosine of the angle between normal and "
    "eye and the length scale squared",
    this->Threshold, 0.0, 1.0e6);
  this->AddParameter("fade", "how far above the threshold lines have their full strength",
    this->Fade, 1.0e-6, 1.0e6);
  this->AddParameter(
    "side", "1 for crests only, -1 for folds only, 0 for both", this->Side, -1.0, 1.0);
}

//------------------------------------------------------------------------------
std::vector<vtkNPRLineDefinition::RequiredArray> vtkNPRPrincipalHighlights::GetRequiredArrays()
  const
{
  return { { npr::names::Normals, 3, "vtkNPRSurfaceNormals" },
    { npr::names::PrincipalCurvature1, 1, "vtkNPRCurvatureTensor" },
    { npr::names::PrincipalCurvature2, 1, "vtkNPRCurvatureTensor" },
    { npr::names::PrincipalDirection1, 3, "vtkNPRCurvatureTensor" } };
}

//------------------------------------------------------------------------------
const char* vtkNPRPrincipalHighlights::GetAxes() const
{
  return npr::names::PrincipalDirection1;
}

//------------------------------------------------------------------------------
void vtkNPRPrincipalHighlights::EvaluateField(const npr::LineSurface& surface,
  const npr::LineView& view, vtkIdType begin, vtkIdType end, float* field) const
{
  const EyeProduct sine(surface, view, npr::names::PrincipalDirection1);
  for (vtkIdType i = begin; i < end; ++i)
  {
    field[i] = sine(i);
  }
}

//------------------------------------------------------------------------------
void vtkNPRPrincipalHighlights::EvaluateTest(const npr::LineSurface& surface,
  const npr::LineView& view, const Index* points, vtkIdType count, const float*, float* test) const
{
  const EyeProduct cosine(surface, view, npr::names::Normals);
  const float* k1 = surface.GetComponent(npr::names::PrincipalCurvature1, 0);
  const float* k2 = surface.GetComponent(npr::names::PrincipalCurvature2, 0);
  const double scale = surface.GetLengthScale();
  for (vtkIdType j = 0; j < count; ++j)
  {
    const Index i = points[j];
    const double first = scale * k1[i];
    const double second = scale * k2[i];
    const double difference = first * first - second * second;
    // The wrong side counts as back faces do. Where the first curvature changes its sign the two
    // are as large as each other, so this does not jump.
    const double facing = this->Side * first < 0.0 ? -std::abs(cosine(i)) : cosine(i);
    test[j] = static_cast<float>((facing * difference - this->Threshold) / this->Fade);
  }
}
