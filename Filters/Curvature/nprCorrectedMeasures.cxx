// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprCorrectedMeasures.h"

#include "nprNeighbourhood.h"
#include "nprPointMeasures.h"
#include "nprTangentFrame.h"

#include <vtkSMPThreadLocal.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <cmath>

namespace npr
{
namespace
{
using Index = TriangleMesh::Index;
using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr double LeastRadius = Neighbourhood::LeastRadius;
constexpr double GreatestRadius = Neighbourhood::GreatestRadius;

/// In mean edges: of the first round, which need only be good enough to correct the normals.
constexpr double FirstRadius = 2.5;
/// In mean edges: the least and the greatest that is chosen for a surface without noise.
constexpr double CleanRadius[2] = { 3.0, 5.0 };

Tuples<6>::value_type ToTensor(const LinearForm& form, const Vector3f& normal)
{
  return FromFrame(form.Form.cast<double>(), MakeTangentFrame(normal.cast<double>())).cast<float>();
}

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
    vtkSMPThreadLocal<MeasureFit> fits(MeasureFit(graph, points, measures));
    return ForWithProgress(size, part,
      [&](vtkIdType begin, vtkIdType end)
      {
        MeasureFit& fitting = fits.Local();
        for (vtkIdType i = begin; i < end; ++i)
        {
          const Index point = static_cast<Index>(i);
          const double radius = getRadius(static_cast<double>(edges[i]));
          forms[i] = radius > 0.0 && std::isfinite(radius) ? fitting.Fit(point, radius, rings)
                                                           : LinearForm();
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
