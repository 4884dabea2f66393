// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprPlainLines.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace nprbench
{
namespace
{
// As the library's definitions have them by default.
constexpr float SuggestiveThreshold = 2.0f;
constexpr float SuggestiveFade = 2.0f;
constexpr float LeastSine = 0.2588190f; // of 15 degrees
constexpr float ContourFade = 0.02f;
constexpr float RidgeThreshold = 4.0f;
constexpr float RidgeFade = 4.0f;
constexpr float ApparentThreshold = 6.0f;
constexpr float ApparentFade = 4.0f;
// Seen from the side, curvature grows beyond any bound.
constexpr float LeastCosine = 0.01f;

/// The corner whose sign is not that of the other two.
int FindOddCorner(bool a, bool b, bool c)
{
  return a == b ? 2 : a == c ? 1 : 0;
}
}

//------------------------------------------------------------------------------
PlainLines::PlainLines(PlainMesh mesh, float lengthScale)
  : Mesh(std::move(mesh)), LengthScale(lengthScale)
{
  this->Mesh.ComputeAdjacency();
  const std::size_t size = this->Mesh.Points.size();
  this->Facing.resize(size);
  this->ToEye.resize(size);
  this->RadialCurvature.resize(size);
  this->Test.resize(size);
  this->ViewCurvature.resize(size);
  this->ViewDirection.resize(size);
  this->ViewDerivative.resize(size);
}

//------------------------------------------------------------------------------
void PlainLines::SetUpView(const Vector& eye)
{
  this->Segments.clear();
  for (std::size_t i = 0; i < this->Facing.size(); ++i)
  {
    this->ToEye[i] = (eye - this->Mesh.Points[i]).normalized();
    this->Facing[i] = this->Mesh.Normals[i].dot(this->ToEye[i]);
  }
}

//------------------------------------------------------------------------------
void PlainLines::AddSegment(const Triangle& t, const Corners& field, const Corners& test)
{
  const int odd = FindOddCorner(field[0] < 0.0f, field[1] < 0.0f, field[2] < 0.0f);
  const int next = odd == 2 ? 0 : odd + 1;
  const int last = odd == 0 ? 2 : odd - 1;
  const float s = field[odd] / (field[odd] - field[next]);
  const float r = field[odd] / (field[odd] - field[last]);
  float accepted[2] = { test[odd] + s * (test[next] - test[odd]),
    test[odd] + r * (test[last] - test[odd]) };
  if (accepted[0] <= 0.0f && accepted[1] <= 0.0f)
  {
    return;
  }
  const Vector& corner = this->Mesh.Points[t[odd]];
  Vector ends[2] = { corner + s * (this->Mesh.Points[t[next]] - corner),
    corner + r * (this->Mesh.Points[t[last]] - corner) };
  for (int i = 0; i < 2; ++i)
  {
    if (accepted[i] < 0.0f)
    {
      ends[i] += accepted[i] / (accepted[i] - accepted[1 - i]) * (ends[1 - i] - ends[i]);
      accepted[i] = 0.0f;
    }
  }
  this->Segments.push_back(
    { ends[0], ends[1], std::min(accepted[0], 1.0f), std::min(accepted[1], 1.0f) });
}

//------------------------------------------------------------------------------
void PlainLines::AddMaximum(
  const Triangle& t, const std::vector<Vector>& directions, Corners derivative, const Corners& test)
{
  const Vector& direction = directions[t[0]];
  for (int i = 1; i < 3; ++i)
  {
    if (directions[t[i]].dot(direction) < 0.0f)
    {
      derivative[i] = -derivative[i];
    }
  }
  const bool negative = derivative[0] < 0.0f;
  if (negative == (derivative[1] < 0.0f) && negative == (derivative[2] < 0.0f))
  {
    return;
  }
  // What rises lies behind the maximum, what falls beyond it: along the direction the derivative
  // falls over the triangle.
  const Vector& a = this->Mesh.Points[t[0]];
  const Vector b = this->Mesh.Points[t[1]] - a;
  const Vector c = this->Mesh.Points[t[2]] - a;
  const Vector gradient =
    ((derivative[1] - derivative[0]) * c - (derivative[2] - derivative[0]) * b).cross(b.cross(c));
  if (gradient.dot(direction) < 0.0f)
  {
    this->AddSegment(t, derivative, test);
  }
}

//------------------------------------------------------------------------------
void PlainLines::AddContour(const Triangle& t)
{
  const float a = this->Facing[t[0]];
  const float b = this->Facing[t[1]];
  const float c = this->Facing[t[2]];
  if ((a < 0.0f) != (b < 0.0f) || (a < 0.0f) != (c < 0.0f))
  {
    this->AddSegment(t, { a, b, c }, { 1.0f, 1.0f, 1.0f });
  }
}

//------------------------------------------------------------------------------
void PlainLines::FindContours(const Vector& eye)
{
  this->Segments.clear();
  for (std::size_t i = 0; i < this->Facing.size(); ++i)
  {
    this->Facing[i] = this->Mesh.Normals[i].dot(eye - this->Mesh.Points[i]);
  }
  for (const Triangle& t : this->Mesh.Triangles)
  {
    this->AddContour(t);
  }
}

//------------------------------------------------------------------------------
// Radial curvature times sin^2, and what must be positive.
void PlainLines::ComputeRadialCurvature(const Vector& eye)
{
  this->SetUpView(eye);
  const float square = this->LengthScale * this->LengthScale;
  for (std::size_t i = 0; i < this->Facing.size(); ++i)
  {
    const float cosine = this->Facing[i];
    const float u = this->ToEye[i].dot(this->Mesh.E1[i]);
    const float v = this->ToEye[i].dot(this->Mesh.E2[i]);
    const float sine2 = u * u + v * v;
    const float k1 = this->Mesh.K1[i];
    const float k2 = this->Mesh.K2[i];
    this->RadialCurvature[i] = k1 * u * u + k2 * v * v;
    const float sine = std::sqrt(sine2);
    const float facing = std::min((sine - LeastSine) / LeastSine, cosine / ContourFade);
    if (facing <= 0.0f)
    {
      this->Test[i] = facing;
      continue;
    }
    const std::array<float, 4>& c = this->Mesh.Derivatives[i];
    const float cubic = u * u * (u * c[0] + 3.0f * v * c[1]) + v * v * (3.0f * u * c[2] + v * c[3]);
    const float derivative = cubic / sine2 + 2.0f * k1 * k2 * cosine;
    this->Test[i] =
      std::min(facing, (square * derivative - SuggestiveThreshold * sine) / SuggestiveFade);
  }
}

//------------------------------------------------------------------------------
void PlainLines::FindSuggestiveContours(const Vector& eye)
{
  this->ComputeRadialCurvature(eye);
  for (const Triangle& t : this->Mesh.Triangles)
  {
    this->AddContour(t);
    const Corners test = { this->Test[t[0]], this->Test[t[1]], this->Test[t[2]] };
    if (test[0] <= 0.0f && test[1] <= 0.0f && test[2] <= 0.0f)
    {
      continue;
    }
    const Corners field = { this->RadialCurvature[t[0]], this->RadialCurvature[t[1]],
      this->RadialCurvature[t[2]] };
    if ((field[0] < 0.0f) != (field[1] < 0.0f) || (field[0] < 0.0f) != (field[2] < 0.0f))
    {
      this->AddSegment(t, field, test);
    }
  }
}

//------------------------------------------------------------------------------
// The largest singular value of S (I + (sec - 1) w w'), w of unit length, and its direction.
void PlainLines::ComputeViewCurvature()
{
  for (std::size_t i = 0; i < this->Facing.size(); ++i)
  {
    const float cosine = this->Facing[i];
    this->ViewCurvature[i] = 0.0f;
    if (cosine <= 0.0f)
    {
      continue;
    }
    const float u = this->ToEye[i].dot(this->Mesh.E1[i]);
    const float v = this->ToEye[i].dot(this->Mesh.E2[i]);
    const float secant = 1.0f / std::max(cosine, LeastCosine);
    // (sec - 1) / sin^2 = sec^2 / (sec + 1), which does not vanish over itself.
    const float stretch = secant * secant / (secant + 1.0f);
    const float k1 = this->Mesh.K1[i];
    const float k2 = this->Mesh.K2[i];
    const float a = k1 * (1.0f + stretch * u * u);
    const float b = k1 * stretch * u * v;
    const float c = k2 * stretch * u * v;
    const float d = k2 * (1.0f + stretch * v * v);
    // Of the symmetric matrix A'A.
    const float first = a * a + c * c;
    const float mixed = a * b + c * d;
    const float second = b * b + d * d;
    const float half = 0.5f * (first - second);
    const float root = std::sqrt(half * half + mixed * mixed);
    this->ViewCurvature[i] = std::sqrt(std::max(0.5f * (first + second) + root, 0.0f));
    const Vector along = half >= 0.0f
      ? Vector((half + root) * this->Mesh.E1[i] + mixed * this->Mesh.E2[i])
      : Vector(mixed * this->Mesh.E1[i] + (root - half) * this->Mesh.E2[i]);
    this->ViewDirection[i] = along.normalized();
  }
}

//------------------------------------------------------------------------------
// The mean of both ways along the direction, each to where it leaves the triangles at the point.
void PlainLines::ComputeViewDerivative()
{
  for (std::size_t i = 0; i < this->Facing.size(); ++i)
  {
    this->ViewDerivative[i] = 0.0f;
    if (this->Facing[i] <= 0.0f)
    {
      continue;
    }
    const Vector& point = this->Mesh.Points[i];
    const Vector& along = this->ViewDirection[i];
    const Vector across = this->Mesh.Normals[i].cross(along);
    float sum = 0.0f;
    int count = 0;
    for (const int face : this->Mesh.AdjacentTriangles[i])
    {
      const Triangle& t = this->Mesh.Triangles[face];
      const int here = t[0] == static_cast<int>(i) ? 0 : t[1] == static_cast<int>(i) ? 1 : 2;
      const int b = t[(here + 1) % 3];
      const int c = t[(here + 2) % 3];
      const Vector toB = this->Mesh.Points[b] - point;
      const Vector toC = this->Mesh.Points[c] - point;
      const float yb = toB.dot(across);
      const float yc = toC.dot(across);
      if ((yb < 0.0f) == (yc < 0.0f))
      {
        continue;
      }
      const float s = yb / (yb - yc);
      const float x = (toB + s * (toC - toB)).dot(along);
      const float there =
        this->ViewCurvature[b] + s * (this->ViewCurvature[c] - this->ViewCurvature[b]);
      if (x != 0.0f)
      {
        sum += (there - this->ViewCurvature[i]) / x;
        ++count;
      }
    }
    this->ViewDerivative[i] = count > 0 ? sum / static_cast<float>(count) : 0.0f;
  }
}

//------------------------------------------------------------------------------
void PlainLines::FindApparentRidges(const Vector& eye)
{
  this->SetUpView(eye);
  this->ComputeViewCurvature();
  this->ComputeViewDerivative();
  const float least = ApparentThreshold / this->LengthScale;
  const float scale = this->LengthScale / ApparentFade;
  for (const Triangle& t : this->Mesh.Triangles)
  {
    if (this->Facing[t[0]] <= 0.0f || this->Facing[t[1]] <= 0.0f || this->Facing[t[2]] <= 0.0f)
    {
      continue;
    }
    const Corners test = { scale * (this->ViewCurvature[t[0]] - least),
      scale * (this->ViewCurvature[t[1]] - least), scale * (this->ViewCurvature[t[2]] - least) };
    if (test[0] <= 0.0f && test[1] <= 0.0f && test[2] <= 0.0f)
    {
      continue;
    }
    this->AddMaximum(t, this->ViewDirection,
      { this->ViewDerivative[t[0]], this->ViewDerivative[t[1]], this->ViewDerivative[t[2]] }, test);
  }
}

//------------------------------------------------------------------------------
void PlainLines::FindRidgesAndValleys()
{
  this->Segments.clear();
  const float least = RidgeThreshold / this->LengthScale;
  const float scale = this->LengthScale / RidgeFade;
  for (const Triangle& t : this->Mesh.Triangles)
  {
    const Corners k = { this->Mesh.K1[t[0]], this->Mesh.K1[t[1]], this->Mesh.K1[t[2]] };
    const float side = k[0] < 0.0f ? -1.0f : 1.0f;
    if (side * k[1] <= 0.0f || side * k[2] <= 0.0f)
    {
      continue;
    }
    const Corners test = { scale * (side * k[0] - least), scale * (side * k[1] - least),
      scale * (side * k[2] - least) };
    if (test[0] > 0.0f || test[1] > 0.0f || test[2] > 0.0f)
    {
      this->AddMaximum(t, this->Mesh.E1,
        { side * this->Mesh.Derivatives[t[0]][0], side * this->Mesh.Derivatives[t[1]][0],
          side * this->Mesh.Derivatives[t[2]][0] },
        test);
    }
  }
}

//------------------------------------------------------------------------------
void PlainLines::AddLevels(const std::vector<float>& levels)
{
  for (const Triangle& t : this->Mesh.Triangles)
  {
    const float a = this->Facing[t[0]];
    const float b = this->Facing[t[1]];
    const float c = this->Facing[t[2]];
    const float high = std::max({ a, b, c });
    for (auto level = std::upper_bound(levels.begin(), levels.end(), std::min({ a, b, c }));
         level != levels.end() && *level <= high; ++level)
    {
      this->AddSegment(t, { a - *level, b - *level, c - *level }, { 1.0f, 1.0f, 1.0f });
    }
  }
}

//------------------------------------------------------------------------------
void PlainLines::FindIsophotes(const Vector& eye, const std::vector<float>& levels)
{
  this->SetUpView(eye);
  this->AddLevels(levels);
}

//------------------------------------------------------------------------------
void PlainLines::FindTopographicLines(const Vector& direction, const std::vector<float>& levels)
{
  this->Segments.clear();
  for (std::size_t i = 0; i < this->Facing.size(); ++i)
  {
    this->Facing[i] = this->Mesh.Points[i].dot(direction);
  }
  this->AddLevels(levels);
}
}
