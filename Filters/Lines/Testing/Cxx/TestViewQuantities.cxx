// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// The quantities that lines are made from, against the closed form of a torus.
#include "nprLineTesting.h"
#include "nprViewQuantities.h"

#include <cmath>
#include <numeric>

using namespace nprtest;

namespace
{
std::vector<double> Evaluate(const char* name, int component, const npr::LineSurface& surface,
  const npr::LineView& view, const npr::PointSpan& points)
{
  std::vector<double> values(points.GetNumberOfPoints());
  npr::FindViewQuantity(name)->Evaluate(surface, view, points, component, values.data());
  return values;
}

npr::LineSurface MakeSurface(vtkPolyData* torus, double lengthScale)
{
  npr::LineSurface surface(torus, lengthScale);
  for (const npr::ViewQuantity& quantity : npr::GetViewQuantities())
  {
    for (const auto& array : quantity.Arrays)
    {
      surface.LoadArray(torus, array.Name, array.Components);
    }
  }
  return surface;
}

void TestTorus(const Vector& eye, bool parallel, const Vector& offset, Checks& check)
{
  const int nu = 80;
  const int nv = 40;
  const Torus torus;
  auto data = torus.Make(nu, nv);
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    data->GetPoints()->SetPoint(i, Vector(Vector(data->GetPoint(i)) + offset).data());
  }
  const double L = 2.5;
  const npr::LineSurface surface = MakeSurface(data, L);
  npr::LineView view;
  npr::MakeLineView(MakeCamera(eye + (parallel ? Vector(0, 0, 0) : offset), parallel),
    Eigen::Matrix4d::Identity(), surface.GetMesh().GetOrigin(), view);
  const npr::PointSpan points = npr::PointSpan::Range(0, data->GetNumberOfPoints());
  const auto get = [&](const char* name, int component)
  { return Evaluate(name, component, surface, view, points); };
  const auto expect = [&](const char* name, int component, double tolerance, auto truth)
  {
    const std::vector<double> values = get(name, component);
    double worst = 0.0;
    for (int i = 0; i < nu * nv; ++i)
    {
      const int point = static_cast<int>(surface.GetPointId(i));
      const double u = 2.0 * Pi * (point / nv) / nu;
      const double v = 2.0 * Pi * (point % nv) / nv;
      const double expected = truth(u, v);
      if (std::isfinite(expected))
      {
        worst = std::max(worst, std::abs(values[i] - expected) / (1.0 + std::abs(expected)));
      }
    }
    check(worst < tolerance, name, worst);
  };
  const auto toEye = [&](double u, double v)
  { return Vector(parallel ? eye : Vector(eye - torus.Point(u, v))).normalized(); };
  const auto across = [&](double u, double v)
  {
    const Vector n = torus.Normal(u, v);
    return Vector(toEye(u, v) - n.dot(toEye(u, v)) * n);
  };
  const auto radial = [&](double u, double v)
  {
    const double a = across(u, v).dot(torus.AlongU(u));
    const double b = across(u, v).dot(torus.AlongV(u, v));
    return L * (a * a * torus.CurvatureU(v) + b * b / torus.r) / (a * a + b * b);
  };

  expect("ndotv", 0, 1e-5, [&](double u, double v) { return torus.Normal(u, v).dot(toEye(u, v)); });
  expect("sintheta", 0, 1e-5, [&](double u, double v) { return across(u, v).norm(); });
  expect("kr", 0, 1e-4,
    [&](double u, double v) { return across(u, v).norm() > 0.05 ? radial(u, v) : std::nan(""); });
  // dwkr is the derivative along the surface where kr is 0; there alone.
  expect("dwkr", 0, 0.03,
    [&](double u, double v)
    {
      const Vector w = across(u, v).normalized();
      const double du = w.dot(torus.AlongU(u)) / (torus.R + torus.r * std::cos(v));
      const double dv = w.dot(torus.AlongV(u, v)) / torus.r;
      const double h = 1.0e-5;
      return std::abs(radial(u, v)) < 0.01 && across(u, v).norm() > 0.05
        ? L * (radial(u + h * du, v + h * dv) - radial(u - h * du, v - h * dv)) / (2.0 * h)
        : std::nan("");
    });
  const auto k1 = [&](double, double) { return L / torus.r; };
  const auto k2 = [&](double, double v) { return L * torus.CurvatureU(v); };
  expect("k1", 0, 1e-5, k1);
  expect("k2", 0, 1e-5, k2);
  expect("K", 0, 1e-5, [&](double u, double v) { return k1(u, v) * k2(u, v); });
  expect("H", 0, 1e-5, [&](double u, double v) { return 0.5 * (k1(u, v) + k2(u, v)); });
  expect("P", 0, 1e-5, [](double, double) { return 0.0; });
  expect("Q", 0, 1e-5, [](double, double) { return 0.0; });
  expect("S", 0, 1e-5,
    [&](double, double v)
    {
      const double d = torus.R + torus.r * std::cos(v);
      return L * L * -torus.R * std::sin(v) / (torus.r * d * d);
    });
  expect("T", 0, 1e-5, [](double, double) { return 0.0; });
  for (int c = 0; c < 3; ++c)
  {
    expect("e1", c, 1e-5, [&](double u, double v) { return torus.AlongV(u, v)[c]; });
    expect("e2", c, 1e-5, [&](double u, double) { return -torus.AlongU(u)[c]; });
    expect("n", c, 1e-5, [&](double u, double v) { return torus.Normal(u, v)[c]; });
    expect("v", c, 1e-5, [&](double u, double v) { return toEye(u, v)[c]; });
    expect("w", c, 1e-5, [&](double u, double v) { return across(u, v)[c]; });
    expect("p", c, 1e-6, [&](double u, double v) { return (torus.Point(u, v) + offset)[c]; });
  }

  // Lists of points give the bits of ranges.
  std::vector<npr::LineSurface::Index> list = { 5, 6, 7, 3, 3, 1999, 0 };
  for (const npr::ViewQuantity& quantity : npr::GetViewQuantities())
  {
    for (int c = 0; c < quantity.Components; ++c)
    {
      const std::vector<double> all = get(quantity.Name, c);
      const std::vector<double> some = Evaluate(quantity.Name, c, surface, view,
        npr::PointSpan::List(list.data(), static_cast<vtkIdType>(list.size())));
      for (std::size_t i = 0; i < list.size(); ++i)
      {
        check(some[i] == all[list[i]], quantity.Name, some[i]);
      }
    }
  }
}

// Seen head-on, at the eye, and where normals are 0, nothing is divided by 0.
void TestHeadOn(Checks& check)
{
  auto data = Torus().Make(40, 20);
  const npr::LineSurface surface = MakeSurface(data, 1.0);
  for (const double distance : { 2.0, 1.4 }) // in the line of the first point's normal; at it
  {
    npr::LineView view;
    npr::MakeLineView(MakeCamera({ distance, 0.0, 0.0 }), Eigen::Matrix4d::Identity(),
      surface.GetMesh().GetOrigin(), view);
    for (const npr::ViewQuantity& quantity : npr::GetViewQuantities())
    {
      for (const double value : Evaluate(
             quantity.Name, 0, surface, view, npr::PointSpan::Range(0, data->GetNumberOfPoints())))
      {
        check(std::isfinite(value), quantity.Name, value);
      }
    }
  }
}
}

int TestViewQuantities(int, char*[])
{
  Checks check;
  TestTorus({ 3.0, 1.0, 3.0 }, false, Vector::Zero(), check);
  TestTorus({ 4.0, 1.0, 2.5 }, true, Vector::Zero(), check);
  TestTorus({ 3.0, 1.0, 3.0 }, false, { 1.0e6, -2.0e6, 5.0e5 }, check);
  TestHeadOn(check);
  check(!npr::FindViewQuantity("Kr"), "names are told apart by their case");
  return check.GetResult();
}
