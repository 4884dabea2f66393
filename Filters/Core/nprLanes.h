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

#include <array>
#include <cmath>
#include <cstddef>
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

/// A number for each lane: make(i) for lane i.
template<typename Make>
Lanes MakeLanes(const Make& make)
{
  return Lanes{ make(0), make(1), make(2), make(3) };
}

/// A sum of lanes in double precision.
class LaneSum
{
public:
  void Add(Lanes x)
  {
    using Floats = float __attribute__((vector_size(8)));
    this->Low += __builtin_convertvector(Floats{ x[0], x[1] }, Doubles);
    this->High += __builtin_convertvector(Floats{ x[2], x[3] }, Doubles);
  }
  double Get() const { return (this->Low[0] + this->Low[1]) + (this->High[0] + this->High[1]); }

private:
  using Doubles = double __attribute__((vector_size(16)));
  Doubles Low = {};
  Doubles High = {};
};

/// Four rows of four numbers as four columns.
inline std::array<Lanes, 4> LoadColumns(const std::array<const float*, 4>& rows)
{
  std::array<Lanes, 4> r;
  for (int i = 0; i < 4; ++i)
  {
    std::memcpy(&r[i], rows[i], sizeof(Lanes));
  }
  const Lanes low01 = __builtin_shufflevector(r[0], r[1], 0, 4, 1, 5);
  const Lanes low23 = __builtin_shufflevector(r[2], r[3], 0, 4, 1, 5);
  const Lanes high01 = __builtin_shufflevector(r[0], r[1], 2, 6, 3, 7);
  const Lanes high23 = __builtin_shufflevector(r[2], r[3], 2, 6, 3, 7);
  return { __builtin_shufflevector(low01, low23, 0, 1, 4, 5),
    __builtin_shufflevector(low01, low23, 2, 3, 6, 7),
    __builtin_shufflevector(high01, high23, 0, 1, 4, 5),
    __builtin_shufflevector(high01, high23, 2, 3, 6, 7) };
}
#else
using Lanes = float;
constexpr int NumberOfLanes = 1;

template<typename Make>
Lanes MakeLanes(const Make& make)
{
  return make(0);
}

class LaneSum
{
public:
  void Add(Lanes x) { this->Total += x; }
  double Get() const { return this->Total; }

private:
  double Total = 0.0;
};

inline std::array<Lanes, 4> LoadColumns(const std::array<const float*, 1>& rows)
{
  return { rows[0][0], rows[0][1], rows[0][2], rows[0][3] };
}
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

template<typename T>
void PrefetchSpan(const T* begin, std::size_t count)
{
  constexpr std::size_t line = 64;
  const char* const bytes = reinterpret_cast<const char*>(begin);
  for (std::size_t i = 0; i < count * sizeof(T); i += line)
  {
    Prefetch(bytes + i);
  }
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
