// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprDerivativeDoubt.h"

#include "nprCurvatureDerivatives.h"
#include "nprForAll.h"
#include "nprPlaneFacets.h"
#include "nprRingMeans.h"
#include "nprTangentFrame.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

namespace npr
{
namespace
{
using Index = TriangleMesh::Index;
using Eigen::Vector3d;
using Eigen::Vector4d;

constexpr int ThinnessRings = 3;
constexpr double ThinnessLimit = 4.2;
constexpr double StepLimit = 20.0; // with the square of the thinness
constexpr double LeastFacets = 0.35;
constexpr double AllFacets = 0.5;
constexpr double DoubtOfFacets = 4.0;
constexpr double UnexplainedLimit = 0.35;
constexpr double NoDoubt = 0.8; // below this what is unexplained is of no matter
constexpr double LargestDoubt = 10.0;

/// C(edge, ., .), as the components UU, UV, VV.
Vector3d Contract(const Vector4d& cubic, const TangentFrame& frame, const Vector3d& edge)
{
  const double u = edge.dot(frame.U);
  const double v = edge.dot(frame.V);
  return { cubic[0] * u + cubic[1] * v, cubic[1] * u + cubic[2] * v, cubic[2] * u + cubic[3] * v };
}

double GetSquare(const Vector3d& form)
{
  return form[0] * form[0] + 2.0 * form[1] * form[1] + form[2] * form[2];
}

class DoubtMeter
{
public:
  DoubtMeter(const TriangleMesh& mesh, const Tuples<3>& normals, const Tuples<6>& tensors,
    const Tuples<4>& cubics)
    : Mesh(mesh), Normals(normals), Tensors(tensors), Cubics(cubics), Thinness(normals.size()),
      Facets(MeasurePlaneFacets(mesh))
  {
    ForAll(
      this->Thinness.size(), [this](Index i) { this->Thinness[i] = this->MeasureThinness(i); });
    AverageOverRings(mesh, ThinnessRings, this->Thinness);
  }

  double Measure(Index point) const
  {
    const TangentFrame frame = MakeTangentFrame(this->Normals[point].cast<double>());
    const double thinness = this->Thinness[point];
    const double facets =
      std::clamp((this->Facets[point] - LeastFacets) / (AllFacets - LeastFacets), 0.0, 1.0);
    const double doubt = std::max({ thinness / ThinnessLimit,
      thinness * thinness * this->GetStep(point, frame) / StepLimit, facets * DoubtOfFacets });
    return doubt > NoDoubt
      ? doubt * std::min(1.0, this->GetUnexplained(point, frame) / UnexplainedLimit)
      : doubt;
  }

private:
  std::array<Index, 2> GetOthers(Index triangle, Index point) const
  {
    const TriangleMesh::Triangle& c = this->Mesh.GetTriangle(triangle);
    return c[0] == point ? std::array<Index, 2>{ c[1], c[2] }
      : c[1] == point    ? std::array<Index, 2>{ c[2], c[0] }
                         : std::array<Index, 2>{ c[0], c[1] };
  }

  Vector3d GetEdge(Index from, Index to) const
  {
    return (this->Mesh.GetPoint(to) - this->Mesh.GetPoint(from)).cast<double>();
  }

  /// Two sides of a triangle, from one of its corners.
  struct Corner
  {
    Vector3d A;
    Vector3d B;
    double DoubleArea;
  };
  Corner GetCorner(Index triangle, Index point) const
  {
    const std::array<Index, 2> others = this->GetOthers(triangle, point);
    const Vector3d a = this->GetEdge(point, others[0]);
    const Vector3d b = this->GetEdge(point, others[1]);
    return { a, b, a.cross(b).norm() };
  }

  /// Of the triangles at a point, by their areas. 0 without area.
  float MeasureThinness(Index point) const
  {
    double areas = 0.0;
    double squares = 0.0;
    for (const Index* t = this->Mesh.IncidentBegin(point); t != this->Mesh.IncidentEnd(point); ++t)
    {
      const Corner corner = this->GetCorner(*t, point);
      areas += corner.DoubleArea;
      squares += std::max(
        { corner.A.squaredNorm(), corner.B.squaredNorm(), (corner.B - corner.A).squaredNorm() });
    }
    return areas > 0.0 ? static_cast<float>(squares / areas) : 0.0f;
  }

  double GetStep(Index point, const TangentFrame& frame) const
  {
    const Vector4d cubic = this->Cubics[point].cast<double>();
    double areas = 0.0;
    double steps = 0.0;
    for (const Index* t = this->Mesh.IncidentBegin(point); t != this->Mesh.IncidentEnd(point); ++t)
    {
      const Corner corner = this->GetCorner(*t, point);
      areas += corner.DoubleArea;
      steps += corner.DoubleArea *
        std::sqrt(std::max(GetSquare(Contract(cubic, frame, corner.A)) * corner.A.squaredNorm(),
          GetSquare(Contract(cubic, frame, corner.B)) * corner.B.squaredNorm()));
    }
    return areas > 0.0 ? steps / areas : 0.0;
  }

  /// From 0, where C explains all that differs at the neighbours, to 1 and more.
  double GetUnexplained(Index point, const TangentFrame& frame) const
  {
    const Vector3d normal = this->Normals[point].cast<double>();
    const Vector3d form = ToFrame(this->Tensors[point].cast<double>(), frame);
    const Vector4d cubic = this->Cubics[point].cast<double>();
    double unexplained = 0.0;
    double all = 0.0;
    for (const Index* t = this->Mesh.IncidentBegin(point); t != this->Mesh.IncidentEnd(point); ++t)
    {
      for (const Index other : this->GetOthers(*t, point))
      {
        const Vector3d there = this->Normals[other].cast<double>();
        const MinimalRotation rotation(normal, there);
        if (!rotation.IsValid())
        {
          continue;
        }
        const TangentFrame turned = rotation(frame);
        const Vector3d change = ToFrame(this->Tensors[other].cast<double>(), turned) - form;
        const Vector4d otherCubic =
          ChangeFrame(this->Cubics[other].cast<double>(), MakeTangentFrame(there), turned);
        const Vector3d explained =
          Contract(0.5 * (cubic + otherCubic), frame, this->GetEdge(point, other));
        unexplained += GetSquare(change - explained);
        all += GetSquare(change) + GetSquare(explained);
      }
    }
    return all > 0.0 ? std::sqrt(unexplained / all) : 0.0;
  }

  const TriangleMesh& Mesh;
  const Tuples<3>& Normals;
  const Tuples<6>& Tensors;
  const Tuples<4>& Cubics;
  std::vector<float> Thinness;
  std::vector<float> Facets;
};
}

//------------------------------------------------------------------------------
std::vector<float> ComputeDerivativeDoubt(const TriangleMesh& mesh, const Tuples<3>& normals,
  const Tuples<6>& tensors, const Tuples<4>& cubics)
{
  std::vector<float> doubts(normals.size());
  const DoubtMeter meter(mesh, normals, tensors, cubics);
  ForAll(doubts.size(),
    [&](Index i)
    {
      // In this order what is not a number becomes the largest.
      const double doubt = meter.Measure(i);
      doubts[i] = static_cast<float>(doubt < LargestDoubt ? doubt : LargestDoubt);
    });
  return doubts;
}
}
