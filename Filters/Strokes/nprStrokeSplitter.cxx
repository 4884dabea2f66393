// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprStrokeSplitter.h"

#include <algorithm>
#include <queue>
#include <tuple>
#include <utility>

namespace npr
{
namespace
{
/// In pixels. Pieces are as the one before them until as much has come together.
constexpr double LeastPiece = 0.02;
/// In pixels. How finely pieces are looked at where it depends on distances what hides them.
constexpr double EdgeOnStep = 1.0;
constexpr double MostSteps = 10000.0;
/// In pixels. Shorter segments are not searched for places where they go through a surface.
constexpr double LeastPierced = 0.5;

/// Parts in a row or a ring, that become fewer.
class PartMerger
{
public:
  PartMerger(std::vector<StrokePart>& parts, bool isClosed)
    : Parts(parts), Before(parts.size()), After(parts.size()), Gone(parts.size(), 0)
  {
    const std::size_t size = parts.size();
    for (std::size_t i = 0; i < size; ++i)
    {
      this->Before[i] = i > 0 ? i - 1 : isClosed ? size - 1 : None;
      this->After[i] = i + 1 < size ? i + 1 : isClosed ? 0 : None;
    }
  }

  void MergeShorterThan(double least)
  {
    for (std::size_t i = 0; i < this->Parts.size(); ++i)
    {
      this->Push(i, least);
    }
    while (!this->Shortest.empty())
    {
      const auto [length, part] = this->Shortest.top();
      this->Shortest.pop();
      // What has grown since has come again.
      if (!this->Gone[part] && this->Parts[part].Length == length)
      {
        this->MergeOne(part);
        this->Push(part, least);
      }
    }
  }

  /// In order, beginning with the one that had the first place.
  std::vector<StrokePart> GetParts() const
  {
    std::vector<StrokePart> rest;
    for (std::size_t i = 0; i < this->Parts.size(); ++i)
    {
      if (!this->Gone[i])
      {
        rest.push_back(this->Parts[i]);
      }
    }
    return rest;
  }

  /// Makes one of all neighbours that are alike around this one.
  void JoinLike(std::size_t part)
  {
    for (auto* beside : { &this->After, &this->Before })
    {
      const std::size_t other = (*beside)[part];
      if (other != None && other != part && this->Parts[other].Layers == this->Parts[part].Layers)
      {
        this->Absorb(part, other, beside == &this->After);
      }
    }
  }

private:
  static constexpr std::size_t None = static_cast<std::size_t>(-1);

  void Push(std::size_t part, double least)
  {
    const bool hasBefore = this->IsUsable(this->Before[part], part);
    const bool hasAfter = this->IsUsable(this->After[part], part);
    // What ends hidden is no gap.
    const bool mayChange =
      this->Parts[part].Layers > 0 ? hasBefore && hasAfter : hasBefore || hasAfter;
    if (this->Parts[part].Layers != StrokePart::Nowhere && this->Parts[part].Length < least &&
      mayChange)
    {
      this->Shortest.push({ this->Parts[part].Length, part });
    }
  }
  bool IsUsable(std::size_t other, std::size_t part) const
  {
    return other != None && other != part && this->Parts[other].Layers != StrokePart::Nowhere;
  }
  void MergeOne(std::size_t part)
  {
    std::size_t other = this->Before[part];
    const std::size_t after = this->After[part];
    if (!this->IsUsable(other, part) ||
      (this->IsUsable(after, part) && this->Parts[after].Length > this->Parts[other].Length))
    {
      other = after;
    }
    if (this->IsUsable(other, part))
    {
      this->Parts[part].Layers = this->Parts[other].Layers;
      this->JoinLike(part);
    }
  }
  void Absorb(std::size_t part, std::size_t other, bool isAfter)
  {
    StrokePart& merged = this->Parts[part];
    merged.Length += this->Parts[other].Length;
    this->Gone[other] = 1;
    if (isAfter)
    {
      merged.End = this->Parts[other].End;
      this->After[part] = this->After[other];
      if (this->After[part] != None)
      {
        this->Before[this->After[part]] = part;
      }
    }
    else
    {
      merged.Begin = this->Parts[other].Begin;
      this->Before[part] = this->Before[other];
      if (this->Before[part] != None)
      {
        this->After[this->Before[part]] = part;
      }
    }
  }

  using LengthAndPart = std::pair<double, std::size_t>;
  std::vector<StrokePart>& Parts;
  std::vector<std::size_t> Before;
  std::vector<std::size_t> After;
  std::vector<unsigned char> Gone;
  std::priority_queue<LengthAndPart, std::vector<LengthAndPart>, std::greater<>> Shortest;
};
}

//------------------------------------------------------------------------------
std::vector<StrokePart> MergeParts(
  std::vector<StrokePart> parts, double least, bool isClosed, std::size_t size)
{
  if (parts.size() < 2)
  {
    return parts;
  }
  PartMerger merger(parts, isClosed);
  if (isClosed)
  {
    merger.JoinLike(0);
  }
  merger.MergeShorterThan(least);
  std::vector<StrokePart> merged = merger.GetParts();
  if (merged.size() == 1)
  {
    // A ring that is all alike begins where it did.
    merged[0].Begin = 0.0;
    merged[0].End = static_cast<double>(size);
  }
  return merged;
}

//------------------------------------------------------------------------------
StrokeSplitter::StrokeSplitter(const HidingSurfaces& surfaces, const HidingEdges& edges,
  const ImageProjection& projection, int most)
  : Surfaces(surfaces), Edges(edges), Projection(projection), Layers(surfaces, projection, most)
{
}

//------------------------------------------------------------------------------
std::vector<StrokePart> StrokeSplitter::Split(
  const std::vector<Vector>& points, const std::vector<Vector>& normals)
{
  this->Points = &points;
  this->Normals = &normals;
  this->Parts.clear();
  this->Unseen = 0.0;
  for (std::size_t segment = 0; segment + 1 < points.size(); ++segment)
  {
    this->SplitSegment(segment);
  }
  return std::move(this->Parts);
}

//------------------------------------------------------------------------------
void StrokeSplitter::Append(int layers, double begin, double end, double length)
{
  if (!this->Parts.empty() && this->Parts.back().Layers == layers)
  {
    this->Parts.back().End = end;
    this->Parts.back().Length += length;
  }
  else
  {
    this->Parts.push_back({ layers, begin, end, length });
  }
}

//------------------------------------------------------------------------------
int StrokeSplitter::CountLayers(std::size_t segment, double place, bool mayBeEdgeOn)
{
  if (this->Surfaces.IsEmpty())
  {
    return 0;
  }
  const auto mix = [&](const std::vector<Vector>& values)
  { return Vector(values[segment] + place * (values[segment + 1] - values[segment])); };
  Vector normal = this->Normals->empty() ? Vector(Vector::Zero()) : mix(*this->Normals);
  if (!normal.allFinite())
  {
    normal.setZero();
  }
  return this->Layers.Count(mix(*this->Points), normal, mayBeEdgeOn);
}

//------------------------------------------------------------------------------
void StrokeSplitter::AddPiece(
  std::size_t segment, double begin, double end, double length, bool mayBeEdgeOn)
{
  const auto start = static_cast<double>(segment);
  const bool isKnown = !this->Parts.empty() && this->Parts.back().Layers != StrokePart::Nowhere;
  this->Unseen += length;
  if (isKnown && this->Unseen < LeastPiece)
  {
    this->Append(this->Parts.back().Layers, start + begin, start + end, length);
    return;
  }
  this->Unseen = 0.0;
  const int layers = this->CountLayers(segment, 0.5 * (begin + end), mayBeEdgeOn);
  if (length < 2.0 * EdgeOnStep || !this->Layers.IsNearlyEdgeOn())
  {
    this->Append(layers, start + begin, start + end, length);
    return;
  }
  const int steps = static_cast<int>(std::min(length / EdgeOnStep, MostSteps));
  for (int step = 0; step < steps; ++step)
  {
    const double from = begin + (end - begin) * step / steps;
    const double to = step + 1 < steps ? begin + (end - begin) * (step + 1) / steps : end;
    this->Append(this->CountLayers(segment, 0.5 * (from + to), mayBeEdgeOn), start + from,
      start + to, length / steps);
  }
}

//------------------------------------------------------------------------------
void StrokeSplitter::SplitSegment(std::size_t segment)
{
  const Vector& from = (*this->Points)[segment];
  const Vector& to = (*this->Points)[segment + 1];
  const auto start = static_cast<double>(segment);
  if (!from.allFinite() || !to.allFinite())
  {
    this->Append(StrokePart::Nowhere, start, start + 1.0, 0.0);
    return;
  }
  // What is in front of the eye.
  ImageProjection::Place begin = this->Projection.Project(from);
  ImageProjection::Place end = this->Projection.Project(to);
  double first = 0.0;
  double last = 1.0;
  const bool isBeginSeen = this->Projection.IsInFront(begin.Depth);
  const bool isEndSeen = this->Projection.IsInFront(end.Depth);
  if (!isBeginSeen && !isEndSeen)
  {
    this->Append(StrokePart::Nowhere, start, start + 1.0, 0.0);
    return;
  }
  if (!isBeginSeen || !isEndSeen)
  {
    // Twice the least depth, for what is cut at the least may come out behind it.
    const double cut = std::clamp(
      (2.0 * this->Projection.GetNearest() - begin.Depth) / (end.Depth - begin.Depth), 0.0, 1.0);
    (isBeginSeen ? last : first) = cut;
    (isBeginSeen ? end : begin) = this->Projection.Project(from + cut * (to - from));
  }
  const Vector seenFrom = from + first * (to - from);
  const Vector seenTo = from + last * (to - from);

  this->Places.clear();
  if (!this->Surfaces.IsEmpty())
  {
    this->Edges.FindCrossings(begin, end, this->Places);
    if ((end.Pixel - begin.Pixel).norm() > LeastPierced)
    {
      this->Layers.FindPiercings(seenFrom, seenTo, this->Places);
    }
    std::sort(this->Places.begin(), this->Places.end());
  }
  this->Places.push_back(1.0);
  const bool mayBeEdgeOn = this->Edges.MayBeEdgeOn(begin, end);

  if (first > 0.0)
  {
    this->Append(StrokePart::Nowhere, start, start + first, 0.0);
  }
  double before = first;
  Eigen::Vector2d pixelBefore = begin.Pixel;
  for (const double seenPlace : this->Places)
  {
    const double place = std::min(last, first + seenPlace * (last - first));
    if (place <= before)
    {
      continue;
    }
    const Eigen::Vector2d pixel =
      seenPlace == 1.0 ? end.Pixel : this->Projection.Project(from + place * (to - from)).Pixel;
    const double length = (pixel - pixelBefore).norm();
    this->AddPiece(segment, before, place, length, mayBeEdgeOn);
    before = place;
    pixelBefore = pixel;
  }
  if (last < 1.0)
  {
    this->Append(StrokePart::Nowhere, start + last, start + 1.0, 0.0);
  }
}
}
