// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprTangentFrame.h
 * @brief Tangent planes, the rotation from one to another, and symmetric tensors in space.
 *
 * In double precision: the surface may be as small as 1e-9, and products of its lengths must not
 * vanish. Tensors have the order XX YY ZZ XY YZ XZ, as everywhere in VTK.
 */
#ifndef nprTangentFrame_h
#define nprTangentFrame_h

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>

namespace npr
{
using SymmetricTensor = Eigen::Matrix<double, 6, 1>;

/// Two unit vectors with U x V = the unit normal they belong to.
struct TangentFrame
{
  Eigen::Vector3d U;
  Eigen::Vector3d V;
};

/// Some unit vector of the plane with unit normal n, always the same for the same n, without a
/// branch near which it would lose digits (Duff et al., "Building an Orthonormal Basis, Revisited",
/// JCGT 2017).
template<typename Real>
Eigen::Matrix<Real, 3, 1> MakeTangent(const Eigen::Matrix<Real, 3, 1>& n)
{
  const Real sign = std::copysign(Real(1), n.z());
  const Real a = Real(-1) / (sign + n.z());
  return { Real(1) + sign * n.x() * n.x() * a, sign * n.x() * n.y() * a, -sign * n.x() };
}

/// The frame of the plane with unit normal n that begins with MakeTangent(n).
inline TangentFrame MakeTangentFrame(const Eigen::Vector3d& n)
{
  const Eigen::Vector3d u = MakeTangent(n);
  return { u, n.cross(u) };
}

/// The rotation about from x to that takes the unit vector `from` to the unit vector `to`.
class MinimalRotation
{
public:
  MinimalRotation(const Eigen::Vector3d& from, const Eigen::Vector3d& to)
    : Axis(from.cross(to)), Cosine(from.dot(to))
  {
  }
  /// False where the vectors are all but opposite: then there is no one shortest way.
  bool IsValid() const { return this->Cosine > -0.99; }
  Eigen::Vector3d operator()(const Eigen::Vector3d& x) const
  {
    const Eigen::Vector3d turned = this->Axis.cross(x);
    return x + turned + this->Axis.cross(turned) / (1.0 + this->Cosine);
  }
  TangentFrame operator()(const TangentFrame& frame) const
  {
    return { (*this)(frame.U), (*this)(frame.V) };
  }

private:
  Eigen::Vector3d Axis;
  double Cosine;
};

/// a' T b.
inline double Evaluate(const SymmetricTensor& t, const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  return t[0] * a.x() * b.x() + t[1] * a.y() * b.y() + t[2] * a.z() * b.z() +
    t[3] * (a.x() * b.y() + a.y() * b.x()) + t[4] * (a.y() * b.z() + a.z() * b.y()) +
    t[5] * (a.x() * b.z() + a.z() * b.x());
}

/// The components UU, UV, VV of a tensor in a tangent frame.
inline Eigen::Vector3d ToFrame(const SymmetricTensor& t, const TangentFrame& frame)
{
  return { Evaluate(t, frame.U, frame.U), Evaluate(t, frame.U, frame.V),
    Evaluate(t, frame.V, frame.V) };
}

/// The tensor in space that has the components UU, UV, VV in a tangent frame.
inline SymmetricTensor FromFrame(const Eigen::Vector3d& components, const TangentFrame& frame)
{
  const Eigen::Vector3d a = components[0] * frame.U + components[1] * frame.V;
  const Eigen::Vector3d b = components[1] * frame.U + components[2] * frame.V;
  const Eigen::Vector3d& u = frame.U;
  const Eigen::Vector3d& v = frame.V;
  SymmetricTensor t;
  t << a.x() * u.x() + b.x() * v.x(), a.y() * u.y() + b.y() * v.y(), a.z() * u.z() + b.z() * v.z(),
    a.x() * u.y() + b.x() * v.y(), a.y() * u.z() + b.y() * v.z(), a.x() * u.z() + b.x() * v.z();
  return t;
}
}

#endif
