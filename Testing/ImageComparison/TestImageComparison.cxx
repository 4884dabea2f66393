// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Draws lines of several widths on several grounds, changes them as a broken renderer would, and
// asks that each change is seen and that antialiasing's own is not.
#include "nprImageComparison.h"
#include "nprImageMeasures.h"

#include <vtkImageData.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <random>

namespace
{
enum class Ground
{
  White,
  Black, // with white lines
  Shaded // a sphere in cool and warm tones on white, with a dark core
};

struct Drawing
{
  Ground On = Ground::White;
  double Width = 1.0;
  double Phase = 0.0;             // moves everything, so that lines fall between pixels; pixels
  double Shift[2] = { 0.0, 0.0 }; // moves the lines alone; pixels
  double Grey = 0.0;              // 0 is full ink, 1 is paper
  double Gap = 0.0;               // length that misses in the second circle; pixels
  double SpotRadius = 0.0;        // of a dot of ink where there should be none; pixels
  double Tone = 0.0;              // added to the ground
  int Noise = 0;                  // levels
  int Components = 3;
  int Size = 200;
};

// The distance to the nearest centre line.
double LineDistance(double x, double y, const Drawing& drawing)
{
  const double radius = std::hypot(x - 100.0, y - 100.0);
  double distance = std::abs(radius - 80.0);
  // The gap stands at the circle's right.
  const bool inGap = x > 100.0 && std::abs(y - 100.0) < drawing.Gap / 2.0;
  if (!inGap)
  {
    distance = std::min(distance, std::abs(radius - 45.0));
  }
  const auto segment = [&](double ax, double ay, double bx, double by)
  {
    const double dx = bx - ax;
    const double dy = by - ay;
    const double t = ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy);
    const double s = std::clamp(t, 0.0, 1.0);
    distance = std::min(distance, std::hypot(x - ax - s * dx, y - ay - s * dy));
  };
  segment(70.5, 100.5, 130.5, 100.5);
  segment(85.0, 70.0, 115.0, 90.0);
  segment(100.5, 120.5, 100.5, 135.5);
  return distance;
}

std::array<double, 3> GroundColour(double x, double y, const Drawing& drawing)
{
  if (drawing.On == Ground::Black)
  {
    return { 0.0, 0.0, 0.0 };
  }
  const double r2 = (std::pow(x - 100.0, 2) + std::pow(y - 100.0, 2)) / (78.0 * 78.0);
  if (drawing.On == Ground::White || r2 > 1.0)
  {
    return { 1.0, 1.0, 1.0 };
  }
  // Gooch's blend of a cool and a warm colour by the angle to a light from the upper left.
  const double light =
    0.5 + 0.5 * (-0.5 * (x - 100.0) / 78.0 + 0.5 * (y - 100.0) / 78.0 + 0.7 * std::sqrt(1.0 - r2));
  return { 0.35 + 0.6 * light, 0.4 + 0.45 * light, 0.75 - 0.2 * light };
}

vtkSmartPointer<vtkImageData> Draw(const Drawing& drawing)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(drawing.Size, drawing.Size, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, drawing.Components);
  std::mt19937 random(7);
  std::uniform_int_distribution<int> noise(-drawing.Noise, drawing.Noise);
  const double ink = drawing.On == Ground::Black ? 1.0 : 0.0;
  for (int j = 0; j < drawing.Size; ++j)
  {
    for (int i = 0; i < drawing.Size; ++i)
    {
      const double x = i + 0.5 + drawing.Phase;
      const double y = j + 0.5 + drawing.Phase;
      const double inside = std::max(
        drawing.Width / 2.0 - LineDistance(x - drawing.Shift[0], y - drawing.Shift[1], drawing),
        drawing.SpotRadius - std::hypot(x - 30.0, y - 30.0));
      // How much of the pixel is covered, as good antialiasing gives it. Nothing has no edge.
      const bool drawn = drawing.Width > 0.0;
      const double coverage = drawn ? std::clamp(inside + 0.5, 0.0, 1.0) : 0.0;
      const double alpha = coverage * (1.0 - drawing.Grey);
      const auto ground = GroundColour(x, y, drawing);
      double colour[3];
      for (int k = 0; k < 3; ++k)
      {
        colour[k] = alpha * ink + (1.0 - alpha) * (ground[k] + drawing.Tone);
      }
      auto* pixel = static_cast<unsigned char*>(image->GetScalarPointer(i, j, 0));
      for (int k = 0; k < drawing.Components; ++k)
      {
        const double level = k < 3 ? std::round(255.0 * colour[k]) + noise(random) : 255.0;
        pixel[k] = static_cast<unsigned char>(std::clamp(level, 0.0, 255.0));
      }
    }
  }
  return image;
}

int Failures = 0;

void Expect(bool good, const std::string& what)
{
  if (!good)
  {
    std::cerr << "FAILED: " << what << "\n";
    ++Failures;
  }
}

const npr::ImageMeasure& Find(const npr::ImageComparison& comparison, const char* name)
{
  return *std::find_if(comparison.Measures.begin(), comparison.Measures.end(),
    [&](const npr::ImageMeasure& measure) { return measure.Name == name; });
}

struct Change
{
  const char* Name;
  bool Passes;
  const char* Measure; // one that must fail, or null for any
  void (*Apply)(Drawing&);
};

const Change Changes[] = {
  { "none", true, nullptr, [](Drawing&) {} },
  { "noise of 2 levels", true, nullptr, [](Drawing& d) { d.Noise = 2; } },
  { "0.1 px to the right", true, nullptr, [](Drawing& d) { d.Shift[0] = 0.1; } },
  { "0.1 px both ways", true, nullptr, [](Drawing& d) { d.Shift[0] = d.Shift[1] = -0.1; } },
  { "0.1 px up, noise of 2 levels", true, nullptr,
    [](Drawing& d)
    {
      d.Shift[1] = 0.1;
      d.Noise = 2;
    } },
  { "2 px to the right", false, "ink recall", [](Drawing& d) { d.Shift[0] = 2.0; } },
  { "2 px down", false, "ink precision", [](Drawing& d) { d.Shift[1] = -2.0; } },
  { "wider by 1 px", false, "ink amount change", [](Drawing& d) { d.Width += 1.0; } },
  { "black to grey", false, "ink tone change", [](Drawing& d) { d.Grey = 0.5; } },
  { "black to dark grey", false, "ink amount change", [](Drawing& d) { d.Grey = 0.1; } },
  { "lost 10 px of one line", false, "missing piece (px)", [](Drawing& d) { d.Gap = 10.0; } },
  { "a spot", false, "extra piece (px)", [](Drawing& d) { d.SpotRadius = 4.0; } },
  { "ground brighter or darker", false, nullptr,
    [](Drawing& d) { d.Tone = d.On == Ground::Black ? 0.1 : -0.1; } },
};

void TestChanges()
{
  const char* grounds[] = { "white", "black", "shaded" };
  for (const Ground ground : { Ground::White, Ground::Black, Ground::Shaded })
  {
    for (const double width : { 1.0, 2.5, 10.0 })
    {
      for (const double phase : { 0.0, 0.3 })
      {
        // Lines that lie exactly on the pixels: what one of the grounds shows.
        if (phase == 0.0 && (ground != Ground::White || width > 1.0))
        {
          continue;
        }
        Drawing drawing;
        drawing.On = ground;
        drawing.Width = width;
        drawing.Phase = phase;
        const auto baseline = Draw(drawing);
        for (const Change& change : Changes)
        {
          Drawing changed = drawing;
          change.Apply(changed);
          const auto comparison = npr::CompareImages(baseline, Draw(changed));
          const bool asExpected = comparison.Passes() == change.Passes &&
            (!change.Measure || !Find(comparison, change.Measure).Passes());
          if (!asExpected || std::getenv("NPR_VERBOSE"))
          {
            std::cerr << comparison.Report();
          }
          Expect(asExpected,
            std::string(change.Name) + ", lines of " + std::to_string(width) + " px on " +
              grounds[static_cast<int>(ground)] + ", phase " + std::to_string(phase));
        }
      }
    }
  }
}

void ExpectProblem(vtkImageData* baseline, vtkImageData* result, const std::string& text)
{
  const auto comparison = npr::CompareImages(baseline, result);
  Expect(!comparison.Passes() && comparison.Problem.find(text) != std::string::npos &&
      comparison.Report().find(text) != std::string::npos,
    "the problem should be: " + text + "; it is: " + comparison.Problem);
}

void TestProblems()
{
  const auto good = Draw({});
  Drawing small;
  small.Size = 199;
  ExpectProblem(good, Draw(small), "the baseline has 200x200 pixels, the result 199x199");
  ExpectProblem(nullptr, good, "no baseline");
  ExpectProblem(good, nullptr, "no result");
  vtkNew<vtkImageData> empty;
  ExpectProblem(good, empty, "result is not a two-dimensional image");

  Drawing nothing;
  nothing.Width = 0.0;
  nothing.Noise = 2;
  const auto blank = Draw(nothing);
  ExpectProblem(good, blank, "the result is blank");
  ExpectProblem(blank, good, "the baseline is blank");
  ExpectProblem(blank, blank, "the baseline is blank");

  // VTK's gradient background alone is blank, too.
  auto gradient = Draw({});
  for (int j = 0; j < 200; ++j)
  {
    for (int i = 0; i < 200; ++i)
    {
      std::fill_n(static_cast<unsigned char*>(gradient->GetScalarPointer(i, j, 0)), 3,
        static_cast<unsigned char>(j));
    }
  }
  ExpectProblem(good, gradient, "the result is blank");
}

void TestFormats()
{
  Drawing rgba;
  rgba.Components = 4;
  const auto opaque = Draw(rgba);
  Expect(npr::CompareImages(Draw({}), opaque).Passes(), "an opaque image is one without alpha");

  // A drawing in the alpha channel alone.
  const auto transparent = Draw(rgba);
  const auto thicker = Draw(
    []
    {
      Drawing drawing;
      drawing.Components = 4;
      drawing.Width = 2.0;
      return drawing;
    }());
  for (vtkImageData* image : { transparent.Get(), thicker.Get() })
  {
    auto* pixels = static_cast<unsigned char*>(image->GetScalarPointer());
    for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
    {
      pixels[4 * i + 3] = static_cast<unsigned char>(255 - pixels[4 * i]);
      std::fill_n(pixels + 4 * i, 3, static_cast<unsigned char>(0));
    }
  }
  Expect(npr::CompareImages(transparent, transparent).Passes(), "transparent paper");
  Expect(!npr::CompareImages(transparent, thicker).Passes(), "wider lines on transparent paper");
  Expect(!npr::CompareImages(opaque, transparent).Passes(), "paper that became transparent");
}

void TestKernels()
{
  // The distance transform against its definition.
  constexpr int width = 23;
  constexpr int height = 17;
  std::mt19937 random(3);
  npr::Mask mask(width * height);
  for (auto& value : mask)
  {
    value = random() % 40 == 0;
  }
  const npr::Plane distance = npr::DistanceTo(mask, width, height);
  double worst = 0.0;
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      double nearest = 1e30;
      for (int i = 0; i < width * height; ++i)
      {
        nearest = mask[i] ? std::min(nearest, std::hypot(x - i % width, y - i / width)) : nearest;
      }
      worst = std::max(worst, std::abs(nearest - distance.At(x, y)));
    }
  }
  Expect(worst < 1e-5, "distances are exact");
  const npr::Plane none = npr::DistanceTo(npr::Mask(width * height), width, height);
  Expect(*std::min_element(none.Values.begin(), none.Values.end()) > std::hypot(width, height),
    "no ink is far away");

  npr::Mask pieces(width * height);
  for (const int i : { 0, 1, 2, 3 + width, 4 + 2 * width, 10, 12 })
  {
    pieces[i] = 1;
  }
  Expect(npr::LongestPiece(pieces, width, height) == 5, "a piece goes on over corners");
  Expect(npr::LongestPiece(npr::Mask(width * height), width, height) == 0, "no piece");

  // Of two plain images, SSIM is the comparison of their means alone.
  const npr::Plane a(width, height, 0.2f);
  const npr::Plane b(width, height, 0.6f);
  const double expected = (2 * 0.2 * 0.6 + 0.01) / (0.04 + 0.36 + 0.01);
  for (const float value : npr::StructuralSimilarity(a, b).Values)
  {
    Expect(std::abs(value - expected) < 1e-3, "SSIM of plain images");
  }
}

void TestPicture()
{
  Drawing gap;
  gap.Gap = 10.0;
  gap.SpotRadius = 4.0;
  const auto comparison = npr::CompareImages(Draw({}), Draw(gap));
  int size[3];
  comparison.Picture->GetDimensions(size);
  Expect(size[0] == 3 * 200 + 2 * 4 && size[1] == 200, "three panels, two gaps");
  const auto pixel = [&](int x, int y)
  { return static_cast<unsigned char*>(comparison.Picture->GetScalarPointer(x, y, 0)); };
  Expect(pixel(144, 100)[0] < 200 && pixel(204 + 144, 100)[0] == 255, "baseline, then result");
  Expect(pixel(408 + 144, 100)[0] > 200 && pixel(408 + 144, 100)[2] < 50, "lost ink is red");
  Expect(pixel(408 + 30, 30)[2] > 200 && pixel(408 + 30, 30)[0] < 50, "new ink is blue");
  Expect(pixel(408 + 5, 5)[0] == 255, "no change is white");
}

void TestBaselineFiles(const std::string& folder)
{
  std::string program = "test";
  std::string name = "ComparisonWithBaseline";
  std::string flags[] = { "-B", folder + "/ComparisonBaseline", "-T",
    folder + "/ComparisonOutput" };
  char* argv[] = { program.data(), flags[0].data(), flags[1].data(), flags[2].data(),
    flags[3].data() };
  const auto good = Draw({});
  const auto compare = [&](vtkImageData* image, int argc = 5)
  { return npr::CompareWithBaseline(image, name.c_str(), argc, argv); };
  const std::string baseline = flags[1] + "/" + name + ".png";
  const std::string result = flags[3] + "/" + name + ".png";
  const std::string difference = flags[3] + "/" + name + ".difference.png";
  std::remove(baseline.c_str());

  Expect(compare(good) == EXIT_FAILURE, "a missing baseline fails");
  const auto written = npr::ReadImage(result);
  Expect(written && npr::CompareImages(good, written).Passes(), "the result was saved");
  Expect(compare(good, 3) == EXIT_FAILURE, "no folder for output");
  Expect(compare(good, 1) == EXIT_FAILURE, "no folder of baselines");

  // What a person does: take the result for the baseline.
  std::system(("mkdir -p '" + flags[1] + "'").c_str());
  Expect(npr::WriteImage(written, baseline), "the baseline can be written");
  Expect(compare(good) == EXIT_SUCCESS, "a result like its baseline");
  Expect(!npr::ReadImage(difference), "no difference, no picture of it");
  Expect(compare(nullptr) == EXIT_FAILURE, "no result");
  Drawing wide;
  wide.Width = 2.0;
  wide.Gap = 10.0;
  wide.SpotRadius = 4.0;
  wide.On = Ground::Shaded;
  Expect(compare(Draw(wide)) == EXIT_FAILURE, "a result unlike its baseline");
  Expect(npr::ReadImage(difference) != nullptr, "the difference was saved");
}
}

int TestImageComparison(int argc, char* argv[])
{
  TestChanges();
  TestProblems();
  TestFormats();
  TestKernels();
  TestPicture();
  for (int i = 1; i + 1 < argc; ++i)
  {
    if (std::string(argv[i]) == "-T")
    {
      TestBaselineFiles(argv[i + 1]);
    }
  }
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
