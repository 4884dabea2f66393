// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRZeroCurvatureLines.h"

#include "nprArrayNames.h"
#include "nprSignRegions.h"
#include "nprSmoothShape.h"
#include "nprSurfaceDiffusion.h"

#include <vtkSMPTools.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>
#include <utility>

namespace
{
using Index = npr::TriangleMesh::Index;

// That a single sliver is beyond all doubt says no more of the curvature around.
constexpr float LargestDoubt = 3.0f;
// A line is where what is on its two sides cancels out, so their doubt counts, too.
constexpr double WidthOfDoubt = 2.0;

// Of a function that is linear in each triangle: the length of the mean of its gradients around
// each point, by their areas.
std::vector<float> MeasureGradients(const npr::TriangleMesh& mesh, const std::vector<float>& field)
{
  std::vector<float> lengths(field.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(field.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const Index point = static_cast<Index>(i);
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        double area = 0.0;
        for (const Index* t = mesh.IncidentBegin(point); t != mesh.IncidentEnd(point); ++t)
        {
          const npr::TriangleMesh::Triangle& corners = mesh.GetTriangle(*t);
          const Eigen::Vector3d normal = mesh.GetAreaNormal(*t).cast<double>();
          const double twice = normal.norm();
          if (!(twice > 0.0))
          {
            continue;
          }
          for (int c = 0; c < 3; ++c)
          {
            const Eigen::Vector3d opposite = mesh.GetPoint(corners[(c + 2) % 3]).cast<double>() -
              mesh.GetPoint(corners[(c + 1) % 3]).cast<double>();
            sum += double(field[corners[c]]) * (normal / twice).cross(opposite);
          }
          area += twice;
        }
        lengths[i] = area > 0.0 ? static_cast<float>(sum.norm() / area) : 0.0f;
      }
    });
  return lengths;
}
}

//------------------------------------------------------------------------------
vtkNPRZeroCurvatureLines::vtkNPRZeroCurvatureLines(
  const char* gradient, double threshold, double fade, double smoothing, double region)
  : Threshold(threshold), Fade(fade), Smoothing(smoothing), Region(region)
{
  this->AddParameter("threshold", gradient, this->Threshold, 0.0, 1.0e9);
  this->AddParameter("fade", "how far above the threshold lines have their full strength",
    this->Fade, 1.0e-6, 1.0e9);
  this->AddParameter("smoothing",
    "standard deviation of a smoothing of the curvature, over the length scale", this->Smoothing,
    0.0, 1.0);
  this->AddParameter("region",
    "how much the surface bends at least on either side of a line, as the square of an angle",
    this->Region, 0.0, 1.0e6);
}

//------------------------------------------------------------------------------
std::vector<vtkNPRLineDefinition::RequiredArray> vtkNPRZeroCurvatureLines::GetRequiredArrays() const
{
  return { { npr::names::Normals, 3, "vtkNPRSurfaceNormals" },
    { npr::names::CurvatureTensor, 6, "vtkNPRCurvatureTensor" } };
}

//------------------------------------------------------------------------------
double vtkNPRZeroCurvatureLines::GetReach() const
{
  return this->Smoothing > 0.0 ? npr::DiffusionReach : 1.0;
}

//------------------------------------------------------------------------------
void vtkNPRZeroCurvatureLines::BeginView(const npr::LineSurface& surface, const npr::LineView&)
{
  npr::TriangleMesh mesh = surface.GetMesh();
  mesh.BuildIncidence();
  const double scale = surface.GetLengthScale();
  const npr::SmoothShape shape(surface, this->Smoothing, false);
  const std::size_t size = shape.Tensors.size();
  this->Field.resize(size);
  std::vector<float> density(size);
  for (std::size_t i = 0; i < size; ++i)
  {
    const auto& t = shape.Tensors[i];
    const double mean = 0.5 * (double(t[0]) + t[1] + t[2]);
    const double gaussian = double(t[0]) * t[1] + double(t[1]) * t[2] + double(t[2]) * t[0] -
      double(t[3]) * t[3] - double(t[4]) * t[4] - double(t[5]) * t[5];
    this->Field[i] = shape.IsNumber[i] ? static_cast<float>(this->GetCurvature(mean, gaussian))
                                       : std::numeric_limits<float>::quiet_NaN();
    density[i] = static_cast<float>(this->GetDensity(this->Field[i]));
  }
  this->SetDoubts(surface, shape);
  this->Gradients = MeasureGradients(mesh, this->Field);
  for (float& gradient : this->Gradients)
  {
    gradient *= static_cast<float>(scale);
  }
  if (this->Region > 0.0)
  {
    npr::MergeLightRegions(surface, density, this->Region * scale * scale, this->Field);
  }
}

//------------------------------------------------------------------------------
// A mean of curvatures is as doubtful as these are in the mean.
void vtkNPRZeroCurvatureLines::SetDoubts(
  const npr::LineSurface& surface, const npr::SmoothShape& shape)
{
  this->Doubts.clear();
  if (!surface.HasArray(npr::names::DerivativeDoubt))
  {
    return;
  }
  const float* const doubts = surface.GetComponent(npr::names::DerivativeDoubt, 0);
  this->Doubts.resize(shape.Tensors.size());
  std::transform(doubts, doubts + this->Doubts.size(), this->Doubts.begin(),
    [](float doubt) { return doubt < LargestDoubt ? doubt : LargestDoubt; });
  shape.Smooth(this->Doubts, WidthOfDoubt);
}

//------------------------------------------------------------------------------
void vtkNPRZeroCurvatureLines::EndView(const npr::LineSurface&)
{
  std::vector<float>().swap(this->Doubts);
  std::vector<float>().swap(this->Field);
  std::vector<float>().swap(this->Gradients);
}

//------------------------------------------------------------------------------
void vtkNPRZeroCurvatureLines::EvaluateField(
  const npr::LineSurface&, const npr::LineView&, vtkIdType begin, vtkIdType end, float* field) const
{
  std::copy(this->Field.begin() + begin, this->Field.begin() + end, field + begin);
}

//------------------------------------------------------------------------------
void vtkNPRZeroCurvatureLines::EvaluateTest(const npr::LineSurface&, const npr::LineView&,
  const Index* points, vtkIdType count, const float*, float* test) const
{
  for (vtkIdType j = 0; j < count; ++j)
  {
    test[j] = static_cast<float>((this->Gradients[points[j]] - this->Threshold) / this->Fade);
  }
}
