// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Every pixel of a sphere, in perspective and parallel projection, against the formula of each
// style computed here.

#include "nprShadingTest.h"

#include "vtkNPRGoochStyle.h"
#include "vtkNPRPhongStyle.h"
#include "vtkNPRShadingPass.h"
#include "vtkNPRToonStyle.h"

#include <vtkDoubleArray.h>
#include <vtkMath.h>

#include <functional>

using namespace npr::testing;

namespace
{
constexpr double Power = 20.0;
const Vector Diffuse = { 0.72, 0.4, 0.24 };
const Vector Specular = { 0.3, 0.3, 0.3 };
const Vector Ambient = { 0.08, 0.05, 0.03 };
const Vector LightColor = { 0.9, 1.0, 0.8 };
const Vector ToLight = Unit({ 0.6, 0.7, 0.9 });

// What a formula is given: normal and view in world coordinates (the camera's axes are theirs).
struct Point
{
  Vector Normal;
  Vector View;
  double Lambert() const { return Dot(this->Normal, ToLight); }
  double Reflection() const
  {
    const double nl = this->Lambert();
    Vector r;
    for (int c = 0; c < 3; ++c)
    {
      r[c] = 2.0 * nl * this->Normal[c] - ToLight[c];
    }
    return nl > 0.0 ? std::pow(std::max(Dot(r, this->View), 1e-9), Power) : 0.0;
  }
  double Halfway() const
  {
    const Vector h =
      Unit({ ToLight[0] + this->View[0], ToLight[1] + this->View[1], ToLight[2] + this->View[2] });
    return this->Lambert() > 0.0 ? std::pow(std::max(Dot(this->Normal, h), 1e-9), Power) : 0.0;
  }
};

using Formula = std::function<Vector(const Point&)>;

Vector PhongWith(double diffuse, double specular)
{
  Vector color;
  for (int c = 0; c < 3; ++c)
  {
    color[c] = Ambient[c] + LightColor[c] * (Diffuse[c] * diffuse + Specular[c] * specular);
  }
  return color;
}

double Tone(const std::vector<double>& tones, double x)
{
  const int n = static_cast<int>(tones.size());
  return tones[static_cast<size_t>(std::clamp(static_cast<int>(std::floor(x * n)), 0, n - 1))];
}

// Farther than this from a border of the n tones?
bool ClearOfBorders(double x, int n, double margin)
{
  const double place = x * n;
  const double nearest = std::clamp(std::round(place), 1.0, std::max(1.0, n - 1.0));
  return n == 1 || std::abs(place - nearest) > margin * n;
}

// The point of the unit sphere under a pixel; false outside and near its outline.
bool Hit(const Stage& stage, const Image& image, int x, int y, Point& point)
{
  vtkCamera* camera = const_cast<Stage&>(stage).Renderer->GetActiveCamera();
  const double u = 2.0 * (x + 0.5) / image.Width - 1.0;
  const double v = 2.0 * (y + 0.5) / image.Height - 1.0;
  Vector origin;
  Vector direction;
  if (camera->GetParallelProjection())
  {
    const double scale = camera->GetParallelScale();
    origin = { u * scale, v * scale, 4.0 };
    direction = { 0.0, 0.0, -1.0 };
  }
  else
  {
    const double scale = std::tan(vtkMath::RadiansFromDegrees(camera->GetViewAngle()) / 2.0);
    origin = { 0.0, 0.0, 4.0 };
    direction = Unit({ u * scale, v * scale, -1.0 });
  }
  const double b = Dot(origin, direction);
  const double square = b * b - (Dot(origin, origin) - 1.0);
  if (square < 0.04)
  {
    return false;
  }
  const double t = -b - std::sqrt(square);
  for (int c = 0; c < 3; ++c)
  {
    point.Normal[c] = origin[c] + t * direction[c];
    point.View[c] = -direction[c];
  }
  return true;
}

void Compare(
  Checker& check, Stage& stage, const std::string& name, const Formula& formula,
  const std::function<bool(const Point&)>& use = [](const Point&) { return true; })
{
  for (int parallel = 0; parallel < 2; ++parallel)
  {
    stage.Renderer->GetActiveCamera()->SetParallelProjection(parallel);
    const std::string title = name + (parallel ? "Parallel" : "Perspective");
    const Image image = stage.Render(check.Folder + "/Shading" + title + ".png");
    int used = 0;
    int wrong = 0;
    int worst = 0;
    for (int y = 0; y < image.Height; ++y)
    {
      for (int x = 0; x < image.Width; ++x)
      {
        Point point;
        if (!Hit(stage, image, x, y, point) || !use(point))
        {
          continue;
        }
        const Vector expected = formula(point);
        const std::array<int, 3> drawn = image.At(x, y);
        int difference = 0;
        for (int c = 0; c < 3; ++c)
        {
          difference = std::max(difference,
            std::abs(
              drawn[c] - static_cast<int>(std::lround(255.0 * std::clamp(expected[c], 0.0, 1.0)))));
        }
        ++used;
        wrong += difference > 2;
        worst = std::max(worst, difference);
      }
    }
    std::cout << title << ": " << used << " pixels, greatest difference " << worst << "\n";
    check(used > 5000, title + ": too few pixels compared");
    check(wrong == 0, title + ": " + std::to_string(wrong) + " pixels off by more than 2/255");
  }
}
}

int TestShadingFormulas(int argc, char* argv[])
{
  Checker check(argc, argv);
  Stage stage;
  vtkProperty* property = stage.AddSphere()->GetProperty();
  property->SetAmbient(0.1);
  property->SetDiffuse(0.8);
  property->SetSpecular(0.3);
  property->SetSpecularPower(Power);
  property->SetAmbientColor(Ambient[0] / 0.1, Ambient[1] / 0.1, Ambient[2] / 0.1);
  property->SetDiffuseColor(Diffuse[0] / 0.8, Diffuse[1] / 0.8, Diffuse[2] / 0.8);
  property->SetSpecularColor(1, 1, 1);
  vtkLight* light = stage.AddLight(ToLight[0], ToLight[1], ToLight[2]);
  light->SetDiffuseColor(LightColor[0] / 0.5, LightColor[1] / 0.5, LightColor[2] / 0.5);
  light->SetIntensity(0.5);

  vtkNew<vtkNPRShadingPass> pass;
  stage.Renderer->SetPass(pass);

  vtkNew<vtkNPRPhongStyle> phong;
  pass->SetStyle(phong);
  Compare(check, stage, "Phong",
    [](const Point& p) { return PhongWith(std::max(p.Lambert(), 0.0), p.Reflection()); });
  phong->HalfwayVectorOn();
  Compare(check, stage, "Blinn",
    [](const Point& p) { return PhongWith(std::max(p.Lambert(), 0.0), p.Halfway()); });

  vtkNew<vtkNPRGoochStyle> gooch;
  pass->SetStyle(gooch);
  const auto goochFormula = [&](const Point& p)
  {
    const double warmth = 0.5 * (1.0 + p.Lambert());
    Vector color;
    for (int c = 0; c < 3; ++c)
    {
      const double cool = gooch->GetCoolColor()[c] + gooch->GetAlpha() * Diffuse[c];
      const double warm = gooch->GetWarmColor()[c] + gooch->GetBeta() * Diffuse[c];
      color[c] = cool + warmth * (warm - cool) + LightColor[c] * Specular[c] * p.Reflection();
    }
    return color;
  };
  Compare(check, stage, "Gooch", goochFormula);
  const Image image = stage.Render();
  const std::array<int, 3> facing = image.At(140, 145);
  const std::array<int, 3> away = image.At(35, 38);
  check(facing[0] > facing[2] && away[2] > away[0], "Gooch: warm must face the light");
  gooch->SetCoolColor(0.1, 0.4, 0.2);
  gooch->SetWarmColor(0.5, 0.1, 0.3);
  gooch->SetAlpha(0.6);
  gooch->SetBeta(0.1);
  Compare(check, stage, "GoochColors", goochFormula);

  vtkNew<vtkNPRToonStyle> toon;
  pass->SetStyle(toon);
  const std::vector<std::vector<double>> tables = { { 1.0 }, { 0.3, 1.0 }, { 0.3, 0.7, 1.0 },
    { 0.3, 0.44, 0.58, 0.72, 0.86, 1.0 } };
  for (const std::vector<double>& tones : tables)
  {
    const int n = static_cast<int>(tones.size());
    toon->SetNumberOfTones(n);
    Compare(
      check, stage, "Toon" + std::to_string(n),
      [&](const Point& p)
      { return PhongWith(Tone(tones, p.Lambert()), p.Halfway() >= 0.5 ? 1.0 : 0.0); },
      [&](const Point& p)
      { return ClearOfBorders(p.Lambert(), n, 0.04) && std::abs(p.Halfway() - 0.5) > 0.12; });
  }

  // Exactly n tones and the background where borders are not smoothed, more where they are.
  property->SetSpecular(0.0);
  toon->SetSmoothingWidth(0.0);
  for (int n : { 2, 3, 7 })
  {
    toon->SetNumberOfTones(n);
    const size_t colors = stage.Render().Colors().size();
    check(colors == static_cast<size_t>(n) + 1,
      "Toon: " + std::to_string(colors - 1) + " tones instead of " + std::to_string(n));
  }
  toon->SetSmoothingWidth(1.5);
  check(stage.Render().Colors().size() > 30, "Toon: borders are not smooth");

  // A ramp of colours replaces the tones.
  vtkNew<vtkDoubleArray> ramp;
  ramp->SetNumberOfComponents(3);
  ramp->InsertNextTuple3(0.2, 0.1, 0.6);
  ramp->InsertNextTuple3(0.8, 0.3, 0.3);
  ramp->InsertNextTuple3(1.0, 0.9, 0.4);
  ramp->InsertNextTuple3(1.0, 0.9, 0.4);
  toon->SetDiffuseRamp(ramp);
  Compare(
    check, stage, "ToonRamp",
    [&](const Point& p)
    {
      const int step = std::clamp(static_cast<int>(std::floor(4.0 * p.Lambert())), 0, 3);
      Vector color = PhongWith(1.0, 0.0);
      for (int c = 0; c < 3; ++c)
      {
        color[c] = Ambient[c] + (color[c] - Ambient[c]) * ramp->GetComponent(step, c);
      }
      return color;
    },
    [](const Point& p) { return ClearOfBorders(p.Lambert(), 4, 0.04); });
  return check.Result();
}
