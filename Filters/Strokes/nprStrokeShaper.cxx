// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprStrokeShaper.h"

#include "nprLatticeNoise.h"

#include <vtkMath.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace npr
{
namespace
{
constexpr double StepsOfTaper = 8.0;
constexpr double StepsOfWave = 16.0;
constexpr double MostSteps = 4096.0;        // of a segment
constexpr double LeastOfWidth = 0.25;       // however small a stroke is: it is to be seen
constexpr double TangentOfOvershoot = 0.25; // the stretch, as a share of it, that it goes on from

/// The sample at the end of the segment that holds a length, and where in that.
template<typename Numbers>
std::pair<std::size_t, double> FindSegment(const Numbers& lengths, double length)
{
  const auto next = std::upper_bound(lengths.begin() + 1, lengths.end() - 1, length);
  const double step = *next - *(next - 1);
  return { static_cast<std::size_t>(next - lengths.begin()),
    step > 0.0 ? (length - *(next - 1)) / step : 0.0 };
}

/// The measured way along samples.
class Path
{
public:
  Path(const std::vector<StrokeSample>& samples, const StrokeMeasure& measure, bool closed)
    : Closed(closed)
  {
    for (const StrokeSample& sample : samples)
    {
      this->Places.push_back(measure.GetPlace(sample.Position));
      this->Lengths.push_back(this->Lengths.empty()
          ? 0.0
          : this->Lengths.back() + (this->Places.back() - *(this->Places.end() - 2)).norm());
    }
  }

  double GetLength() const { return this->Lengths.back(); }
  double GetLengthAt(std::size_t sample) const { return this->Lengths[sample]; }

  Eigen::Vector3d GetArea() const
  {
    Eigen::Vector3d area = Eigen::Vector3d::Zero();
    for (std::size_t i = 1; i < this->Places.size(); ++i)
    {
      area += 0.5 * this->Places[i - 1].cross(this->Places[i]);
    }
    return area;
  }

  Eigen::Vector3d GetPlace(double length) const
  {
    const auto [i, t] = FindSegment(this->Lengths, length);
    return this->Places[i - 1] + t * (this->Places[i] - this->Places[i - 1]);
  }

  /// One by the radius of the circle through the places at and around a length.
  double GetCurvature(double length, double reach) const
  {
    const double whole = this->GetLength();
    reach = std::min(reach, (this->Closed ? 0.25 : 0.5) * whole);
    if (!this->Closed)
    {
      length = std::min(std::max(length, reach), whole - reach);
    }
    const Eigen::Vector3d here = this->GetPlace(length);
    const Eigen::Vector3d in = here - this->GetPlace(this->Wrap(length - reach));
    const Eigen::Vector3d out = this->GetPlace(this->Wrap(length + reach)) - here;
    const double sides = in.norm() * out.norm() * (in + out).norm();
    // Where the curve comes back to where it was, the circle has no size.
    const double most = 2.0 / std::max(reach, std::numeric_limits<double>::min());
    return sides > 0.0 ? std::min(2.0 * in.cross(out).norm() / sides, most) : 0.0;
  }

private:
  double Wrap(double length) const
  {
    const double whole = this->GetLength();
    return !this->Closed ? length
      : length < 0.0     ? length + whole
      : length > whole   ? length - whole
                         : length;
  }

  bool Closed;
  std::vector<Eigen::Vector3d> Places;
  std::vector<double> Lengths;
};

std::vector<StrokeSample> MakeSamples(const StrokeChain& chain)
{
  std::vector<StrokeSample> samples;
  for (const StrokePoint& point : chain.Points)
  {
    samples.push_back({ point.Position, 0.0, point.Id, point.Id, 0.0 });
  }
  if (chain.Closed)
  {
    samples.push_back(samples.front());
  }
  return samples;
}

void Overshoot(std::vector<StrokeSample>& samples, const StrokeMeasure& measure,
  const StrokeShape& shape, const StrokeTraits& traits)
{
  const Path path(samples, measure, false);
  const double stretch =
    std::min(TangentOfOvershoot * shape.OvershootLength, 0.5 * path.GetLength());
  const auto makeEnd = [&](const StrokeSample& end, double at, double before)
  {
    const Eigen::Vector3d way = path.GetPlace(at) - path.GetPlace(before);
    StrokeSample beyond = end;
    beyond.Position = measure.Move(end.Position, shape.OvershootLength * way.stableNormalized());
    return beyond;
  };
  if (traits.EndIsTrue)
  {
    samples.push_back(makeEnd(samples.back(), path.GetLength(), path.GetLength() - stretch));
  }
  if (traits.StartIsTrue)
  {
    samples.insert(samples.begin(), makeEnd(samples.front(), 0.0, stretch));
  }
}

/// Adds samples where a taper or a wave needs them.
std::vector<StrokeSample> Refine(const std::vector<StrokeSample>& samples, const Path& path,
  double wave, double startTaper, double endTaper)
{
  std::vector<StrokeSample> finer{ samples.front() };
  for (std::size_t i = 1; i < samples.size(); ++i)
  {
    const double begin = path.GetLengthAt(i - 1);
    const double end = path.GetLengthAt(i);
    double steps = wave > 0.0 ? StepsOfWave * (end - begin) / wave : 1.0;
    if (begin < startTaper)
    {
      steps = std::max(steps, StepsOfTaper * (end - begin) / startTaper);
    }
    if (end > path.GetLength() - endTaper)
    {
      steps = std::max(steps, StepsOfTaper * (end - begin) / endTaper);
    }
    const StrokeSample& a = samples[i - 1];
    const StrokeSample& b = samples[i];
    const int count = static_cast<int>(std::min(std::max(std::ceil(steps), 1.0), MostSteps));
    for (int step = 1; step < count; ++step)
    {
      const double t = static_cast<double>(step) / count;
      Vector3 position;
      for (int c = 0; c < 3; ++c)
      {
        position[c] = a.Position[c] + t * (b.Position[c] - a.Position[c]);
      }
      finer.push_back({ position, 0.0, a.From, b.From, t });
    }
    finer.push_back(b);
  }
  return finer;
}

class Wobble
{
public:
  Wobble(const StrokeShape& shape, std::uint32_t seed, double length, bool closed)
    : Amplitude(shape.WobbleAmplitude), Seed(seed)
  {
    const double places = 2.0 * length / shape.WobbleWavelength;
    if (closed && length > 0.0)
    {
      this->Period = std::max<std::int64_t>(2, std::llround(places));
    }
    this->Length = length;
    this->Places = this->Period > 0 ? static_cast<double>(this->Period) : places;
  }

  double Get(double at, std::uint32_t axis) const
  {
    const double x = this->Length > 0.0 ? at / this->Length * this->Places : 0.0;
    const std::uint32_t seed = HashInteger(this->Seed + axis);
    return this->Amplitude / 1.5 *
      (GetLatticeNoise(x, seed, this->Period) +
        0.5 * GetLatticeNoise(2.0 * x, ~seed, 2 * this->Period));
  }

private:
  double Amplitude;
  std::uint32_t Seed;
  double Length = 0.0;
  double Places = 0.0;
  std::int64_t Period = 0;
};
}

//------------------------------------------------------------------------------
StrokeShape StrokeShape::For(double length) const
{
  StrokeShape shape = *this;
  if (this->RelativeToStroke)
  {
    shape.Reach *= length;
    shape.CurvatureUnit *= length;
    shape.TaperLength *= length;
    shape.OvershootLength *= length;
    shape.WobbleAmplitude *= length;
    shape.WobbleWavelength *= length;
    shape.RelativeToStroke = false;
  }
  return shape;
}

//------------------------------------------------------------------------------
void ShapedStrokes::Average(float* values) const
{
  std::size_t first = 0;
  for (std::size_t stroke = 0; stroke < this->Sizes.size(); ++stroke)
  {
    const std::size_t size = static_cast<std::size_t>(this->Sizes[stroke]);
    const std::vector<float> lengths(
      this->Lengths.begin() + first, this->Lengths.begin() + first + size);
    std::vector<double> sums{ 0.0 }; // over the way from the start
    for (std::size_t i = 1; i < size; ++i)
    {
      const double step = static_cast<double>(lengths[i]) - lengths[i - 1];
      sums.push_back(sums.back() + 0.5 * step * (values[first + i] + values[first + i - 1]));
    }
    const bool closed = this->Closed[stroke] != 0;
    const double whole = lengths.back();
    const auto sum = [&, &lengths = lengths](double length)
    {
      const double turns = closed ? std::floor(length / whole) : 0.0;
      const auto [i, t] = FindSegment(lengths, length - turns * whole);
      return turns * sums.back() + sums[i - 1] + t * (sums[i] - sums[i - 1]);
    };
    const double reach = this->Reaches[stroke];
    for (std::size_t i = 0; reach > 0.0 && i < size; ++i)
    {
      const double begin = closed ? lengths[i] - reach : std::max(lengths[i] - reach, 0.0);
      const double end = closed ? lengths[i] + reach : std::min(lengths[i] + reach, whole);
      values[first + i] = static_cast<float>((sum(end) - sum(begin)) / (end - begin));
    }
    first += size;
  }
}

//------------------------------------------------------------------------------
double ShapedStrokes::GetSize(std::size_t stroke) const
{
  std::size_t end = 0;
  for (std::size_t i = 0; i <= stroke; ++i)
  {
    end += static_cast<std::size_t>(this->Sizes[i]);
  }
  const double length = this->Lengths[end - 1];
  if (!this->Closed[stroke])
  {
    return 2.0 / vtkMath::Pi() * length;
  }
  return length > 0.0 ? 4.0 * this->Areas[stroke].norm() / length : 0.0;
}

//------------------------------------------------------------------------------
void ShapedStrokes::LimitWidths(float* widths, double perSize, bool isRelative) const
{
  std::size_t first = 0;
  for (std::size_t stroke = 0; stroke < this->Sizes.size(); ++stroke)
  {
    const std::size_t end = first + static_cast<std::size_t>(this->Sizes[stroke]);
    const double unit = isRelative ? this->Lengths[end - 1] : 1.0;
    const double most = unit > 0.0 ? perSize * this->GetSize(stroke) / unit : 0.0;
    const double widest = *std::max_element(widths + first, widths + end);
    if (widest > most)
    {
      const auto factor = static_cast<float>(std::max(most / widest, LeastOfWidth));
      std::for_each(widths + first, widths + end, [factor](float& width) { width *= factor; });
    }
    first = end;
  }
}

//------------------------------------------------------------------------------
void ShapeStroke(const StrokeChain& chain, const StrokeMeasure& measure, const StrokeShape& given,
  const StrokeTraits& traits, double firstArcLength, ShapedStrokes& strokes)
{
  std::vector<StrokeSample> samples = MakeSamples(chain);
  const StrokeShape shape = given.For(Path(samples, measure, chain.Closed).GetLength());
  if (!chain.Closed && shape.OvershootLength > 0.0)
  {
    Overshoot(samples, measure, shape, traits);
  }
  const Path coarse(samples, measure, chain.Closed);
  const double taper = chain.Closed ? 0.0 : std::min(shape.TaperLength, 0.5 * coarse.GetLength());
  const double startTaper = traits.StartIsTrue ? taper : 0.0;
  const double endTaper = traits.EndIsTrue ? taper : 0.0;
  const double wave = shape.WobbleAmplitude > 0.0 ? shape.WobbleWavelength : 0.0;
  samples = Refine(samples, coarse, wave, startTaper, endTaper);

  const Path path(samples, measure, chain.Closed);
  const double length = path.GetLength();
  const Wobble wobble(shape, traits.Seed, length, chain.Closed);
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    const double at = path.GetLengthAt(i);
    const auto rise = [](double fromEnd, double range)
    {
      const double x = range > 0.0 ? std::min(fromEnd / range, 1.0) : 1.0;
      return x * (2.0 - x);
    };
    strokes.Tapers.push_back(
      static_cast<float>(rise(at, startTaper) * rise(length - at, endTaper)));
    strokes.Lengths.push_back(static_cast<float>(at));
    if (shape.Curvatures)
    {
      strokes.Curvatures.push_back(
        static_cast<float>(shape.CurvatureUnit * path.GetCurvature(at, shape.Reach)));
    }
    if (wave > 0.0)
    {
      const double out = measure.IsPage() ? 0.0 : wobble.Get(at, 2);
      samples[i].Position =
        measure.Move(samples[i].Position, { wobble.Get(at, 0), wobble.Get(at, 1), out });
    }
  }
  strokes.Reaches.push_back(std::min(shape.Reach, 0.5 * length));
  strokes.Closed.push_back(chain.Closed);
  strokes.Areas.push_back(path.GetArea());
  samples.front().ArcLength = firstArcLength;
  MeasureArcLength(samples, 0);
  strokes.Samples.insert(strokes.Samples.end(), samples.begin(), samples.end());
  strokes.Sizes.push_back(static_cast<vtkIdType>(samples.size()));
}
}
