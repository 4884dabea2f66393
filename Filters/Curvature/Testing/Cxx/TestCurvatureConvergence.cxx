// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Normals, curvatures and derivatives of known surfaces converge, each at its rate; borders too.
#include "nprCurvaturePipeline.h"

#include <array>
#include <functional>
#include <string>

using namespace nprtest;

namespace
{
/// Largest errors inside (two rings off the border) and on the rest, with single precision's noise.
struct SurfaceErrors
{
  Errors Inside;
  Errors Border;
};

SurfaceErrors Measure(const AnalyticSurface& surface, Checks& check)
{
  Pipeline pipeline(surface.Mesh);
  vtkPolyData* output = pipeline.Update();
  check(output->GetNumberOfPoints() == surface.Mesh->GetNumberOfPoints(), "no point is split");
  npr::TriangleMesh mesh(output);
  mesh.BuildIncidence();
  std::vector<int> rings(output->GetNumberOfPoints(), 4);
  for (int ring = 0; ring < 4; ++ring)
  {
    for (npr::TriangleMesh::Index i = 0; i < mesh.GetNumberOfPoints(); ++i)
    {
      if (ring == 0 && mesh.IsBorderPoint(i))
      {
        rings[i] = 0;
      }
      for (const auto* t = mesh.IncidentBegin(i); ring > 0 && t != mesh.IncidentEnd(i); ++t)
      {
        for (auto corner : mesh.GetTriangle(*t))
        {
          if (rings[corner] == ring - 1 && rings[i] > ring)
          {
            rings[i] = ring;
          }
        }
      }
    }
  }
  SurfaceErrors errors;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const Errors here = GetErrors(output, i, surface.Truths[i]);
    (rings[i] == 4 ? errors.Inside : errors.Border).Include(here);
    check((GetValue(output, npr::names::BorderPoints, i) == 1.0) == (rings[i] == 0),
      "borders are flagged");
  }
  return errors;
}

void TestSurface(const std::string& name, const std::function<AnalyticSurface(int)>& make, int n,
  double firstOrder, double secondOrder, Checks& check)
{
  std::array<SurfaceErrors, 3> errors;
  for (int level = 0; level < 3; ++level)
  {
    errors[level] = Measure(make(n << level), check);
    for (const auto& part : { std::make_pair("inside", errors[level].Inside),
           std::make_pair("border", errors[level].Border) })
    {
      std::cout << name << " " << (n << level) << " " << part.first << ": normal "
                << part.second.Normal << " form " << part.second.Form << " principal "
                << part.second.Principal << " direction " << part.second.Direction << " cubic "
                << part.second.Cubic << "\n";
    }
  }
  const auto checkRate = [&](double Errors::*quantity, bool atBorder, double noise, double order,
                           const std::string& what)
  {
    for (int level = 1; level < 3; ++level)
    {
      const double coarse =
        (atBorder ? errors[level - 1].Border : errors[level - 1].Inside).*quantity;
      const double fine = (atBorder ? errors[level].Border : errors[level].Inside).*quantity;
      check(fine <= noise || std::log2(coarse / fine) > order, name + ": " + what,
        std::log2(coarse / fine));
    }
  };
  // The noise of single precision: relative 1e-7, divided by the edge length once for each
  // derivative.
  const double h = 1.0 / (4 * n);
  checkRate(&Errors::Normal, false, 2e-7 / h, 1.7, "normals converge with h^2");
  checkRate(&Errors::Form, false, 1e-6 / h, 1.6, "tensors converge with h^2");
  checkRate(&Errors::Principal, false, 1e-6 / h, 1.6, "principal curvatures converge with h^2");
  checkRate(&Errors::Direction, false, 1e-6 / h, 0.8, "principal directions converge");
  checkRate(&Errors::Cubic, false, 3e-6 / (h * h), 1.6, "derivatives converge with h^2");
  checkRate(&Errors::Normal, true, 1e-6 / h, 1.6, "normals at borders converge");
  checkRate(&Errors::Form, true, 1e-6 / h, 0.8, "tensors at borders converge");
  // A derivative from one side has an error of its own size, but no more.
  check(errors[2].Border.Cubic < 10.0 * secondOrder, name + ": derivatives at borders are bounded",
    errors[2].Border.Cubic);
  check(errors[2].Inside.Form < firstOrder, name + ": curvatures are right", errors[2].Inside.Form);
  check(
    errors[2].Inside.Cubic < secondOrder, name + ": derivatives are right", errors[2].Inside.Cubic);
}
}

int TestCurvatureConvergence(int, char*[])
{
  Checks check;
  TestSurface(
    "torus", [](int n) { return MakeTorus(1.0, 0.4, 2 * n, n); }, 40, 0.02, 0.1, check);
  TestSurface(
    "cylinder", [](int n) { return MakeCylinder(0.5, 1.0, 2 * n, n); }, 12, 0.01, 0.01, check);
  TestSurface(
    "sphere", [](int n) { return MakeSpherePatch(2.0, n, n); }, 16, 0.01, 0.05, check);
  TestSurface(
    "saddle", [](int n) { return MakeSaddle(n); }, 20, 0.01, 0.05, check);
  TestSurface(
    "waves", [](int n) { return MakeWaves(n); }, 24, 0.01, 0.1, check);
  TestSurface(
    "cone", [](int n) { return MakeSurface(Cone(0.5, 2.0, 1.0), 3 * n, n); }, 12, 0.01, 0.1, check);
  TestSurface(
    "ellipsoid",
    [](int n) {
      return MakeSurface(EllipsoidPatch({ 1.0, 0.9, 0.7 }), n, n);
    },
    24, 0.02, 0.2, check);
  TestSurface(
    "monkey saddle", [](int n) { return MakeSurface(MonkeySaddle(), n, n); }, 40, 0.02, 0.2, check);
  return check.GetResult();
}
