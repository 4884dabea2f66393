// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprSurfaceDiffusion.h"

#include "nprCurvature.h"
#include "nprCurvatureDerivatives.h"

#include <vtkSMPTools.h>

#include <algorithm>
#include <cmath>

namespace npr
{
namespace
{
using Index = TriangleMesh::Index;
using Eigen::Vector3d;

/// Of evaluations of the Laplacian: more would take minutes on large scans. The documentation of
/// the filters says that it ends here.
constexpr int MaximumNumberOfSteps = 1000;

/// An explicit step is stable up to 1; above it a point would overshoot its neighbours.
constexpr double LargestStep = 0.8;

/// Into how many parts a long time is cut, so that the long steps follow the heat equation: what is
/// 1/e after the whole time is then wrong by 4 %.
constexpr int NumberOfParts = 8;

/// Of half a sum of two cotangents: a triangle's angle of 135 degrees on both sides has -1.
constexpr double MostNegativeWeight = -0.5;
/// Two angles of 11 degrees have as much. The ends of a short edge are in balance with each other
/// long before it matters; with more weight they would be held back from all others, too.
constexpr double LargestWeight = 5.0;

/// What the operator of std::complex does, without its care for infinities, which costs a call.
std::complex<float> Multiply(std::complex<float> a, std::complex<float> b)
{
  return { a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real() };
}

std::complex<float> Turn(std::complex<float> value, std::complex<float> turning, int spin)
{
  for (int i = 0; i < spin; ++i)
  {
    value = Multiply(value, turning);
  }
  return value;
}
}

//------------------------------------------------------------------------------
SurfaceDiffusion::SurfaceDiffusion(const TriangleMesh& mesh, const Tuples<3>& normals)
  : Normals(normals)
{
  const Index numberOfPoints = mesh.GetNumberOfPoints();
  // Each triangle at a point gives it two half links, so this is an upper bound; those to the same
  // neighbour are joined.
  this->Offsets.resize(numberOfPoints + 1, 0);
  for (Index i = 0; i < numberOfPoints; ++i)
  {
    this->Offsets[i + 1] = this->Offsets[i] + 2 * mesh.GetNumberOfIncident(i);
  }
  this->Links.resize(this->Offsets.back());
  this->Ends.resize(numberOfPoints);
  this->Rates.resize(numberOfPoints, 0.0f);
  std::vector<double> areas(numberOfPoints, 0.0);
  vtkSMPTools::For(0, numberOfPoints,
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<std::pair<Index, double>> halves;
      for (vtkIdType i = begin; i < end; ++i)
      {
        const Index point = static_cast<Index>(i);
        halves.clear();
        for (const Index* t = mesh.IncidentBegin(point); t != mesh.IncidentEnd(point); ++t)
        {
          const TriangleMesh::Triangle& corners = mesh.GetTriangle(*t);
          const FaceFrame face(mesh, corners);
          if (!face.IsUsable)
          {
            continue;
          }
          const int here = corners[0] == point ? 0 : (corners[1] == point ? 1 : 2);
          const int next = (here + 1) % 3;
          const int last = (here + 2) % 3;
          areas[i] += face.GetCornerAreas()[here];
          // Half the cotangent of the angle opposite the link; cot = dot / (2 area).
          halves.emplace_back(
            corners[next], -face.Edges[here].dot(face.Edges[next]) / (4.0 * face.Area));
          halves.emplace_back(
            corners[last], -face.Edges[here].dot(face.Edges[last]) / (4.0 * face.Area));
        }
        std::sort(halves.begin(), halves.end());
        const Vector3d normal = normals[i].cast<double>();
        const TangentFrame frame = MakeTangentFrame(normal);
        Index slot = this->Offsets[i];
        double rate = 0.0;
        for (std::size_t h = 0; h < halves.size();)
        {
          const Index to = halves[h].first;
          double weight = 0.0;
          for (; h < halves.size() && halves[h].first == to; ++h)
          {
            weight += halves[h].second;
          }
          const Vector3d other = normals[to].cast<double>();
          const MinimalRotation rotation(other, normal);
          // Negative weights belong to the Laplacian where triangles are sheared; only those of
          // slivers are cut, which would throw values far beyond their neighbours'.
          weight = rotation.IsValid() && areas[i] > 0.0
            ? std::clamp(weight, MostNegativeWeight, LargestWeight) / areas[i]
            : 0.0;
          if (weight != 0.0)
          {
            const Vector3d u = rotation(MakeTangentFrame(other).U);
            this->Links[slot++] = { to, static_cast<float>(weight),
              { static_cast<float>(u.dot(frame.U)), static_cast<float>(u.dot(frame.V)) } };
            rate += std::abs(weight);
          }
        }
        this->Ends[i] = slot;
        this->Rates[i] = static_cast<float>(rate);
      }
    });
  double sum = 0.0;
  double area = 0.0;
  for (Index i = 0; i < numberOfPoints; ++i)
  {
    sum += areas[i] * this->Rates[i];
    area += areas[i];
  }
  this->Areas.assign(areas.begin(), areas.end());
  this->MeanRate = area > 0.0 ? sum / area : 0.0;
}

//------------------------------------------------------------------------------
TangentFrame SurfaceDiffusion::GetFrame(Index point) const
{
  return MakeTangentFrame(this->Normals[point].cast<double>());
}

//------------------------------------------------------------------------------
// Points that are held back to a largest rate are as slow as if they had more area than they have.
// This is how much more there seems to be in all, and how much longer all takes, so.
double SurfaceDiffusion::GetHeatCapacity(double largestRate) const
{
  double capacity = 0.0;
  double area = 0.0;
  for (std::size_t i = 0; i < this->Areas.size(); ++i)
  {
    capacity += this->Areas[i] * std::max(1.0, this->Rates[i] / largestRate);
    area += this->Areas[i];
  }
  return area > 0.0 && largestRate > 0.0 ? capacity / area : 1.0;
}

//------------------------------------------------------------------------------
void SurfaceDiffusion::Smooth(Field& field, int spin, double radius, const Progress& progress) const
{
  // Points with up to half as much again as the mean rate are followed exactly; only smaller
  // triangles, which are in balance with their neighbourhood anyway, are held back.
  const double largestRate = 1.5 * this->MeanRate;
  const double time = 0.5 * radius * radius * this->GetHeatCapacity(largestRate);
  const double wanted = std::ceil(time * largestRate / LargestStep);
  if (!(wanted >= 1.0))
  {
    return;
  }
  // Each part takes as many stages as make it stable: one does the work of one explicit step, s do
  // that of s (s + 1) / 2. C. D. Meyer, D. S. Balsara, T. D. Aslam, "A second-order accurate Super
  // TimeStepping formulation for anisotropic thermal conduction", MNRAS 422, 2012: the first order
  // scheme, by Legendre polynomials.
  const int parts = static_cast<int>(std::min<double>(wanted, NumberOfParts));
  int stages = 1;
  while (
    0.5 * stages * (stages + 1) * parts < wanted && parts * (stages + 1) <= MaximumNumberOfSteps)
  {
    ++stages;
  }
  const double gain = 0.5 * stages * (stages + 1);
  const double step = std::min(time / parts, gain * LargestStep / largestRate) / gain;
  const vtkIdType size = static_cast<vtkIdType>(field.size());
  Field last(field.size());
  for (int part = 0; part < parts; ++part)
  {
    for (int stage = 1; stage <= stages; ++stage)
    {
      if (!progress((part + (stage - 1.0) / stages) / parts))
      {
        return;
      }
      // The new values are written over the last but one, which nothing needs but the new ones.
      const float swing = stage == 1 ? 0.0f : static_cast<float>(stage - 1) / stage;
      const float length = static_cast<float>(step * (2.0 * stage - 1.0) / stage);
      const float largest = static_cast<float>(largestRate);
      vtkSMPTools::For(0, size,
        [&](vtkIdType begin, vtkIdType end)
        {
          for (vtkIdType i = begin; i < end; ++i)
          {
            std::complex<float> change = 0.0f;
            for (Index l = this->Offsets[i]; l < this->Ends[i]; ++l)
            {
              const Link& link = this->Links[l];
              change += link.Weight * (Turn(field[link.To], link.Turning, spin) - field[i]);
            }
            const float rate = this->Rates[i];
            const float factor = rate <= largest ? length : length * largest / rate;
            last[i] = field[i] + swing * (field[i] - last[i]) + factor * change;
          }
        });
      field.swap(last);
    }
  }
  progress(1.0);
}

//------------------------------------------------------------------------------
void SurfaceDiffusion::PreserveFeatures(const TriangleMesh& mesh, double strength, double radius)
{
  if (!(strength > 0.0) || !(radius > 0.0))
  {
    return;
  }
  Tuples<3> smooth = this->Normals;
  this->SmoothNormals(smooth, 0.5 * radius);
  vtkSMPTools::For(0, mesh.GetNumberOfPoints(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        double rate = 0.0;
        for (Index l = this->Offsets[i]; l < this->Ends[i]; ++l)
        {
          Link& link = this->Links[l];
          const double turn = (smooth[link.To] - smooth[i]).cast<double>().norm();
          const double length =
            (mesh.GetPoint(link.To) - mesh.GetPoint(static_cast<Index>(i))).cast<double>().norm();
          const double bend = strength * radius * turn / length;
          // Points in one place have no way to bend.
          link.Weight *= length > 0.0 ? static_cast<float>(std::exp(-bend * bend)) : 1.0f;
          rate += std::abs(link.Weight);
        }
        this->Rates[i] = static_cast<float>(rate);
      }
    });
}

//------------------------------------------------------------------------------
void SurfaceDiffusion::SmoothNormals(
  Tuples<3>& normals, double radius, const Progress& progress) const
{
  Field xy(normals.size());
  Field z(normals.size());
  for (std::size_t i = 0; i < normals.size(); ++i)
  {
    xy[i] = { normals[i].x(), normals[i].y() };
    z[i] = normals[i].z();
  }
  this->Smooth(xy, 0, radius, PartOf(progress, 0.0, 0.5));
  this->Smooth(z, 0, radius, PartOf(progress, 0.5, 1.0));
  for (std::size_t i = 0; i < normals.size(); ++i)
  {
    const Eigen::Vector3f smooth(xy[i].real(), xy[i].imag(), z[i].real());
    // Where the normals around cancel each other the old one is as good as any.
    if (smooth.norm() > 1e-3f)
    {
      normals[i] = smooth.normalized();
    }
  }
}

//------------------------------------------------------------------------------
void SurfaceDiffusion::SmoothTensors(
  Tuples<6>& tensors, double radius, const Progress& progress) const
{
  // The mean of the two curvatures is a scalar; the rest turns by twice the angle.
  Field mean(tensors.size());
  Field rest(tensors.size());
  const vtkIdType size = static_cast<vtkIdType>(tensors.size());
  vtkSMPTools::For(0, size,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const Eigen::Vector3f form =
          ToFrame(tensors[i].cast<double>(), this->GetFrame(static_cast<Index>(i))).cast<float>();
        mean[i] = 0.5f * (form[0] + form[2]);
        rest[i] = { 0.5f * (form[0] - form[2]), form[1] };
      }
    });
  this->Smooth(mean, 0, radius, PartOf(progress, 0.0, 0.5));
  this->Smooth(rest, 2, radius, PartOf(progress, 0.5, 1.0));
  vtkSMPTools::For(0, size,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const Vector3d form(
          mean[i].real() + rest[i].real(), rest[i].imag(), mean[i].real() - rest[i].real());
        tensors[i] = FromFrame(form, this->GetFrame(static_cast<Index>(i))).cast<float>();
      }
    });
}

//------------------------------------------------------------------------------
void SurfaceDiffusion::SmoothCubics(
  Tuples<4>& cubics, const Tuples<3>& e1, double radius, const Progress& progress) const
{
  // C(x,x,x) over the unit circle, x at the angle a, has just the terms cos a, sin a, cos 3a, sin
  // 3a.
  Field first(cubics.size());
  Field third(cubics.size());
  const vtkIdType size = static_cast<vtkIdType>(cubics.size());
  const auto principalFrame = [&](vtkIdType i)
  {
    const Vector3d a = e1[i].cast<double>();
    return TangentFrame{ a, this->Normals[i].cast<double>().cross(a) };
  };
  vtkSMPTools::For(0, size,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const Eigen::Vector4f c = ChangeFrame(
          cubics[i].cast<double>(), principalFrame(i), this->GetFrame(static_cast<Index>(i)))
                                    .cast<float>();
        first[i] = { 0.75f * (c[0] + c[2]), 0.75f * (c[1] + c[3]) };
        third[i] = { 0.25f * (c[0] - 3.0f * c[2]), 0.25f * (3.0f * c[1] - c[3]) };
      }
    });
  this->Smooth(first, 1, radius, PartOf(progress, 0.0, 0.5));
  this->Smooth(third, 3, radius, PartOf(progress, 0.5, 1.0));
  vtkSMPTools::For(0, size,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const double a1 = first[i].real();
        const double b1 = first[i].imag();
        const double a3 = third[i].real();
        const double b3 = third[i].imag();
        const Eigen::Vector4d c(a1 + a3, b1 / 3.0 + b3, a1 / 3.0 - a3, b1 - b3);
        cubics[i] =
          ChangeFrame(c, this->GetFrame(static_cast<Index>(i)), principalFrame(i)).cast<float>();
      }
    });
}
}
