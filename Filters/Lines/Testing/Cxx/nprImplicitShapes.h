// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprImplicitShapes.h
 * @brief Surfaces given by a function, meshes of them, and what is true of their curvature.
 *
 * What is true is taken from the gradient by differences in space and along the surface, by none
 * of the formulas that the library uses.
 */
#ifndef nprImplicitShapes_h
#define nprImplicitShapes_h

#include "nprLineTesting.h"

#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkImplicitFunction.h>

#include <functional>

namespace nprtest
{
/// The surface where the function is 0; outside it is positive.
class ImplicitShape : public vtkImplicitFunction
{
public:
  static ImplicitShape* New() { VTK_STANDARD_NEW_BODY(ImplicitShape); }
  vtkTypeMacro(ImplicitShape, vtkImplicitFunction);

  std::function<double(const Vector&)> Value;
  std::function<Vector(const Vector&)> Gradient;

  using vtkImplicitFunction::EvaluateFunction;
  double EvaluateFunction(double x[3]) override { return this->Value(Vector(x)); }
  void EvaluateGradient(double x[3], double g[3]) override
  {
    Eigen::Map<Vector>(g, 3) = this->Gradient(Vector(x));
  }

  /// The point of the surface that is next in the direction of the gradient.
  Vector Project(Vector p) const
  {
    for (int i = 0; i < 8; ++i)
    {
      const Vector gradient = this->Gradient(p);
      p -= this->Value(p) / gradient.squaredNorm() * gradient;
    }
    return p;
  }

  Vector GetNormal(const Vector& p) const { return this->Gradient(p).normalized(); }

  /// The second fundamental form as a matrix in space.
  Eigen::Matrix3d GetForm(const Vector& p) const
  {
    constexpr double h = 1.0e-4;
    Eigen::Matrix3d form;
    for (int i = 0; i < 3; ++i)
    {
      const Vector step = h * Vector::Unit(i);
      form.col(i) = (this->GetNormal(p + step) - this->GetNormal(p - step)) / (2.0 * h);
    }
    const Vector n = this->GetNormal(p);
    const Eigen::Matrix3d tangent = Eigen::Matrix3d::Identity() - n * n.transpose();
    form = tangent * form * tangent;
    return 0.5 * (form + form.transpose());
  }

  /// The principal curvature of the greater amount, and its direction.
  std::pair<double, Vector> GetFirstCurvature(const Vector& p) const
  {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(this->GetForm(p));
    const int first = std::abs(solver.eigenvalues()[0]) > std::abs(solver.eigenvalues()[2]) ? 0 : 2;
    return { solver.eigenvalues()[first], solver.eigenvectors().col(first) };
  }

  /// How fast something changes along the surface in the direction of a tangent.
  double Differentiate(const std::function<double(const Vector&)>& something, const Vector& p,
    const Vector& direction) const
  {
    constexpr double h = 1.0e-3;
    return (something(this->Project(p + h * direction)) -
             something(this->Project(p - h * direction))) /
      (2.0 * h);
  }

protected:
  ImplicitShape() = default;
  ~ImplicitShape() override = default;
};

inline vtkSmartPointer<ImplicitShape> MakeShape(
  std::function<double(const Vector&)> value, std::function<Vector(const Vector&)> gradient)
{
  auto shape = vtkSmartPointer<ImplicitShape>::New();
  shape->Value = std::move(value);
  shape->Gradient = std::move(gradient);
  return shape;
}

//------------------------------------------------------------------------------
inline vtkSmartPointer<ImplicitShape> MakeTorusShape()
{
  const auto ring = [](const Vector& p)
  { return Vector(Vector(p[0], p[1], 0.0) / std::hypot(p[0], p[1])); };
  return MakeShape([ring](const Vector& p) { return (p - ring(p)).squaredNorm() - 0.16; },
    [ring](const Vector& p) { return Vector(2.0 * (p - ring(p))); });
}

inline vtkSmartPointer<ImplicitShape> MakeEllipsoidShape(const Vector& axes)
{
  const Vector inverse = axes.cwiseAbs2().cwiseInverse();
  return MakeShape([inverse](const Vector& p) { return p.cwiseAbs2().dot(inverse) - 1.0; },
    [inverse](const Vector& p) { return Vector(2.0 * p.cwiseProduct(inverse)); });
}

/// Waves of different heights whose crests bend.
inline vtkSmartPointer<ImplicitShape> MakeWavesShape()
{
  const auto phase = [](const Vector& p) { return 2.0 * p[0] + 0.6 * p[1] * p[1]; };
  return MakeShape([phase](const Vector& p) { return p[2] - 0.3 * std::sin(phase(p)); },
    [phase](const Vector& p)
    {
      const double c = 0.3 * std::cos(phase(p));
      return Vector(-2.0 * c, -1.2 * p[1] * c, 1.0);
    });
}

/// The sum of x^4 - 5 x^2 over the coordinates is -11.8: a cube of tubes, of genus 5.
inline vtkSmartPointer<ImplicitShape> MakeTangleShape()
{
  return MakeShape(
    [](const Vector& p)
    {
      const Vector q = p.cwiseAbs2();
      return q.squaredNorm() - 5.0 * q.sum() + 11.8;
    },
    [](const Vector& p) { return Vector(4.0 * p.cwiseProduct(p.cwiseAbs2()) - 10.0 * p); });
}

//------------------------------------------------------------------------------
/// Moves the points onto the surface; their normals are then the library's to find.
inline vtkSmartPointer<vtkPolyData> PutOn(const ImplicitShape& shape, vtkPolyData* mesh)
{
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(mesh->GetNumberOfPoints());
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    points->SetPoint(i, shape.Project(Vector(mesh->GetPoint(i))).data());
  }
  surface->SetPoints(points);
  surface->SetPolys(mesh->GetPolys());
  return surface;
}

/// Marching cubes of so many cells in each direction over [-size, size]^3.
inline vtkSmartPointer<vtkPolyData> MakeIsosurface(
  const ImplicitShape& shape, double size, int cells)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(cells + 1, cells + 1, cells + 1);
  image->SetOrigin(-size, -size, -size);
  image->SetSpacing(2.0 * size / cells, 2.0 * size / cells, 2.0 * size / cells);
  image->AllocateScalars(VTK_DOUBLE, 1);
  auto* const values = static_cast<double*>(image->GetScalarPointer());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    values[i] = shape.Value(Vector(image->GetPoint(i)));
  }
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(image);
  contour->SetValue(0, 0.0);
  contour->ComputeNormalsOff();
  contour->ComputeScalarsOff();
  contour->Update();
  return PutOn(shape, contour->GetOutput());
}
}

#endif
