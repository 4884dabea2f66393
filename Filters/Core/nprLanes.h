// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprLanes.h
 * @brief Several floats that are worked on at once, and small vectors of them or of single ones.
 *
 * Kernels are templates over Real, which is float or Lanes; instead of branches they have
 * `condition ? a : b`, which chooses for each lane.
 */
#ifndef nprLanes_h
#define nprLanes_h

#include <cmath>
#include <cstdint>
#include <cstring>

#if defined(__SSE__)
#include <xmmintrin.h>
#endif

namespace npr
{
#if defined(__GNUC__)
using Lanes = float __attribute__((vector_size(16)));
constexpr int NumberOfLanes = 4;

inline Lanes SquareRoot(Lanes x)
{
#if defined(__SSE__)
  // Rounded as it must be, on every processor; libraries may take an estimate and improve it.
  return reinterpret_cast<Lanes>(_mm_sqrt_ps(reinterpret_cast<__m128>(x)));
#else
  Lanes root;
  for (int i = 0; i < NumberOfLanes; ++i)
  {
    root[i] = std::sqrt(x[i]);
  }
  return root;
#endif
}

/// -1 for negative numbers and the negative zero, else 1.
inline Lanes SignOf(Lanes x)
{
  using Bits = std::int32_t __attribute__((vector_size(16)));
  const Bits sign = reinterpret_cast<Bits>(x) & INT32_MIN;
  return reinterpret_cast<Lanes>(sign | 0x3f800000); // the bits of 1
}
#else
using Lanes = float;
constexpr int NumberOfLanes = 1;
#endif

/// Starts to load what will be read soon.
inline void Prefetch(const void* address)
{
#if defined(__GNUC__)
  __builtin_prefetch(address);
#else
  (void)address;
#endif
}

inline float SquareRoot(float x)
{
  return std::sqrt(x);
}
inline float SignOf(float x)
{
  return std::copysign(1.0f, x);
}

/// As many values as there are lanes.
template<typename Real>
Real Load(const float* values)
{
  Real loaded;
  std::memcpy(&loaded, values, sizeof(loaded));
  return loaded;
}
template<typename Real>
void Store(const Real& stored, float* values)
{
  std::memcpy(values, &stored, sizeof(stored));
}

/// @name The same for the last values of a span, which are fewer; other lanes are 0.
///@{
template<typename Real>
Real LoadFirst(const float* values, int count)
{
  Real loaded = {};
  std::memcpy(&loaded, values, count * sizeof(float));
  return loaded;
}
template<typename Real>
void StoreFirst(const Real& stored, float* values, int count)
{
  std::memcpy(values, &stored, count * sizeof(float));
}
///@}

/// A vector in space.
template<typename Real>
struct Vector3
{
  Real X;
  Real Y;
  Real Z;
};

template<typename Real>
Vector3<Real> operator-(const Vector3<Real>& a, const Vector3<Real>& b)
{
  return { a.X - b.X, a.Y - b.Y, a.Z - b.Z };
}
template<typename Real>
Vector3<Real> operator*(const Vector3<Real>& a, const Real& factor)
{
  return { a.X * factor, a.Y * factor, a.Z * factor };
}
template<typename Real>
Real Dot(const Vector3<Real>& a, const Vector3<Real>& b)
{
  return a.X * b.X + a.Y * b.Y + a.Z * b.Z;
}
template<typename Real>
Vector3<Real> Cross(const Vector3<Real>& a, const Vector3<Real>& b)
{
  return { a.Y * b.Z - a.Z * b.Y, a.Z * b.X - a.X * b.Z, a.X * b.Y - a.Y * b.X };
}
}

#endif
