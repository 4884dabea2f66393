// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Flat tones as filled areas: against the isophotes of a sphere, one laid over the other, without
// specks; and what is no picture of tones.
#include "nprChecks.h"
#include "nprDrawingTesting.h"

#include <vtkErrorCode.h>
#include <vtkImageData.h>
#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <cmath>
#include <functional>
#include <tuple>

namespace
{
using namespace nprtest;

Checks check;
std::string folder;

using Pixel = std::array<double, 4>; // 0 to 255
constexpr Pixel Light = { 250, 200, 150, 255 };
constexpr Pixel Middle = { 200, 160, 120, 255 };
constexpr Pixel Dark = { 100, 80, 60, 255 };
constexpr Pixel None = { 0, 0, 0, 0 };

/// `get` tells the colour of a place; the page is 100 x 100 mm, y up. Pixels are the mean of so
/// many samples each way, but opaque or not as their middle is.
vtkSmartPointer<vtkImageData> MakePicture(
  const std::function<Pixel(double, double)>& get, int size, int samples = 1)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size, size, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  auto* pixel = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int y = 0; y < size; ++y)
  {
    for (int x = 0; x < size; ++x, pixel += 4)
    {
      Pixel sum = { 0, 0, 0, 0 };
      double weight = 0.0;
      for (int k = 0; k < samples * samples; ++k)
      {
        const Pixel one = get(100.0 * (x + (k % samples + 0.5) / samples) / size,
          100.0 * (y + (k / samples + 0.5) / samples) / size);
        const double share = one[3] / 255.0;
        weight += share;
        for (int c = 0; c < 3; ++c)
        {
          sum[c] += share * one[c];
        }
      }
      for (int c = 0; c < 3; ++c)
      {
        pixel[c] = static_cast<unsigned char>(weight > 0 ? std::lround(sum[c] / weight) : 0);
      }
      pixel[3] = get(100.0 * (x + 0.5) / size, 100.0 * (y + 0.5) / size)[3] > 0 ? 255 : 0;
    }
  }
  return image;
}

void SetPage(vtkNPRDrawingWriter* writer, vtkImageData* tones)
{
  SetPlainPage(writer, MakeStrokes({ { { -30, 0, 0 }, { 30, 0, 0 } } }));
  writer->SetTones(tones);
}

const Layer* DrawTones(vtkImageData* tones, Drawing& drawing)
{
  vtkNew<vtkNPRSVGWriter> writer;
  SetPage(writer, tones);
  drawing = Draw(writer, folder + "DrawingTones.svg");
  return drawing.Find("tones");
}

/// Of a part of a path.
double GetArea(const std::vector<Cubic>& part)
{
  const std::vector<Point2> points = Sample(part, 16);
  double twice = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const Point2& next = points[(i + 1) % points.size()];
    twice += points[i].x() * next.y() - points[i].y() * next.x();
  }
  return 0.5 * std::abs(twice);
}

//------------------------------------------------------------------------------
constexpr double Radius = 40.0;
constexpr double LeastMiddle = 0.6; // cosines
constexpr double LeastLight = 0.85;
constexpr double Slant = Pi / 6; // of the light, so that both isophotes are seen whole

Pixel ShadeSphere(double x, double y)
{
  const double u = (x - 50.0) / Radius;
  const double v = (y - 50.0) / Radius;
  const double squared = u * u + v * v;
  if (squared >= 1.0)
  {
    return None;
  }
  const double cosine = std::sin(Slant) * u + std::cos(Slant) * std::sqrt(1.0 - squared);
  return cosine > LeastLight ? Light : cosine > LeastMiddle ? Middle : Dark;
}

/// An isophote is a circle, and its image an ellipse.
double GetIsophoteArea(double cosine)
{
  return Pi * Radius * Radius * (1.0 - cosine * cosine) * std::cos(Slant);
}

/// How far a place of the page is from the ellipse, nearly.
double GetDistanceFromIsophote(const Point2& place, double cosine)
{
  const double across = Radius * std::sqrt(1.0 - cosine * cosine);
  const double along = across * std::cos(Slant);
  const double u = (place.x() - 50.0 - Radius * cosine * std::sin(Slant)) / along;
  const double v = (place.y() - 50.0) / across;
  const double value = u * u + v * v - 1.0;
  return std::abs(value) / (2.0 * std::hypot(u / along, v / across));
}

void TestSphere()
{
  const double whole = Pi * Radius * Radius;
  const double areas[] = { whole, whole - GetIsophoteArea(LeastLight),
    whole - GetIsophoteArea(LeastMiddle) };
  const char* const colors[] = { "#fac896", "#c8a078", "#64503c" };
  for (const auto& [size, samples, mostDistance] :
    { std::tuple(1000, 1, 0.08), { 1000, 4, 0.06 }, { 2000, 1, 0.04 } })
  {
    Drawing drawing;
    const Layer* const layer = DrawTones(MakePicture(ShadeSphere, size, samples), drawing);
    if (!check(layer && layer->Paths.size() == 3, "three tones"))
    {
      continue;
    }
    check(&drawing.Layers[0] == layer, "tones are below lines");
    check(layer->Get("fill-rule") == "evenodd", "holes are holes");
    double worst = 0.0;
    std::size_t curves = 0;
    for (int tone = 0; tone < 3; ++tone)
    {
      const Path& path = layer->Paths[tone];
      check(
        layer->Element->GetNestedElement(tone)->GetAttribute("fill") == std::string(colors[tone]),
        "the lightest first");
      if (!check(path.Parts.size() == (tone == 0 ? 1 : 2), "one border, and one hole",
            static_cast<double>(path.Parts.size())))
      {
        continue;
      }
      double area = GetArea(path.Parts[0]);
      if (tone > 0)
      {
        const double other = GetArea(path.Parts[1]);
        area = std::abs(area - other);
        const auto& hole = path.Parts[other < GetArea(path.Parts[0]) ? 1 : 0];
        for (const Point2& place : Sample(hole, 16))
        {
          worst =
            std::max(worst, GetDistanceFromIsophote(place, tone == 1 ? LeastLight : LeastMiddle));
        }
      }
      check(std::abs(area - areas[tone]) < 1e-3 * areas[tone], "the area of a tone",
        area / areas[tone] - 1.0);
      for (std::size_t part = 0; part < path.Parts.size(); ++part)
      {
        check(path.Closed[part], "borders are closed");
        curves += path.Parts[part].size();
      }
    }
    std::cout << size << " pixels, " << samples << " samples: " << worst
              << " mm from the isophotes, " << curves << " curves, "
              << ReadFile(folder + "DrawingTones.svg").size() << " bytes\n";
    check(worst < mostDistance, "isophotes are ellipses", worst);
    check(curves < 500, "few curves", static_cast<double>(curves));
  }
}

/// A tone is below all darker ones, so that nothing shows between neighbours.
void TestSpotsAndBorders()
{
  const auto get = [](double x, double y) -> Pixel
  {
    const auto isWithin = [&](double left, double bottom, double size)
    { return x > left && x < left + size && y > bottom && y < bottom + size; };
    return isWithin(20, 70, 10) ? Light : isWithin(70, 30, 0.15) ? Light : x < 50 ? Dark : Middle;
  };
  Drawing drawing;
  const Layer* const layer = DrawTones(MakePicture(get, 1000), drawing);
  if (!check(layer && layer->Paths.size() == 3, "three tones up to the border"))
  {
    return;
  }
  check(layer->Paths[0].Parts.size() == 1, "the lightest is below all others");
  check(GetArea(layer->Paths[0].Parts[0]) >= 100.0 * 100.0 - 1e-6, "it fills the picture");
  check(layer->Paths[1].Parts.size() == 2, "one gap, and no speck",
    static_cast<double>(layer->Paths[1].Parts.size()));
  check(layer->Get("clip-path") == "url(#picture)", "nothing goes beyond the picture");
  for (const Point2& place : Sample(layer->Paths[2].Parts[0], 4))
  {
    check(place.x() < 50.2, "the darkest stays where it is", place.x());
  }
}

void TestPictures()
{
  Drawing drawing;
  check(!DrawTones(MakePicture([](double, double) { return None; }, 50), drawing) && drawing.Root,
    "nothing is to be seen of nothing");
  const Layer* layer = DrawTones(MakePicture([](double, double) { return Dark; }, 1), drawing);
  check(layer && layer->Paths.size() == 1, "one pixel");

  // Grey levels, without an opacity.
  vtkNew<vtkImageData> grey;
  grey->SetExtent(5, 104, -7, 92, 3, 3);
  grey->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* pixel = static_cast<unsigned char*>(grey->GetScalarPointer());
  for (int i = 0; i < 100 * 100; ++i)
  {
    pixel[i] = i % 100 < 30 ? 51 : 204; // the left of it
  }
  layer = DrawTones(grey, drawing);
  if (check(layer && layer->Paths.size() == 2, "two levels of grey"))
  {
    check(layer->Element->GetNestedElement(1)->GetAttribute("fill") == std::string("#333333"),
      "a level of grey");
    check(std::abs(Sample(layer->Paths[1].Parts[0], 4)[0].x()) < 31.0, "on the left");
  }
  const std::string bytes = ReadFile(folder + "DrawingTones.svg");
  DrawTones(grey, drawing);
  check(ReadFile(folder + "DrawingTones.svg") == bytes, "the same bytes again");
}

void TestRefused()
{
  const auto gradient = [](double x, double y) { return Pixel{ 2.5 * x, 2.5 * y, x + y, 255 }; };
  vtkNew<vtkImageData> floats;
  floats->SetDimensions(4, 4, 1);
  floats->AllocateScalars(VTK_FLOAT, 3);
  const std::string file = folder + "DrawingTonesRefused.svg";
  vtksys::SystemTools::RemoveFile(file);
  vtkObject::GlobalWarningDisplayOff();
  const vtkSmartPointer<vtkImageData> smooth = MakePicture(gradient, 200);
  for (vtkImageData* const image : { smooth.Get(), floats.Get() })
  {
    vtkNew<vtkNPRSVGWriter> writer;
    SetPage(writer, image);
    writer->SetFileName(file.c_str());
    check(!writer->Write() && writer->GetErrorCode() == vtkErrorCode::UserError &&
        !vtksys::SystemTools::FileExists(file),
      "what is no picture of tones is refused");
  }
  vtkObject::GlobalWarningDisplayOn();
}
}

int TestDrawingTones(int argc, char* argv[])
{
  folder = OutputFolder(argc, argv);
  TestSphere();
  TestSpotsAndBorders();
  TestPictures();
  TestRefused();
  return check.GetResult();
}
