// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Curvature from an implicit function is that of the surface known by formula, to almost all digits
// that single precision has; where there is none it says so.
#include "nprCurvaturePipeline.h"

#include "nprImplicitCurvature.h"
#include "vtkNPRImplicitCurvature.h"

#include <vtkCone.h>
#include <vtkCylinder.h>
#include <vtkImplicitFunction.h>
#include <vtkObject.h>
#include <vtkObjectFactory.h>
#include <vtkQuadric.h>
#include <vtkSphere.h>
#include <vtkTransform.h>

using namespace nprtest;

namespace
{
/// (sqrt(x^2 + y^2) - R)^2 + z^2 - r^2, around z: no quadric.
class TorusFunction : public vtkImplicitFunction
{
public:
  static TorusFunction* New();
  vtkTypeMacro(TorusFunction, vtkImplicitFunction);

  using vtkImplicitFunction::EvaluateFunction;
  double EvaluateFunction(double x[3]) override
  {
    const double d = std::hypot(x[0], x[1]) - 1.0;
    return d * d + x[2] * x[2] - 0.16;
  }
  void EvaluateGradient(double x[3], double g[3]) override
  {
    const double rho = std::hypot(x[0], x[1]);
    g[0] = 2.0 * (rho - 1.0) * x[0] / rho;
    g[1] = 2.0 * (rho - 1.0) * x[1] / rho;
    g[2] = 2.0 * x[2];
  }
};
vtkStandardNewMacro(TorusFunction);

/// z - 0.3 sin 2x cos y.
class WavesFunction : public vtkImplicitFunction
{
public:
  static WavesFunction* New();
  vtkTypeMacro(WavesFunction, vtkImplicitFunction);

  using vtkImplicitFunction::EvaluateFunction;
  double EvaluateFunction(double x[3]) override
  {
    return x[2] - 0.3 * std::sin(2.0 * x[0]) * std::cos(x[1]);
  }
  void EvaluateGradient(double x[3], double g[3]) override
  {
    g[0] = -0.6 * std::cos(2.0 * x[0]) * std::cos(x[1]);
    g[1] = 0.3 * std::sin(2.0 * x[0]) * std::sin(x[1]);
    g[2] = 1.0;
  }
};
vtkStandardNewMacro(WavesFunction);

void TestSurface(const std::string& name, vtkImplicitFunction* function,
  const AnalyticSurface& surface, Checks& check)
{
  vtkNew<vtkNPRImplicitCurvature> filter;
  filter->SetInputData(surface.Mesh);
  filter->SetImplicitFunction(function);
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  Errors worst;
  double size = 0.0;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    worst.Include(GetErrors(output, i, surface.Truths[i]));
    size = std::max(size, surface.Truths[i].Form.norm());
    check(GetValue(output, npr::names::UnknownCurvature, i) == 0.0, name + ": known everywhere");
  }
  std::cout << name << ": normal " << worst.Normal << " form " << worst.Form << " cubic "
            << worst.Cubic << "\n";
  // Single precision is what the arrays have.
  check(worst.Normal < 3e-7, name + ": normals", worst.Normal);
  check(worst.Form < 1e-6 * size, name + ": curvatures", worst.Form);
  check(worst.Principal < 1e-6 * size, name + ": principal curvatures", worst.Principal);
  check(worst.Direction < 1e-5, name + ": directions", worst.Direction);
  check(worst.Cubic < 3e-6 * size * size, name + ": derivatives", worst.Cubic);
}

void TestFunctions(Checks& check)
{
  vtkNew<vtkSphere> sphere;
  sphere->SetRadius(2.0);
  TestSurface("sphere", sphere, MakeSpherePatch(2.0, 16, 16), check);

  // Around y, turned by a transform.
  vtkNew<vtkCylinder> cylinder;
  vtkNew<vtkTransform> transform;
  transform->RotateX(90.0);
  cylinder->SetRadius(0.5);
  cylinder->SetTransform(transform);
  TestSurface("cylinder", cylinder, MakeCylinder(0.5, 1.0, 24, 12), check);

  // Around x.
  vtkNew<vtkCone> cone;
  vtkNew<vtkTransform> toX;
  toX->RotateY(90.0);
  cone->SetAngle(30.0);
  cone->SetTransform(toX);
  TestSurface("cone", cone, MakeSurface(Cone(Pi / 6.0, 2.0, 0.5), 24, 12), check);

  const Vector3d axes(1.0, 0.7, 0.5);
  vtkNew<vtkQuadric> ellipsoid;
  ellipsoid->SetCoefficients(1.0 / (axes[0] * axes[0]), 1.0 / (axes[1] * axes[1]),
    1.0 / (axes[2] * axes[2]), 0, 0, 0, 0, 0, 0, -1);
  TestSurface("ellipsoid", ellipsoid, MakeSurface(EllipsoidPatch(axes), 16, 16), check);

  vtkNew<TorusFunction> torus;
  TestSurface("torus", torus, MakeTorus(1.0, 0.4, 40, 20), check);
  vtkNew<WavesFunction> waves;
  TestSurface("waves", waves, MakeWaves(20), check);
}

void TestAccuracy(Checks& check)
{
  // In double precision, as the documentation of the filter says.
  const AnalyticSurface surface = MakeTorus(1.0, 0.4, 40, 20);
  vtkNew<TorusFunction> torus;
  double form = 0.0;
  double cubic = 0.0;
  for (const Truth& truth : surface.Truths)
  {
    npr::LevelSetJet jet;
    check(npr::ComputeLevelSetJet(
            [&](const Vector3d& p)
            {
              Vector3d g;
              torus->FunctionGradient(p.data(), g.data());
              return g;
            },
            truth.Point, 0.001, jet),
      "a torus has curvature everywhere");
    const npr::TangentFrame frame = npr::MakeTangentFrame(jet.Normal);
    form = std::max(
      form, (npr::FromFrame(jet.Form, frame) - npr::FromFrame(truth.Form, truth.Frame)).norm());
    cubic = std::max(cubic, (npr::ChangeFrame(jet.Cubic, frame, truth.Frame) - truth.Cubic).norm());
  }
  check(form < 1e-9, "curvature in double precision", form);
  check(cubic < 1e-6, "derivatives in double precision", cubic);
}

void TestSides(Checks& check)
{
  vtkNew<vtkSphere> sphere;
  sphere->SetRadius(2.0);
  vtkNew<vtkNPRImplicitCurvature> filter;
  filter->SetInputData(MakeSpherePatch(2.0, 8, 8).Mesh);
  filter->SetImplicitFunction(sphere);
  filter->OutputShapeIndexOn();
  filter->OutputCurvednessOn();
  filter->Update();
  check(std::abs(GetValue(filter->GetOutput(), npr::names::MeanCurvature, 7) - 0.5) < 1e-6,
    "a sphere is positive");
  check(GetValue(filter->GetOutput(), npr::names::ShapeIndex, 7) > 0.99, "a sphere is a cap");
  check(std::abs(GetValue(filter->GetOutput(), npr::names::Curvedness, 7) - 0.5) < 1e-6,
    "curvedness of a sphere");
  filter->FlipNormalsOn();
  filter->Update();
  check(std::abs(GetValue(filter->GetOutput(), npr::names::MeanCurvature, 7) + 0.5) < 1e-6,
    "turned inside out it is negative");

  // A change of the function makes new curvatures: now the points lie inside, on a smaller sphere.
  sphere->SetCenter(filter->GetOutput()->GetPoint(7));
  sphere->SetCenter(sphere->GetCenter()[0], sphere->GetCenter()[1], sphere->GetCenter()[2] + 1.0);
  filter->Update();
  check(std::abs(GetValue(filter->GetOutput(), npr::names::MeanCurvature, 7) + 1.0) < 1e-6,
    "the level set through a point counts, and the function's changes");
}

void TestUnknown(Checks& check)
{
  // The apex of a cone, the centre of a sphere, no number, and a good point.
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(0.0, 0.0, 0.0);
  points->InsertNextPoint(1e-5, 1e-5, 0.0);
  points->InsertNextPoint(std::nan(""), 0.0, 0.0);
  points->InsertNextPoint(1.0, 1.0, 0.0);
  vtkNew<vtkPolyData> input;
  input->SetPoints(points);
  vtkNew<vtkCone> cone;
  vtkNew<vtkNPRImplicitCurvature> filter;
  filter->SetInputData(input);
  vtkObject::GlobalWarningDisplayOff();
  filter->Update();
  check(filter->GetOutput()->GetNumberOfPoints() == 0, "no output without a function");
  filter->SetImplicitFunction(cone);
  filter->Update();
  vtkObject::GlobalWarningDisplayOn();
  for (vtkIdType i = 0; i < 4; ++i)
  {
    check((GetValue(filter->GetOutput(), npr::names::UnknownCurvature, i) == 1.0) == (i < 3),
      "where there is no curvature", i);
    for (const char* name : GetArrayNames())
    {
      vtkDataArray* array = filter->GetOutput()->GetPointData()->GetArray(name);
      for (int c = 0; array && c < array->GetNumberOfComponents(); ++c)
      {
        check(std::isfinite(array->GetComponent(i, c)), std::string("finite ") + name);
      }
    }
    check(std::abs(GetTuple<3>(filter->GetOutput(), npr::names::Normals, i).norm() - 1.0) < 1e-6,
      "unit normals");
  }
  check(std::abs(GetValue(filter->GetOutput(), npr::names::PrincipalCurvature1, 3)) > 0.1,
    "points without cells have curvature");
  vtkNew<vtkPolyData> nothing;
  filter->SetInputData(nothing);
  filter->Update();
  check(filter->GetOutput()->GetNumberOfPoints() == 0, "nothing comes of nothing");
}
}

int TestImplicitCurvature(int, char*[])
{
  Checks check;
  TestFunctions(check);
  TestAccuracy(check);
  TestSides(check);
  TestUnknown(check);
  return check.GetResult();
}
