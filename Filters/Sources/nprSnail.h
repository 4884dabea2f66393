// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprSnail_h
#define nprSnail_h

#include <Eigen/Core>

namespace npr
{
/// The box that the snail lies in, with some room around.
inline constexpr double SnailBounds[6] = { -2.0, 2.2, -0.1, 1.9, -0.85, 0.95 };

/// Nowhere does SnailField() change faster than this, over the distance.
inline constexpr double SnailLipschitz = 2.0;

/**
 * A garden snail as a scalar field: negative inside, positive outside, about the distance from the
 * surface near it. Twice continuously differentiable there. It creeps on the plane y = 0 towards
 * +x; its right side, with the apex of the shell, faces +z. It is about four units long.
 */
double SnailField(const Eigen::Vector3d& point);

/// The snail's parts, by their numbers.
enum class SnailPart
{
  Shell,
  Body,
  Horns
};
/// Of a point on the surface.
SnailPart FindSnailPart(const Eigen::Vector3d& point);

/// How far a point is from the apex of the shell.
double GetDistanceFromApex(const Eigen::Vector3d& point);
}

#endif
