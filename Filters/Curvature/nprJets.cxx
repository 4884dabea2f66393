// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprJets.h"

#include "nprFaceCurvature.h"
#include "nprJetFit.h"
#include "nprOrderedMesh.h"

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

/// The automatic radius on clean meshes, in edges: it holds about twice the points that a
/// polynomial of degree 4 has coefficients.
constexpr double BaseRadius = 2.75;

/// See ChooseRadius(); measured on a noisy torus of 3,000 to 200,000 triangles.
constexpr double Balance = 1300.0;

/// In edges: what is below is the rounding of single precision. On surfaces that are mostly flat it
/// would be all there is, and the bends that matter be lost in the greatest neighbourhood.
constexpr double LeastNoise = 1e-5;

/// Where the choice ends, in edges: at some 2500 points for each fit. What lies to one side of its
/// neighbourhood, at a border, may still look farther.
constexpr double GreatestChoice = 28.0;

/// From how far out, in radii, the points' centre of gravity tells of a border; and how fast the
/// radius grows from there, so that half a neighbourhood holds about as many points as a whole one.
constexpr double LeastOneSided = 0.1;
constexpr double BorderGrowth = 2.0;

/// How many points a stable fit wants.
int GetWantedPoints(int degree)
{
  return CountCoefficients(degree) + 9;
}

/// What one thread fits with.
class Fitter
{
public:
  Fitter() = default;
  Fitter(const PointGraph& graph, const std::vector<OrientedPoint>& points)
    : Points(&points), Around(graph, points)
  {
  }

  /// The jet at a point, in units of the radius, which may be made larger. False if there is none.
  bool FitPoint(
    Index point, int degree, double& radius, double greatest, int rings, SurfaceJet& result)
  {
    if (!(radius > 0.0) || !std::isfinite(radius))
    {
      return false;
    }
    // Of all weights that fade to nothing this one lets least noise through (Epanechnikov).
    const auto weight = [](const Lanes& s, const Lanes& turn) { return Lanes(turn * (1.0 - s)); };
    int usable = 0;
    for (bool widened = false;; widened = true)
    {
      this->Around.Collect(point, radius, rings);
      double growth = 1.4;
      if (this->CountPoints() >= GetWantedPoints(degree))
      {
        const double oneSided = this->Gather(point, radius, weight);
        if (widened || oneSided < LeastOneSided)
        {
          usable = this->Fit.Solve(degree, this->Jet);
        }
        else
        {
          growth = 1.0 + BorderGrowth * (oneSided - LeastOneSided);
        }
      }
      if (usable == degree || radius >= greatest)
      {
        break;
      }
      radius = std::min(greatest, growth * radius);
    }
    if (usable < 2)
    {
      this->Gather(point, radius,
        [](const Lanes& s, const Lanes& turn) { return Lanes(turn * (1.0 - 0.9 * s)); });
      usable = this->Fit.Solve(degree, this->Jet);
    }
    if (usable < 2)
    {
      return false;
    }
    result = Differentiate(this->Jet, this->Frame, this->Normal);
    return result.Normal.allFinite() && result.Form.allFinite() && result.Cubic.allFinite();
  }

  /// The standard deviation of the points from the best polynomial of degree 4, and the greater
  /// curvature there, in units of the radius. False where there are too few points to tell.
  bool MeasureNoise(Index point, double radius, int rings, double& noise, double& curvature)
  {
    this->Around.Collect(point, radius, rings);
    // All alike: what is left over is then known to be the noise times what the fit leaves free.
    this->Gather(point, radius, [](const Lanes&, const Lanes&) { return Lanes(Lanes::Ones()); });
    const int freedom = this->CountPoints() - CountCoefficients(4);
    if (freedom < 5 || this->Fit.Solve(4, this->Jet) < 4)
    {
      return false;
    }
    noise = std::sqrt(this->Fit.GetResidual(this->Jet) / freedom);
    const SurfaceJet surface = Differentiate(this->Jet, this->Frame, this->Normal);
    const Vector3d& form = surface.Form;
    curvature = std::sqrt(form[0] * form[0] + 2.0 * form[1] * form[1] + form[2] * form[2]);
    return std::isfinite(noise) && std::isfinite(curvature);
  }

private:
  using Lanes = JetFit::Lanes;

  int CountPoints() const { return static_cast<int>(this->Around.GetMembers().size()); }

  /// How far the points lie to one side, in radii: about 0 inside, 0.3 at a straight border.
  template<typename Weight>
  double Gather(Index point, double radius, const Weight& weight)
  {
    this->Normal = (*this->Points)[point].Normal.head<3>().cast<double>();
    this->Frame = MakeTangentFrame(this->Normal);
    // In units of the radius.
    const Vector3d toX = this->Frame.U / radius;
    const Vector3d toY = this->Frame.V / radius;
    const Vector3d toZ = this->Normal / radius;
    const Lanes used[2] = { Lanes(1.0, 0.0), Lanes(1.0, 1.0) };
    Lanes sumX = Lanes::Zero();
    Lanes sumY = Lanes::Zero();
    Lanes sum = Lanes::Zero();
    const auto& members = this->Around.GetMembers();
    this->Fit.Start((members.size() + 1) / 2);
    for (std::size_t i = 0; i < members.size(); i += 2)
    {
      const bool isPair = i + 1 < members.size();
      const Neighbourhood::Member& a = members[i];
      const Neighbourhood::Member& b = members[i + isPair];
      const Lanes offset[3] = { Lanes(a.Offset[0], b.Offset[0]), Lanes(a.Offset[1], b.Offset[1]),
        Lanes(a.Offset[2], b.Offset[2]) };
      const auto along = [&offset](const Vector3d& axis)
      { return Lanes(offset[0] * axis[0] + offset[1] * axis[1] + offset[2] * axis[2]); };
      const Lanes x = along(toX);
      const Lanes y = along(toY);
      const Lanes w =
        weight(Lanes(a.SquaredDistance, b.SquaredDistance), Lanes(a.Turn, b.Turn)) * used[isPair];
      this->Fit.Set(i / 2, x, y, along(toZ), w);
      sumX += w * x;
      sumY += w * y;
      sum += w;
    }
    return std::hypot(sumX.sum(), sumY.sum()) / sum.sum();
  }

  const std::vector<OrientedPoint>* Points = nullptr;
  Neighbourhood Around;
  JetFit Fit;
  JetCoefficients Jet;
  Vector3d Normal;
  TangentFrame Frame;
};

//------------------------------------------------------------------------------
double Median(std::vector<double>& values)
{
  const auto middle = values.begin() + values.size() / 2;
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

//------------------------------------------------------------------------------
/// How many edges the radius must have so that noise and bias are in balance.
double ChooseRadius(const PointGraph& graph, const std::vector<OrientedPoint>& points,
  const std::vector<float>& edges)
{
  constexpr Index wanted = 1500;
  std::vector<Index> sample;
  const auto size = static_cast<Index>(points.size());
  for (Index i = 0; i < wanted; ++i)
  {
    const auto point =
      static_cast<Index>((2 * static_cast<std::int64_t>(i) + 1) * size / (2 * wanted));
    if (edges[point] > 0.0f && (sample.empty() || sample.back() != point))
    {
      sample.push_back(point);
    }
  }
  // Of each: noise in edges, edges in radii of curvature; negative where there is nothing to say.
  std::vector<double> noises(sample.size(), -1.0);
  std::vector<double> bends(sample.size(), -1.0);
  vtkSMPTools::For(0, static_cast<vtkIdType>(sample.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      Fitter fitter(graph, points);
      for (vtkIdType i = begin; i < end; ++i)
      {
        double noise;
        double curvature;
        if (fitter.MeasureNoise(sample[i], BaseRadius * edges[sample[i]],
              Neighbourhood::GetRings(BaseRadius), noise, curvature))
        {
          noises[i] = noise * BaseRadius;
          bends[i] = curvature / BaseRadius;
        }
      }
    });
  for (auto* values : { &noises, &bends })
  {
    values->erase(std::remove(values->begin(), values->end(), -1.0), values->end());
  }
  if (noises.empty())
  {
    return BaseRadius;
  }
  const double noise = Median(noises);
  if (noise < LeastNoise)
  {
    return BaseRadius;
  }
  const double bend = Median(bends);
  // The derivative's error is about noise * edge / r^4 from noise, and r^2 / feature^4 from bias.
  const double radius = std::pow(Balance * noise / std::pow(bend, 4), 1.0 / 6.0);
  return std::isfinite(radius) ? std::clamp(radius, BaseRadius, GreatestChoice) : BaseRadius;
}

//------------------------------------------------------------------------------
/// What the triangles say, where nothing is known.
void FillFromFaces(
  const TriangleMesh& mesh, const Tuples<3>& normals, bool derivatives, CurvatureEstimate& estimate)
{
  std::vector<Index> unknown;
  for (Index i = 0; i < mesh.GetNumberOfPoints(); ++i)
  {
    if (estimate.Unknown[i])
    {
      unknown.push_back(i);
    }
  }
  if (unknown.empty())
  {
    return;
  }
  const CurvatureEstimate rest = FaceCurvature().EstimateAt(unknown, mesh, normals, derivatives);
  for (std::size_t i = 0; i < unknown.size(); ++i)
  {
    estimate.Tensors[unknown[i]] = rest.Tensors[i];
    if (derivatives)
    {
      estimate.Derivatives[unknown[i]] = rest.Derivatives[i];
    }
    estimate.Unknown[unknown[i]] = rest.Unknown[i];
  }
}
}

//------------------------------------------------------------------------------
int Jets::GetReach() const
{
  // One more ring for the edges' lengths, one for the normals.
  const double chosen = this->Fit.Radius > 0.0 ? this->Fit.Radius : GreatestChoice;
  return Neighbourhood::GetRings(this->Fit.Length > 0.0 ? GreatestRadius : chosen) + 2;
}

//------------------------------------------------------------------------------
CurvatureEstimate Jets::Estimate(const TriangleMesh& given, const Tuples<3>& givenNormals,
  bool derivatives, const Progress& progress) const
{
  CurvatureEstimate estimate;
  estimate.Normals = givenNormals;
  if (!progress(0.0))
  {
    return estimate;
  }
  const OrderedMesh ordered(given, givenNormals);
  const TriangleMesh& mesh = ordered.Mesh;
  const PointGraph graph(mesh);
  const std::vector<OrientedPoint> points = MakeOrientedPoints(mesh, ordered.Normals);
  const std::vector<float> edges = ComputeMeanEdges(mesh, graph);
  double edgeRadius = 0.0;
  if (this->Fit.Length <= 0.0)
  {
    edgeRadius = this->Fit.Radius > 0.0 ? Neighbourhood::ClampRadius(this->Fit.Radius)
                                        : ChooseRadius(graph, points, edges);
  }
  estimate.Radius = edgeRadius;
  const Index size = mesh.GetNumberOfPoints();
  estimate.Tensors.assign(size, SymmetricTensor::Zero().cast<float>());
  estimate.Derivatives.assign(derivatives ? size : 0, Eigen::Vector4f::Zero());
  estimate.Unknown.assign(size, 0);
  const int rings = this->GetReach() - 2;
  vtkSMPThreadLocal<Fitter> fitters(Fitter(graph, points));
  const bool done = ForWithProgress(size, PartOf(progress, 0.1, 1.0),
    [&](vtkIdType begin, vtkIdType end)
    {
      Fitter& fitter = fitters.Local();
      for (vtkIdType i = begin; i < end; ++i)
      {
        const vtkIdType point = ordered.Points[i];
        const double edge = edges[i];
        double radius = this->Fit.Length > 0.0 ? this->Fit.Length : edgeRadius * edge;
        radius = std::clamp(radius, LeastRadius * edge, GreatestRadius * edge);
        SurfaceJet jet;
        if (!fitter.FitPoint(static_cast<Index>(i), this->Fit.Degree, radius,
              std::min(3.0 * radius, GreatestRadius * edge), rings, jet))
        {
          estimate.Unknown[point] = 1;
          continue;
        }
        estimate.Normals[point] = jet.Normal.cast<float>();
        estimate.Tensors[point] =
          (FromFrame(jet.Form, MakeTangentFrame(jet.Normal)) / radius).cast<float>();
        if (derivatives)
        {
          estimate.Derivatives[point] = (jet.Cubic / (radius * radius)).cast<float>();
        }
      }
    });
  if (done)
  {
    FillFromFaces(given, givenNormals, derivatives, estimate);
  }
  return estimate;
}
}
