// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRSuggestiveContours.h"

#include "nprArrayNames.h"

#include <vtkMath.h>
#include <vtkObjectFactory.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Core>

vtkStandardNewMacro(vtkNPRSuggestiveContours);

namespace
{
// The components of a vector array.
struct Vectors
{
  const float* X;
  const float* Y;
  const float* Z;
  Vectors(const npr::LineSurface& surface, const char* name)
    : X(surface.GetComponent(name, 0)), Y(surface.GetComponent(name, 1)),
      Z(surface.GetComponent(name, 2))
  {
  }
  Eigen::Vector3f operator[](vtkIdType i) const { return { this->X[i], this->Y[i], this->Z[i] }; }
};
}

//------------------------------------------------------------------------------
vtkNPRSuggestiveContours::vtkNPRSuggestiveContours()
{
  this->AddParameter("threshold",
    "least derivative of the radial curvature, times length scale squared", this->Threshold, 0.0,
    1.0e6);
  this->AddParameter("fade", "how far above the threshold lines have their full strength",
    this->Fade, 1.0e-6, 1.0e6);
  this->AddParameter("minimumAngle", "least angle between normal and eye, in degrees",
    this->MinimumAngle, 0.0, 45.0);
  this->AddParameter("contourFade",
    "cosine of the angle between normal and eye where lines start to fade towards the contour",
    this->ContourFade, 1.0e-6, 1.0);
}

//------------------------------------------------------------------------------
std::vector<vtkNPRLineDefinition::RequiredArray> vtkNPRSuggestiveContours::GetRequiredArrays() const
{
  return { { npr::names::Normals, 3, "vtkNPRSurfaceNormals" },
    { npr::names::CurvatureTensor, 6, "vtkNPRCurvatureTensor" },
    { npr::names::PrincipalCurvature1, 1, "vtkNPRCurvatureTensor" },
    { npr::names::PrincipalCurvature2, 1, "vtkNPRCurvatureTensor" },
    { npr::names::PrincipalDirection1, 3, "vtkNPRCurvatureTensor" },
    { npr::names::PrincipalDirection2, 3, "vtkNPRCurvatureTensor" },
    { npr::names::CurvatureDerivatives, 4, "vtkNPRCurvatureTensor" } };
}

//------------------------------------------------------------------------------
void vtkNPRSuggestiveContours::EvaluateField(const npr::LineSurface& surface,
  const npr::LineView& view, vtkIdType begin, vtkIdType end, float* field) const
{
  const float* px = surface.GetCoordinate(0);
  const float* py = surface.GetCoordinate(1);
  const float* pz = surface.GetCoordinate(2);
  const Vectors n(surface, npr::names::Normals);
  const float* xx = surface.GetComponent(npr::names::CurvatureTensor, 0);
  const float* yy = surface.GetComponent(npr::names::CurvatureTensor, 1);
  const float* zz = surface.GetComponent(npr::names::CurvatureTensor, 2);
  const float* xy = surface.GetComponent(npr::names::CurvatureTensor, 3);
  const float* yz = surface.GetComponent(npr::names::CurvatureTensor, 4);
  const float* xz = surface.GetComponent(npr::names::CurvatureTensor, 5);
  const float s = view.Perspective;
  for (vtkIdType i = begin; i < end; ++i)
  {
    float x = view.Eye[0] - s * px[i];
    float y = view.Eye[1] - s * py[i];
    float z = view.Eye[2] - s * pz[i];
    // At the eye itself the direction is 0, and so is the field.
    const float square = x * x + y * y + z * z;
    const float scale = 1.0f / std::sqrt(square + std::numeric_limits<float>::min());
    x *= scale;
    y *= scale;
    z *= scale;
    const float cosine = n.X[i] * x + n.Y[i] * y + n.Z[i] * z;
    x -= cosine * n.X[i];
    y -= cosine * n.Y[i];
    z -= cosine * n.Z[i];
    field[i] = x * (xx[i] * x + 2.0f * xy[i] * y) + y * (yy[i] * y + 2.0f * yz[i] * z) +
      z * (zz[i] * z + 2.0f * xz[i] * x);
  }
}

//------------------------------------------------------------------------------
void vtkNPRSuggestiveContours::BoundField(
  const npr::LineSurface& surface, vtkIdType begin, vtkIdType end, signed char* sign) const
{
  // Where both principal curvatures have one sign, so has the curvature in every direction. The
  // margin is for the rounding in the tensor.
  const float* k1 = surface.GetComponent(npr::names::PrincipalCurvature1, 0);
  const float* k2 = surface.GetComponent(npr::names::PrincipalCurvature2, 0);
  for (vtkIdType i = begin; i < end; ++i)
  {
    const float margin = 1.0e-3f * std::abs(k1[i]);
    sign[i] = std::min(k1[i], k2[i]) > margin ? 1 : std::max(k1[i], k2[i]) < -margin ? -1 : 0;
  }
}

//------------------------------------------------------------------------------
void vtkNPRSuggestiveContours::EvaluateTest(const npr::LineSurface& surface,
  const npr::LineView& view, const Index* points, vtkIdType count, const float*, float* test) const
{
  const Vectors normals(surface, npr::names::Normals);
  const Vectors directions1(surface, npr::names::PrincipalDirection1);
  const Vectors directions2(surface, npr::names::PrincipalDirection2);
  const float* k1 = surface.GetComponent(npr::names::PrincipalCurvature1, 0);
  const float* k2 = surface.GetComponent(npr::names::PrincipalCurvature2, 0);
  const float* p = surface.GetComponent(npr::names::CurvatureDerivatives, 0);
  const float* q = surface.GetComponent(npr::names::CurvatureDerivatives, 1);
  const float* s = surface.GetComponent(npr::names::CurvatureDerivatives, 2);
  const float* t = surface.GetComponent(npr::names::CurvatureDerivatives, 3);
  const double square = surface.GetLengthScale() * surface.GetLengthScale();
  const double least = std::sin(vtkMath::RadiansFromDegrees(this->MinimumAngle));
  const Eigen::Vector3f eye(view.Eye[0], view.Eye[1], view.Eye[2]);

  for (vtkIdType j = 0; j < count; ++j)
  {
    const Index i = points[j];
    const Eigen::Vector3f point(
      surface.GetCoordinate(0)[i], surface.GetCoordinate(1)[i], surface.GetCoordinate(2)[i]);
    const Eigen::Vector3f v = (eye - view.Perspective * point).normalized();
    const Eigen::Vector3f n = normals[i];
    const double cosine = n.dot(v);
    const Eigen::Vector3f w = v - static_cast<float>(cosine) * n;
    const double sine = w.norm();
    const double headOn = least > 0.0 ? (sine - least) / least : 1.0;
    const double facing = std::min(headOn, cosine / this->ContourFade);
    if (facing <= 0.0)
    {
      test[j] = static_cast<float>(facing);
      continue;
    }
    const Eigen::Vector3f unit = w.normalized(); // 0 where there is no direction
    const double a = unit.dot(directions1[i]);
    const double b = unit.dot(directions2[i]);
    const double cubic = a * a * (a * p[i] + 3.0 * b * q[i]) + b * b * (3.0 * a * s[i] + b * t[i]);
    const double derivative = sine * cubic + 2.0 * double(k1[i]) * k2[i] * cosine;
    const double rise = (square * derivative - this->Threshold * sine) / this->Fade;
    // In this order a NaN stays.
    test[j] = static_cast<float>(facing < rise ? facing : rise);
  }
}
