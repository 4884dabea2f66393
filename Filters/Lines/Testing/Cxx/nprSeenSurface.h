// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprSeenSurface.h
 * @brief Known surfaces as an eye sees them, to check lines that depend on the view.
 */
#ifndef nprSeenSurface_h
#define nprSeenSurface_h

#include "nprLineTesting.h"

#include "nprSurfaceTruths.h"

#include <vtkMinimalStandardRandomSequence.h>
#include <vtkSMPTools.h>

#include <functional>

namespace nprtest
{
/// The principal curvatures, |K1| >= |K2|, and the derivatives in their frame.
struct PrincipalTruth
{
  double K1;
  double K2;
  Vector E1;
  Vector E2;
  Vector4d Cubic;

  explicit PrincipalTruth(const Truth& truth, double way = 1.0)
  {
    Eigen::Matrix2d form;
    form << truth.Form[0], truth.Form[1], truth.Form[1], truth.Form[2];
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(form);
    const Eigen::Vector2d values = solver.eigenvalues();
    const int first = std::abs(values[0]) > std::abs(values[1]) ? 0 : 1;
    const Eigen::Vector2d a = way * solver.eigenvectors().col(first);
    const Eigen::Vector2d b(-a[1], a[0]);
    this->K1 = values[first];
    this->K2 = values[1 - first];
    this->E1 = a[0] * truth.Frame.U + a[1] * truth.Frame.V;
    this->E2 = b[0] * truth.Frame.U + b[1] * truth.Frame.V;
    const auto cubic =
      [&](const Eigen::Vector2d& x, const Eigen::Vector2d& y, const Eigen::Vector2d& z)
    {
      const Vector4d& c = truth.Cubic;
      return c[0] * x[0] * y[0] * z[0] +
        c[1] * (x[0] * y[0] * z[1] + x[0] * y[1] * z[0] + x[1] * y[0] * z[0]) +
        c[2] * (x[0] * y[1] * z[1] + x[1] * y[0] * z[1] + x[1] * y[1] * z[0]) +
        c[3] * x[1] * y[1] * z[1];
    };
    this->Cubic = { cubic(a, a, a), cubic(a, a, b), cubic(a, b, b), cubic(b, b, b) };
  }
};

/// A surface over two parameters and an eye: a position, or the direction to it.
struct SeenSurface
{
  std::function<Truth(double u, double v)> At;
  Vector Eye;
  bool Parallel = false;

  Vector ToEye(const Vector& p) const
  {
    return (this->Parallel ? this->Eye : Vector(this->Eye - p)).normalized();
  }
  double Cosine(double u, double v) const
  {
    const Truth truth = this->At(u, v);
    return truth.Normal.dot(this->ToEye(truth.Point));
  }

  /// What belongs to a step in u and v: how far it leads, how far as it is seen, and how far the
  /// normal turns; by differences.
  struct Steps
  {
    Eigen::Matrix<double, 3, 2> Point;
    Eigen::Matrix<double, 3, 2> Screen;
    Eigen::Matrix<double, 3, 2> Normal;
  };
  Steps GetSteps(double u, double v) const
  {
    const double h = 1.0e-4;
    const Truth here = this->At(u, v);
    const Vector eye = this->ToEye(here.Point);
    Steps steps;
    for (int i = 0; i < 2; ++i)
    {
      const Truth back = this->At(u - (i == 0 ? h : 0.0), v - (i == 1 ? h : 0.0));
      const Truth forth = this->At(u + (i == 0 ? h : 0.0), v + (i == 1 ? h : 0.0));
      steps.Point.col(i) = (forth.Point - back.Point) / (2.0 * h);
      steps.Normal.col(i) = (forth.Normal - back.Normal) / (2.0 * h);
    }
    steps.Screen = steps.Point - eye * (eye.transpose() * steps.Point);
    return steps;
  }

  /// The view-dependent curvature from its definition: how far the normal turns at most for a step
  /// that looks as long as 1; and the step in u and v, as long as 1 on the surface, that does it.
  double GetCurvature(double u, double v, Eigen::Vector2d& step) const
  {
    const Steps steps = this->GetSteps(u, v);
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix2d> solver(
      steps.Normal.transpose() * steps.Normal, steps.Screen.transpose() * steps.Screen);
    step = solver.eigenvectors().col(1);
    step /= (steps.Point * step).norm();
    return std::sqrt(solver.eigenvalues()[1]);
  }
  double GetCurvature(double u, double v) const
  {
    Eigen::Vector2d step;
    return this->GetCurvature(u, v, step);
  }

  /// Its derivative along that step, which is turned to the side of `axis`, a direction in space.
  double GetDerivative(double u, double v, Vector& axis) const
  {
    Eigen::Vector2d step;
    this->GetCurvature(u, v, step);
    const Vector along = this->GetSteps(u, v).Point * step;
    if (along.dot(axis) < 0.0)
    {
      step = -step;
    }
    axis = along.dot(axis) < 0.0 ? Vector(-along) : along;
    const double h = 1.0e-3;
    const auto at = [&](double x) { return this->GetCurvature(u + x * step[0], v + x * step[1]); };
    return (8.0 * (at(h) - at(-h)) - (at(2.0 * h) - at(-2.0 * h))) / (12.0 * h);
  }
};

/// A mesh of a surface over rectangles of parameters [u0, u1] x [v0, v1], with exact arrays; every
/// other frame turned over at random.
inline vtkSmartPointer<vtkPolyData> MakeSeenMesh(const std::function<Truth(double, double)>& at,
  const std::array<double, 4>& range, int nu, int nv, int seed)
{
  auto surface = MakeGrid(nu + 1, nv + 1, false, false);
  auto normals = AddArray(surface, npr::names::Normals, 3);
  auto k1 = AddArray(surface, npr::names::PrincipalCurvature1, 1);
  auto k2 = AddArray(surface, npr::names::PrincipalCurvature2, 1);
  auto e1 = AddArray(surface, npr::names::PrincipalDirection1, 3);
  auto derivatives = AddArray(surface, npr::names::CurvatureDerivatives, 4);
  vtkNew<vtkMinimalStandardRandomSequence> random;
  random->SetSeed(seed);
  for (int i = 0; i <= nu; ++i)
  {
    for (int j = 0; j <= nv; ++j)
    {
      const vtkIdType id = static_cast<vtkIdType>(i) * (nv + 1) + j;
      const Truth truth =
        at(range[0] + (range[1] - range[0]) * i / nu, range[2] + (range[3] - range[2]) * j / nv);
      random->Next();
      const PrincipalTruth principal(truth, random->GetValue() < 0.5 ? -1.0 : 1.0);
      surface->GetPoints()->SetPoint(id, truth.Point.data());
      normals->SetTuple(id, truth.Normal.data());
      k1->SetTuple1(id, principal.K1);
      k2->SetTuple1(id, principal.K2);
      e1->SetTuple(id, principal.E1.data());
      derivatives->SetTuple(id, principal.Cubic.data());
    }
  }
  return surface;
}

/// Where a function of parameters and an axis in space changes its sign along lines of constant u
/// or v; the function turns the axis to its own and its value with it.
inline std::vector<Eigen::Vector2d> FindRoots(
  const std::function<double(double u, double v, Vector& axis)>& function,
  const std::array<double, 4>& range, int lines, int steps)
{
  std::vector<Eigen::Vector2d> roots;
  for (int direction = 0; direction < 2; ++direction)
  {
    for (int line = 0; line < lines; ++line)
    {
      const auto at = [&](double step) -> Eigen::Vector2d
      {
        const double along = step / steps;
        const double across = (line + 0.37) / lines;
        const double u = direction == 0 ? along : across;
        const double v = direction == 0 ? across : along;
        return { range[0] + (range[1] - range[0]) * u, range[2] + (range[3] - range[2]) * v };
      };
      const auto evaluate = [&](double step, Vector& axis)
      {
        const Eigen::Vector2d place = at(step);
        return function(place[0], place[1], axis);
      };
      Vector axis(0.3, 0.5, 0.7);
      double last = evaluate(0.5, axis);
      for (int i = 1; i < steps; ++i)
      {
        const Vector lastAxis = axis;
        const double next = evaluate(i + 0.5, axis);
        // Axes that are not the same axis say nothing.
        if ((next > 0.0) != (last > 0.0) && axis.dot(lastAxis) > 0.9)
        {
          double low = i - 0.5;
          double high = i + 0.5;
          for (int j = 0; j < 30; ++j)
          {
            const double middle = 0.5 * (low + high);
            Vector side = lastAxis;
            ((evaluate(middle, side) > 0.0) == (last > 0.0) ? low : high) = middle;
          }
          roots.push_back(at(low));
        }
        last = next;
      }
    }
  }
  return roots;
}

/// The same surface, moved by a rotation and scaled, and the lines of it moved back.
struct Motion
{
  Eigen::AngleAxisd Turn;
  double Size;

  vtkSmartPointer<vtkPolyData> Move(vtkPolyData* surface) const
  {
    auto moved = vtkSmartPointer<vtkPolyData>::New();
    moved->DeepCopy(surface);
    const auto scale = [&](const char* name, double factor)
    {
      vtkDataArray* array = moved->GetPointData()->GetArray(name);
      for (int c = 0; c < array->GetNumberOfComponents(); ++c)
      {
        for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
        {
          array->SetComponent(i, c, factor * array->GetComponent(i, c));
        }
      }
    };
    const auto turn = [&](const char* name)
    {
      vtkDataArray* array = moved->GetPointData()->GetArray(name);
      for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
      {
        const Vector turned = this->Turn * Vector(array->GetTuple3(i));
        array->SetTuple(i, turned.data());
      }
    };
    for (vtkIdType i = 0; i < moved->GetNumberOfPoints(); ++i)
    {
      moved->GetPoints()->SetPoint(i, this->Move(Vector(surface->GetPoint(i))).data());
    }
    turn(npr::names::Normals);
    turn(npr::names::PrincipalDirection1);
    scale(npr::names::PrincipalCurvature1, 1.0 / this->Size);
    scale(npr::names::PrincipalCurvature2, 1.0 / this->Size);
    scale(npr::names::CurvatureDerivatives, 1.0 / (this->Size * this->Size));
    return moved;
  }
  Vector Move(const Vector& p) const { return this->Size * (this->Turn * p); }
  Vector MoveBack(const Vector& p) const { return this->Turn.inverse() * p / this->Size; }
};

/// Lines of a definition, the length scale being a given length.
inline std::vector<Chain> Extract(
  vtkPolyData* surface, vtkNPRLineDefinition* definition, vtkCamera* camera, double lengthScale)
{
  vtkNew<vtkNPRFeatureLines> lines;
  lines->AddDefinition(definition);
  lines->SetLengthScale(lengthScale);
  lines->SetCamera(camera);
  lines->SetInputData(surface);
  lines->Update();
  return GetChains(lines->GetOutput());
}

/// That lines are where they were when surface and eye move together or frames are turned over, and
/// the same bits for every number of threads.
inline void CheckInvariance(const SeenSurface& seen, const std::array<double, 4>& range,
  vtkNPRLineDefinition* definition, Checks& check)
{
  const auto surface = MakeSeenMesh(seen.At, range, 60, 60, 1);
  const auto camera = MakeCamera(seen.Eye, seen.Parallel);
  const auto chains = Extract(surface, definition, camera, 1.0);
  const auto segments = GetSegments(chains);
  check(segments.size() > 30, "there is something to compare", double(segments.size()));
  check(GetSegments(Extract(MakeSeenMesh(seen.At, range, 60, 60, 2), definition, camera, 1.0)) ==
      segments,
    "turning frames over changes nothing");
  for (int threads : { 1, 2, 3 })
  {
    vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads, "STDThread", false },
      [&]()
      {
        check(GetSegments(Extract(surface, definition, camera, 1.0)) == segments,
          "the number of threads does not matter", threads);
      });
  }
  for (double size : { 1.0e-6, 1.0e6 })
  {
    const Motion motion = { Eigen::AngleAxisd(1.1, Vector(3.0, -1.0, 2.0).normalized()), size };
    const auto moved = Extract(
      motion.Move(surface), definition, MakeCamera(motion.Move(seen.Eye), seen.Parallel), size);
    double length = 0.0;
    double movedLength = 0.0;
    for (const Chain& chain : chains)
    {
      length += GetLength(chain);
    }
    for (const Chain& chain : moved)
    {
      movedLength += GetLength(chain) / size;
      for (const Vector& p : chain.Points)
      {
        const double distance = GetDistance(chains, motion.MoveBack(p));
        check(distance < 1.0e-3, "lines move with the surface", distance);
      }
    }
    check(std::abs(movedLength - length) < 1.0e-2 * length, "all of them do", movedLength - length);
  }
}

/// The eye behind, in and on the surface: nothing worse than fewer lines.
inline void CheckStrangeEyes(
  const SeenSurface& seen, const std::array<double, 4>& range, const char* name, Checks& check)
{
  const auto surface = MakeSeenMesh(seen.At, range, 20, 20, 3);
  const Vector middle(surface->GetPoint(220));
  const Vector normal(surface->GetPointData()->GetArray(npr::names::Normals)->GetTuple3(220));
  for (double height : { 0.0, 1.0e-7, 0.01, -0.01, -3.0 })
  {
    const auto camera = MakeCamera(middle + height * normal);
    camera->SetFocalPoint(0.1, 0.2, 5.0);
    CheckSound(Extract(surface, { name }, camera), check);
  }
  const auto behind = MakeCamera(Vector(0.1, 0.2, -1.0e6));
  check(Extract(surface, { name }, behind).empty(), "no line on a back face");
}

}

#endif
