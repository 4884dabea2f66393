// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRIsophotes.h"

#include "nprArrayNames.h"
#include "nprSmoothShape.h"
#include "nprSurfaceDiffusion.h"

#include <vtkMath.h>
#include <vtkObjectFactory.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/Core>

vtkStandardNewMacro(vtkNPRIsophotes);

// Where the light is: Place - Near * p is the vector from a point p to it.
class vtkNPRIsophotes::Light
{
public:
  // A light at the eye.
  Light(const npr::LineView& view, const npr::LineSurface& surface)
    : X(surface.GetCoordinate(0)), Y(surface.GetCoordinate(1)), Z(surface.GetCoordinate(2)),
      Place(Eigen::Map<const Eigen::Vector3f>(view.Eye.data())), Near(view.Perspective)
  {
  }
  Light(const vtkNPRIsophotes& lines, const npr::LineView& view, const npr::LineSurface& surface)
    : Light(view, surface)
  {
    if (!lines.IsViewDependent())
    {
      this->Place =
        Eigen::Map<const Eigen::Vector3d>(lines.Direction).stableNormalized().cast<float>();
      this->Near = 0.0f;
    }
    else if (lines.Azimuth != 0.0 || lines.Elevation != 0.0)
    {
      const double azimuth = vtkMath::RadiansFromDegrees(lines.Azimuth);
      const double elevation = vtkMath::RadiansFromDegrees(lines.Elevation);
      const auto right = static_cast<float>(std::sin(azimuth) * std::cos(elevation));
      const auto up = static_cast<float>(std::sin(elevation));
      const auto back = static_cast<float>(std::cos(azimuth) * std::cos(elevation));
      this->Place = (right * view.Axes[0] + up * view.Axes[1] + back * view.Axes[2]).normalized();
      this->Near = 0.0f;
    }
  }
  // The unit vector to the light; 0 at the light itself.
  Eigen::Vector3f operator()(vtkIdType i) const
  {
    return (this->Place - this->Near * Eigen::Vector3f(this->X[i], this->Y[i], this->Z[i]))
      .normalized();
  }

private:
  const float* X;
  const float* Y;
  const float* Z;
  Eigen::Vector3f Place;
  float Near;
};

//------------------------------------------------------------------------------
vtkNPRIsophotes::vtkNPRIsophotes()
{
  this->AddParameter("levels", "how many levels there are", this->Levels, 1.0, 1000.0);
  this->AddParameter("minimum", "the cosine from which to 1 the levels are, in equal steps",
    this->Minimum, -1.0, 0.999);
  this->AddParameter(
    "azimuth", "of the light, degrees to the right of the viewer", this->Azimuth, -360.0, 360.0);
  this->AddParameter(
    "elevation", "of the light, degrees above the viewer", this->Elevation, -90.0, 90.0);
  this->AddParameter("direction",
    "to a light that stays with the model, in its coordinates; 0 0 0 for one beside the viewer",
    this->Direction, VTK_DOUBLE_MIN, VTK_DOUBLE_MAX);
  this->AddParameter("smoothing",
    "standard deviation of a smoothing of the surface, over the length scale", this->Smoothing, 0.0,
    1.0);
  this->AddParameter("threshold", "least curvature towards the light, times length scale",
    this->Threshold, 0.0, 1.0e6);
  this->AddParameter("fade", "how far above the threshold lines have their full strength",
    this->Fade, 1.0e-6, 1.0e6);
  this->AddParameter("distance",
    "least distance of two lines as the eye sees it, in length scales; 0 lets them crowd",
    this->Distance, 0.0, 1.0e3);
}

//------------------------------------------------------------------------------
bool vtkNPRIsophotes::IsViewDependent() const
{
  return this->Direction[0] == 0.0 && this->Direction[1] == 0.0 && this->Direction[2] == 0.0;
}

//------------------------------------------------------------------------------
std::vector<vtkNPRLineDefinition::RequiredArray> vtkNPRIsophotes::GetRequiredArrays() const
{
  std::vector<RequiredArray> required = { { npr::names::Normals, 3, "vtkNPRSurfaceNormals" } };
  if (this->HasTest() || this->Smoothing > 0.0)
  {
    required.push_back({ npr::names::CurvatureTensor, 6, "vtkNPRCurvatureTensor" });
  }
  return required;
}

//------------------------------------------------------------------------------
double vtkNPRIsophotes::GetReach() const
{
  return this->Smoothing > 0.0 ? npr::DiffusionReach : this->Superclass::GetReach();
}

//------------------------------------------------------------------------------
// With their own names, for there may be several definitions that smooth.
std::string vtkNPRIsophotes::GetNormals() const
{
  return this->Smoothing > 0.0 ? npr::names::Normals + (" over " + std::to_string(this->Smoothing))
                               : npr::names::Normals;
}

std::string vtkNPRIsophotes::GetTensor() const
{
  return this->Smoothing > 0.0
    ? npr::names::CurvatureTensor + (" over " + std::to_string(this->Smoothing))
    : npr::names::CurvatureTensor;
}

//------------------------------------------------------------------------------
void vtkNPRIsophotes::PrepareSurface(npr::LineSurface& surface)
{
  if (!(this->Smoothing > 0.0))
  {
    return;
  }
  const npr::SmoothShape shape(surface, this->Smoothing, true);
  const auto perScale = static_cast<float>(1.0 / surface.GetLengthScale());
  std::vector<npr::AlignedVector<float>> normals(
    3, npr::AlignedVector<float>(shape.Normals.size()));
  std::vector<npr::AlignedVector<float>> tensor(6, npr::AlignedVector<float>(shape.Tensors.size()));
  for (std::size_t i = 0; i < shape.Normals.size(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      normals[c][i] = shape.Normals[i][c];
    }
    for (int c = 0; c < 6; ++c)
    {
      tensor[c][i] = shape.IsNumber[i] ? perScale * shape.Tensors[i][c]
                                       : std::numeric_limits<float>::quiet_NaN();
    }
  }
  surface.SetArray(this->GetNormals(), std::move(normals));
  surface.SetArray(this->GetTensor(), std::move(tensor));
}

//------------------------------------------------------------------------------
double vtkNPRIsophotes::GetStep() const
{
  return (1.0 - this->Minimum) / (std::round(this->Levels) + 1.0);
}

//------------------------------------------------------------------------------
std::vector<float> vtkNPRIsophotes::GetLevels(const npr::LineSurface&) const
{
  const double step = this->GetStep();
  std::vector<float> levels(static_cast<std::size_t>(std::round(this->Levels)));
  for (std::size_t i = 0; i < levels.size(); ++i)
  {
    levels[i] = static_cast<float>(this->Minimum + step * (i + 1.0));
  }
  return levels;
}

//------------------------------------------------------------------------------
void vtkNPRIsophotes::EvaluateField(const npr::LineSurface& surface, const npr::LineView& view,
  vtkIdType begin, vtkIdType end, float* field) const
{
  const Light light(*this, view, surface);
  const std::string normals = this->GetNormals();
  const float* x = surface.GetComponent(normals.c_str(), 0);
  const float* y = surface.GetComponent(normals.c_str(), 1);
  const float* z = surface.GetComponent(normals.c_str(), 2);
  for (vtkIdType i = begin; i < end; ++i)
  {
    field[i] = light(i).dot(Eigen::Vector3f(x[i], y[i], z[i]));
  }
}

//------------------------------------------------------------------------------
void vtkNPRIsophotes::EvaluateTest(const npr::LineSurface& surface, const npr::LineView& view,
  const Index* points, vtkIdType count, const float*, float* test) const
{
  const Light light(*this, view, surface);
  const Light eye(view, surface);
  const bool isSeen = this->IsViewDependent();
  const std::string normalsName = this->GetNormals();
  const std::string tensorName = this->GetTensor();
  std::array<const float*, 3> normals;
  std::array<const float*, 6> tensor;
  for (int c = 0; c < 6; ++c)
  {
    tensor[c] = surface.GetComponent(tensorName.c_str(), c);
    if (c < 3)
    {
      normals[c] = surface.GetComponent(normalsName.c_str(), c);
    }
  }
  const double scale = surface.GetLengthScale();
  const double step = this->GetStep();
  const double distance = this->Distance * scale;
  constexpr float least = std::numeric_limits<float>::min(); // so that nothing is divided by 0
  for (vtkIdType j = 0; j < count; ++j)
  {
    const Index i = points[j];
    const Eigen::Vector3f n(normals[0][i], normals[1][i], normals[2][i]);
    const Eigen::Vector3f toLight = light(i);
    const Eigen::Vector3f l = toLight - n.dot(toLight) * n;
    // How the light changes along the surface.
    const Eigen::Vector3f gradient = {
      tensor[0][i] * l[0] + tensor[3][i] * l[1] + tensor[5][i] * l[2],
      tensor[3][i] * l[0] + tensor[1][i] * l[1] + tensor[4][i] * l[2],
      tensor[5][i] * l[0] + tensor[4][i] * l[1] + tensor[2][i] * l[2],
    };
    const float change = gradient.norm();
    // 0 where there is no direction to the light.
    const double curvature = scale * change / std::max(l.norm(), least);
    double strength = (curvature - this->Threshold) / this->Fade;
    if (distance > 0.0)
    {
      double seen = change;
      if (isSeen)
      {
        // The surface is shorter in the direction of the eye, by the cosine.
        const Eigen::Vector3f v = eye(i);
        const float cosine = n.dot(v);
        seen = std::hypot(change, gradient.dot(v) / std::max(std::abs(cosine), least));
      }
      strength = std::min(strength, step / std::max(distance * seen, double(least)) - 1.0);
    }
    test[j] = static_cast<float>(strength);
  }
}
