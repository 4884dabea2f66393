// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprCorrectedMeasures.h"

#include "nprNeighbourhood.h"
#include "nprTangentFrame.h"

#include <vtkSMPThreadLocal.h>
#include <vtkSMPTools.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace npr
{
namespace
{
using Index = TriangleMesh::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr double LeastRadius = Neighbourhood::LeastRadius;
constexpr double GreatestRadius = Neighbourhood::GreatestRadius;

/// In mean edges: of the first round, which need only be good enough to correct the normals.
constexpr double FirstRadius = 2.5;
/// In mean edges: the least and the greatest that is chosen for a surface without noise.
constexpr double CleanRadius[2] = { 3.0, 5.0 };

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

/// What is collected at a point, and what else its neighbours need of it. The form is the mean over
/// the area, and refers to MakeTangentFrame(Normal): a multiple of the identity and a part that
/// turns by twice the angle.
struct PointMeasure
{
  Vector3f Normal;
  Vector3f Axis; // first of the frame
  float Area = 0.0f;
  float Mean = 0.0f;
  float Difference = 0.0f; // (UU - VV) / 2
  float Mixed = 0.0f;      // UV
};

//------------------------------------------------------------------------------
std::vector<PointMeasure> MeasurePoints(const TriangleMesh& mesh, const Tuples<3>& normals)
{
  std::vector<PointMeasure> measures(mesh.GetNumberOfPoints());
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
        measure.Normal = normals[i];
        measure.Axis = frame.U.cast<float>();
        if (area > 0.0 && form.allFinite())
        {
          measure.Area = static_cast<float>(area / 3.0);
          measure.Mean = static_cast<float>(0.5 * (form[0] + form[2]));
          measure.Difference = static_cast<float>(0.5 * (form[0] - form[2]));
          measure.Mixed = static_cast<float>(form[1]);
        }
      }
    });
  return measures;
}

/// The form at a point and its derivative, over MakeTangentFrame(normal).
struct LinearForm
{
  Eigen::Vector3f Form = Eigen::Vector3f::Zero();
  Eigen::Vector4f Cubic = Eigen::Vector4f::Zero();
  bool IsKnown = false;
};

Tuples<6>::value_type ToTensor(const LinearForm& form, const Vector3f& normal)
{
  return FromFrame(form.Form.cast<double>(), MakeTangentFrame(normal.cast<double>())).cast<float>();
}

/// The sums that a linear function is fitted from; lengths in units of the radius.
class Moments
{
public:
  void Add(double weight, double x, double y, const double form[3])
  {
    const double wx = weight * x;
    const double wy = weight * y;
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
    const double sum = this->Plain[0];
    if (!(sum > 0.0))
    {
      return result;
    }
    const double* const m = this->Plain;
    Matrix3d matrix;
    matrix << m[0], m[1], m[2], m[1], m[3], m[4], m[2], m[4], m[5];
    matrix /= sum;
    // Rows: value, d/dx, d/dy; columns: the parts of the form.
    Matrix3d solution = Eigen::Map<const Matrix3d>(this->WithForm) / sum;
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
  double Plain[6] = {};    // w, w x, w y, w xx, w xy, w yy
  double WithForm[9] = {}; // w, w x, w y times each part of the form
};

/// The measures as they are around a point.
class Fitter
{
public:
  Fitter() = default;
  Fitter(const PointGraph& graph, const std::vector<OrientedPoint>& points,
    const std::vector<PointMeasure>& measures)
    : Measures(&measures), Around(graph, points)
  {
  }

  LinearForm Fit(Index point, double radius, int rings)
  {
    this->Around.Collect(point, radius, rings);
    const Vector3f normal = (*this->Measures)[point].Normal;
    const TangentFrame frame = MakeTangentFrame(normal.cast<double>());
    const Vector3f u = frame.U.cast<float>();
    const Vector3f v = frame.V.cast<float>();
    Moments sums;
    const double scale = 1.0 / radius;
    for (const Neighbourhood::Member& member : this->Around.GetMembers())
    {
      const PointMeasure& measure = (*this->Measures)[member.Point];
      // The first axis of the member's frame, turned into the point's plane; the square of that as
      // a complex number turns the form.
      const float along = measure.Axis.dot(normal) / (1.0f + member.Turn);
      const float cosine = measure.Axis.dot(u) - along * measure.Normal.dot(u);
      const float sine = measure.Axis.dot(v) - along * measure.Normal.dot(v);
      const float twiceCosine = cosine * cosine - sine * sine;
      const float twiceSine = 2.0f * cosine * sine;
      const double form[3] = { measure.Mean,
        twiceCosine * measure.Difference - twiceSine * measure.Mixed,
        twiceSine * measure.Difference + twiceCosine * measure.Mixed };
      // As far away in the plane as it is in space: nearer to its distance along the surface.
      const double distance = member.SquaredDistance;
      const Vector3d offset = scale * member.Offset.head<3>().cast<double>();
      double x = offset.dot(frame.U);
      double y = offset.dot(frame.V);
      const double flat = x * x + y * y;
      const double stretch = flat > 0.0 ? std::sqrt(distance / flat) : 0.0;
      x *= stretch;
      y *= stretch;
      sums.Add((1.0 - distance) * (1.0 - distance) * member.Turn * measure.Area, x, y, form);
    }
    return sums.Solve(radius);
  }

private:
  const std::vector<PointMeasure>* Measures = nullptr;
  Neighbourhood Around;
};

//------------------------------------------------------------------------------
double Median(std::vector<float>& values)
{
  if (values.empty())
  {
    return 0.0;
  }
  const auto middle = values.begin() + values.size() / 2;
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Normals that fit the edges, and what that says about the surface.
struct FittedNormals
{
  Tuples<3> Normals;
  /// Of the points, in mean edges: standard deviation across the surface.
  double Noise = 0.0;
  /// The curvature times the mean edge.
  double Bend = 0.0;
};

//------------------------------------------------------------------------------
/// Along an edge e from a point with the normal n, the form changing linearly from one end (0) to
/// the other (1), a surface falls by -n.e = (2 II0(e, e) + II1(e, e)) / 6.
FittedNormals FitNormals(const TriangleMesh& mesh, const PointGraph& graph,
  const std::vector<float>& edges, const Tuples<3>& normals, const std::vector<LinearForm>& forms)
{
  const Index size = mesh.GetNumberOfPoints();
  FittedNormals fitted;
  fitted.Normals = normals;
  Tuples<6> tensors(size);
  vtkSMPTools::For(0, size,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        tensors[i] = ToTensor(forms[i], normals[i]);
      }
    });
  std::vector<float> noises(size, -1.0f);
  std::vector<float> bends(size, -1.0f);
  vtkSMPTools::For(0, size,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const Index point = static_cast<Index>(i);
        const Vector3d normal = normals[i].cast<double>();
        const TangentFrame frame = MakeTangentFrame(normal);
        const Vector3d p = mesh.GetPoint(point).cast<double>();
        double uu = 0.0;
        double uv = 0.0;
        double vv = 0.0;
        double ru = 0.0;
        double rv = 0.0;
        double rr = 0.0;
        int count = 0;
        for (const Index* other = graph.Begin(point); other != graph.End(point); ++other)
        {
          Vector3d edge = mesh.GetPoint(*other).cast<double>() - p;
          const double length = edge.norm();
          if (!forms[*other].IsKnown || !(length > 0.0))
          {
            continue;
          }
          edge /= length;
          const SymmetricTensor tensor =
            (2.0 * tensors[i].cast<double>() + tensors[*other].cast<double>()) / 6.0;
          const double residual = edge.dot(normal) + length * Evaluate(tensor, edge, edge);
          const double x = edge.dot(frame.U);
          const double y = edge.dot(frame.V);
          uu += x * x;
          uv += x * y;
          vv += y * y;
          ru -= residual * x;
          rv -= residual * y;
          rr += residual * residual;
          ++count;
        }
        const double determinant = uu * vv - uv * uv;
        if (!forms[i].IsKnown || !(determinant > 0.01 * (uu + vv) * (uu + vv)))
        {
          continue;
        }
        const double du = (vv * ru - uv * rv) / determinant;
        const double dv = (uu * rv - uv * ru) / determinant;
        // A turn by more than 45 degrees is not a correction but a misfit (noise, a fold).
        if (du * du + dv * dv < 1.0)
        {
          fitted.Normals[i] = (normal + du * frame.U + dv * frame.V).normalized().cast<float>();
        }
        if (count > 3)
        {
          // Both ends of an edge are noisy.
          noises[i] = static_cast<float>(
            std::sqrt(std::max(0.0, rr - du * ru - dv * rv) / (2.0 * (count - 2))));
          const Eigen::Vector3f& form = forms[i].Form;
          bends[i] =
            edges[i] * std::sqrt(form[0] * form[0] + 2.0f * form[1] * form[1] + form[2] * form[2]);
        }
      }
    });
  for (auto* values : { &noises, &bends })
  {
    values->erase(std::remove(values->begin(), values->end(), -1.0f), values->end());
  }
  fitted.Noise = Median(noises);
  fitted.Bend = Median(bends);
  return fitted;
}

//------------------------------------------------------------------------------
/// The radius r in edges h. Noise leaves noise / (h r^2) in the form, its change within the radius
/// curvature^3 (h r)^2: they are in balance at the fourth root of noise / (h curvature)^3. Without
/// noise it is the mesh's irregularity that is left over, and falls if the radius falls slower than
/// the edges. Both factors are measured, between the best for curvature and for its derivatives.
double ChooseRadius(double noise, double bend)
{
  // Each triangle around costs more than a point does a jet.
  constexpr double greatest = 14.0;
  // What is below is the rounding of single precision.
  constexpr double leastNoise = 1e-5;
  const double noisy = noise < leastNoise ? 0.0 : 3.0 * std::pow(noise / std::pow(bend, 3), 0.25);
  const double clean = std::clamp(2.0 * std::pow(bend, -0.25), CleanRadius[0], CleanRadius[1]);
  return std::min(std::max(clean, noisy), greatest);
}
}

//------------------------------------------------------------------------------
int CorrectedMeasures::GetReach() const
{
  const bool open = this->Wanted.Radius <= 0.0 || this->Wanted.Length > 0.0;
  // Besides both rounds, one ring for the edges' lengths, one for each round's measures, one for
  // the normals' fit and one for the normals.
  return Neighbourhood::GetRings(FirstRadius) +
    Neighbourhood::GetRings(open ? GreatestRadius : this->Wanted.Radius) + 5;
}

//------------------------------------------------------------------------------
CurvatureEstimate CorrectedMeasures::Estimate(const TriangleMesh& mesh, const Tuples<3>& normals,
  bool derivatives, const Progress& progress) const
{
  CurvatureEstimate estimate;
  estimate.Normals = normals;
  if (!progress(0.0))
  {
    return estimate;
  }
  const Index size = mesh.GetNumberOfPoints();
  const PointGraph graph(mesh);
  const std::vector<float> edges = ComputeMeanEdges(mesh, graph);
  std::vector<LinearForm> forms(size);
  const auto fit = [&](const auto& getRadius, int rings, const Progress& part)
  {
    const std::vector<PointMeasure> measures = MeasurePoints(mesh, estimate.Normals);
    const std::vector<OrientedPoint> points = MakeOrientedPoints(mesh, estimate.Normals);
    vtkSMPThreadLocal<Fitter> fitters(Fitter(graph, points, measures));
    return ForWithProgress(size, part,
      [&](vtkIdType begin, vtkIdType end)
      {
        Fitter& fitter = fitters.Local();
        for (vtkIdType i = begin; i < end; ++i)
        {
          const Index point = static_cast<Index>(i);
          const double radius = getRadius(static_cast<double>(edges[i]));
          forms[i] =
            radius > 0.0 && std::isfinite(radius) ? fitter.Fit(point, radius, rings) : LinearForm();
        }
      });
  };
  if (!fit([](double edge) { return FirstRadius * edge; }, Neighbourhood::GetRings(FirstRadius),
        PartOf(progress, 0.05, 0.3)))
  {
    return estimate;
  }
  FittedNormals fitted = FitNormals(mesh, graph, edges, estimate.Normals, forms);
  estimate.Normals = std::move(fitted.Normals);
  double wanted = this->Wanted.Radius;
  if (this->Wanted.Length <= 0.0)
  {
    wanted =
      wanted > 0.0 ? Neighbourhood::ClampRadius(wanted) : ChooseRadius(fitted.Noise, fitted.Bend);
    estimate.Radius = wanted;
  }
  const auto getRadius = [&](double edge)
  {
    return this->Wanted.Length > 0.0
      ? std::clamp(this->Wanted.Length, LeastRadius * edge, GreatestRadius * edge)
      : wanted * edge;
  };
  if (!fit(getRadius, Neighbourhood::GetRings(this->Wanted.Length > 0.0 ? GreatestRadius : wanted),
        PartOf(progress, 0.35, 1.0)))
  {
    return estimate;
  }
  estimate.Tensors.resize(size);
  estimate.Derivatives.resize(derivatives ? size : 0);
  estimate.Unknown.resize(size);
  vtkSMPTools::For(0, size,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        estimate.Unknown[i] = !forms[i].IsKnown;
        estimate.Tensors[i] = ToTensor(forms[i], estimate.Normals[i]);
        if (derivatives)
        {
          estimate.Derivatives[i] = forms[i].Cubic;
        }
      }
    });
  return estimate;
}
}
