// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprBenchmarkTorus.h
 * @brief A torus of any number of triangles, and how far an estimate is from its curvature.
 */
#ifndef nprBenchmarkTorus_h
#define nprBenchmarkTorus_h

#include "nprCurvatureDerivatives.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace nprbench
{
using Surface = vtkSmartPointer<vtkPolyData>;
using Eigen::Vector3d;
using Eigen::Vector4d;

constexpr double Pi = 3.14159265358979323846;
constexpr double Radius = 1.0; // of the torus
constexpr double Tube = 0.4;

//------------------------------------------------------------------------------
/// Around z, in rows around the tube; triangles of about equal sides. Bumps make the tube thicker
/// and thinner by this share of itself; from 10,000 triangles on, each is wide enough for its shape
/// to be the same at every size.
inline Surface MakeTorus(int triangles, double bumps = 0.0)
{
  const int columns = std::max(3, static_cast<int>(std::sqrt(triangles / 2.0 * Tube / Radius)));
  const int rows = std::max(3, triangles / 2 / columns);
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  cells->AllocateExact(2 * rows * columns, 6 * rows * columns);
  for (int i = 0; i < rows; ++i)
  {
    const double u = 2.0 * Pi * i / rows;
    for (int j = 0; j < columns; ++j)
    {
      const double v = 2.0 * Pi * j / columns;
      const double tube = Tube * (1.0 + bumps * std::sin(5.0 * u) * std::sin(3.0 * v));
      const double rho = Radius + tube * std::cos(v);
      points->InsertNextPoint(rho * std::cos(u), rho * std::sin(u), tube * std::sin(v));
      const vtkIdType right = (i + 1) % rows * columns;
      const vtkIdType up = (j + 1) % columns;
      const vtkIdType lower[3] = { i * columns + j, right + j, right + up };
      const vtkIdType upper[3] = { i * columns + j, right + up, i * columns + up };
      cells->InsertNextCell(3, lower);
      cells->InsertNextCell(3, upper);
    }
  }
  auto surface = Surface::New();
  surface->SetPoints(points);
  surface->SetPolys(cells);
  return surface;
}

/// Root mean square errors relative to the root mean square of what is true.
class TorusErrors
{
public:
  /// The principal curvatures in any order, and the derivatives over the frame (e1, e2).
  void Add(const Vector3d& p, double k1, double k2, const Vector3d& e1, const Vector3d& e2,
    const Vector4d& derivatives)
  {
    const double distance = std::hypot(p.x(), p.y());
    const double sine = p.z() / Tube;
    const double across = (distance - Radius) / Tube / distance;
    this->Curvature +=
      std::pow(std::max(k1, k2) - 1.0 / Tube, 2) + std::pow(std::min(k1, k2) - across, 2);
    this->TrueCurvature += 1.0 / (Tube * Tube) + across * across;
    // Along the meridian u only the curvature across it changes.
    const Vector3d v(-p.y() / distance, p.x() / distance, 0.0);
    const Vector3d n((distance - Radius) / Tube * p.x() / distance,
      (distance - Radius) / Tube * p.y() / distance, sine);
    const double slope = -Radius * sine / (Tube * distance * distance);
    const Vector4d here = npr::ChangeFrame(derivatives, { e1, e2 }, { n.cross(v), v });
    const Vector4d wrong = here - Vector4d(0.0, 0.0, slope, 0.0);
    this->Derivative += wrong[0] * wrong[0] + 3.0 * wrong[1] * wrong[1] +
      3.0 * wrong[2] * wrong[2] + wrong[3] * wrong[3];
    this->TrueDerivative += 3.0 * slope * slope;
  }
  void Print(const char* name) const
  {
    std::printf("%-32s curvature %.1e  derivatives %.1e\n", name,
      std::sqrt(this->Curvature / this->TrueCurvature),
      std::sqrt(this->Derivative / this->TrueDerivative));
  }

private:
  double Curvature = 0.0;
  double TrueCurvature = 0.0;
  double Derivative = 0.0;
  double TrueDerivative = 0.0;
};

}

#endif
