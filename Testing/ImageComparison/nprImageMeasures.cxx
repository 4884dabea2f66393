// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprImageMeasures.h"

#include <vtkImageData.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace npr
{
namespace
{
// One pass along the rows, returned transposed; two passes make a separable filter of any kind.
template<typename Filter>
Plane RowsTransposed(const Plane& in, Filter&& filter)
{
  Plane out(in.Height, in.Width);
  std::vector<float> row(in.Width);
  for (int y = 0; y < in.Height; ++y)
  {
    filter(in.Values.data() + static_cast<std::size_t>(y) * in.Width, row.data(), in.Width);
    for (int x = 0; x < in.Width; ++x)
    {
      out.At(y, x) = row[x];
    }
  }
  return out;
}

template<typename Filter>
Plane Separable(const Plane& in, Filter&& filter)
{
  return RowsTransposed(RowsTransposed(in, filter), filter);
}

template<typename Compare>
Plane WindowExtremum(const Plane& in, int reach, Compare better)
{
  return Separable(in,
    [&](const float* values, float* result, int count)
    {
      for (int i = 0; i < count; ++i)
      {
        const int begin = std::max(i - reach, 0);
        const int end = std::min(i + reach + 1, count);
        result[i] = *std::max_element(
          values + begin, values + end, [&](float a, float b) { return better(b, a); });
      }
    });
}

Plane Dilated(const Plane& in, int reach)
{
  return WindowExtremum(in, reach, [](float a, float b) { return a > b; });
}

Plane Eroded(const Plane& in, int reach)
{
  return WindowExtremum(in, reach, [](float a, float b) { return a < b; });
}

Plane Blurred(const Plane& in)
{
  constexpr int reach = 5;
  constexpr double sigma = 1.5;
  std::array<float, 2 * reach + 1> weights;
  for (int k = -reach; k <= reach; ++k)
  {
    weights[k + reach] = static_cast<float>(std::exp(-k * k / (2.0 * sigma * sigma)));
  }
  return Separable(in,
    [&](const float* values, float* result, int count)
    {
      for (int i = 0; i < count; ++i)
      {
        float sum = 0.0f;
        float total = 0.0f;
        for (int k = std::max(-reach, -i); k <= std::min(reach, count - 1 - i); ++k)
        {
          sum += weights[k + reach] * values[i + k];
          total += weights[k + reach];
        }
        result[i] = sum / total;
      }
    });
}

Plane Product(const Plane& a, const Plane& b)
{
  Plane out(a.Width, a.Height);
  std::transform(a.Values.begin(), a.Values.end(), b.Values.begin(), out.Values.begin(),
    [](float x, float y) { return x * y; });
  return out;
}

// Squared distances along one row, given the squared distances across it: the lower envelope of
// the parabolas that stand on the row's pixels.
void SquaredDistanceRow(const float* values, float* result, int count)
{
  std::vector<int> apex(count);
  std::vector<double> start(count + 1);
  const auto meet = [&](int left, int right)
  {
    return ((values[right] + double(right) * right) - (values[left] + double(left) * left)) /
      (2.0 * (right - left));
  };
  int last = 0;
  apex[0] = 0;
  start[0] = -1e30;
  start[1] = 1e30;
  for (int i = 1; i < count; ++i)
  {
    double crossing = meet(apex[last], i);
    while (crossing <= start[last])
    {
      --last;
      crossing = meet(apex[last], i);
    }
    ++last;
    apex[last] = i;
    start[last] = crossing;
    start[last + 1] = 1e30;
  }
  int parabola = 0;
  for (int i = 0; i < count; ++i)
  {
    while (start[parabola + 1] < i)
    {
      ++parabola;
    }
    const int offset = i - apex[parabola];
    result[i] = static_cast<float>(double(offset) * offset + values[apex[parabola]]);
  }
}

double SumAbove(const Plane& plane, float threshold)
{
  double sum = 0.0;
  for (const float value : plane.Values)
  {
    sum += value > threshold ? value : 0.0;
  }
  return sum;
}

// The pixels that differ from the most frequent value of their row, or of their column.
int CountOffRow(const Plane& plane, bool columns)
{
  constexpr float tolerance = 8.0f / 255.0f;
  const int rows = columns ? plane.Width : plane.Height;
  const int length = columns ? plane.Height : plane.Width;
  int count = 0;
  std::vector<float> row(length);
  for (int r = 0; r < rows; ++r)
  {
    for (int i = 0; i < length; ++i)
    {
      row[i] = columns ? plane.At(r, i) : plane.At(i, r);
    }
    std::nth_element(row.begin(), row.begin() + length / 2, row.end());
    const float median = row[length / 2];
    count += static_cast<int>(std::count_if(
      row.begin(), row.end(), [&](float value) { return std::abs(value - median) > tolerance; }));
  }
  return count;
}
}

Plane::Plane(int width, int height, float value)
  : Width(width), Height(height), Values(static_cast<std::size_t>(width) * height, value)
{
}

std::vector<Plane> SplitChannels(vtkImageData* image)
{
  int size[3];
  image->GetDimensions(size);
  const int components = image->GetNumberOfScalarComponents();
  const bool grey = components < 3;
  const int alpha = components == 2 || components == 4 ? components - 1 : -1;
  std::vector<Plane> channels(4, Plane(size[0], size[1], 1.0f));
  const auto* pixels = static_cast<const unsigned char*>(image->GetScalarPointer());
  const std::size_t count = channels[0].Values.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    const unsigned char* pixel = pixels + i * components;
    for (int c = 0; c < 3; ++c)
    {
      channels[c].Values[i] = static_cast<float>(pixel[grey ? 0 : c]) / 255.0f;
    }
    if (alpha >= 0)
    {
      channels[3].Values[i] = static_cast<float>(pixel[alpha]) / 255.0f;
    }
  }
  return channels;
}

Plane InkStrength(const std::vector<Plane>& channels, Polarity polarity, int reach)
{
  Plane ink(channels[0].Width, channels[0].Height);
  const bool dark = polarity == Polarity::Dark;
  for (const Plane& channel : channels)
  {
    if (&channel != &channels[0] && channel.Values == channels[0].Values)
    {
      continue; // grey pictures, the usual ones, take a third of the time
    }
    const Plane paper =
      dark ? Eroded(Dilated(channel, reach), reach) : Dilated(Eroded(channel, reach), reach);
    for (std::size_t i = 0; i < ink.Values.size(); ++i)
    {
      ink.Values[i] = std::max(ink.Values[i], std::abs(paper.Values[i] - channel.Values[i]));
    }
  }
  return ink;
}

Polarity FindPolarity(const std::vector<Plane>& channels)
{
  // Thin strokes tell, where there are any: black lines on a bright object before a black
  // background are dark ink.
  constexpr float noise = 0.1f;
  constexpr int thin = 2;
  const double dark = SumAbove(InkStrength(channels, Polarity::Dark, thin), noise);
  const double light = SumAbove(InkStrength(channels, Polarity::Light, thin), noise);
  const auto count = static_cast<double>(channels[0].Values.size());
  if (std::max(dark, light) > std::max(0.002 * count, 3.0 * std::min(dark, light)))
  {
    return dark > light ? Polarity::Dark : Polarity::Light;
  }
  // Bold lines, or as many thin gaps as lines: what is not the paper, most of the picture, is ink.
  double paper = 0.0;
  double mean = 0.0;
  for (const Plane& channel : channels)
  {
    std::vector<float> values = channel.Values;
    std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
    paper += values[values.size() / 2];
    mean += std::accumulate(values.begin(), values.end(), 0.0) / count;
  }
  return mean <= paper ? Polarity::Dark : Polarity::Light;
}

Mask Threshold(const Plane& plane, float threshold)
{
  Mask mask(plane.Values.size());
  std::transform(plane.Values.begin(), plane.Values.end(), mask.begin(),
    [=](float value) { return static_cast<std::uint8_t>(value >= threshold); });
  return mask;
}

Plane DistanceTo(const Mask& mask, int width, int height)
{
  // Finite, so that the envelope's arithmetic holds; larger than any squared distance in the image.
  const float far =
    4.0f * (static_cast<float>(width) * width + static_cast<float>(height) * height);
  Plane distance(width, height);
  std::transform(mask.begin(), mask.end(), distance.Values.begin(),
    [=](std::uint8_t inside) { return inside ? 0.0f : far; });
  distance = Separable(distance, SquaredDistanceRow);
  for (float& value : distance.Values)
  {
    value = std::sqrt(value);
  }
  return distance;
}

int LongestPiece(const Mask& mask, int width, int height)
{
  Mask left = mask;
  int longest = 0;
  std::vector<int> stack;
  for (int seed = 0; seed < width * height; ++seed)
  {
    if (!left[seed])
    {
      continue;
    }
    int low[2] = { width, height };
    int high[2] = { 0, 0 };
    left[seed] = 0;
    stack.push_back(seed);
    while (!stack.empty())
    {
      const int at[2] = { stack.back() % width, stack.back() / width };
      stack.pop_back();
      for (int k = 0; k < 2; ++k)
      {
        low[k] = std::min(low[k], at[k]);
        high[k] = std::max(high[k], at[k]);
      }
      for (int y = std::max(at[1] - 1, 0); y <= std::min(at[1] + 1, height - 1); ++y)
      {
        for (int x = std::max(at[0] - 1, 0); x <= std::min(at[0] + 1, width - 1); ++x)
        {
          if (left[y * width + x])
          {
            left[y * width + x] = 0;
            stack.push_back(y * width + x);
          }
        }
      }
    }
    longest = std::max({ longest, high[0] - low[0] + 1, high[1] - low[1] + 1 });
  }
  return longest;
}

Plane StructuralSimilarity(const Plane& a, const Plane& b)
{
  constexpr float c1 = 0.1f * 0.1f;
  constexpr float c2 = 0.05f * 0.05f;
  const Plane meanA = Blurred(a);
  const Plane meanB = Blurred(b);
  const Plane squareA = Blurred(Product(a, a));
  const Plane squareB = Blurred(Product(b, b));
  const Plane product = Blurred(Product(a, b));
  Plane similarity(a.Width, a.Height);
  for (std::size_t i = 0; i < similarity.Values.size(); ++i)
  {
    const float ma = meanA.Values[i];
    const float mb = meanB.Values[i];
    const float covariance = product.Values[i] - ma * mb;
    const float variances = squareA.Values[i] - ma * ma + squareB.Values[i] - mb * mb;
    similarity.Values[i] = (2.0f * ma * mb + c1) * (2.0f * covariance + c2) /
      ((ma * ma + mb * mb + c1) * (variances + c2));
  }
  return similarity;
}

bool IsBlank(const std::vector<Plane>& channels)
{
  // A few stray pixels are no drawing either.
  constexpr int stray = 10;
  return std::all_of(channels.begin(), channels.end(),
    [](const Plane& channel)
    { return CountOffRow(channel, false) < stray || CountOffRow(channel, true) < stray; });
}
}
