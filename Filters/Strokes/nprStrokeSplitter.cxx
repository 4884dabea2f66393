// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprStrokeSplitter.h"

#include <algorithm>
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

}

//------------------------------------------------------------------------------
StrokeSplitter::StrokeSplitter(const HidingSurfaces& surfaces, const HidingEdges& edges,
  const ImageProjection& projection, int most, bool isMirrored)
  : Surfaces(surfaces), Edges(edges), Projection(projection), Layers(surfaces, projection, most),
    Direction(isMirrored ? -1.0 : 1.0)
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
  const Vector along = this->Direction * ((*this->Points)[segment + 1] - (*this->Points)[segment]);
  return this->Layers.Count(mix(*this->Points), normal, along, mayBeEdgeOn);
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
  if (length < 2.0 * EdgeOnStep || !this->Layers.DependsOnDistance())
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
