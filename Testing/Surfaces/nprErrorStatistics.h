// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprErrorStatistics.h
 * @brief How far the arrays of vtkNPRCurvatureTensor are from the truth, over a whole surface.
 *
 * Who includes this links NPR::FiltersCurvature.
 */
#ifndef nprErrorStatistics_h
#define nprErrorStatistics_h

#include "nprAnalyticSurfaces.h"
#include "nprArrayNames.h"
#include "nprCurvatureDerivatives.h"
#include "nprPointValues.h"
#include "nprTriangleMesh.h"

#include <algorithm>
#include <limits>

namespace nprtest
{
/// Rms = sqrt(sum |estimate - truth|^2 / sum |truth|^2), Max = the largest |estimate - truth| over
/// the root mean square of the truth. NaN without the array or a point.
struct RelativeError
{
  double Rms = std::numeric_limits<double>::quiet_NaN();
  double Max = std::numeric_limits<double>::quiet_NaN();
};

struct ErrorStatistics
{
  /// Both principal curvatures together, each with the true one of its rank: where their magnitudes
  /// are near each other, which is the first is chance.
  RelativeError Principal;
  RelativeError Mean;
  RelativeError Gaussian;
  /// The second fundamental form as a tensor in space, with the normal's error in it.
  RelativeError Form;
  /// C over one frame, in the norm of its 8 components. Where it is zero everywhere, relative to
  /// the square of the curvature.
  RelativeError Cubic;
  /// Not relative: the angle, in radians.
  RelativeError Normal;
  /// Not relative: the angle between the lines of e1, in radians; only where |k1| and |k2| differ
  /// by a fifth of the first.
  RelativeError Direction;
  vtkIdType Points = 0;
  /// Points without an estimate; they count with the zeros that they have.
  vtkIdType Unknown = 0;
};

struct SurfaceStatistics
{
  ErrorStatistics All;
  /// Farther than two rings of triangles from a border.
  ErrorStatistics Interior;
  ErrorStatistics Border;
};

/// How many rings of triangles lie between a point and the border: 0 on it, at most `most`.
inline std::vector<int> CountRings(vtkPolyData* surface, int most)
{
  npr::TriangleMesh mesh(surface);
  mesh.BuildIncidence();
  std::vector<int> rings(mesh.GetNumberOfPoints(), most);
  for (npr::TriangleMesh::Index i = 0; i < mesh.GetNumberOfPoints(); ++i)
  {
    rings[i] = mesh.IsBorderPoint(i) ? 0 : most;
  }
  for (int ring = 1; ring < most; ++ring)
  {
    for (const auto& corners : mesh.GetTriangles())
    {
      const bool isNext = std::any_of(corners.begin(), corners.end(),
        [&](npr::TriangleMesh::Index i) { return rings[i] == ring - 1; });
      for (const npr::TriangleMesh::Index i : corners)
      {
        rings[i] = isNext ? std::min(rings[i], ring) : rings[i];
      }
    }
  }
  return rings;
}

/// The true principal curvatures, |K1| >= |K2|, and the first direction.
struct TruePrincipal
{
  double K1;
  double K2;
  Vector3d E1;
};

inline TruePrincipal GetPrincipal(const Truth& truth)
{
  const double mean = 0.5 * (truth.Form[0] + truth.Form[2]);
  const double half = 0.5 * (truth.Form[0] - truth.Form[2]);
  const double radius = std::hypot(half, truth.Form[1]);
  double angle = 0.5 * std::atan2(truth.Form[1], half);
  TruePrincipal principal = { mean + radius, mean - radius, {} };
  if (std::abs(principal.K1) < std::abs(principal.K2))
  {
    std::swap(principal.K1, principal.K2);
    angle += 0.5 * Pi;
  }
  principal.E1 = std::cos(angle) * truth.Frame.U + std::sin(angle) * truth.Frame.V;
  return principal;
}

/// The norm of a cubic form as a tensor with 8 components: it does not depend on the frame.
inline double GetCubicNorm(const Vector4d& c)
{
  return std::sqrt(c[0] * c[0] + 3.0 * (c[1] * c[1] + c[2] * c[2]) + c[3] * c[3]);
}

/// Adds up squares.
class ErrorSum
{
public:
  void Add(double error, double truth)
  {
    this->Errors += error * error;
    this->Truths += truth * truth;
    this->Largest = std::max(this->Largest, error);
    ++this->Count;
  }
  double GetTruth() const { return std::sqrt(this->Truths / std::max<vtkIdType>(this->Count, 1)); }
  /// Relative to the truth, or to the scale where all of the truth is zero.
  RelativeError Get(double scale = 1.0) const
  {
    RelativeError error;
    if (this->Count > 0)
    {
      const double truth = this->GetTruth();
      const double unit = truth > 1e-9 * scale ? truth : scale;
      error.Rms = std::sqrt(this->Errors / this->Count) / unit;
      error.Max = this->Largest / unit;
    }
    return error;
  }

private:
  double Errors = 0.0;
  double Truths = 0.0;
  double Largest = 0.0;
  vtkIdType Count = 0;
};

/// The errors at some points of a surface that has the point arrays of vtkNPRCurvatureTensor, or
/// some of them. Point i of the surface has the truth i.
inline ErrorStatistics MeasureErrors(vtkPolyData* surface, const std::vector<Truth>& truths,
  const std::function<bool(vtkIdType)>& isWanted)
{
  const auto has = [&](const char* name) { return surface->GetPointData()->HasArray(name) != 0; };
  const bool hasPrincipal =
    has(npr::names::PrincipalCurvature1) && has(npr::names::PrincipalCurvature2);
  const bool hasNormals = has(npr::names::Normals);
  const bool hasDirections = has(npr::names::PrincipalDirection1);
  ErrorSum principal, mean, gaussian, form, cubic, normal, direction;
  ErrorStatistics statistics;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    if (!isWanted(i))
    {
      continue;
    }
    ++statistics.Points;
    statistics.Unknown += GetValue(surface, npr::names::UnknownCurvature, i) != 0.0;
    const Truth& truth = truths[i];
    const TruePrincipal known = GetPrincipal(truth);
    if (hasPrincipal)
    {
      const double k1 = GetValue(surface, npr::names::PrincipalCurvature1, i);
      const double k2 = GetValue(surface, npr::names::PrincipalCurvature2, i);
      principal.Add(std::hypot(std::max(k1, k2) - std::max(known.K1, known.K2),
                      std::min(k1, k2) - std::min(known.K1, known.K2)),
        std::hypot(known.K1, known.K2));
    }
    if (has(npr::names::MeanCurvature))
    {
      const double h = 0.5 * (known.K1 + known.K2);
      mean.Add(std::abs(GetValue(surface, npr::names::MeanCurvature, i) - h), h);
    }
    if (has(npr::names::GaussianCurvature))
    {
      const double k = known.K1 * known.K2;
      gaussian.Add(std::abs(GetValue(surface, npr::names::GaussianCurvature, i) - k), k);
    }
    if (has(npr::names::CurvatureTensor))
    {
      // Off the diagonal a component stands for two.
      npr::SymmetricTensor error = GetTuple<6>(surface, npr::names::CurvatureTensor, i) -
        npr::FromFrame(truth.Form, truth.Frame);
      error.tail<3>() *= std::sqrt(2.0);
      form.Add(error.norm(), std::hypot(known.K1, known.K2));
    }
    const Vector3d n = GetTuple<3>(surface, npr::names::Normals, i);
    if (hasNormals)
    {
      normal.Add(std::atan2(n.cross(truth.Normal).norm(), n.dot(truth.Normal)), 1.0);
    }
    const Vector3d e1 = GetTuple<3>(surface, npr::names::PrincipalDirection1, i);
    if (hasDirections &&
      std::abs(std::abs(known.K1) - std::abs(known.K2)) > 0.2 * std::abs(known.K1))
    {
      direction.Add(std::atan2(e1.cross(known.E1).norm(), std::abs(e1.dot(known.E1))), 1.0);
    }
    if (has(npr::names::CurvatureDerivatives) && hasDirections && hasNormals)
    {
      Vector4d estimate = GetTuple<4>(surface, npr::names::CurvatureDerivatives, i);
      const npr::MinimalRotation rotation(n, truth.Normal);
      if (rotation.IsValid())
      {
        estimate =
          npr::ChangeFrame(estimate, rotation(npr::TangentFrame{ e1, n.cross(e1) }), truth.Frame);
      }
      cubic.Add(GetCubicNorm(estimate - truth.Cubic), GetCubicNorm(truth.Cubic));
    }
  }
  const double curvature = hasPrincipal ? principal.GetTruth() : form.GetTruth();
  statistics.Principal = principal.Get(curvature);
  statistics.Mean = mean.Get(curvature);
  statistics.Gaussian = gaussian.Get(curvature * curvature);
  statistics.Form = form.Get(curvature);
  statistics.Cubic = cubic.Get(curvature * curvature);
  statistics.Normal = normal.Get();
  statistics.Direction = direction.Get();
  return statistics;
}

/// The same for all points, and for those inside and near the border apart.
inline SurfaceStatistics MeasureSurface(vtkPolyData* surface, const std::vector<Truth>& truths)
{
  const std::vector<int> rings = CountRings(surface, 3);
  return { MeasureErrors(surface, truths, [](vtkIdType) { return true; }),
    MeasureErrors(surface, truths, [&](vtkIdType i) { return rings[i] == 3; }),
    MeasureErrors(surface, truths, [&](vtkIdType i) { return rings[i] < 3; }) };
}
}

#endif
