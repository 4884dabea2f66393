// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprJetFit.h"

#include <algorithm>
#include <cmath>

namespace npr
{
namespace
{
/// The powers of x and y that a coefficient belongs to.
struct Exponents
{
  int X[15];
  int Y[15];
};

constexpr Exponents MakeExponents()
{
  Exponents e{};
  int i = 0;
  for (int degree = 0; degree <= 4; ++degree)
  {
    for (int y = 0; y <= degree; ++y, ++i)
    {
      e.X[i] = degree - y;
      e.Y[i] = y;
    }
  }
  return e;
}

constexpr Exponents Powers = MakeExponents();
}

//------------------------------------------------------------------------------
int JetFit::Solve(int degree, JetCoefficients& jet)
{
  switch (degree)
  {
    case 2:
      return this->SolveDegree<2>(jet);
    case 3:
      return this->SolveDegree<3>(jet);
    default:
      return this->SolveDegree<4>(jet);
  }
}

//------------------------------------------------------------------------------
template<int A, int Degree>
void JetFit::Sum(Moments<Degree>& moments)
{
  // All sums with the same power of x at once: they fit the processor's registers.
  constexpr int plain = 2 * Degree - A + 1;
  constexpr int withHeight = A <= Degree ? Degree - A + 1 : 0;
  Lanes sums[plain];
  Lanes products[withHeight + 1];
  std::fill_n(sums, plain, Lanes::Zero());
  std::fill_n(products, withHeight + 1, Lanes::Zero());
  for (Pair& pair : this->Pairs)
  {
    Lanes power = A == 0 ? pair.W : Lanes(pair.Power * pair.X);
    pair.Power = power;
    const Lanes y = pair.Y;
    const Lanes z = pair.Z;
    for (int b = 0; b < plain; ++b)
    {
      sums[b] += power;
      if (b < withHeight)
      {
        products[b] += power * z;
      }
      power *= y;
    }
  }
  for (int b = 0; b < plain; ++b)
  {
    moments.Plain[A][b] = sums[b].sum();
  }
  for (int b = 0; b < withHeight; ++b)
  {
    moments.WithHeight[A][b] = products[b].sum();
  }
  if constexpr (A < 2 * Degree)
  {
    this->Sum<A + 1>(moments);
  }
}

//------------------------------------------------------------------------------
template<int Degree>
int JetFit::SolveDegree(JetCoefficients& jet)
{
  constexpr int size = CountCoefficients(Degree);
  jet.fill(0.0);

  Moments<Degree> moments;
  this->Sum<0>(moments);

  // Elimination of the upper half, two columns at a time, with the right side as a last column.
  // The rows of a lower degree come first, so that the first bad pivot tells the degree that
  // remains.
  constexpr int pairs = size / 2 + 1;
  Lanes rows[size][pairs];
  double diagonal[size];
  const auto at = [&rows](int i, int j) -> double& { return rows[i][j / 2][j % 2]; };
  for (int i = 0; i < size; ++i)
  {
    rows[i][pairs - 1].setZero();
    for (int j = i / 2 * 2; j < size; ++j)
    {
      at(i, j) = moments.Plain[Powers.X[i] + Powers.X[j]][Powers.Y[i] + Powers.Y[j]];
    }
    at(i, size) = moments.WithHeight[Powers.X[i]][Powers.Y[i]];
    diagonal[i] = at(i, i);
  }
  double inverse[size];
  int usable = Degree;
  for (int k = 0; k < size; ++k)
  {
    // How much of the monomial is not a combination of those before it.
    constexpr double leastPivot = 1e-4;
    const double pivot = at(k, k);
    if (!(pivot > leastPivot * diagonal[k]))
    {
      usable = Powers.X[k] + Powers.Y[k] - 1;
      break;
    }
    inverse[k] = 1.0 / pivot;
    for (int i = k + 1; i < size; ++i)
    {
      const double factor = inverse[k] * at(k, i);
      for (int j = i / 2; j < pairs; ++j)
      {
        rows[i][j] -= factor * rows[k][j];
      }
    }
  }
  if (usable < 2)
  {
    return usable;
  }
  for (int i = CountCoefficients(usable) - 1; i >= 0; --i)
  {
    double value = at(i, size);
    for (int k = i + 1; k < CountCoefficients(usable); ++k)
    {
      value -= at(i, k) * jet[k];
    }
    jet[i] = inverse[i] * value;
  }
  return usable;
}

//------------------------------------------------------------------------------
double JetFit::GetResidual(const JetCoefficients& jet) const
{
  double sum = 0.0;
  for (const Pair& pair : this->Pairs)
  {
    Lanes difference = pair.Z;
    for (int k = 0; k < CountCoefficients(4); ++k)
    {
      difference -= jet[k] * pair.X.pow(Powers.X[k]) * pair.Y.pow(Powers.Y[k]);
    }
    sum += (pair.W * difference.square()).sum();
  }
  return sum;
}

//------------------------------------------------------------------------------
SurfaceJet Differentiate(
  const JetCoefficients& jet, const TangentFrame& frame, const Eigen::Vector3d& normal)
{
  // z = f(x, y) with W^2 = 1 + fx^2 + fy^2: in the basis of the coordinates the second fundamental
  // form is -f_ij / W (convex upwards is positive), the Christoffel symbols are f_l f_ij / W^2, and
  // so the covariant derivative of the form is -f_ijk / W + (f_ij g_k + f_ik g_j + f_jk g_i) / W^3
  // with g_i = f_l f_li.
  const double fx = jet[1];
  const double fy = jet[2];
  const double fxx = 2.0 * jet[3];
  const double fxy = jet[4];
  const double fyy = 2.0 * jet[5];
  const double inverse = 1.0 / std::sqrt(1.0 + fx * fx + fy * fy);
  const double gx = fx * fxx + fy * fxy;
  const double gy = fx * fxy + fy * fyy;
  const double form[3] = { -inverse * fxx, -inverse * fxy, -inverse * fyy };
  const double s = -inverse * inverse; // the second term, by the form instead of f_ij
  const double cubic[4] = { -6.0 * inverse * jet[6] + s * 3.0 * form[0] * gx,
    -2.0 * inverse * jet[7] + s * (form[0] * gy + 2.0 * form[1] * gx),
    -2.0 * inverse * jet[8] + s * (2.0 * form[1] * gy + form[2] * gx),
    -6.0 * inverse * jet[9] + s * 3.0 * form[2] * gy };

  SurfaceJet result;
  result.Normal = inverse * (normal - fx * frame.U - fy * frame.V);
  // A tangent vector's components in the basis of the coordinates are its x and y.
  const TangentFrame tangents = MakeTangentFrame(result.Normal);
  const double ux = tangents.U.dot(frame.U);
  const double uy = tangents.U.dot(frame.V);
  const double vx = tangents.V.dot(frame.U);
  const double vy = tangents.V.dot(frame.V);
  const auto evaluate = [](const double(&f)[3], double ax, double ay, double bx, double by)
  { return f[0] * ax * bx + f[1] * (ax * by + ay * bx) + f[2] * ay * by; };
  result.Form = { evaluate(form, ux, uy, ux, uy), evaluate(form, ux, uy, vx, vy),
    evaluate(form, vx, vy, vx, vy) };
  const auto contract = [&](double ax, double ay, double(&f)[3])
  {
    for (int i = 0; i < 3; ++i)
    {
      f[i] = cubic[i] * ax + cubic[i + 1] * ay;
    }
  };
  double alongU[3];
  double alongV[3];
  contract(ux, uy, alongU);
  contract(vx, vy, alongV);
  result.Cubic = { evaluate(alongU, ux, uy, ux, uy), evaluate(alongU, ux, uy, vx, vy),
    evaluate(alongU, vx, vy, vx, vy), evaluate(alongV, vx, vy, vx, vy) };
  return result;
}
}
