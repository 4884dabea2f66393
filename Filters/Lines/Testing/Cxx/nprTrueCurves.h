// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprTrueCurves.h
 * @brief Zero curves of fields on surfaces known by formula, and how far chains are from them.
 */
#ifndef nprTrueCurves_h
#define nprTrueCurves_h

#include "nprAnalyticSurfaces.h"
#include "nprChainTesting.h"
#include "vtkNPRCurvatureTensor.h"
#include "vtkNPRLineDefinition.h"
#include "vtkNPRSurfaceNormals.h"

#include <vtkFloatArray.h>

#include <Eigen/Eigenvalues>

#include <functional>
#include <limits>

namespace nprtest
{
/// Curvatures of a point in its principal frame.
struct Principal
{
  double K1, K2;
  Vector3d E1, E2;
  Vector4d Derivatives; // P Q S T
};

/// C(a,b,c) for vectors given by their components in the truth's frame.
inline double EvaluateCubic(
  const Truth& truth, const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c)
{
  const Vector4d& t = truth.Cubic;
  return t[0] * a[0] * b[0] * c[0] +
    t[1] * (a[0] * b[0] * c[1] + a[0] * b[1] * c[0] + a[1] * b[0] * c[0]) +
    t[2] * (a[0] * b[1] * c[1] + a[1] * b[0] * c[1] + a[1] * b[1] * c[0]) +
    t[3] * a[1] * b[1] * c[1];
}

inline Principal GetPrincipal(const Truth& truth)
{
  Eigen::Matrix2d form;
  form << truth.Form[0], truth.Form[1], truth.Form[1], truth.Form[2];
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(form);
  const int first = std::abs(solver.eigenvalues()[0]) > std::abs(solver.eigenvalues()[1]) ? 0 : 1;
  const Eigen::Vector2d a = solver.eigenvectors().col(first);
  const Eigen::Vector2d b(-a[1], a[0]);
  Principal result;
  result.K1 = solver.eigenvalues()[first];
  result.K2 = solver.eigenvalues()[1 - first];
  result.E1 = a[0] * truth.Frame.U + a[1] * truth.Frame.V;
  result.E2 = b[0] * truth.Frame.U + b[1] * truth.Frame.V;
  result.Derivatives = { EvaluateCubic(truth, a, a, a), EvaluateCubic(truth, a, a, b),
    EvaluateCubic(truth, a, b, b), EvaluateCubic(truth, b, b, b) };
  return result;
}

/// A place for a surface: what is at p comes to Size * (Turn * p) + Shift.
struct Placement
{
  double Size = 1.0;
  Eigen::Matrix3d Turn = Eigen::Matrix3d::Identity();
  Vector3d Shift = Vector3d::Zero();
  Vector3d Undo(const Vector3d& p) const
  {
    return this->Turn.transpose() * (p - this->Shift) / this->Size;
  }
};

/// Moves the surface, and gives it its exact normals, curvatures and derivatives.
inline void AddExactArrays(const AnalyticSurface& surface, const Placement& at = Placement())
{
  const auto add = [&](const char* name, int components)
  {
    auto array = vtkSmartPointer<vtkFloatArray>::New();
    array->SetName(name);
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(surface.Mesh->GetNumberOfPoints());
    surface.Mesh->GetPointData()->AddArray(array);
    return array;
  };
  const auto normals = add(npr::names::Normals, 3);
  const auto tensors = add(npr::names::CurvatureTensor, 6);
  const auto k1 = add(npr::names::PrincipalCurvature1, 1);
  const auto k2 = add(npr::names::PrincipalCurvature2, 1);
  const auto e1 = add(npr::names::PrincipalDirection1, 3);
  const auto e2 = add(npr::names::PrincipalDirection2, 3);
  const auto derivatives = add(npr::names::CurvatureDerivatives, 4);
  for (std::size_t n = 0; n < surface.Truths.size(); ++n)
  {
    const auto i = static_cast<vtkIdType>(n);
    const Truth& truth = surface.Truths[n];
    const Principal principal = GetPrincipal(truth);
    const Vector3d a = at.Turn * principal.E1;
    const Vector3d b = at.Turn * principal.E2;
    const Eigen::Matrix3d t =
      (principal.K1 * a * a.transpose() + principal.K2 * b * b.transpose()) / at.Size;
    surface.Mesh->GetPoints()->SetPoint(
      i, Vector3d(at.Size * (at.Turn * truth.Point) + at.Shift).data());
    normals->SetTuple(i, Vector3d(at.Turn * truth.Normal).data());
    tensors->SetTuple6(i, t(0, 0), t(1, 1), t(2, 2), t(0, 1), t(1, 2), t(0, 2));
    k1->SetTuple1(i, principal.K1 / at.Size);
    k2->SetTuple1(i, principal.K2 / at.Size);
    e1->SetTuple(i, a.data());
    e2->SetTuple(i, b.data());
    derivatives->SetTuple(i, Vector4d(principal.Derivatives / (at.Size * at.Size)).data());
  }
}

/// The same arrays as vtkNPRCurvatureTensor finds them from the mesh.
inline vtkSmartPointer<vtkPolyData> EstimateArrays(const AnalyticSurface& surface)
{
  vtkNew<vtkNPRSurfaceNormals> normals;
  normals->SetInputData(surface.Mesh);
  vtkNew<vtkNPRCurvatureTensor> tensor;
  tensor->SetInputConnection(normals->GetOutputPort());
  tensor->Update();
  return tensor->GetOutput();
}

/// A field over the parameters of a surface whose u and v are x and y.
struct TrueCurve
{
  ParametricSurface Surface;
  std::function<double(const Truth&)> Field;

  double At(double u, double v) const { return this->Field(this->Surface.At(u, v)); }

  /// Points of the curve, by bisection along so many lines of both parameters. Those where the
  /// field jumps over 0 are not on it.
  std::vector<Vector3d> Sample(int lines) const
  {
    std::vector<Vector3d> points;
    const auto& r = this->Surface.Range;
    for (int direction = 0; direction < 2; ++direction)
    {
      for (int i = 0; i <= lines; ++i)
      {
        const auto place = [&](double s) -> std::array<double, 2>
        {
          const double along = s;
          const double across = static_cast<double>(i) / lines;
          const double u = direction == 0 ? along : across;
          const double v = direction == 0 ? across : along;
          return { r[0] + (r[1] - r[0]) * u, r[2] + (r[3] - r[2]) * v };
        };
        const auto value = [&](double s) { return this->At(place(s)[0], place(s)[1]); };
        double before = value(0.0);
        for (int j = 1; j <= lines; ++j)
        {
          const double here = value(static_cast<double>(j) / lines);
          if ((before > 0.0) != (here > 0.0))
          {
            double low = (j - 1.0) / lines;
            double high = static_cast<double>(j) / lines;
            for (int step = 0; step < 45; ++step)
            {
              const double middle = 0.5 * (low + high);
              ((value(middle) > 0.0) == (before > 0.0) ? low : high) = middle;
            }
            if (std::abs(value(low)) < 1.0e-6 && std::abs(value(high)) < 1.0e-6)
            {
              points.push_back(this->Surface.At(place(low)[0], place(low)[1]).Point);
            }
          }
          before = here;
        }
      }
    }
    return points;
  }

  /// How far a point is from the curve: to where Newton's steps lead from it.
  double GetDistance(const Vector3d& p) const
  {
    double u = p[0];
    double v = p[1];
    const double d = 1.0e-6;
    for (int step = 0; step < 20; ++step)
    {
      const Eigen::Vector2d slope((this->At(u + d, v) - this->At(u - d, v)) / (2.0 * d),
        (this->At(u, v + d) - this->At(u, v - d)) / (2.0 * d));
      const Eigen::Vector2d way = slope * (this->At(u, v) / slope.squaredNorm());
      u -= way[0];
      v -= way[1];
    }
    const double distance = (this->Surface.At(u, v).Point - p).norm();
    return std::abs(this->At(u, v)) < 1.0e-6 ? distance : std::numeric_limits<double>::infinity();
  }
};

/// The larger of the greatest distances from the chains to the curve and back.
inline double GetHausdorffDistance(const std::vector<Chain>& chains, const TrueCurve& curve)
{
  double greatest = 0.0;
  for (const Chain& chain : chains)
  {
    for (const Vector3d& p : chain.Points)
    {
      greatest = std::max(greatest, curve.GetDistance(p));
    }
  }
  for (const Vector3d& p : curve.Sample(150))
  {
    greatest = std::max(greatest, GetDistance(chains, p));
  }
  return greatest;
}

/// With a length scale of 1, so that thresholds have the unit of the surface; 0 for its own.
inline std::vector<Chain> ExtractLines(
  vtkPolyData* surface, vtkNPRLineDefinition* definition, double lengthScale = 1.0)
{
  vtkNew<vtkNPRFeatureLines> lines;
  lines->SetLengthScale(lengthScale);
  lines->AddDefinition(definition);
  lines->SetCamera(MakeCamera({ 0.0, 0.0, 5.0 }));
  lines->SetInputData(surface);
  lines->Update();
  return GetChains(lines->GetOutput());
}

/// Whether the distance of a definition's lines from the true curve falls with the square of the
/// edge length where curvatures are exact, and with the edge length where they are estimated.
inline void CheckConvergence(
  vtkNPRLineDefinition* definition, const TrueCurve& curve, std::size_t count, Checks& check)
{
  const double none = std::numeric_limits<double>::infinity();
  double lastExact = none;
  double firstEstimate = none;
  double lastEstimate = none;
  for (const int n : { 30, 60, 120 })
  {
    const AnalyticSurface surface = MakeSurface(curve.Surface, n, n, { 0.25, 7 });
    const auto estimate = ExtractLines(EstimateArrays(surface), definition);
    AddExactArrays(surface);
    const auto exact = ExtractLines(surface.Mesh, definition);
    CheckSound(exact, check);
    check(exact.size() == count, "as many chains as there are curves", double(exact.size()));
    const double error = GetHausdorffDistance(exact, curve);
    lastEstimate = GetHausdorffDistance(estimate, curve);
    std::cout << definition->GetName() << " n " << n << ": " << error << " exact, " << lastEstimate
              << " estimated\n";
    check(error < 0.36 * lastExact, "exact: the error falls with h^2", error / lastExact);
    lastExact = error;
    firstEstimate = n == 30 ? lastEstimate : firstEstimate;
  }
  check(lastEstimate < 0.36 * firstEstimate, "estimated: the error falls with h",
    lastEstimate / firstEstimate);
}

/// Whether a surface's lines are the same, by the definition's own thresholds, where the surface is
/// much smaller or larger, turned, or far away.
inline void CheckInvariance(
  vtkNPRLineDefinition* definition, const ParametricSurface& shape, Checks& check)
{
  const auto extract = [&](const Placement& at)
  {
    const AnalyticSurface surface = MakeSurface(shape, 60, 60, { 0.25, 7 });
    AddExactArrays(surface, at);
    return ExtractLines(surface.Mesh, definition, 0.0);
  };
  const auto chains = extract(Placement());
  check(!chains.empty(), "there is something to compare");
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(1.1, Vector3d(3.0, -1.0, 2.0).normalized()).toRotationMatrix();
  for (const double size : { 1.0e-3, 1.0, 1.0e3 })
  {
    for (const Placement& at :
      { Placement{ size }, Placement{ size, turn, size * Vector3d(3.0, 2.0, -10.0) } })
    {
      auto others = extract(at);
      check(others.size() == chains.size(), "so many chains at every size and place",
        double(others.size()) - double(chains.size()));
      for (Chain& chain : others)
      {
        for (Vector3d& p : chain.Points)
        {
          p = at.Undo(p);
          check(GetDistance(chains, p) < 1.0e-4, "where they were", GetDistance(chains, p));
        }
      }
      for (const Chain& chain : chains)
      {
        for (const Vector3d& p : chain.Points)
        {
          check(GetDistance(others, p) < 1.0e-4, "none is missing", GetDistance(others, p));
        }
      }
    }
  }
}

/// The bump z = height exp(-(x^2 + y^2) / 2).
inline ParametricSurface Bump(double height)
{
  const auto at = [=](double x, double y)
  {
    const double f = height * std::exp(-0.5 * (x * x + y * y));
    return MakeHeightTruth(x, y,
      { f, { -x * f, -y * f }, { (x * x - 1.0) * f, x * y * f, (y * y - 1.0) * f },
        { x * (3.0 - x * x) * f, y * (1.0 - x * x) * f, x * (1.0 - y * y) * f,
          y * (3.0 - y * y) * f } });
  };
  return { at, { -2.2, 2.2, -2.2, 2.2 } };
}
}

#endif
