// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprLineFlicker.h"

#include "nprArrayNames.h"
#include "nprBenchmarkViews.h"
#include "vtkNPRFeatureLines.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <algorithm>

namespace nprbench
{
namespace
{
constexpr int Size = 1000;    // pixels
constexpr double Reach = 1.5; // pixels
constexpr double Step = 0.5;  // pixels between the places that are looked at along a line

struct Place
{
  double X; // pixels
  double Y;
  float Strength;
};

//------------------------------------------------------------------------------
/// Places along lines, as a camera sees them.
std::vector<Place> Project(vtkPolyData* lines, vtkCamera* camera)
{
  const Eigen::Matrix4d matrix = Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(
    camera->GetCompositeProjectionTransformMatrix(1.0, -1.0, 1.0)->GetData());
  vtkDataArray* const strengths = lines->GetPointData()->GetArray(npr::names::Strength);
  const auto project = [&](vtkIdType id, Place& place)
  {
    Eigen::Vector4d p = Eigen::Vector4d::Ones();
    lines->GetPoint(id, p.data());
    p = matrix * p;
    place.X = 0.5 * Size * (p.x() / p.w() + 1.0);
    place.Y = 0.5 * Size * (p.y() / p.w() + 1.0);
    place.Strength = static_cast<float>(strengths->GetTuple1(id));
    return p.w() > 0.0;
  };
  std::vector<Place> places;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < lines->GetNumberOfLines(); ++cell)
  {
    lines->GetLines()->GetCellAtId(cell, ids);
    double along = 0.5 * Step; // of the next place, from the start of the piece
    for (vtkIdType i = 0; i + 1 < ids->GetNumberOfIds(); ++i)
    {
      Place from{};
      Place to{};
      if (!project(ids->GetId(i), from) || !project(ids->GetId(i + 1), to))
      {
        continue;
      }
      const double length = std::hypot(to.X - from.X, to.Y - from.Y);
      for (; along < length; along += Step)
      {
        const double t = along / length;
        places.push_back({ from.X + t * (to.X - from.X), from.Y + t * (to.Y - from.Y),
          from.Strength + static_cast<float>(t) * (to.Strength - from.Strength) });
      }
      along -= length;
    }
  }
  return places;
}

//------------------------------------------------------------------------------
bool IsInside(int x, int y)
{
  return x >= 0 && x < Size && y >= 0 && y < Size;
}

//------------------------------------------------------------------------------
/// The greatest strength within reach of each pixel.
std::vector<float> Draw(const std::vector<Place>& places)
{
  std::vector<float> picture(static_cast<std::size_t>(Size) * Size, 0.0f);
  constexpr int Wide = static_cast<int>(Reach) + 1;
  for (const Place& place : places)
  {
    const int column = static_cast<int>(std::floor(place.X));
    const int row = static_cast<int>(std::floor(place.Y));
    for (int y = row - Wide; y <= row + Wide; ++y)
    {
      for (int x = column - Wide; x <= column + Wide; ++x)
      {
        if (IsInside(x, y) && std::hypot(x + 0.5 - place.X, y + 0.5 - place.Y) <= Reach)
        {
          float& pixel = picture[static_cast<std::size_t>(y) * Size + x];
          pixel = std::max(pixel, place.Strength);
        }
      }
    }
  }
  return picture;
}

//------------------------------------------------------------------------------
struct Ink
{
  double All = 0.0;
  double Missing = 0.0;
};

/// Adds what of the lines a picture does not have.
void Compare(const std::vector<Place>& places, const std::vector<float>& picture, Ink& ink)
{
  for (const Place& place : places)
  {
    const int x = static_cast<int>(std::floor(place.X));
    const int y = static_cast<int>(std::floor(place.Y));
    if (IsInside(x, y))
    {
      const float there = picture[static_cast<std::size_t>(y) * Size + x];
      ink.All += Step * place.Strength;
      ink.Missing += Step * std::max(0.0f, place.Strength - there);
    }
  }
}

//------------------------------------------------------------------------------
void CompareFrames(const std::vector<Place>& then, const std::vector<Place>& now, Ink& ink)
{
  Compare(now, Draw(then), ink);
  Compare(then, Draw(now), ink);
}

//------------------------------------------------------------------------------
std::vector<Place> WithoutFading(std::vector<Place> places)
{
  for (Place& place : places)
  {
    place.Strength = 1.0f;
  }
  return places;
}
}

//------------------------------------------------------------------------------
LineFlicker MeasureFlicker(vtkPolyData* surface, const char* lineName, int steps, double degrees)
{
  vtkNew<vtkNPRFeatureLines> filter;
  filter->AddDefinition(lineName);
  filter->SetInputData(surface);
  vtkNew<vtkPolyData> before;
  Ink faded;
  Ink drawn;
  for (int i = 0; i <= steps; ++i)
  {
    const auto camera = MakeView(surface, degrees * i, 4.5);
    filter->SetCamera(camera);
    filter->Update();
    if (i > 0)
    {
      const std::vector<Place> now = Project(filter->GetOutput(), camera);
      const std::vector<Place> then = Project(before, camera);
      CompareFrames(then, now, faded);
      CompareFrames(WithoutFading(then), WithoutFading(now), drawn);
    }
    before->DeepCopy(filter->GetOutput());
  }
  LineFlicker flicker;
  flicker.Faded = faded.All > 0.0 ? faded.Missing / faded.All : 0.0;
  flicker.Drawn = drawn.All > 0.0 ? drawn.Missing / drawn.All : 0.0;
  flicker.Pixels = 0.5 * drawn.All / steps;
  return flicker;
}
}
