// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprLatticeNoise.h
 * @brief Smooth random values along a line, the same for the same seed on every machine.
 *
 * Random values stand at the whole numbers and are joined by 6x^5 - 15x^4 + 10x^3 (K. Perlin:
 * Improving Noise, 2002). The hash is in 32-bit integers only, so that shaders can have it, too.
 */
#ifndef nprLatticeNoise_h
#define nprLatticeNoise_h

#include <cmath>
#include <cstdint>

namespace npr
{
/// Mixes all bits of a number (the finaliser of A. Appleby's MurmurHash3).
inline std::uint32_t HashInteger(std::uint32_t x)
{
  x ^= x >> 16;
  x *= 0x85ebca6bu;
  x ^= x >> 13;
  x *= 0xc2b2ae35u;
  x ^= x >> 16;
  return x;
}

/// The random value in [-1, 1) of a place of the lattice.
inline double GetLatticeValue(std::int64_t place, std::uint32_t seed)
{
  const std::uint32_t hash = HashInteger(static_cast<std::uint32_t>(place) + HashInteger(seed));
  return hash * (2.0 / 4294967296.0) - 1.0;
}

/**
 * Smooth noise in [-1, 1) with a wavelength of about two.
 *
 * @param period after so many places of the lattice the noise repeats; 0 for never
 */
inline double GetLatticeNoise(double x, std::uint32_t seed, std::int64_t period = 0)
{
  const double floor = std::floor(x);
  const double t = x - floor;
  std::int64_t place = static_cast<std::int64_t>(floor);
  std::int64_t next = place + 1;
  if (period > 0)
  {
    place = (place % period + period) % period;
    next = (next % period + period) % period;
  }
  const double weight = t * t * t * (t * (6.0 * t - 15.0) + 10.0);
  const double value = GetLatticeValue(place, seed);
  return value + weight * (GetLatticeValue(next, seed) - value);
}
}

#endif
