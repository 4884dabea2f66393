// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprImplicitCurvature.h
 * @brief Normal, second fundamental form and its derivative of the level sets of a function.
 */
#ifndef nprImplicitCurvature_h
#define nprImplicitCurvature_h

#include "vtkNPRFiltersCurvatureModule.h"

#include <Eigen/Core>

#include <functional>

namespace npr
{
/// What the level set through a point does there. Form (UU, UV, VV) and Cubic (UUU, UUV, UVV, VVV)
/// refer to MakeTangentFrame(Normal).
struct LevelSetJet
{
  Eigen::Vector3d Normal;
  Eigen::Vector3d Form;
  Eigen::Vector4d Cubic;
};

/**
 * With the gradient g, n = g / |g| and B = Hessian / |g|, the form is B in the tangent plane, and
 * its covariant derivative
 *
 *     C(x,y,z) = D3F(x,y,z) / |g| - B(x,y) B(n,z) - B(x,z) B(n,y) - B(y,z) B(n,x).
 *
 * Second and third derivatives are central differences of fourth order of the gradient along two
 * tangents, from nine gradients in all: their error is that of rounding divided by the step (the
 * form) and its square (C), and grows with the fourth power of the step where the function is no
 * quadric.
 *
 * @param gradient of the function; towards the outside
 * @param step of the differences; length
 * @return false where the gradient vanishes, is not finite, or turns so fast that its direction
 * says nothing at the size of the step
 */
VTKNPRFILTERSCURVATURE_EXPORT bool ComputeLevelSetJet(
  const std::function<Eigen::Vector3d(const Eigen::Vector3d&)>& gradient,
  const Eigen::Vector3d& point, double step, LevelSetJet& jet);
}

#endif
