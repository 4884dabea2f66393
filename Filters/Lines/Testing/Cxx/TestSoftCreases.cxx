// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Creases below the angle: walls that meet a round, folds that fade; and what must not be one: the
// edges of coarse cylinders, spheres, rings and fillets.
#include "nprAnalyticSurfaces.h"
#include "nprLineTesting.h"

#include "vtkNPRSurfacePreparation.h"

#include <vtkAppendPolyData.h>

using namespace nprtest;

namespace
{
std::vector<Chain> ExtractCreases(vtkPolyData* surface, Checks& check)
{
  vtkNew<vtkNPRSurfacePreparation> preparation;
  preparation->SetInputData(surface);
  vtkNew<vtkNPRFeatureLines> lines;
  lines->AddDefinition("creases");
  lines->SetInputConnection(preparation->GetOutputPort());
  lines->Update();
  const auto chains = GetChains(lines->GetOutput());
  CheckSound(chains, check);
  return chains;
}

using Profile = std::vector<std::array<double, 2>>;

/// A sheet with so many rows across a profile, some length apart.
vtkSmartPointer<vtkPolyData> Extrude(const Profile& profile, int rows, double length)
{
  auto sheet = MakeGrid(static_cast<int>(profile.size()), rows, false, false);
  for (vtkIdType i = 0; i < sheet->GetNumberOfPoints(); ++i)
  {
    const auto& [x, z] = profile[i / rows];
    sheet->GetPoints()->SetPoint(i, x, length * static_cast<double>(i % rows) / (rows - 1), z);
  }
  return sheet;
}

/// Goes on in a direction, which turns to the left by an angle at the start and by as much in all
/// on the way, in so many steps along an arc.
class Pen
{
public:
  explicit Pen(Profile& profile) : Line(profile) { this->Line.push_back({ 0.0, 0.0 }); }
  void Turn(double degrees) { this->Direction += vtkMath::RadiansFromDegrees(degrees); }
  void Draw(double length)
  {
    const auto& [x, z] = this->Line.back();
    this->Line.push_back(
      { x + length * std::cos(this->Direction), z + length * std::sin(this->Direction) });
  }
  void DrawArc(double radius, double degrees, int steps)
  {
    const double step = degrees / steps;
    for (int i = 0; i < steps; ++i)
    {
      this->Turn(0.5 * step);
      this->Draw(2.0 * radius * std::sin(std::abs(vtkMath::RadiansFromDegrees(0.5 * step))));
      this->Turn(0.5 * step);
    }
  }

private:
  Profile& Line;
  double Direction = 0.0;
};

// A wall with a round channel in it, whose sides meet it at 31 degrees.
void TestChannel(Checks& check)
{
  for (const int steps : { 6, 8, 16, 40 })
  {
    for (const int rows : { 2, 5, 20 })
    {
      Profile profile;
      Pen pen(profile);
      pen.Draw(1.0);
      pen.Turn(-31.0);
      const std::size_t first = profile.size() - 1;
      pen.DrawArc(1.0, 62.0, steps);
      const std::size_t second = profile.size() - 1;
      pen.Turn(-31.0);
      pen.Draw(1.0);
      const auto chains = ExtractCreases(Extrude(profile, rows, 4.0), check);
      check(chains.size() == 2, "a channel has two edges", static_cast<double>(chains.size()));
      for (const Chain& chain : chains)
      {
        const Vector& p = chain.Points[0];
        check(
          std::abs(GetLength(chain) - 4.0) < 1.0e-5, "they are as long as it", GetLength(chain));
        check(std::min(std::abs(p[0] - profile[first][0]), std::abs(p[0] - profile[second][0])) <
            1.0e-5,
          "and where the wall ends", p[0]);
      }
    }
  }
}

// Flat faces joined by fillets, of steps alike and unlike.
void TestFillets(Checks& check)
{
  for (const double angle : { 30.0, 60.0, 90.0, 150.0 })
  {
    for (int steps = static_cast<int>(angle / 39.0) + 1; steps <= 12; ++steps)
    {
      for (const double radius : { 0.1, 0.5 })
      {
        Profile profile;
        Pen pen(profile);
        pen.Draw(1.0);
        pen.DrawArc(radius, angle, steps);
        pen.Draw(2.0);
        check(ExtractCreases(Extrude(profile, 7, 2.0), check).empty(), "a fillet is no crease",
          angle + 0.01 * steps);
      }
    }
  }
  // Twice as coarse from the middle on, and a radius that grows.
  Profile profile;
  Pen pen(profile);
  pen.Draw(1.0);
  pen.DrawArc(0.2, 45.0, 4);
  pen.DrawArc(0.2, 45.0, 2);
  pen.Draw(1.0);
  for (const double radius : { 0.1, 0.15, 0.2, 0.3 })
  {
    pen.DrawArc(radius, 25.0, 1);
  }
  pen.Draw(1.0);
  check(ExtractCreases(Extrude(profile, 7, 2.0), check).empty(), "nor is an uneven one");
}

// What is round all around, however coarse.
void TestRounds(Checks& check)
{
  for (const int sides : { 8, 9 })
  {
    // Beside what is much larger.
    vtkNew<vtkAppendPolyData> both;
    both->AddInputData(MakeCan(0.03, 0.2, sides));
    both->AddInputData(Extrude({ { 1.0, 0.0 }, { 3.0, 0.0 } }, 2, 2.0));
    both->Update();
    const auto pin = ExtractCreases(both->GetOutput(), check);
    check(pin.size() == 2, "a thin pin has two rims and no other crease",
      static_cast<double>(pin.size()));
  }
  for (const int sides : { 10, 12, 16, 24 })
  {
    const auto can = ExtractCreases(MakeCan(1.0, 3.0, sides), check);
    check(can.size() == 2, "a cylinder has two rims and no other crease",
      static_cast<double>(can.size()));
    check(ExtractCreases(MakeSphere(sides, 1.0), check).empty(), "a sphere has no crease", sides);
    check(ExtractCreases(MakeTorus(1.0, 0.4, sides, sides).Mesh, check).empty(),
      "a ring has no crease", sides);
  }
  for (const int level : { 2, 3 })
  {
    check(ExtractCreases(MakeOctasphere(1.0, level), check).empty(), "nor has a ball", level);
  }
}

// What is made of flat faces keeps its edges: chamfers of 45 degrees, bars.
void TestChamfers(Checks& check)
{
  for (const double width : { 0.05, 0.2, 1.0 })
  {
    Profile profile;
    Pen pen(profile);
    pen.Draw(2.0);
    pen.Turn(45.0);
    pen.Draw(width);
    pen.Turn(45.0);
    pen.Draw(1.0);
    const auto chains = ExtractCreases(Extrude(profile, 7, 2.0), check);
    check(chains.size() == 2, "a chamfer has two edges", static_cast<double>(chains.size()));
  }
  for (const int sides : { 6, 8 })
  {
    const auto bar = ExtractCreases(MakeCan(1.0, 3.0, sides), check);
    check(bar.size() == 3u * sides, "a hexagonal or octagonal bar has all edges",
      static_cast<double>(bar.size()));
  }
}

// A shaft that gets thinner, or thicker, by a cone of 29 degrees, with flat ends.
void TestTurnedParts(Checks& check)
{
  const Profile outline = { { 0.2, 0.0 }, { 1.0, 0.0 }, { 1.0, 1.0 }, { 0.5, 1.9 }, { 0.5, 2.7 },
    { 0.2, 2.7 } };
  const int rows = static_cast<int>(outline.size());
  for (const int sides : { 16, 40, 100 })
  {
    auto shaft = MakeGrid(sides, rows, true, false);
    for (vtkIdType i = 0; i < shaft->GetNumberOfPoints(); ++i)
    {
      const auto& [radius, height] = outline[i % rows];
      const double angle = 2.0 * Pi * static_cast<double>(i / rows) / sides;
      shaft->GetPoints()->SetPoint(i, radius * std::cos(angle), radius * std::sin(angle), height);
    }
    const auto chains = ExtractCreases(shaft, check);
    check(chains.size() == 4 &&
        std::all_of(chains.begin(), chains.end(), [](const Chain& chain) { return chain.Closed; }),
      "it has the rims of its ends and those of the cone", static_cast<double>(chains.size()));
  }
}

// A fold across a sheet, whose angle is the same all along or falls to nothing.
void TestFolds(Checks& check)
{
  for (const double angle : { 15.0, 25.0, 35.0 })
  {
    Profile profile;
    Pen pen(profile);
    pen.Draw(1.0);
    pen.Turn(angle);
    pen.Draw(1.0);
    const auto chains = ExtractCreases(Extrude(profile, 10, 2.0), check);
    check(
      chains.size() == (angle < 20.0 ? 0 : 1), "a fold from border to border is a crease", angle);
  }
  auto fading = Extrude({ { 0.0, 0.0 }, { 1.0, 0.0 }, { 2.0, 0.0 } }, 20, 4.0);
  for (vtkIdType i = 40; i < 60; ++i)
  {
    double p[3];
    fading->GetPoint(i, p);
    fading->GetPoints()->SetPoint(i, p[0], p[1], 0.6 * (1.0 - 0.25 * p[1]));
  }
  check(ExtractCreases(fading, check).empty(), "a soft fold that ends nowhere is none");
}
}

int TestSoftCreases(int, char*[])
{
  Checks check;
  TestChannel(check);
  TestFillets(check);
  TestRounds(check);
  TestChamfers(check);
  TestTurnedParts(check);
  TestFolds(check);
  return check.GetResult();
}
