// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprRibs.h
 * @brief A plate with round ribs, in the triangles that a CAD program makes of it.
 */
#ifndef nprRibs_h
#define nprRibs_h

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
/// A plate with three ribs, round with a radius of 0.1 at their tops and at their feet. Between any
/// two of its lines along the ribs all triangles are in one plane. They are of about equal edges.
inline vtkSmartPointer<vtkPolyData> MakeRibs(int steps = 4)
{
  constexpr double radius = 0.1;
  const double step = radius * vtkMath::RadiansFromDegrees(60.0) / steps;
  std::vector<std::array<double, 2>> profile = { { 0.0, 0.0 } };
  double direction = 0.0;
  const auto draw = [&](double length)
  {
    const auto [x, z] = profile.back();
    profile.push_back({ x + length * std::cos(direction), z + length * std::sin(direction) });
  };
  const auto drawArc = [&](double degrees, int count)
  {
    const double turn = vtkMath::RadiansFromDegrees(degrees) / count;
    for (int i = 0; i < count; ++i)
    {
      direction += 0.5 * turn;
      draw(2.0 * radius * std::sin(0.5 * std::abs(turn)));
      direction += 0.5 * turn;
    }
  };
  for (int rib = 0; rib < 3; ++rib)
  {
    for (int i = 0; i < 6; ++i)
    {
      draw(step);
    }
    drawArc(60.0, steps);
    drawArc(-120.0, 2 * steps);
    drawArc(60.0, steps);
  }
  for (int i = 0; i < 6; ++i)
  {
    draw(step);
  }

  // Points of each second line stand in the middle between those of the others.
  const int rows = static_cast<int>(0.8 / (1.15 * step));
  const int columns = static_cast<int>(profile.size());
  auto points = vtkSmartPointer<vtkPoints>::New();
  auto triangles = vtkSmartPointer<vtkCellArray>::New();
  const auto getPoint = [rows](int column, int row)
  { return static_cast<vtkIdType>(column) * (rows + 1) + row; };
  const auto add = [&](vtkIdType a, vtkIdType b, vtkIdType c)
  {
    const std::array<vtkIdType, 3> corners = { a, b, c };
    triangles->InsertNextCell(3, corners.data());
  };
  for (int column = 0; column < columns; ++column)
  {
    const bool isShifted = column % 2 == 1;
    for (int row = 0; row <= rows; ++row)
    {
      const double place = isShifted && row < rows ? row + 0.5 : row;
      points->InsertNextPoint(profile[column][0], 1.15 * step * place, profile[column][1]);
    }
    for (int row = 0; column > 0 && row < rows; ++row)
    {
      const vtkIdType a = getPoint(column - 1, row);
      const vtkIdType b = getPoint(column, row);
      if (isShifted)
      {
        add(a, b, a + 1);
        add(b, b + 1, a + 1);
      }
      else
      {
        add(a, b, b + 1);
        add(a, b + 1, a + 1);
      }
    }
  }
  auto ribs = vtkSmartPointer<vtkPolyData>::New();
  ribs->SetPoints(points);
  ribs->SetPolys(triangles);
  return ribs;
}
}

#endif
