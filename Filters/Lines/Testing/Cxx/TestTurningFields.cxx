// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Lines of fields whose sign belongs to an axis that may point either way.
#include "nprGivenLines.h"
#include "nprLineTesting.h"

#include <vtkMinimalStandardRandomSequence.h>

#include <functional>

using namespace nprtest;

namespace
{
constexpr int Size = 21;

/// The square [-1, 1]^2. `at` gives an axis and the field's value for it, at random one way or the
/// other. Normals and axes are as if it were bent between x = 0 and 0.1, each half by an angle.
std::vector<Chain> Extract(const std::function<std::pair<Vector, double>(double x, double y)>& at,
  int seed, double angle = 0.0)
{
  const auto surface = MakeGrid(Size, Size, false, false);
  auto normals = AddArray(surface, npr::names::Normals, 3);
  auto axes = AddArray(surface, "Axes", 3);
  auto field = AddArray(surface, "Field", 1);
  vtkNew<vtkMinimalStandardRandomSequence> random;
  random->SetSeed(seed);
  for (vtkIdType i = 0; i < Size * Size; ++i)
  {
    const double x = -1.0 + 2.0 * (i / Size) / (Size - 1);
    const double y = -1.0 + 2.0 * (i % Size) / (Size - 1);
    random->Next();
    const double way = random->GetValue() < 0.5 ? -1.0 : 1.0;
    const auto [axis, value] = at(x, y);
    surface->GetPoints()->SetPoint(i, x, y, 0.0);
    const Eigen::AngleAxisd bend(x < 0.05 ? -angle : angle, Vector::UnitY());
    normals->SetTuple(i, Vector(bend * Vector::UnitZ()).data());
    axes->SetTuple(i, Vector(way * (bend * axis)).data());
    field->SetTuple1(i, way * value);
  }
  vtkNew<GivenLines> definition;
  definition->Axial = true;
  vtkNew<vtkNPRFeatureLines> lines;
  lines->AddDefinition(definition);
  lines->SetInputData(surface);
  lines->Update();
  return GetChains(lines->GetOutput());
}
}

int TestTurningFields(int, char*[])
{
  Checks check;
  for (int seed = 1; seed <= 5; ++seed)
  {
    // Around a point where axes have no direction they turn by half a circle: there a line ends.
    // The middle is inside of a triangle, and the line misses all points.
    const auto half = Extract(
      [](double x, double y)
      {
        const double angle = 0.5 * std::atan2(y - 0.03, x - 0.06);
        return std::make_pair(Vector(std::cos(angle), std::sin(angle), 0.0), std::cos(angle));
      },
      seed);
    CheckSound(half, check);
    if (check(half.size() == 1 && !half[0].Closed, "one line with two ends", double(half.size())))
    {
      const Vector& a = half[0].Points.front();
      const Vector& b = half[0].Points.back();
      const Vector inner = a.norm() < b.norm() ? a : b;
      const Vector outer = a.norm() < b.norm() ? b : a;
      check((inner - Vector(0.06, 0.03, 0.0)).norm() < 0.15, "it begins in the middle");
      check(std::abs(outer[0] + 1.0) < 1.0e-6, "it ends at the border", outer[0]);
      for (const Vector& p : half[0].Points)
      {
        check(std::abs(p[1] - 0.03) < 0.02, "it is where the field is zero", p[1]);
      }
    }

    // Across a sharp bend axes are compared after the turn from one side to the other; beyond a
    // right angle they are not.
    const auto across = [](double x, double) { return std::make_pair(Vector(1, 0, 0), x - 0.05); };
    const auto bent = Extract(across, seed, 0.7);
    check(bent.size() == 1 && std::abs(GetLength(bent[0]) - 2.0) < 1.0e-6,
      "a line runs along a bend", double(bent.size()));
    check(Extract(across, seed, 0.8).empty(), "no line where the surface turns back");

    // Where axes swap, a change of the sign means nothing.
    check(Extract(
            [](double x, double) {
              return x < 0.02 ? std::make_pair(Vector(1, 0, 0), 1.0)
                              : std::make_pair(Vector(0, 1, 0), -1.0);
            },
            seed)
            .empty(),
      "no line between different axes");

    // A row of points where the field is exactly 0, its axes anyhow: one line from side to side.
    const auto row =
      Extract([](double x, double) { return std::make_pair(Vector(0, 1, 0), x); }, seed);
    CheckSound(row, check);
    check(row.size() == 1 && std::abs(GetLength(row[0]) - 2.0) < 1.0e-6,
      "exact zeros neither lose nor double the line", double(row.size()));

    // The same where the order of the axes in space changes along the row.
    const auto turning = Extract(
      [](double x, double y)
      {
        const double angle = 0.5 * Pi + 1.2 * y;
        return std::make_pair(Vector(std::cos(angle), std::sin(angle), 0.0), x);
      },
      seed);
    CheckSound(turning, check);
    check(turning.size() == 1 && std::abs(GetLength(turning[0]) - 2.0) < 1.0e-6,
      "exact zeros between axes of either order", double(turning.size()));
  }
  return check.GetResult();
}
