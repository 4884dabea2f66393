// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprOutlineTesting.h
 * @brief White shapes on white paper, so that whatever is dark is a line.
 */
#ifndef nprOutlineTesting_h
#define nprOutlineTesting_h

#include "nprShadingTest.h"

#include <vtkCubeSource.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace npr
{
namespace testing
{
using Place = std::array<double, 2>;

inline void MakeWhite(vtkActor* actor)
{
  actor->GetProperty()->SetInterpolationToPhong();
  actor->GetProperty()->SetAmbient(1.0);
  actor->GetProperty()->SetDiffuse(0.0);
}

struct WhiteStage : Stage
{
  explicit WhiteStage(int size = 200) : Stage(size) { this->Renderer->SetBackground(1, 1, 1); }

  vtkActor* AddWhiteSphere()
  {
    vtkActor* actor = this->AddSphere();
    MakeWhite(actor);
    return actor;
  }

  vtkActor* AddWhiteBox(double size)
  {
    vtkNew<vtkCubeSource> box;
    box->SetXLength(size);
    box->SetYLength(size);
    box->SetZLength(size);
    vtkActor* actor = this->Add(box->GetOutputPort());
    MakeWhite(actor);
    return actor;
  }

  Place Project(double x, double y, double z)
  {
    this->Renderer->SetWorldPoint(x, y, z, 1.0);
    this->Renderer->WorldToDisplay();
    const double* display = this->Renderer->GetDisplayPoint();
    return { display[0], display[1] };
  }
};

/// Darkness in [0, 1] at a place in pixels, between the middles of pixels.
inline double GetInk(const Image& image, double x, double y)
{
  const double left = std::floor(x - 0.5);
  const double below = std::floor(y - 0.5);
  const double u = x - 0.5 - left;
  const double v = y - 0.5 - below;
  const auto at = [&](int i, int j)
  {
    i = std::clamp(static_cast<int>(left) + i, 0, image.Width - 1);
    j = std::clamp(static_cast<int>(below) + j, 0, image.Height - 1);
    return 1.0 - image.At(i, j)[0] / 255.0;
  };
  return (1 - v) * ((1 - u) * at(0, 0) + u * at(1, 0)) + v * ((1 - u) * at(0, 1) + u * at(1, 1));
}

inline double GetInk(const Image& image)
{
  double ink = 0.0;
  for (size_t i = 0; i < image.Bytes.size(); i += 3)
  {
    ink += 1.0 - image.Bytes[i] / 255.0;
  }
  return ink;
}

/// What is dark across a line, within a reach.
struct Profile
{
  double Width = 0.0;  ///< of as much black, pixels
  double Offset = 0.0; ///< of its middle, along the normal, pixels
};

inline Profile GetProfile(const Image& image, const Place& place, const Place& normal, double reach)
{
  constexpr double Step = 0.1;
  Profile profile;
  double moment = 0.0;
  for (double t = -reach; t <= reach; t += Step)
  {
    const double ink = GetInk(image, place[0] + t * normal[0], place[1] + t * normal[1]);
    profile.Width += Step * ink;
    moment += Step * t * ink;
  }
  profile.Offset = profile.Width > 0.0 ? moment / profile.Width : reach;
  return profile;
}

/// The largest deviations along a line from place to place.
struct Deviation
{
  double Offset = 0.0;
  double LeastWidth = 1.0e9;
  double MostWidth = 0.0;

  void Add(const Profile& profile)
  {
    this->Offset = std::max(this->Offset, std::abs(profile.Offset));
    this->LeastWidth = std::min(this->LeastWidth, profile.Width);
    this->MostWidth = std::max(this->MostWidth, profile.Width);
  }
};

inline std::string Say(const Deviation& d)
{
  return ": off by " + std::to_string(d.Offset) + " pixels, width " + std::to_string(d.LeastWidth) +
    " to " + std::to_string(d.MostWidth);
}

/// Along a straight line, but for some pixels at its ends.
inline Deviation MeasureStraight(
  const Image& image, const Place& from, const Place& to, double margin, double reach)
{
  const double length = std::hypot(to[0] - from[0], to[1] - from[1]);
  const Place along = { (to[0] - from[0]) / length, (to[1] - from[1]) / length };
  Deviation deviation;
  for (double s = margin; s <= length - margin; s += 0.5)
  {
    deviation.Add(GetProfile(
      image, { from[0] + s * along[0], from[1] + s * along[1] }, { -along[1], along[0] }, reach));
  }
  return deviation;
}

inline Deviation MeasureCircle(const Image& image, const Place& center, double radius, double reach)
{
  Deviation deviation;
  for (int i = 0; i < 720; ++i)
  {
    const double angle = i * 3.14159265358979 / 360.0;
    const Place normal = { std::cos(angle), std::sin(angle) };
    deviation.Add(GetProfile(
      image, { center[0] + radius * normal[0], center[1] + radius * normal[1] }, normal, reach));
  }
  return deviation;
}

/// The radius, in pixels, at which a perspective view shows a sphere's outline.
inline double GetOutlineRadius(double radius, double distance, double viewAngle, int height)
{
  const double half = 0.5 * viewAngle * 3.14159265358979 / 180.0;
  return 0.5 * height * std::tan(std::asin(radius / distance)) / std::tan(half);
}
}
}

#endif
