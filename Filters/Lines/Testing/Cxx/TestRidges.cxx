// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Ridges and valleys of surfaces where they are known: of a wave along its crests and troughs, of
// an ellipsoid along its largest section, of spheres, cylinders and tori nowhere.
#include "nprLineTesting.h"

#include "nprTangentFrame.h"
#include "vtkNPRRidges.h"
#include "vtkNPRValleys.h"

#include <vtkMinimalStandardRandomSequence.h>

#include <functional>

using namespace nprtest;

namespace
{
// What is true at a point.
struct Truth
{
  Vector Normal;
  Vector E1;
  double K1;
  double P;
};

// Gives each point its truth, every other axis turned over at random.
void AddTruths(vtkPolyData* surface, const std::function<Truth(const Vector&)>& at, int seed)
{
  auto normals = AddArray(surface, npr::names::Normals, 3);
  auto k1 = AddArray(surface, npr::names::PrincipalCurvature1, 1);
  auto e1 = AddArray(surface, npr::names::PrincipalDirection1, 3);
  auto derivatives = AddArray(surface, npr::names::CurvatureDerivatives, 4);
  vtkNew<vtkMinimalStandardRandomSequence> random;
  random->SetSeed(seed);
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    Vector p;
    surface->GetPoint(i, p.data());
    const Truth truth = at(p);
    random->Next();
    const double way = random->GetValue() < 0.5 ? -1.0 : 1.0;
    normals->SetTuple(i, truth.Normal.data());
    k1->SetTuple1(i, truth.K1);
    e1->SetTuple(i, Vector(way * truth.E1).data());
    derivatives->SetTuple4(i, way * truth.P, 0.0, 0.0, 0.0);
  }
}

// An ellipsoid from its equation. P by differences of the exact curvature.
struct Ellipsoid
{
  Vector Axes;

  double GetK1(const Vector& p, Vector& normal, Vector& e1) const
  {
    const Vector gradient = p.cwiseQuotient(this->Axes.cwiseProduct(this->Axes));
    normal = gradient.normalized();
    const npr::TangentFrame frame = npr::MakeTangentFrame(normal);
    const Vector inverse = this->Axes.cwiseProduct(this->Axes).cwiseInverse();
    const auto form = [&](const Vector& a, const Vector& b)
    { return a.cwiseProduct(inverse).dot(b) / gradient.norm(); };
    Eigen::Matrix2d matrix;
    matrix << form(frame.U, frame.U), form(frame.U, frame.V), form(frame.V, frame.U),
      form(frame.V, frame.V);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(matrix);
    const Eigen::Vector2d first = solver.eigenvectors().col(1);
    e1 = first[0] * frame.U + first[1] * frame.V;
    return solver.eigenvalues()[1];
  }
  Vector Project(const Vector& p) const { return p / p.cwiseQuotient(this->Axes).norm(); }
  Truth At(const Vector& p) const
  {
    Truth truth;
    truth.K1 = this->GetK1(p, truth.Normal, truth.E1);
    const double h = 1.0e-4;
    Vector n, e;
    truth.P = (this->GetK1(this->Project(p + h * truth.E1), n, e) -
                this->GetK1(this->Project(p - h * truth.E1), n, e)) /
      (2.0 * h);
    return truth;
  }
  // The points of a sphere that is turned, so that no row of them lies along a ridge.
  vtkSmartPointer<vtkPolyData> Make(int n, int seed) const
  {
    auto surface = MakeSphere(n, 1.0);
    const Eigen::AngleAxisd turn(0.7, Vector(1.0, 2.0, 3.0).normalized());
    for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
    {
      Vector p;
      surface->GetPoint(i, p.data());
      surface->GetPoints()->SetPoint(i, Vector((turn * p).cwiseProduct(this->Axes)).data());
    }
    AddTruths(
      surface, [this](const Vector& p) { return this->At(p); }, seed);
    return surface;
  }
};

// z = a cos x, the same for all y.
struct Wave
{
  double a = 0.6;

  Truth At(const Vector& p) const
  {
    const double slope = -this->a * std::sin(p[0]);
    const double second = -this->a * std::cos(p[0]);
    const double third = this->a * std::sin(p[0]);
    const double w = std::sqrt(1.0 + slope * slope);
    Truth truth;
    truth.Normal = Vector(-slope, 0.0, 1.0) / w;
    truth.E1 = Vector(1.0, 0.0, slope) / w;
    truth.K1 = -second / (w * w * w);
    const double dx = -third / (w * w * w) + 3.0 * second * second * slope / std::pow(w, 5.0);
    // Exactly 0 on points that are meant to be on a crest.
    truth.P = std::abs(dx) < 1.0e-12 ? 0.0 : dx / w;
    return truth;
  }
  // Slanting, or with a row of points along each ridge and a trough at both ends, of which one
  // counts.
  vtkSmartPointer<vtkPolyData> Make(int n, bool slanting, int seed) const
  {
    auto surface = MakeGrid(4 * n + 1, n + 1, false, false);
    for (int i = 0; i <= 4 * n; ++i)
    {
      for (int j = 0; j <= n; ++j)
      {
        const double y = 3.0 * j / n;
        const double x = slanting ? -3.0 + 11.0 * i / (4.0 * n) + y / 3.0 : 2.0 * Pi * i / n - Pi;
        surface->GetPoints()->SetPoint(i * (n + 1) + j, x, y, this->a * std::cos(x));
      }
    }
    AddTruths(
      surface, [this](const Vector& p) { return this->At(p); }, seed);
    return surface;
  }
};

std::vector<Chain> ExtractRidges(vtkPolyData* surface, bool valleys, double threshold)
{
  const auto definition = valleys
    ? vtkSmartPointer<vtkNPRRidges>(vtkSmartPointer<vtkNPRValleys>::New())
    : vtkSmartPointer<vtkNPRRidges>::New();
  definition->SetThreshold(threshold);
  vtkNew<vtkNPRFeatureLines> lines;
  lines->SetLengthScale(1.0);
  lines->AddDefinition(definition);
  lines->SetInputData(surface);
  lines->Update();
  return GetChains(lines->GetOutput());
}

void TestEllipsoid(Checks& check)
{
  const Ellipsoid ellipsoid{ { 1.5, 1.0, 0.6 } };
  double lastError = 0.0;
  for (int n : { 30, 60, 120 })
  {
    const auto surface = ellipsoid.Make(n, 1);
    const auto chains = ExtractRidges(surface, false, 0.1);
    CheckSound(chains, check);
    // Between the umbilics is a line where the curvature has a minimum: that is no ridge.
    check(chains.size() == 1 && chains[0].Closed, "one closed ridge", double(chains.size()));
    double error = 0.0;
    for (const Chain& chain : chains)
    {
      for (const Vector& p : chain.Points)
      {
        error = std::max(error, std::abs(p[2]));
      }
      // Ramanujan's circumference of an ellipse.
      const double h = std::pow(0.5 / 2.5, 2.0);
      const double circumference = Pi * 2.5 * (1.0 + 3.0 * h / (10.0 + std::sqrt(4.0 - 3.0 * h)));
      check(std::abs(GetLength(chain) - circumference) < 15.0 / (n * n), "it is the whole section",
        GetLength(chain));
      check(*std::min_element(chain.Strength.begin(), chain.Strength.end()) > 0.1, "it is strong");
    }
    check(
      lastError == 0.0 || error < 0.3 * lastError, "the error falls with h^2", error / lastError);
    lastError = error;
    check(ExtractRidges(surface, true, 0.1).empty(), "an ellipsoid has no valley");
    check(ExtractRidges(surface, false, 5.0).empty(), "the threshold holds");
    check(ExtractRidges(surface, false, 3.5).size() == 2, "the ends of the ellipsoid bend most");
  }
}

void TestWave(Checks& check)
{
  const Wave wave;
  for (bool slanting : { true, false })
  {
    double lastError = 0.0;
    for (int n : { 16, 32, 64 })
    {
      const auto surface = wave.Make(n, slanting, 2);
      for (bool valleys : { false, true })
      {
        const auto chains = ExtractRidges(surface, valleys, 0.1);
        CheckSound(chains, check);
        check(chains.size() == (slanting ? (valleys ? 1u : 2u) : 4u), "one line for each crest",
          double(chains.size()));
        double error = 0.0;
        for (const Chain& chain : chains)
        {
          check(GetLength(chain) > 2.99, "a line runs from side to side", GetLength(chain));
          for (const Vector& p : chain.Points)
          {
            const double turns = p[0] / (2.0 * Pi) - (valleys ? 0.5 : 0.0);
            error = std::max(error, 2.0 * Pi * std::abs(turns - std::round(turns)));
          }
        }
        if (slanting && !valleys)
        {
          check(lastError == 0.0 || error < 0.4 * lastError, "the error falls with h^2",
            error / lastError);
          lastError = error;
        }
        check(slanting || error < 1.0e-6, "lines through points are exact", error);
      }
    }
  }
}

// Where the curvature does not change across, no noise makes a line.
void TestConstant(Checks& check)
{
  vtkNew<vtkMinimalStandardRandomSequence> random;
  random->SetSeed(3);
  for (double noise : { 0.0, 0.001 })
  {
    const auto addNoise = [&](const Truth& truth)
    {
      random->Next();
      Truth noisy = truth;
      noisy.P = noise * random->GetRangeValue(-1.0, 1.0) * truth.K1 * truth.K1;
      return noisy;
    };
    const Torus shape;
    const auto torus = shape.Make(120, 60);
    AddTruths(
      torus,
      [&](const Vector& p)
      {
        const double u = std::atan2(p[1], p[0]);
        const double v = std::atan2(p[2], std::hypot(p[0], p[1]) - shape.R);
        return addNoise({ shape.Normal(u, v), shape.AlongV(u, v), 1.0 / shape.r, 0.0 });
      },
      4);
    check(ExtractRidges(torus, false, 0.1).empty(), "a torus has no ridge", noise);
    const auto cylinder = MakeGrid(60, 30, true, false);
    for (vtkIdType i = 0; i < cylinder->GetNumberOfPoints(); ++i)
    {
      const double angle = 2.0 * Pi * (i / 30) / 60.0;
      cylinder->GetPoints()->SetPoint(i, std::cos(angle), std::sin(angle), 0.1 * (i % 30));
    }
    AddTruths(
      cylinder,
      [&](const Vector& p) {
        return addNoise({ { p[0], p[1], 0.0 }, { -p[1], p[0], 0.0 }, 1.0, 0.0 });
      },
      5);
    check(ExtractRidges(cylinder, false, 0.1).empty(), "a cylinder has no ridge", noise);
    const auto sphere = MakeSphere(30, 1.0);
    AddTruths(
      sphere,
      [&](const Vector& p) {
        return addNoise({ p, npr::MakeTangentFrame(p).U, 1.0, 0.0 });
      },
      6);
    check(ExtractRidges(sphere, false, 0.1).empty(), "a sphere has no ridge", noise);
    check(ExtractRidges(sphere, true, 0.0).empty(), "a sphere has no valley", noise);
  }
}

void TestInvariance(Checks& check)
{
  const Wave wave;
  const auto surface = wave.Make(20, true, 7);
  const auto segments = GetSegments(ExtractRidges(surface, false, 0.1));
  check(segments.size() > 40, "there is something to compare");

  for (bool slanting : { true, false })
  {
    check(GetSegments(ExtractRidges(wave.Make(20, slanting, 8), false, 0.1)) ==
        GetSegments(ExtractRidges(wave.Make(20, slanting, 9), false, 0.1)),
      "turning axes over changes nothing");
  }

  // Points and triangles in the opposite order; the latter begin with another corner.
  auto permuted = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const vtkIdType last = surface->GetNumberOfPoints() - 1;
  for (vtkIdType i = last; i >= 0; --i)
  {
    points->InsertNextPoint(surface->GetPoint(i));
  }
  permuted->SetPoints(points);
  vtkNew<vtkCellArray> triangles;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = surface->GetNumberOfPolys() - 1; cell >= 0; --cell)
  {
    surface->GetPolys()->GetCellAtId(cell, ids);
    triangles->InsertNextCell({ last - ids->GetId(1), last - ids->GetId(2), last - ids->GetId(0) });
  }
  permuted->SetPolys(triangles);
  AddTruths(
    permuted, [&](const Vector& p) { return wave.At(p); }, 10);
  check(GetSegments(ExtractRidges(permuted, false, 0.1)) == segments,
    "the order of points and triangles does not matter");

  // Turned inside out, ridges are valleys.
  auto reversed = vtkSmartPointer<vtkPolyData>::New();
  reversed->SetPoints(surface->GetPoints());
  vtkNew<vtkCellArray> others;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfPolys(); ++cell)
  {
    surface->GetPolys()->GetCellAtId(cell, ids);
    others->InsertNextCell({ ids->GetId(0), ids->GetId(2), ids->GetId(1) });
  }
  reversed->SetPolys(others);
  AddTruths(
    reversed,
    [&](const Vector& p)
    {
      const Truth truth = wave.At(p);
      return Truth{ -truth.Normal, truth.E1, -truth.K1, -truth.P };
    },
    11);
  check(GetSegments(ExtractRidges(reversed, true, 0.1)) == segments,
    "ridges are the valleys of the other side");

  // Turned in space, and as small as a millionth.
  const Eigen::AngleAxisd turn(1.1, Vector(3.0, -1.0, 2.0).normalized());
  const double size = 1.0e-6;
  auto turned = vtkSmartPointer<vtkPolyData>::New();
  turned->DeepCopy(surface);
  for (vtkIdType i = 0; i <= last; ++i)
  {
    Vector p;
    surface->GetPoint(i, p.data());
    turned->GetPoints()->SetPoint(i, Vector(size * (turn * p)).data());
  }
  AddTruths(
    turned,
    [&](const Vector& p)
    {
      const Truth truth = wave.At(turn.inverse() * p / size);
      return Truth{ turn * truth.Normal, turn * truth.E1, truth.K1 / size,
        truth.P / (size * size) };
    },
    12);
  vtkNew<vtkNPRRidges> ridges;
  ridges->SetThreshold(0.1);
  vtkNew<vtkNPRFeatureLines> lines;
  lines->SetLengthScale(size);
  lines->AddDefinition(ridges);
  lines->SetInputData(turned);
  lines->Update();
  auto back = GetChains(lines->GetOutput());
  check(GetSegments(back).size() == segments.size(), "the turned surface has the same lines",
    double(GetSegments(back).size()) - double(segments.size()));
  for (Chain& chain : back)
  {
    for (Vector& p : chain.Points)
    {
      p = turn.inverse() * p / size;
      const double turns = p[0] / (2.0 * Pi);
      check(std::abs(turns - std::round(turns)) < 0.02, "they are where they were", p[0]);
    }
  }
}
}

int TestRidges(int, char*[])
{
  Checks check;
  TestEllipsoid(check);
  TestWave(check);
  TestConstant(check);
  TestInvariance(check);
  return check.GetResult();
}
