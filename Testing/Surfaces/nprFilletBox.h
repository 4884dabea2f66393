// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprFilletBox.h
 * @brief A box with round edges, in the triangles that a CAD program makes of it.
 */
#ifndef nprFilletBox_h
#define nprFilletBox_h

#include <vtkCellArray.h>
#include <vtkMath.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <cmath>
#include <vector>

namespace nprtest
{
/// A block on a foot, whose edges are all round with that radius, also where the block stands on
/// the foot: each fillet is of so many slivers side by side that run from one end of it to the
/// other.
inline vtkSmartPointer<vtkPolyData> MakeFilletBox(double radius, int slivers = 3)
{
  // How far the surface is from the inner rectangle, and its height.
  std::vector<std::array<double, 2>> profile = { { 0.0, 0.0 } };
  const auto addFillet = [&](double distance, double height, double from, double to)
  {
    for (int i = 0; i <= slivers; ++i)
    {
      const double angle = vtkMath::RadiansFromDegrees(from + (to - from) * i / slivers);
      profile.push_back({ distance + radius * std::cos(angle), height + radius * std::sin(angle) });
    }
  };
  const double block = 0.05 + radius;
  const double foot = 0.4 + 2.0 * radius;
  const double height = 0.2 + 2.0 * radius;
  const double top = 0.7 + 4.0 * radius;
  addFillet(foot - radius, radius, -90.0, 0.0);
  addFillet(foot - radius, height - radius, 0.0, 90.0);
  addFillet(block + radius, height + radius, 270.0, 180.0);
  addFillet(block - radius, top - radius, 0.0, 90.0);
  profile.push_back({ 0.0, top });

  const std::array<double, 2> halves = { 0.6, 0.4 };
  const int columns = 4 * (slivers + 1);
  const int rows = static_cast<int>(profile.size());
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  std::vector<vtkIdType> ids;
  for (const auto& [distance, z] : profile)
  {
    for (int column = 0; column < columns; ++column)
    {
      const int quarter = column / (slivers + 1);
      const int step = column % (slivers + 1);
      if (distance == 0.0 && step > 0)
      {
        ids.push_back(ids.back());
        continue;
      }
      const double longitude =
        0.5 * vtkMath::Pi() * (quarter + static_cast<double>(step) / slivers);
      ids.push_back(points->InsertNextPoint(
        distance * std::cos(longitude) + (quarter == 0 || quarter == 3 ? halves[0] : -halves[0]),
        distance * std::sin(longitude) + (quarter < 2 ? halves[1] : -halves[1]), z));
    }
  }
  const auto getPoint = [&](int row, int column) { return ids[row * columns + column % columns]; };
  auto triangles = vtkSmartPointer<vtkCellArray>::New();
  const auto add = [&](vtkIdType a, vtkIdType b, vtkIdType c)
  {
    if (a != b && b != c && c != a)
    {
      const std::array<vtkIdType, 3> corners = { a, b, c };
      triangles->InsertNextCell(3, corners.data());
    }
  };
  const auto addQuad = [&](vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType d)
  {
    add(a, b, c);
    add(a, c, d);
  };
  for (int row = 0; row + 1 < rows; ++row)
  {
    for (int column = 0; column < columns; ++column)
    {
      addQuad(getPoint(row, column), getPoint(row, column + 1), getPoint(row + 1, column + 1),
        getPoint(row + 1, column));
    }
  }
  const int quarter = slivers + 1;
  addQuad(getPoint(0, 3 * quarter), getPoint(0, 2 * quarter), getPoint(0, quarter), getPoint(0, 0));
  addQuad(getPoint(rows - 1, 0), getPoint(rows - 1, quarter), getPoint(rows - 1, 2 * quarter),
    getPoint(rows - 1, 3 * quarter));
  auto box = vtkSmartPointer<vtkPolyData>::New();
  box->SetPoints(points);
  box->SetPolys(triangles);
  return box;
}
}

#endif
