// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprPointMeasures.h"

#include "nprTangentFrame.h"

#include <vtkSMPTools.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace npr
{
namespace
{
using Index = TriangleMesh::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::Vector3f;
using Eigen::Vector4f;

/// As many members of a neighbourhood side by side.
using Lanes = Eigen::Array4f;
constexpr int NumberOfLanes = 4;

/// 1 in so many lanes, else 0.
const Lanes Used[NumberOfLanes + 1] = { { 0.0f, 0.0f, 0.0f, 0.0f }, { 1.0f, 0.0f, 0.0f, 0.0f },
  { 1.0f, 1.0f, 0.0f, 0.0f }, { 1.0f, 1.0f, 1.0f, 0.0f }, { 1.0f, 1.0f, 1.0f, 1.0f } };

/// The integrals over one triangle, with the normals interpolated between its corners.
struct FaceMeasure
{
  double Area;
  Vector3d Normal; // unit, the direction of the mean of the corners' normals
  SymmetricTensor Form;
};

//------------------------------------------------------------------------------
FaceMeasure MeasureFace(
  const TriangleMesh& mesh, const Tuples<3>& normals, const TriangleMesh::Triangle& corners)
{
  const Vector3d origin = mesh.GetPoint(corners[0]).cast<double>();
  const Vector3d a = mesh.GetPoint(corners[1]).cast<double>() - origin;
  const Vector3d b = mesh.GetPoint(corners[2]).cast<double>() - origin;
  const Vector3d n0 = normals[corners[0]].cast<double>();
  const Vector3d n1 = normals[corners[1]].cast<double>();
  const Vector3d n2 = normals[corners[2]].cast<double>();
  const Vector3d mean = (n0 + n1 + n2) / 3.0;
  const double area = 0.5 * mean.dot(a.cross(b));
  // Where the normals disagree with the winding, they win.
  const double sign = std::copysign(0.5, area);
  // The form is x (n1 - n0)' + y (n2 - n0)', but for its part that is not symmetric.
  const Vector3d x = sign * b.cross(mean);
  const Vector3d y = sign * mean.cross(a);
  const Matrix3d form = x * (n1 - n0).transpose() + y * (n2 - n0).transpose();
  FaceMeasure measure;
  measure.Area = std::abs(area);
  measure.Normal = mean.normalized();
  measure.Form << form(0, 0), form(1, 1), form(2, 2), 0.5 * (form(0, 1) + form(1, 0)),
    0.5 * (form(1, 2) + form(2, 1)), 0.5 * (form(0, 2) + form(2, 0));
  return measure;
}

/// The sums that a linear function is fitted from; lengths in units of the radius.
class Moments
{
public:
  void Add(const Lanes& weight, const Lanes& x, const Lanes& y, const Lanes (&form)[3])
  {
    const Lanes wx = weight * x;
    const Lanes wy = weight * y;
    this->Plain[0] += weight;
    this->Plain[1] += wx;
    this->Plain[2] += wy;
    this->Plain[3] += wx * x;
    this->Plain[4] += wx * y;
    this->Plain[5] += wy * y;
    for (int i = 0; i < 3; ++i)
    {
      this->WithForm[3 * i] += weight * form[i];
      this->WithForm[3 * i + 1] += wx * form[i];
      this->WithForm[3 * i + 2] += wy * form[i];
    }
  }

  LinearForm Solve(double radius) const
  {
    LinearForm result;
    const auto add = [](const Lanes& lanes) { return lanes.cast<double>().sum(); };
    double m[6];
    std::transform(std::begin(this->Plain), std::end(this->Plain), m, add);
    const double sum = m[0];
    if (!(sum > 0.0))
    {
      return result;
    }
    Matrix3d matrix;
    matrix << m[0], m[1], m[2], m[1], m[3], m[4], m[2], m[4], m[5];
    matrix /= sum;
    // Rows: value, d/dx, d/dy; columns: the parts of the form.
    Matrix3d solution;
    std::transform(std::begin(this->WithForm), std::end(this->WithForm), solution.data(), add);
    solution /= sum;
    // A full disc has 1/64, half a disc a quarter of that.
    constexpr double leastDeterminant = 2e-4;
    if (matrix.determinant() > leastDeterminant)
    {
      solution = (matrix.inverse() * solution).eval();
    }
    else
    {
      solution.bottomRows<2>().setZero();
    }
    const Eigen::Vector3d uu = solution.col(0) + solution.col(1);
    const Eigen::Vector3d uv = solution.col(2);
    const Eigen::Vector3d vv = solution.col(0) - solution.col(1);
    // The derivative is symmetric in all three arguments: nearest to the six slopes is the mean.
    const Eigen::Vector4d cubic(
      uu[1], (uu[2] + 2.0 * uv[1]) / 3.0, (vv[1] + 2.0 * uv[2]) / 3.0, vv[2]);
    result.Form = Vector3d(uu[0], uv[0], vv[0]).cast<float>();
    result.Cubic = (cubic / radius).cast<float>();
    result.IsKnown = result.Form.allFinite() && result.Cubic.allFinite();
    return result.IsKnown ? result : LinearForm();
  }

private:
  // w, w x, w y, w xx, w xy, w yy
  Lanes Plain[6] = { Lanes::Zero(), Lanes::Zero(), Lanes::Zero(), Lanes::Zero(), Lanes::Zero(),
    Lanes::Zero() };
  // w, w x, w y times each part of the form
  Lanes WithForm[9] = { Lanes::Zero(), Lanes::Zero(), Lanes::Zero(), Lanes::Zero(), Lanes::Zero(),
    Lanes::Zero(), Lanes::Zero(), Lanes::Zero(), Lanes::Zero() };
};

/// Four vectors of four components, turned into four lanes.
struct Transposed
{
  template<typename GetVector>
  explicit Transposed(const GetVector& getVector)
  {
    for (int k = 0; k < NumberOfLanes; ++k)
    {
      this->Components.col(k) = getVector(k);
    }
    this->Components.transposeInPlace();
  }
  Lanes operator[](int i) const { return this->Components.col(i).array(); }
  Lanes Dot(const Vector3f& v) const
  {
    return (*this)[0] * v[0] + (*this)[1] * v[1] + (*this)[2] * v[2];
  }

private:
  Eigen::Matrix4f Components;
};
}

//------------------------------------------------------------------------------
std::vector<PointMeasure> MeasurePoints(const TriangleMesh& mesh, const Tuples<3>& normals)
{
  std::vector<PointMeasure> measures(mesh.GetNumberOfPoints());
  const double perSquare = 1.0 / (3.0 * mesh.GetUnit() * mesh.GetUnit());
  vtkSMPTools::For(0, mesh.GetNumberOfPoints(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const Index point = static_cast<Index>(i);
        const Vector3d normal = normals[i].cast<double>();
        const TangentFrame frame = MakeTangentFrame(normal);
        double area = 0.0;
        Vector3d form = Vector3d::Zero();
        for (const Index* t = mesh.IncidentBegin(point); t != mesh.IncidentEnd(point); ++t)
        {
          const FaceMeasure face = MeasureFace(mesh, normals, mesh.GetTriangle(*t));
          const MinimalRotation rotation(normal, face.Normal);
          if (face.Area > 0.0 && rotation.IsValid())
          {
            area += face.Area;
            form += ToFrame(face.Form, rotation(frame));
          }
        }
        form /= area;
        PointMeasure& measure = measures[i];
        measure.AxisAndArea << frame.U.cast<float>(), 0.0f;
        measure.Form.setZero();
        if (area > 0.0 && form.allFinite())
        {
          measure.AxisAndArea[3] = static_cast<float>(area * perSquare);
          measure.Form.head<3>() =
            Vector3d(0.5 * (form[0] + form[2]), 0.5 * (form[0] - form[2]), form[1]).cast<float>();
        }
      }
    });
  return measures;
}

//------------------------------------------------------------------------------
LinearForm MeasureFit::Fit(Index point, double radius, int rings)
{
  this->Around.Collect(point, radius, rings);
  const Vector3f normal = (*this->Points)[point].Normal.head<3>();
  const Vector3f u = MakeTangent(normal);
  const Vector3f v = normal.cross(u);
  const auto scale = static_cast<float>(1.0 / radius);
  const auto& members = this->Around.GetMembers();
  const auto size = static_cast<int>(members.size());
  Moments sums;
  for (int i = 0; i < size; i += NumberOfLanes)
  {
    // Where there are fewer than four left, the last one is taken again, without a weight.
    const int left = std::min(NumberOfLanes, size - i);
    const Neighbourhood::Member* const around[NumberOfLanes] = { &members[i],
      &members[i + std::min(1, left - 1)], &members[i + std::min(2, left - 1)],
      &members[i + left - 1] };
    const auto getMeasure = [&](int k) -> const PointMeasure&
    { return (*this->Measures)[around[k]->Point]; };
    const Transposed offset([&](int k) { return around[k]->Offset; });
    const Transposed other([&](int k) { return (*this->Points)[around[k]->Point].Normal; });
    const Transposed axis([&](int k) { return getMeasure(k).AxisAndArea; });
    const Transposed measure([&](int k) { return getMeasure(k).Form; });
    const Lanes distance(around[0]->SquaredDistance, around[1]->SquaredDistance,
      around[2]->SquaredDistance, around[3]->SquaredDistance);
    const Lanes turn(around[0]->Turn, around[1]->Turn, around[2]->Turn, around[3]->Turn);

    // The first axis of the member's frame, turned into the point's plane; the square of that as
    // a complex number turns the form.
    const Lanes along = axis.Dot(normal) / (1.0f + turn);
    const Lanes cosine = axis.Dot(u) - along * other.Dot(u);
    const Lanes sine = axis.Dot(v) - along * other.Dot(v);
    const Lanes twiceCosine = cosine * cosine - sine * sine;
    const Lanes twiceSine = 2.0f * cosine * sine;
    const Lanes form[3] = { measure[0], twiceCosine * measure[1] - twiceSine * measure[2],
      twiceSine * measure[1] + twiceCosine * measure[2] };
    // As far away in the plane as it is in space: nearer to its distance along the surface.
    const Lanes x = scale * offset.Dot(u);
    const Lanes y = scale * offset.Dot(v);
    constexpr float tiny = 1e-30f; // is nothing of a squared radius, and still has an inverse
    const Lanes stretch = (distance / (x * x + y * y).max(tiny)).sqrt();
    const Lanes weight = (1.0f - distance).square() * turn * axis[3] * Used[left];
    sums.Add(weight, stretch * x, stretch * y, form);
  }
  return sums.Solve(radius);
}
}
