// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprImageComparison.h"

#include "nprImageMeasures.h"

#include <vtkImageData.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <numeric>
#include <sstream>

namespace npr
{
namespace
{
// Lines up to twice this wide, in pixels, are ink; what is wider is an area.
constexpr int InkReach = 8;
// Ink of the one image must meet ink in the other, but that may be fainter: a pixel beside the
// threshold must not count as lost because antialiasing shifted it by a few levels.
constexpr double Fainter = 0.4;
// Contrast that is noise, not ink.
constexpr float InkNoise = 16.0f / 255.0f;

struct Ink
{
  Plane Strength;
  Mask Drawn;
  Plane Distance; // to ink that may be fainter

  Ink(const std::vector<Plane>& channels, Polarity polarity, double contrast)
    : Strength(InkStrength(channels, polarity, InkReach)),
      Drawn(Threshold(this->Strength, static_cast<float>(contrast))),
      Distance(DistanceTo(Threshold(this->Strength, static_cast<float>(Fainter * contrast)),
        this->Strength.Width, this->Strength.Height))
  {
  }

  std::size_t Count() const
  {
    return static_cast<std::size_t>(std::count(this->Drawn.begin(), this->Drawn.end(), 1));
  }

  double Amount() const
  {
    double amount = 0.0;
    for (const float strength : this->Strength.Values)
    {
      amount += strength > InkNoise ? strength : 0.0;
    }
    return amount;
  }

  // The contrasts of the ink, as the share of the ink in each of 256 levels.
  std::array<double, 256> Tones() const
  {
    std::array<double, 256> tones{};
    const double share = 1.0 / std::max<double>(1.0, static_cast<double>(this->Count()));
    for (std::size_t i = 0; i < this->Drawn.size(); ++i)
    {
      if (this->Drawn[i])
      {
        tones[static_cast<int>(std::lround(255.0f * this->Strength.Values[i]))] += share;
      }
    }
    return tones;
  }
};

// The ink of `from` that lies further than radius from any ink of `to`.
Mask Unmatched(const Ink& from, const Ink& to, double radius)
{
  Mask mask(from.Drawn.size());
  for (std::size_t i = 0; i < mask.size(); ++i)
  {
    mask[i] = from.Drawn[i] && to.Distance.Values[i] > radius;
  }
  return mask;
}

double ShareMatched(const Mask& unmatched, const Ink& ink)
{
  const auto lost = static_cast<double>(std::count(unmatched.begin(), unmatched.end(), 1));
  const auto all = static_cast<double>(ink.Count());
  return all > 0.0 ? 1.0 - lost / all : 1.0;
}

double MeanTone(const std::array<double, 256>& tones)
{
  double mean = 0.0;
  for (int level = 0; level < 256; ++level)
  {
    mean += tones[level] * level / 255.0;
  }
  return mean;
}

// How far, as a share of the whole range, one histogram's mass must move to make the other.
double EarthMoversDistance(const std::array<double, 256>& a, const std::array<double, 256>& b)
{
  double carried = 0.0;
  double distance = 0.0;
  for (int level = 0; level < 256; ++level)
  {
    carried += a[level] - b[level];
    distance += std::abs(carried) / 255.0;
  }
  return distance;
}

struct Differences
{
  Plane Largest; // over the channels, at each pixel
  double WorstMean = 0.0;
  double MeanSSIM = 1.0;
  double LocalSSIM = 1.0;

  Differences(const std::vector<Plane>& a, const std::vector<Plane>& b)
    : Largest(a[0].Width, a[0].Height)
  {
    const auto count = static_cast<double>(this->Largest.Values.size());
    for (std::size_t c = 0; c < a.size(); ++c)
    {
      double sum = 0.0;
      for (std::size_t i = 0; i < this->Largest.Values.size(); ++i)
      {
        const float difference = std::abs(a[c].Values[i] - b[c].Values[i]);
        this->Largest.Values[i] = std::max(this->Largest.Values[i], difference);
        sum += difference;
      }
      this->WorstMean = std::max(this->WorstMean, sum / count);
      if (sum == 0.0)
      {
        continue;
      }
      const Plane similarity = StructuralSimilarity(a[c], b[c]);
      this->MeanSSIM = std::min(this->MeanSSIM,
        std::accumulate(similarity.Values.begin(), similarity.Values.end(), 0.0) / count);
      this->LocalSSIM = std::min<double>(
        this->LocalSSIM, *std::min_element(similarity.Values.begin(), similarity.Values.end()));
    }
  }
};

vtkSmartPointer<vtkImageData> NewPicture(int width, int height)
{
  auto picture = vtkSmartPointer<vtkImageData>::New();
  picture->SetDimensions(width, height, 1);
  picture->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* pixels = static_cast<unsigned char*>(picture->GetScalarPointer());
  std::fill(pixels, pixels + std::size_t(3) * width * height, static_cast<unsigned char>(128));
  return picture;
}

void SetPixel(vtkImageData* picture, int x, int y, float red, float green, float blue)
{
  auto* pixel = static_cast<unsigned char*>(picture->GetScalarPointer(x, y, 0));
  pixel[0] = static_cast<unsigned char>(std::lround(255.0f * red));
  pixel[1] = static_cast<unsigned char>(std::lround(255.0f * green));
  pixel[2] = static_cast<unsigned char>(std::lround(255.0f * blue));
}

constexpr int PictureGap = 4;

vtkSmartPointer<vtkImageData> SideBySide(
  const std::vector<Plane>& baseline, const std::vector<Plane>& result, int panels)
{
  const int step = std::max(baseline[0].Width, result[0].Width) + PictureGap;
  const int height = std::max(baseline[0].Height, result[0].Height);
  auto picture = NewPicture(panels * step - PictureGap, height);
  int left = 0;
  for (const auto* channels : { &baseline, &result })
  {
    const std::vector<Plane>& c = *channels;
    for (int y = 0; y < c[0].Height; ++y)
    {
      for (int x = 0; x < c[0].Width; ++x)
      {
        // Transparent pixels are shown on white.
        const float paper = 1.0f - c[3].At(x, y);
        const auto over = [&](int k) { return c[3].At(x, y) * c[k].At(x, y) + paper; };
        SetPixel(picture, left + x, y, over(0), over(1), over(2));
      }
    }
    left += step;
  }
  return picture;
}

void PaintDifference(
  vtkImageData* picture, int left, const Plane& largest, const Mask& lost, const Mask& added)
{
  for (int y = 0; y < largest.Height; ++y)
  {
    for (int x = 0; x < largest.Width; ++x)
    {
      const std::size_t i = static_cast<std::size_t>(y) * largest.Width + x;
      const float grey = 1.0f - largest.Values[i];
      if (lost[i])
      {
        SetPixel(picture, left + x, y, 0.85f, 0.0f, 0.0f);
      }
      else if (added[i])
      {
        SetPixel(picture, left + x, y, 0.0f, 0.2f, 0.9f);
      }
      else
      {
        SetPixel(picture, left + x, y, grey, grey, grey);
      }
    }
  }
}

std::string WhyUnusable(vtkImageData* image, const char* which)
{
  if (!image)
  {
    return std::string("there is no ") + which + " image";
  }
  int size[3];
  image->GetDimensions(size);
  const int components = image->GetNumberOfScalarComponents();
  if (size[0] < 1 || size[1] < 1 || size[2] != 1 || !image->GetScalarPointer() ||
    image->GetScalarType() != VTK_UNSIGNED_CHAR || components < 1 || components > 4)
  {
    return std::string("the ") + which +
      " is not a two-dimensional image of unsigned char with 1 to 4 components";
  }
  return {};
}
}

bool ImageComparison::Passes() const
{
  return this->Problem.empty() && !this->Measures.empty() &&
    std::all_of(this->Measures.begin(), this->Measures.end(),
      [](const ImageMeasure& measure) { return measure.Passes(); });
}

std::string ImageComparison::Report() const
{
  std::ostringstream text;
  if (!this->Problem.empty())
  {
    text << "FAILED: " << this->Problem << "\n";
  }
  text << std::fixed << std::setprecision(4);
  for (const ImageMeasure& measure : this->Measures)
  {
    text << (measure.Passes() ? "  ok     " : "  FAILED ") << std::left << std::setw(24)
         << measure.Name << std::right << std::setw(10) << measure.Value
         << (measure.LimitIsLeast ? "  at least " : "  at most  ") << measure.Limit << "\n";
  }
  return text.str();
}

ImageComparison CompareImages(
  vtkImageData* baseline, vtkImageData* result, const ImageLimits& limits)
{
  ImageComparison comparison;
  for (const auto& [image, which] :
    { std::pair(baseline, "baseline"), std::pair(result, "result") })
  {
    comparison.Problem = WhyUnusable(image, which);
    if (!comparison.Problem.empty())
    {
      return comparison;
    }
  }
  const std::vector<Plane> a = SplitChannels(baseline);
  const std::vector<Plane> b = SplitChannels(result);
  const int width = a[0].Width;
  const int height = a[0].Height;
  if (width != b[0].Width || height != b[0].Height)
  {
    std::ostringstream text;
    text << "the baseline has " << width << "x" << height << " pixels, the result " << b[0].Width
         << "x" << b[0].Height;
    comparison.Problem = text.str();
  }
  else if (IsBlank(a))
  {
    comparison.Problem = "the baseline is blank";
  }
  else if (IsBlank(b))
  {
    comparison.Problem = "the result is blank";
  }
  if (!comparison.Problem.empty())
  {
    comparison.Picture = SideBySide(a, b, 2);
    return comparison;
  }

  const Polarity polarity = FindPolarity(a);
  const Ink inkA(a, polarity, limits.InkContrast);
  const Ink inkB(b, polarity, limits.InkContrast);
  const Mask lost = Unmatched(inkA, inkB, limits.Radius);
  const Mask added = Unmatched(inkB, inkA, limits.Radius);
  const auto tonesA = inkA.Tones();
  const auto tonesB = inkB.Tones();
  // A picture with next to no ink is not judged by a relative change of it.
  constexpr double leastAmount = 25.0;
  const double amountChange = std::abs(inkA.Amount() - inkB.Amount()) /
    std::max({ inkA.Amount(), inkB.Amount(), leastAmount });
  // Nor are the tones of no ink.
  const bool both = inkA.Count() > 0 && inkB.Count() > 0;
  const Differences differences(a, b);

  const auto atLeast = [&](const char* name, double value, double limit) {
    comparison.Measures.push_back({ name, value, limit, true });
  };
  const auto atMost = [&](const char* name, double value, double limit) {
    comparison.Measures.push_back({ name, value, limit, false });
  };
  atLeast("ink precision", ShareMatched(added, inkB), limits.InkPrecision);
  atLeast("ink recall", ShareMatched(lost, inkA), limits.InkRecall);
  atMost("missing piece (px)", LongestPiece(lost, width, height), limits.MissingPiece);
  atMost("extra piece (px)", LongestPiece(added, width, height), limits.ExtraPiece);
  atMost("ink amount change", amountChange, limits.InkAmount);
  atMost(
    "ink tone change", both ? std::abs(MeanTone(tonesA) - MeanTone(tonesB)) : 0.0, limits.InkTone);
  atMost("ink tones distance", both ? EarthMoversDistance(tonesA, tonesB) : 0.0, limits.InkTones);
  atLeast("mean SSIM", differences.MeanSSIM, limits.MeanSSIM);
  atLeast("local SSIM", differences.LocalSSIM, limits.LocalSSIM);
  atMost("mean difference", differences.WorstMean, limits.MeanDifference);
  atMost("largest difference",
    *std::max_element(differences.Largest.Values.begin(), differences.Largest.Values.end()),
    limits.MaxDifference);

  comparison.Picture = SideBySide(a, b, 3);
  PaintDifference(comparison.Picture, 2 * (width + PictureGap), differences.Largest, lost, added);
  return comparison;
}
}
