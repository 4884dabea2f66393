// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprViewQuantities.h"

#include "nprArrayNames.h"
#include "nprLanes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace npr
{
namespace
{
using RequiredArray = vtkNPRLineDefinition::RequiredArray;

// Of the length of w, which is a sine: below this its direction is nothing but rounding.
constexpr float LeastSine = 1.0e-6f;

// The components of a vector array.
struct Vectors
{
  const float* X;
  const float* Y;
  const float* Z;
  Vectors(const LineSurface& surface, const char* name)
    : X(surface.GetComponent(name, 0)), Y(surface.GetComponent(name, 1)),
      Z(surface.GetComponent(name, 2))
  {
  }
};

// The unit vector from a point to the eye; 0 at the eye itself.
struct ToEye
{
  const float* X;
  const float* Y;
  const float* Z;
  const LineView View;
  ToEye(const LineSurface& surface, const LineView& view)
    : X(surface.GetCoordinate(0)), Y(surface.GetCoordinate(1)), Z(surface.GetCoordinate(2)),
      View(view)
  {
  }
  void Get(vtkIdType i, float& x, float& y, float& z) const
  {
    x = this->View.Eye[0] - this->View.Perspective * this->X[i];
    y = this->View.Eye[1] - this->View.Perspective * this->Y[i];
    z = this->View.Eye[2] - this->View.Perspective * this->Z[i];
    const float scale = 1.0f / std::sqrt(x * x + y * y + z * z + std::numeric_limits<float>::min());
    x *= scale;
    y *= scale;
    z *= scale;
  }
};

// Takes from the direction to the eye what is along the normal, and returns how much that was.
inline float Project(const Vectors& n, vtkIdType i, float& x, float& y, float& z)
{
  const float cosine = n.X[i] * x + n.Y[i] * y + n.Z[i] * z;
  x -= cosine * n.X[i];
  y -= cosine * n.Y[i];
  z -= cosine * n.Z[i];
  return cosine;
}

const RequiredArray Normals = { names::Normals, 3, "vtkNPRSurfaceNormals" };
RequiredArray FromTensor(const char* name, int components)
{
  return { name, components, "vtkNPRCurvatureTensor" };
}
const RequiredArray Curvature1 = FromTensor(names::PrincipalCurvature1, 1);
const RequiredArray Curvature2 = FromTensor(names::PrincipalCurvature2, 1);
const RequiredArray Direction1 = FromTensor(names::PrincipalDirection1, 3);
const RequiredArray Direction2 = FromTensor(names::PrincipalDirection2, 3);
const RequiredArray Derivatives = FromTensor(names::CurvatureDerivatives, 4);

// One component of an array, times a power of the length scale.
template<int Power>
void CopyComponent(const LineSurface& surface, const char* name, int component,
  const PointSpan& points, double* values)
{
  const float* from = surface.GetComponent(name, component);
  const double scale = Power == 0 ? 1.0 : std::pow(surface.GetLengthScale(), Power);
  for (vtkIdType i = 0; i < points.GetNumberOfPoints(); ++i)
  {
    values[i] = scale * from[points[i]];
  }
}

template<int Component>
void EvaluateDerivative(
  const LineSurface& surface, const LineView&, const PointSpan& points, int, double* values)
{
  CopyComponent<2>(surface, names::CurvatureDerivatives, Component, points, values);
}

template<typename Combine>
void CombineCurvatures(
  const LineSurface& surface, const PointSpan& points, double* values, const Combine& combine)
{
  const float* k1 = surface.GetComponent(names::PrincipalCurvature1, 0);
  const float* k2 = surface.GetComponent(names::PrincipalCurvature2, 0);
  const double scale = surface.GetLengthScale();
  for (vtkIdType i = 0; i < points.GetNumberOfPoints(); ++i)
  {
    values[i] = combine(scale * k1[points[i]], scale * k2[points[i]]);
  }
}

void EvaluateKr(
  const LineSurface& surface, const LineView& view, const PointSpan& points, int, double* values)
{
  // Through the loop over ranges, whatever the points, so that there is one formula. A list is
  // mostly short and in runs.
  constexpr vtkIdType Size = 256;
  std::array<float, Size> part;
  const vtkIdType count = points.GetNumberOfPoints();
  for (vtkIdType first = 0, last; first < count; first = last)
  {
    last = first + 1;
    while (last < count && last - first < Size && points[last] == points[first] + (last - first))
    {
      ++last;
    }
    const vtkIdType begin = points[first];
    EvaluateRadialCurvature(surface, view, begin, begin + (last - first), part.data());
    std::copy(part.data(), part.data() + (last - first), values + first);
  }
}

// v, or w where projected.
template<bool Projected>
void EvaluateToEye(const LineSurface& surface, const LineView& view, const PointSpan& points,
  int component, double* values)
{
  const ToEye toEye(surface, view);
  for (vtkIdType j = 0; j < points.GetNumberOfPoints(); ++j)
  {
    std::array<float, 3> v;
    toEye.Get(points[j], v[0], v[1], v[2]);
    if (Projected)
    {
      Project(Vectors(surface, names::Normals), points[j], v[0], v[1], v[2]);
    }
    values[j] = v[component];
  }
}

template<const char* const& Name>
void EvaluateVector(const LineSurface& surface, const LineView&, const PointSpan& points,
  int component, double* values)
{
  CopyComponent<0>(surface, Name, component, points, values);
}

void EvaluatePosition(const LineSurface& surface, const LineView&, const PointSpan& points,
  int component, double* values)
{
  const float* from = surface.GetCoordinate(component);
  const double origin = surface.GetMesh().GetOrigin()[component];
  for (vtkIdType i = 0; i < points.GetNumberOfPoints(); ++i)
  {
    values[i] = origin + from[points[i]];
  }
}
}

//------------------------------------------------------------------------------
void EvaluateRadialCurvature(const LineSurface& surface, const LineView& view, vtkIdType begin,
  vtkIdType end, float* radialCurvature)
{
  // The quotient does not depend on the length of the vector to the eye, so nothing needs a root,
  // and a loop without branches over a block of its own is one that compilers make vectors of.
  constexpr vtkIdType Size = 1024;
  std::array<float, Size> block;
  const float* px = surface.GetCoordinate(0);
  const float* py = surface.GetCoordinate(1);
  const float* pz = surface.GetCoordinate(2);
  const Vectors n(surface, names::Normals);
  const Vectors e1(surface, names::PrincipalDirection1);
  const float* k1 = surface.GetComponent(names::PrincipalCurvature1, 0);
  const float* k2 = surface.GetComponent(names::PrincipalCurvature2, 0);
  const LineView eye = view;
  const float lengthScale = static_cast<float>(surface.GetLengthScale());
  for (vtkIdType first = begin; first < end; first += Size)
  {
    const vtkIdType count = std::min(Size, end - first);
    for (vtkIdType i = 0; i < count; ++i)
    {
      const vtkIdType j = first + i;
      float x = eye.Eye[0] - eye.Perspective * px[j];
      float y = eye.Eye[1] - eye.Perspective * py[j];
      float z = eye.Eye[2] - eye.Perspective * pz[j];
      const float guard = LeastSine * LeastSine * (x * x + y * y + z * z);
      const float along = n.X[j] * x + n.Y[j] * y + n.Z[j] * z;
      x -= along * n.X[j];
      y -= along * n.Y[j];
      z -= along * n.Z[j];
      const float square = x * x + y * y + z * z;
      const float along1 = e1.X[j] * x + e1.Y[j] * y + e1.Z[j] * z;
      const float square1 = along1 * along1;
      const float bend = k1[j] * square1 + k2[j] * (square - square1);
      block[i] = lengthScale * bend / (square + guard + std::numeric_limits<float>::min());
    }
    std::copy(block.data(), block.data() + count, radialCurvature + (first - begin));
  }
}

//------------------------------------------------------------------------------
void EvaluateRadialDerivative(const LineSurface& surface, const LineView& view,
  const PointSpan& points, double* cosine, double* sine, double* derivative)
{
  using Components3 = std::array<const float*, 3>;
  const auto component = [&](const char* name, int c) { return surface.GetComponent(name, c); };
  const auto vectors = [&](const char* name) -> Components3 {
    return { component(name, 0), component(name, 1), component(name, 2) };
  };
  const Components3 places = { surface.GetCoordinate(0), surface.GetCoordinate(1),
    surface.GetCoordinate(2) };
  const Components3 normals = vectors(names::Normals);
  Components3 e1 = {};
  std::array<const float*, 4> pqst = {};
  const float* k1 = nullptr;
  const float* k2 = nullptr;
  if (derivative)
  {
    e1 = vectors(names::PrincipalDirection1);
    for (int c = 0; c < 4; ++c)
    {
      pqst[c] = component(names::CurvatureDerivatives, c);
    }
    k1 = component(names::PrincipalCurvature1, 0);
    k2 = component(names::PrincipalCurvature2, 0);
  }
  const LineView eye = view;
  const float square = static_cast<float>(surface.GetLengthScale() * surface.GetLengthScale());
  const auto write = [](const Lanes& from, double* to, int count)
  {
    std::array<float, NumberOfLanes> row;
    Store(from, row.data());
    std::copy(row.data(), row.data() + count, to);
  };
  // Writes what belongs to the points from j on; `load` takes theirs from an array.
  const auto evaluate = [&](vtkIdType j, int count, const auto& load)
  {
    const auto load3 = [&load](const Components3& from) -> Vector3<Lanes> {
      return { load(from[0]), load(from[1]), load(from[2]) };
    };
    const Vector3<Lanes> place = load3(places);
    const Vector3<Lanes> normal = load3(normals);
    Vector3<Lanes> v = { eye.Eye[0] - eye.Perspective * place.X,
      eye.Eye[1] - eye.Perspective * place.Y, eye.Eye[2] - eye.Perspective * place.Z };
    // The length of the vector is 0 at the eye itself.
    v = v * Lanes(1.0f / SquareRoot(Lanes(Dot(v, v) + std::numeric_limits<float>::min())));
    const Lanes c = Dot(normal, v);
    const Vector3<Lanes> w = v - normal * c;
    const Lanes s = SquareRoot(Dot(w, w));
    if (cosine)
    {
      write(c, cosine + j, count);
    }
    if (sine)
    {
      write(s, sine + j, count);
    }
    if (derivative)
    {
      const Lanes least = Lanes{} + LeastSine;
      const Lanes over = 1.0f / (s < least ? least : s);
      const Vector3<Lanes> direction1 = load3(e1);
      const Lanes a = over * Dot(w, direction1);
      const Lanes b = over * Dot(w, Cross(normal, direction1));
      const Lanes cubic = a * a * (a * load(pqst[0]) + 3.0f * b * load(pqst[1])) +
        b * b * (3.0f * a * load(pqst[2]) + b * load(pqst[3]));
      write(square * (cubic + 2.0f * load(k1) * load(k2) * c * over), derivative + j, count);
    }
  };
  const vtkIdType size = points.GetNumberOfPoints();
  for (vtkIdType j = 0; j < size; j += NumberOfLanes)
  {
    const int count = static_cast<int>(std::min<vtkIdType>(NumberOfLanes, size - j));
    std::array<vtkIdType, NumberOfLanes> here;
    bool isRow = count == NumberOfLanes;
    for (int i = 0; i < NumberOfLanes; ++i)
    {
      here[i] = points[j + std::min(i, count - 1)];
      isRow &= here[i] == here[0] + i;
    }
    if (isRow)
    {
      evaluate(j, count, [&here](const float* from) { return Load<Lanes>(from + here[0]); });
    }
    else
    {
      evaluate(j, count,
        [&here](const float* from) { return MakeLanes([&](int i) { return from[here[i]]; }); });
    }
  }
}

//------------------------------------------------------------------------------
const std::vector<ViewQuantity>& GetViewQuantities()
{
  static const std::vector<ViewQuantity> quantities = {
    { "ndotv", "cosine of the angle between normal and eye", 1, true, { Normals },
      [](const LineSurface& surface, const LineView& view, const PointSpan& points, int,
        double* values)
      { EvaluateRadialDerivative(surface, view, points, values, nullptr, nullptr); } },
    { "sintheta", "sine of the angle between normal and eye", 1, true, { Normals },
      [](const LineSurface& surface, const LineView& view, const PointSpan& points, int,
        double* values)
      { EvaluateRadialDerivative(surface, view, points, nullptr, values, nullptr); } },
    { "kr", "radial curvature, times the length scale", 1, true,
      { Normals, Curvature1, Curvature2, Direction1 }, EvaluateKr },
    { "dwkr", "derivative of kr towards the eye where kr is 0, times the length scale squared", 1,
      true, { Normals, Curvature1, Curvature2, Direction1, Derivatives },
      [](const LineSurface& surface, const LineView& view, const PointSpan& points, int,
        double* values)
      { EvaluateRadialDerivative(surface, view, points, nullptr, nullptr, values); } },
    { "k1", "first principal curvature, times the length scale", 1, false, { Curvature1 },
      [](const LineSurface& surface, const LineView&, const PointSpan& points, int, double* values)
      { CopyComponent<1>(surface, names::PrincipalCurvature1, 0, points, values); } },
    { "k2", "second principal curvature, times the length scale", 1, false, { Curvature2 },
      [](const LineSurface& surface, const LineView&, const PointSpan& points, int, double* values)
      { CopyComponent<1>(surface, names::PrincipalCurvature2, 0, points, values); } },
    { "K", "Gaussian curvature k1 k2, times the length scale squared", 1, false,
      { Curvature1, Curvature2 },
      [](const LineSurface& surface, const LineView&, const PointSpan& points, int, double* values)
      { CombineCurvatures(surface, points, values, [](double a, double b) { return a * b; }); } },
    { "H", "mean curvature (k1 + k2) / 2, times the length scale", 1, false,
      { Curvature1, Curvature2 },
      [](const LineSurface& surface, const LineView&, const PointSpan& points, int, double* values)
      {
        CombineCurvatures(
          surface, points, values, [](double a, double b) { return 0.5 * (a + b); });
      } },
    { "P", "derivative of k1 along e1, times the length scale squared", 1, false, { Derivatives },
      EvaluateDerivative<0> },
    { "Q", "derivative of k1 along e2, times the length scale squared", 1, false, { Derivatives },
      EvaluateDerivative<1> },
    { "S", "derivative of k2 along e1, times the length scale squared", 1, false, { Derivatives },
      EvaluateDerivative<2> },
    { "T", "derivative of k2 along e2, times the length scale squared", 1, false, { Derivatives },
      EvaluateDerivative<3> },
    { "e1", "first principal direction", 3, false, { Direction1 },
      EvaluateVector<names::PrincipalDirection1> },
    { "e2", "second principal direction", 3, false, { Direction2 },
      EvaluateVector<names::PrincipalDirection2> },
    { "n", "unit normal", 3, false, { Normals }, EvaluateVector<names::Normals> },
    { "v", "unit vector to the eye", 3, true, {}, EvaluateToEye<false> },
    { "w", "v without its part along n", 3, true, { Normals }, EvaluateToEye<true> },
    { "p", "position, in units of the model", 3, false, {}, EvaluatePosition },
  };
  return quantities;
}

//------------------------------------------------------------------------------
const ViewQuantity* FindViewQuantity(const std::string& name)
{
  const std::vector<ViewQuantity>& quantities = GetViewQuantities();
  const auto found = std::find_if(quantities.begin(), quantities.end(),
    [&](const ViewQuantity& quantity) { return name == quantity.Name; });
  return found == quantities.end() ? nullptr : &*found;
}

//------------------------------------------------------------------------------
std::string DescribeViewQuantities()
{
  std::string names;
  for (const ViewQuantity& quantity : GetViewQuantities())
  {
    names += (names.empty() ? "" : ", ") + std::string(quantity.Name);
  }
  return names;
}
}
