// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprStrokeSimplification.h"

#include "nprStrokeBuffer.h"

#include <vtkCamera.h>
#include <vtkMath.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>

namespace npr
{
namespace
{
// No segment gets longer, in tolerances: widths and opacities between its ends are interpolated in
// the picture, where perspective shortens what is far.
constexpr float LongestSegment = 1024.0f;
// Bounds the work where points lie dense.
constexpr std::size_t MostLeftOut = 32;

// What is steep: tolerances of widths, or of opacities, within one of length.
constexpr float WidthSlope = 0.4f;
constexpr float OpacitySlope = 1.5f;

/// Whether records are on the segments from one of them to others.
class SegmentTest
{
public:
  SegmentTest(const StrokeRecord* records, const unsigned char* colors,
    const StrokeTolerance& tolerance, std::size_t start)
    : Records(records), Colors(colors), Tolerance(tolerance), Start(start), End(start),
      IsSeen(!tolerance.Sight.IsAnywhere())
  {
    if (this->IsSeen)
    {
      const std::array<double, 4>& eye = tolerance.Sight.Eye;
      for (int c = 0; c < 3; ++c)
      {
        this->Sight[c] = static_cast<float>(eye[3] * records[start].Position[c] - eye[c]);
      }
      const float size = std::sqrt(Dot(this->Sight, this->Sight));
      for (float& component : this->Sight)
      {
        component /= size;
      }
    }
  }

  void SetEnd(std::size_t end)
  {
    this->End = end;
    for (int c = 0; c < 3; ++c)
    {
      this->Way[c] = this->Records[end].Position[c] - this->Records[this->Start].Position[c];
    }
    this->Depth = this->TakeDepth(this->Way);
    this->Size2 = Dot(this->Way, this->Way);
    this->PerSize2 = this->Size2 > 0.0f ? 1.0f / this->Size2 : 0.0f;
  }

  bool IsTooLong() const
  {
    const float longest = LongestSegment * this->Tolerance.Length;
    return this->Size2 > longest * longest;
  }

  bool Contains(std::size_t index) const
  {
    const StrokeRecord& a = this->Records[this->Start];
    const StrokeRecord& b = this->Records[this->End];
    const StrokeRecord& x = this->Records[index];
    float away[3];
    for (int c = 0; c < 3; ++c)
    {
      away[c] = x.Position[c] - a.Position[c];
    }
    const float depth = this->TakeDepth(away);
    const float along = Dot(away, this->Way);
    const float t = std::min(std::max(along * this->PerSize2, 0.0f), 1.0f);
    for (int c = 0; c < 3; ++c)
    {
      away[c] -= t * this->Way[c];
    }
    const auto agrees = [t](float first, float last, float value, float limit)
    { return std::abs(first + t * (last - first) - value) <= limit; };
    const StrokeTolerance& limit = this->Tolerance;
    return Dot(away, away) <= limit.Length * limit.Length &&
      agrees(0.0f, this->Depth, depth, limit.Sight.Depth * limit.Length) &&
      agrees(a.Width, b.Width, x.Width, limit.Width) &&
      agrees(a.Strength, b.Strength, x.Strength, limit.Strength) &&
      agrees(a.Opacity, b.Opacity, x.Opacity, limit.Opacity) &&
      agrees(a.ArcLength, b.ArcLength, x.ArcLength, limit.ArcLength) &&
      this->HasColor(index, agrees);
  }

private:
  static float Dot(const float a[3], const float b[3])
  {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }

  /// Takes the share along the sight line off, if there is one. @returns it
  float TakeDepth(float way[3]) const
  {
    const float depth = this->IsSeen ? Dot(way, this->Sight) : 0.0f;
    for (int c = 0; c < 3 && this->IsSeen; ++c)
    {
      way[c] -= depth * this->Sight[c];
    }
    return depth;
  }

  template<typename Agrees>
  bool HasColor(std::size_t index, const Agrees& agrees) const
  {
    for (std::size_t c = 0; this->Colors && c < 4; ++c)
    {
      if (!agrees(this->Colors[4 * this->Start + c], this->Colors[4 * this->End + c],
            this->Colors[4 * index + c], this->Tolerance.Color))
      {
        return false;
      }
    }
    return true;
  }

  const StrokeRecord* Records;
  const unsigned char* Colors;
  const StrokeTolerance& Tolerance;
  std::size_t Start;
  std::size_t End;
  bool IsSeen;
  float Sight[3] = { 0.0f, 0.0f, 0.0f }; // from the eye to the first record, of unit length
  float Way[3] = { 0.0f, 0.0f, 0.0f };   // across it
  float Depth = 0.0f;                    // along it
  float Size2 = 0.0f;
  float PerSize2 = 0.0f; // 1 / Size2
};

bool CanLeaveOut(SegmentTest& segment, std::size_t start, std::size_t end)
{
  segment.SetEnd(end);
  if (segment.IsTooLong())
  {
    return false;
  }
  for (std::size_t i = start + 1; i < end; ++i)
  {
    if (!segment.Contains(i))
    {
      return false;
    }
  }
  return true;
}
}

//------------------------------------------------------------------------------
StrokeTolerance StrokeTolerance::Scaled(float factor) const
{
  return { factor * this->Length, factor * this->Width, factor * this->Strength,
    factor * this->Opacity, factor * this->ArcLength, factor * this->Color, this->Sight };
}

StrokeTolerance StrokeTolerance::FromAnywhere() const
{
  StrokeTolerance tolerance = *this;
  tolerance.Sight = StrokeSight();
  return tolerance;
}

StrokeTolerance StrokeTolerance::Relative(const std::array<double, 3>& origin) const
{
  StrokeTolerance tolerance = *this;
  for (int c = 0; c < 3; ++c)
  {
    tolerance.Sight.Eye[c] -= tolerance.Sight.Eye[3] * origin[c];
  }
  return tolerance;
}

bool StrokeTolerance::Allows(const StrokeTolerance& other) const
{
  return other.Length <= this->Length && other.Width <= this->Width &&
    other.Strength <= this->Strength && other.Opacity <= this->Opacity &&
    other.ArcLength <= this->ArcLength && other.Color <= this->Color;
}

//------------------------------------------------------------------------------
void SimplifyStroke(const std::vector<StrokeRecord>& records, const unsigned char* colors,
  const StrokeTolerance& tolerance, std::vector<std::size_t>& kept)
{
  kept.clear();
  const std::size_t size = records.size();
  for (std::size_t start = 0; start < size;)
  {
    kept.push_back(start);
    std::size_t end = start + 1;
    if (tolerance.Length > 0.0f && records[start].Kind != 0.0f)
    {
      SegmentTest segment(records.data(), colors, tolerance, start);
      while (end + 1 < size && end - start < MostLeftOut && records[end].Kind != 0.0f &&
        records[end + 1].Kind != 0.0f && CanLeaveOut(segment, start, end + 1))
      {
        ++end;
      }
    }
    start = end;
  }
}

//------------------------------------------------------------------------------
bool IsSteep(const StrokeRecord& a, const StrokeRecord& b, const StrokeTolerance& tolerance)
{
  float size2 = 0.0f;
  for (int c = 0; c < 3; ++c)
  {
    size2 += (b.Position[c] - a.Position[c]) * (b.Position[c] - a.Position[c]);
  }
  const float size = std::sqrt(size2);
  const auto isSteep = [&](float first, float last, float limit, float slope)
  { return std::abs(last - first) * tolerance.Length > limit * (slope * size + tolerance.Length); };
  return !(tolerance.Length > 0.0f) || isSteep(a.Width, b.Width, tolerance.Width, WidthSlope) ||
    isSteep(a.Strength, b.Strength, tolerance.Strength, WidthSlope) ||
    isSteep(a.Opacity, b.Opacity, tolerance.Opacity, OpacitySlope);
}

//------------------------------------------------------------------------------
StrokeSight FindSight(vtkCamera* camera, vtkMatrix4x4* matrix)
{
  StrokeSight sight;
  if (matrix->Determinant() == 0.0)
  {
    return sight;
  }
  double eye[4] = { 0.0, 0.0, 0.0, 0.0 };
  if (camera->GetParallelProjection())
  {
    camera->GetDirectionOfProjection(eye);
    vtkMath::MultiplyScalar(eye, -1.0);
  }
  else
  {
    camera->GetPosition(eye);
    eye[3] = 1.0;
  }
  vtkNew<vtkMatrix4x4> toModel;
  vtkMatrix4x4::Invert(matrix, toModel);
  toModel->MultiplyPoint(eye, sight.Eye.data());
  return sight;
}

//------------------------------------------------------------------------------
double FindSmallestPixel(vtkRenderer* renderer, vtkMatrix4x4* matrix, const double bounds[6])
{
  double linear[3][3];
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      linear[i][j] = matrix->GetElement(i, j);
    }
  }
  double left[3][3];
  double scales[3];
  double right[3][3];
  vtkMath::SingularValueDecomposition3x3(linear, left, scales, right);
  const double scale = std::max({ std::abs(scales[0]), std::abs(scales[1]), std::abs(scales[2]) });

  vtkCamera* const camera = renderer->GetActiveCamera();
  vtkMatrix4x4* const projection =
    camera->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1, 1);
  int size[2];
  int origin[2];
  renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &origin[0], &origin[1]);
  const double pixel = 2.0 / (projection->GetElement(1, 1) * size[1] * scale);
  if (!std::isfinite(pixel) || camera->GetParallelProjection())
  {
    return std::isfinite(pixel) ? pixel : 0.0;
  }
  double eye[3];
  double direction[3];
  camera->GetPosition(eye);
  camera->GetDirectionOfProjection(direction);
  double nearest = VTK_DOUBLE_MAX;
  for (int corner = 0; corner < 8; ++corner)
  {
    double place[4] = { bounds[corner & 1], bounds[2 + ((corner >> 1) & 1)],
      bounds[4 + ((corner >> 2) & 1)], 1.0 };
    matrix->MultiplyPoint(place, place);
    vtkMath::Subtract(place, eye, place);
    nearest = std::min(nearest, vtkMath::Dot(place, direction));
  }
  return pixel * std::max(nearest, camera->GetClippingRange()[0]);
}
}
