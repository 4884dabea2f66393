// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Lines on finer and finer meshes of known surfaces against the true curves, which are found as
// roots of what defines them: the Hausdorff distance, both ways, falls with the edges' length, and
// thresholds mean the same at every resolution.
#include "nprImplicitShapes.h"

#include "vtkNPRCurvatureTensor.h"
#include "vtkNPRImplicitCurvature.h"
#include "vtkNPRLineDefinition.h"

#include <set>
#include <string>

using namespace nprtest;

namespace
{
/// What defines a line.
struct TrueLine
{
  /// Zero on the line; a number, and the axis that its sign belongs to (0 if it is its own).
  std::function<std::pair<double, Vector>(const Vector&)> Field;
  /// Positive where the line is surely accepted.
  std::function<double(const Vector&)> Test = [](const Vector&) { return 1.0; };

  /// The field, its axis on the side of another.
  double GetField(const Vector& p, const Vector& side) const
  {
    const auto [value, axis] = this->Field(p);
    return axis.dot(side) < 0.0 ? -value : value;
  }
};

TrueLine MakeTrueContours(const ImplicitShape& shape, const Vector& eye)
{
  TrueLine line;
  line.Field = [&shape, eye](const Vector& p)
  { return std::make_pair(shape.GetNormal(p).dot(eye - p), Vector(Vector::Zero())); };
  return line;
}

TrueLine MakeTrueSuggestive(const ImplicitShape& shape, const Vector& eye, double scale)
{
  const auto getTangent = [&shape, eye](const Vector& p)
  {
    const Vector v = (eye - p).normalized();
    const Vector n = shape.GetNormal(p);
    return Vector(v - v.dot(n) * n);
  };
  const auto radial = [&shape, getTangent](const Vector& p)
  {
    const Vector w = getTangent(p).normalized();
    return w.dot(shape.GetForm(p) * w);
  };
  TrueLine line;
  line.Field = [radial](const Vector& p)
  { return std::make_pair(radial(p), Vector(Vector::Zero())); };
  line.Test = [&shape, eye, scale, getTangent, radial](const Vector& p)
  {
    const double cosine = shape.GetNormal(p).dot((eye - p).normalized());
    const double sine = getTangent(p).norm();
    // Well within the defaults: more than 15 degrees, more than 2.
    if (cosine < 0.1 || sine < 0.35)
    {
      return -1.0;
    }
    return scale * scale * shape.Differentiate(radial, p, getTangent(p).normalized()) - 3.0;
  };
  return line;
}

TrueLine MakeTrueRidges(const ImplicitShape& shape, double scale, double side)
{
  const auto curvature = [&shape, side](const Vector& p)
  { return side * shape.GetFirstCurvature(p).first; };
  const auto slope = [&shape, curvature](const Vector& p, const Vector& direction)
  { return shape.Differentiate(curvature, p, direction); };
  TrueLine line;
  line.Field = [&shape, slope](const Vector& p)
  {
    const Vector direction = shape.GetFirstCurvature(p).second;
    return std::make_pair(slope(p, direction), direction);
  };
  line.Test = [&shape, scale, curvature](const Vector& p)
  {
    const Vector direction = shape.GetFirstCurvature(p).second;
    constexpr double h = 0.01;
    const double there = curvature(shape.Project(p + h * direction));
    const double here = curvature(p);
    const double back = curvature(shape.Project(p - h * direction));
    const double fall = (2.0 * here - there - back) / (h * h);
    // Well within the defaults: more than 4, and sharper than 0.2.
    return std::min(here * scale - 4.5, fall / std::pow(std::max(here, 0.1), 3) - 0.5);
  };
  return line;
}

//------------------------------------------------------------------------------
/// The points of the true curve on the edges of a mesh: the roots of the field, by bisection.
std::vector<Vector> FindRoots(const ImplicitShape& shape, const TrueLine& line, vtkPolyData* mesh)
{
  const vtkIdType size = mesh->GetNumberOfPoints();
  std::vector<Vector> points(size);
  std::vector<std::pair<double, Vector>> fields(size);
  for (vtkIdType i = 0; i < size; ++i)
  {
    points[i] = shape.Project(Vector(mesh->GetPoint(i)));
    fields[i] = line.Field(points[i]);
  }
  std::set<std::pair<vtkIdType, vtkIdType>> edges;
  vtkNew<vtkIdList> ids;
  for (vtkIdType t = 0; t < mesh->GetNumberOfPolys(); ++t)
  {
    mesh->GetPolys()->GetCellAtId(t, ids);
    for (int e = 0; e < 3; ++e)
    {
      edges.insert(std::minmax(ids->GetId(e), ids->GetId((e + 1) % 3)));
    }
  }
  std::vector<Vector> roots;
  for (const auto& [a, b] : edges)
  {
    const Vector& axis = fields[a].second;
    const double cosine = axis.dot(fields[b].second);
    const bool hasAxes = axis != Vector::Zero();
    const double end = hasAxes && cosine < 0.0 ? -fields[b].first : fields[b].first;
    if ((fields[a].first > 0.0) == (end > 0.0) || (hasAxes && std::abs(cosine) < 0.9))
    {
      continue;
    }
    double low = 0.0;
    double high = 1.0;
    Vector p;
    for (int i = 0; i < 30; ++i)
    {
      const double middle = 0.5 * (low + high);
      p = shape.Project(points[a] + middle * (points[b] - points[a]));
      ((line.GetField(p, axis) > 0.0) == (fields[a].first > 0.0) ? low : high) = middle;
    }
    if (line.Test(p) > 0.0)
    {
      roots.push_back(p);
    }
  }
  return roots;
}

/// How far a point is from the true curve near it: Newton's steps, the shortest that lead to it.
double GetDistanceToCurve(const ImplicitShape& shape, const TrueLine& line, const Vector& point)
{
  constexpr double h = 1.0e-4;
  const Vector axis = line.Field(shape.Project(point)).second;
  Vector p = point;
  for (int i = 0; i < 6; ++i)
  {
    Eigen::Matrix<double, 2, 3> jacobian;
    jacobian.row(0) = shape.Gradient(p);
    for (int c = 0; c < 3; ++c)
    {
      const Vector step = h * Vector::Unit(c);
      jacobian(1, c) = (line.GetField(p + step, axis) - line.GetField(p - step, axis)) / (2.0 * h);
    }
    const Eigen::Vector2d value(shape.Value(p), line.GetField(p, axis));
    p -= jacobian.transpose() * (jacobian * jacobian.transpose()).ldlt().solve(value);
  }
  return (p - point).norm();
}

double GetDistanceToChains(const std::vector<Chain>& chains, const Vector& p)
{
  double least = 1.0e9;
  for (const Chain& chain : chains)
  {
    for (std::size_t i = 0; i < chain.GetNumberOfSegments(); ++i)
    {
      const Vector along = chain.Next(i) - chain.Points[i];
      const double t = (p - chain.Points[i]).dot(along) / along.squaredNorm();
      const Vector nearest = chain.Points[i] + std::clamp(t, 0.0, 1.0) * along;
      least = std::min(least, (p - nearest).norm());
    }
  }
  return least;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> AddTrueCurvature(ImplicitShape& shape, vtkPolyData* mesh)
{
  vtkNew<vtkNPRImplicitCurvature> curvature;
  curvature->SetImplicitFunction(&shape);
  curvature->SetInputData(mesh);
  curvature->Update();
  return curvature->GetOutput();
}

vtkSmartPointer<vtkPolyData> AddEstimatedCurvature(vtkPolyData* mesh)
{
  vtkNew<vtkNPRCurvatureTensor> curvature;
  curvature->SetInputData(mesh);
  curvature->Update();
  return curvature->GetOutput();
}

using Maker = std::function<vtkSmartPointer<vtkPolyData>(int resolution)>;

/// A mesh of the torus, the ellipsoid or the waves, of edges that are as long as 1 / resolution.
vtkSmartPointer<vtkPolyData> MakeTorusMesh(const ImplicitShape& shape, int n)
{
  const int nu = 6 * n;
  const int nv = 3 * n;
  auto mesh = MakeGrid(nu, nv, true, true);
  for (int i = 0; i < nu; ++i)
  {
    for (int j = 0; j < nv; ++j)
    {
      mesh->GetPoints()->SetPoint(
        i * nv + j, Torus().Point(2.0 * Pi * i / nu, 2.0 * Pi * j / nv).data());
    }
  }
  return PutOn(shape, mesh);
}

vtkSmartPointer<vtkPolyData> MakeWavesMesh(const ImplicitShape& shape, int n)
{
  const int size = 4 * n + 1;
  auto mesh = MakeGrid(size, size, false, false);
  for (int i = 0; i < size; ++i)
  {
    for (int j = 0; j < size; ++j)
    {
      const double x = -2.0 + 4.0 * i / (size - 1);
      const double y = -1.3 + 3.0 * j / (size - 1);
      mesh->GetPoints()->SetPoint(i * size + j, x, y, 0.0);
    }
  }
  return PutOn(shape, mesh);
}

vtkSmartPointer<vtkPolyData> MakeEllipsoidMesh(
  const ImplicitShape& shape, const Vector& axes, int n)
{
  auto mesh = MakeSphere(2 * n, 1.0);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const Vector point = axes.cwiseProduct(Vector(mesh->GetPoint(i)));
    mesh->GetPoints()->SetPoint(i, point.data());
  }
  return PutOn(shape, mesh);
}

//------------------------------------------------------------------------------
struct Case
{
  std::string What;
  const char* Line;
  Vector Eye;
  double LengthScale;
  double Rate; // the least exponent of the edges' length
  /// Only what is here is compared.
  std::function<bool(const Vector&)> Region = [](const Vector&) { return true; };
};

void TestCase(const Case& what, ImplicitShape& shape, const TrueLine& truth, const Maker& make,
  const std::vector<int>& resolutions, Checks& check)
{
  std::vector<Vector> roots = FindRoots(shape, truth, make(resolutions[1]));
  roots.erase(std::remove_if(
                roots.begin(), roots.end(), [&](const Vector& root) { return !what.Region(root); }),
    roots.end());
  check(roots.size() > 20, (what.What + ": there is a curve").c_str(), double(roots.size()));
  std::vector<double> distances;
  for (const int resolution : resolutions)
  {
    vtkNew<vtkNPRFeatureLines> lines;
    lines->AddDefinition(what.Line);
    lines->SetCamera(MakeCamera(what.Eye));
    lines->SetLengthScale(what.LengthScale);
    lines->SetInputData(make(resolution));
    lines->Update();
    const auto chains = GetChains(lines->GetOutput());
    double distance = 0.0;
    for (const Vector& root : roots)
    {
      distance = std::max(distance, GetDistanceToChains(chains, root));
    }
    double back = 0.0;
    for (const Chain& chain : chains)
    {
      for (std::size_t i = 0; i < chain.GetNumberOfSegments(); ++i)
      {
        for (const Vector& p : { chain.Points[i], Vector(0.5 * (chain.Points[i] + chain.Next(i))) })
        {
          back = what.Region(p) ? std::max(back, GetDistanceToCurve(shape, truth, p)) : back;
        }
      }
    }
    std::cout << what.What << ", " << resolution << ": " << chains.size() << " chains, " << distance
              << " from the curve to them, " << back << " back\n";
    distances.push_back(std::max(distance, back));
  }
  const double rate = std::log(distances.front() / distances.back()) /
    std::log(double(resolutions.back()) / resolutions.front());
  std::cout << what.What << ": rate " << rate << "\n";
  check(rate > what.Rate, (what.What + ": rate").c_str(), rate);
}

//------------------------------------------------------------------------------
// With all thresholds as they are by default, there is as much of a line on every mesh.
void TestLengths(const char* name, const Vector& eye, const Maker& make,
  const std::vector<int>& resolutions, double tolerance, Checks& check)
{
  std::vector<double> lengths;
  for (const int resolution : resolutions)
  {
    const auto chains = Extract(AddEstimatedCurvature(make(resolution)), { name }, MakeCamera(eye));
    double length = 0.0;
    for (const Chain& chain : chains)
    {
      length += GetLength(chain);
    }
    std::cout << name << ", " << resolution << ": length " << length << " in " << chains.size()
              << " chains\n";
    lengths.push_back(length);
  }
  const auto [least, most] = std::minmax_element(lengths.begin(), lengths.end());
  check(*least > 1.0, "there are lines", *least);
  check(*most < (1.0 + tolerance) * *least, name, *most / *least);
}
}

int TestLinesConvergence(int, char*[])
{
  Checks check;
  const Vector eye(3.1, 2.2, 4.3);
  const auto torus = MakeTorusShape();
  const Vector axes(1.5, 1.0, 0.6);
  const auto ellipsoid = MakeEllipsoidShape(axes);
  const auto waves = MakeWavesShape();
  const auto tangle = MakeTangleShape();
  const auto withTruth = [](ImplicitShape& shape, const Maker& make) -> Maker
  { return [&shape, make](int n) { return AddTrueCurvature(shape, make(n)); }; };
  const auto withEstimate = [](const Maker& make) -> Maker
  { return [make](int n) { return AddEstimatedCurvature(make(n)); }; };
  const Maker makeTorus = [&](int n) { return MakeTorusMesh(*torus, n); };
  const Maker makeEllipsoid = [&](int n) { return MakeEllipsoidMesh(*ellipsoid, axes, n); };
  const Maker makeWaves = [&](int n) { return MakeWavesMesh(*waves, n); };
  const Maker makeTangle = [&](int n) { return MakeIsosurface(*tangle, 3.0, n); };
  const Vector farEye = 2.5 * eye;
  // Estimates see less at the border.
  const auto inside = [](const Vector& p)
  { return std::abs(p[0]) < 1.6 && p[1] > -1.0 && p[1] < 1.4; };

  TestCase({ "contours of a torus", "contours", eye, 1.0, 1.8 }, *torus,
    MakeTrueContours(*torus, eye), withTruth(*torus, makeTorus), { 8, 16, 32 }, check);
  TestCase({ "contours of an ellipsoid", "contours", eye, 1.0, 1.8 }, *ellipsoid,
    MakeTrueContours(*ellipsoid, eye), withTruth(*ellipsoid, makeEllipsoid), { 8, 16, 32 }, check);
  TestCase({ "contours of an isosurface", "contours", farEye, 1.0, 1.8 }, *tangle,
    MakeTrueContours(*tangle, farEye), withTruth(*tangle, makeTangle), { 24, 48, 96 }, check);
  TestCase({ "suggestive contours of a torus", "suggestive", eye, 2.0, 1.0 }, *torus,
    MakeTrueSuggestive(*torus, eye, 2.0), withTruth(*torus, makeTorus), { 8, 16, 32 }, check);
  TestCase({ "suggestive contours of an isosurface", "suggestive", farEye, 2.0, 1.0 }, *tangle,
    MakeTrueSuggestive(*tangle, farEye, 2.0), withTruth(*tangle, makeTangle), { 24, 48, 96 },
    check);
  TestCase({ "suggestive contours of waves", "suggestive", eye, 1.5, 1.0 }, *waves,
    MakeTrueSuggestive(*waves, eye, 1.5), withTruth(*waves, makeWaves), { 8, 16, 32 }, check);
  TestCase({ "suggestive contours of waves, estimated", "suggestive", eye, 1.5, 1.0, inside },
    *waves, MakeTrueSuggestive(*waves, eye, 1.5), withEstimate(makeWaves), { 8, 16, 32 }, check);
  TestCase({ "ridges of an ellipsoid", "ridges", eye, 2.0, 1.0 }, *ellipsoid,
    MakeTrueRidges(*ellipsoid, 2.0, 1.0), withTruth(*ellipsoid, makeEllipsoid), { 8, 16, 32 },
    check);
  TestCase({ "ridges of waves", "ridges", eye, 5.0, 1.0 }, *waves, MakeTrueRidges(*waves, 5.0, 1.0),
    withTruth(*waves, makeWaves), { 8, 16, 32 }, check);
  TestCase({ "valleys of waves", "valleys", eye, 5.0, 1.0 }, *waves,
    MakeTrueRidges(*waves, 5.0, -1.0), withTruth(*waves, makeWaves), { 8, 16, 32 }, check);
  TestCase({ "ridges of waves, estimated", "ridges", eye, 5.0, 1.0, inside }, *waves,
    MakeTrueRidges(*waves, 5.0, 1.0), withEstimate(makeWaves), { 8, 16, 32 }, check);

  TestLengths("suggestive", farEye, makeTangle, { 40, 60, 90 }, 0.05, check);
  const Vector flatAxes(1.5, 1.0, 0.4);
  const auto flat = MakeEllipsoidShape(flatAxes);
  const Maker makeFlat = [&](int n) { return MakeEllipsoidMesh(*flat, flatAxes, n); };
  TestLengths("ridges", eye, makeFlat, { 16, 24, 36 }, 0.05, check);
  TestLengths("valleys", farEye, makeTangle, { 40, 60, 90 }, 0.05, check);
  TestLengths("suggestive", eye, makeWaves, { 24, 36, 54 }, 0.05, check);
  return check.GetResult();
}
