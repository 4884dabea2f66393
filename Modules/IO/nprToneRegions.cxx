// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprToneRegions.h"

#include "nprNumberText.h"
#include "nprPageComposer.h"

#include <vtkCellArray.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkImageGaussianSmooth.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkStripper.h>
#include <vtkSynchronizedTemplates2D.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <utility>

namespace npr
{
namespace
{
using Color = std::array<int, 3>;

constexpr double LeastShare = 0.002; // of the opaque pixels
constexpr double LeastFlat = 2.0 / 3.0;
constexpr std::size_t MostTones = 24;
constexpr double SmoothingWidth = 1.0; // pixels
constexpr double SmoothingReach = 3.0; // in widths
constexpr unsigned char Nothing = 0;

/// An image's opaque pixels, from the upper left corner.
class FlatPicture
{
public:
  explicit FlatPicture(vtkImageData* image)
    : Image(image), Width(image->GetDimensions()[0]), Height(image->GetDimensions()[1])
  {
  }

  /// False where there is nothing.
  bool GetColor(int x, int y, Color& color) const
  {
    const int* const extent = this->Image->GetExtent();
    const int components = this->Image->GetNumberOfScalarComponents();
    const auto* const pixel = static_cast<const unsigned char*>(
      this->Image->GetScalarPointer(extent[0] + x, extent[3] - y, extent[4]));
    for (int c = 0; c < 3; ++c)
    {
      color[c] = pixel[components < 3 ? 0 : c];
    }
    return components % 2 != 0 || pixel[components - 1] >= 128;
  }

  vtkImageData* const Image;
  const int Width;
  const int Height;
};

std::uint32_t GetKey(const Color& color)
{
  return static_cast<std::uint32_t>(color[0] << 16 | color[1] << 8 | color[2]);
}

/// As bright as it looks; ITU-R BT.709.
double GetLuminance(const Color& color)
{
  return 0.2126 * color[0] + 0.7152 * color[1] + 0.0722 * color[2];
}

/// The lightest first.
std::vector<Color> FindTones(const FlatPicture& picture)
{
  std::unordered_map<std::uint32_t, std::size_t> counts;
  std::size_t opaque = 0;
  Color color;
  for (int y = 0; y < picture.Height; ++y)
  {
    for (int x = 0; x < picture.Width; ++x)
    {
      if (picture.GetColor(x, y, color))
      {
        ++opaque;
        ++counts[GetKey(color)];
      }
    }
  }
  std::vector<std::pair<std::size_t, std::uint32_t>> frequent;
  for (const auto& [key, count] : counts)
  {
    if (static_cast<double>(count) >= LeastShare * static_cast<double>(opaque))
    {
      frequent.emplace_back(count, key);
    }
  }
  std::sort(frequent.rbegin(), frequent.rend());
  frequent.resize(std::min(frequent.size(), MostTones));
  std::size_t flat = 0;
  std::vector<Color> tones;
  for (const auto& [count, key] : frequent)
  {
    flat += count;
    tones.push_back({ static_cast<int>(key >> 16), static_cast<int>(key >> 8 & 255),
      static_cast<int>(key & 255) });
  }
  if (static_cast<double>(flat) < LeastFlat * static_cast<double>(opaque))
  {
    throw DrawingError("The picture of tones is not flat: only " +
      NumberText(100.0 * static_cast<double>(flat) / static_cast<double>(opaque), 3) +
      " % of it have a colour that is frequent. Take a style whose shading is toon, without "
      "textures, or a picture of the shading instead.");
  }
  std::sort(tones.begin(), tones.end(),
    [](const Color& a, const Color& b)
    {
      const double one = GetLuminance(a);
      const double other = GetLuminance(b);
      return one != other ? one > other : a > b;
    });
  return tones;
}

/// What a pixel shows: a tone, or a mean of two, by their places and 1; Nothing where it shows
/// none.
struct Mixture
{
  unsigned char Low = Nothing;
  unsigned char High = Nothing;
  unsigned char Share = 0; // of the high one, in 255

  unsigned char GetCoverage(unsigned char least) const
  {
    return this->Low >= least ? 255 : this->High >= least ? this->Share : 0;
  }
};

/// The two tones between which a colour lies. Where all lie in a line, as the brightnesses of one
/// colour do, that must be the nearest two.
Mixture FindMixture(const Color& color, const std::vector<Color>& tones)
{
  constexpr double distanceForSpan = 1e-3;
  Mixture mixture;
  double best = std::numeric_limits<double>::max();
  const auto get = [](const Color& of) { return Eigen::Vector3d(of[0], of[1], of[2]); };
  for (std::size_t low = 0; low < tones.size(); ++low)
  {
    for (std::size_t high = low; high < tones.size(); ++high)
    {
      const Eigen::Vector3d along = get(tones[high]) - get(tones[low]);
      const Eigen::Vector3d way = get(color) - get(tones[low]);
      const double span = along.squaredNorm();
      const double share = span > 0.0 ? std::clamp(way.dot(along) / span, 0.0, 1.0) : 0.0;
      const double cost = (way - share * along).squaredNorm() + distanceForSpan * span;
      if (cost < best)
      {
        best = cost;
        mixture = { static_cast<unsigned char>(low + 1), static_cast<unsigned char>(high + 1),
          static_cast<unsigned char>(std::lround(255.0 * share)) };
      }
    }
  }
  return mixture;
}

/// Row by row.
std::vector<Mixture> FindMixtures(const FlatPicture& picture, const std::vector<Color>& tones)
{
  std::unordered_map<std::uint32_t, Mixture> known;
  std::vector<Mixture> pixels;
  pixels.reserve(static_cast<std::size_t>(picture.Width) * picture.Height);
  Color color;
  for (int y = 0; y < picture.Height; ++y)
  {
    for (int x = 0; x < picture.Width; ++x)
    {
      if (!picture.GetColor(x, y, color))
      {
        pixels.emplace_back();
        continue;
      }
      const auto [found, isNew] = known.emplace(GetKey(color), Mixture());
      if (isNew)
      {
        found->second = FindMixture(color, tones);
      }
      pixels.push_back(found->second);
    }
  }
  return pixels;
}

/// Around what shows this tone or a later one.
std::vector<std::vector<Eigen::Vector2d>> TraceBorders(
  const std::vector<Mixture>& pixels, int width, int height, unsigned char least)
{
  // What reaches the picture's border goes on beyond it, so that it is not rounded there, and ends,
  // so that its border is closed.
  constexpr int beyond = static_cast<int>(SmoothingReach * SmoothingWidth) + 2;
  constexpr int ring = 1;
  constexpr int margin = beyond + ring;
  vtkNew<vtkImageData> mask;
  mask->SetDimensions(width + 2 * margin, height + 2 * margin, 1);
  mask->SetOrigin(-margin, -margin, 0.0);
  mask->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* pixel = static_cast<unsigned char*>(mask->GetScalarPointer());
  for (int y = -margin; y < height + margin; ++y)
  {
    const std::size_t row = static_cast<std::size_t>(std::clamp(y, 0, height - 1)) * width;
    for (int x = -margin; x < width + margin; ++x)
    {
      const bool isInside =
        x >= -beyond && y >= -beyond && x < width + beyond && y < height + beyond;
      *pixel++ = isInside ? pixels[row + std::clamp(x, 0, width - 1)].GetCoverage(least) : 0;
    }
  }
  vtkNew<vtkImageGaussianSmooth> smooth;
  smooth->SetInputData(mask);
  smooth->SetDimensionality(2);
  smooth->SetStandardDeviation(SmoothingWidth);
  smooth->SetRadiusFactor(SmoothingReach);
  vtkNew<vtkSynchronizedTemplates2D> edges;
  edges->SetInputConnection(smooth->GetOutputPort());
  edges->ComputeScalarsOff();
  edges->SetValue(0, 127.5);
  vtkNew<vtkStripper> join;
  join->SetInputConnection(edges->GetOutputPort());
  join->SetMaximumLength(std::numeric_limits<int>::max());
  join->JoinContiguousSegmentsOn();
  join->Update();

  std::vector<std::vector<Eigen::Vector2d>> loops;
  vtkPolyData* const borders = join->GetOutput();
  vtkNew<vtkIdList> ids;
  for (vtkIdType line = 0; line < borders->GetNumberOfLines(); ++line)
  {
    borders->GetLines()->GetCellAtId(line, ids);
    loops.emplace_back();
    for (vtkIdType i = 0; i + 1 < ids->GetNumberOfIds(); ++i) // the last is the first
    {
      double place[3];
      borders->GetPoint(ids->GetId(i), place);
      loops.back().emplace_back(place[0] + 0.5, place[1] + 0.5); // pixels have their middles there
    }
  }
  return loops;
}
}

//------------------------------------------------------------------------------
std::vector<ToneRegion> FindToneRegions(vtkImageData* image)
{
  const FlatPicture picture(image);
  const std::vector<Color> tones = FindTones(picture);
  const std::vector<Mixture> pixels = FindMixtures(picture, tones);
  std::vector<ToneRegion> regions;
  for (std::size_t tone = 0; tone < tones.size(); ++tone)
  {
    ToneRegion region;
    for (int c = 0; c < 3; ++c)
    {
      region.Color[c] = tones[tone][c] / 255.0;
    }
    region.Loops =
      TraceBorders(pixels, picture.Width, picture.Height, static_cast<unsigned char>(tone + 1));
    regions.push_back(std::move(region));
  }
  return regions;
}
}
