// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprSnail.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

namespace npr
{
namespace
{
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double Pi = 3.14159265358979323846;

// Union of two fields whose seam is rounded over the width k; twice continuously differentiable
// (the cubic form of the smooth minimum, I. Quilez, Smooth minimum, 2013).
double Unite(double a, double b, double k)
{
  const double h = std::max(k - std::abs(a - b), 0.0) / k;
  return std::min(a, b) - h * h * h * k / 6.0;
}

double Intersect(double a, double b, double k)
{
  return -Unite(-a, -b, k);
}

double Length(double x, double y)
{
  return std::sqrt(x * x + y * y); // in half the time of std::hypot()
}

// 0 below, 1 above, twice continuously differentiable.
double Rise(double low, double high, double x)
{
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
}

// About the distance from an ellipsoid along the axes.
double Ellipsoid(const Vector3d& point, const Vector3d& radii)
{
  const Vector3d scaled = point.cwiseQuotient(radii);
  const double length = scaled.norm();
  const double slope = scaled.cwiseQuotient(radii).norm();
  return slope > 1e-9 ? length * (length - 1.0) / slope : -radii.minCoeff();
}

Vector3d TurnAboutZ(const Vector3d& p, double angle)
{
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return { c * p.x() + s * p.y(), -s * p.x() + c * p.y(), p.z() };
}

// A soft horn from its root over a bend to its tip, with a ball on it.
struct Horn
{
  Vector3d Root;
  Vector3d Bend;
  Vector3d Tip;
  double RootRadius;
  double TipRadius;
  double BallRadius;

  double Evaluate(const Vector3d& p) const
  {
    // The nearest parameter on the quadratic Bezier curve, by Newton's steps from the chord's.
    const Vector3d a = this->Bend - this->Root;
    const Vector3d b = this->Root - 2.0 * this->Bend + this->Tip;
    const Vector3d chord = this->Tip - this->Root;
    double t = std::clamp((p - this->Root).dot(chord) / chord.squaredNorm(), 0.0, 1.0);
    for (int step = 0; step < 4; ++step)
    {
      const Vector3d offset = this->Root + t * (2.0 * a + t * b) - p;
      const Vector3d velocity = 2.0 * (a + t * b);
      const double curvature = velocity.squaredNorm() + 2.0 * offset.dot(b);
      t = std::clamp(
        t - offset.dot(velocity) / std::max(curvature, 0.1 * velocity.squaredNorm()), 0.0, 1.0);
    }
    const Vector3d nearest = this->Root + t * (2.0 * a + t * b);
    const double radius =
      this->RootRadius + (this->TipRadius - this->RootRadius) * Rise(-0.2, 1.0, t);
    const double stem = (p - nearest).norm() - radius;
    const double ball = (p - this->Tip).norm() - this->BallRadius;
    return Unite(stem, ball, 0.06);
  }
};

// The shell: a tube around a conical logarithmic spiral (H. Moseley, On the geometrical forms of
// turbinated and discoid shells, 1838), wound clockwise as seen from its apex at +z.
namespace shell
{
constexpr double Growth = 1.95; // of the radius by each whorl
constexpr double Whorls = 3.5;
constexpr double EndRadius = 0.70; // of the spiral's centre line
constexpr double Tube = 0.455;     // the tube's radius over the spiral's
constexpr double Height = 0.60;    // the centre line's height over its radius
constexpr double Suture = 0.075;   // rounding between whorls over the spiral's radius
constexpr double SutureLeast = 0.022;
constexpr double EndAngle = -0.80; // where the mouth is, from +x
constexpr int RibsPerWhorl = 30;
constexpr double RibHeight = 0.009; // over the tube's radius

struct Placement
{
  Eigen::Matrix3d Turn; // from the snail's to the shell's axes
  Vector3d Centre = { -0.30, 1.08, -0.24 };
  double Rate = std::log(Growth) / (2.0 * Pi); // of the logarithm of the radius over the angle
  Vector3d MouthCentre;
  Vector3d MouthAxis;
  double MouthRadius = Tube * EndRadius;
  Vector3d Apex;

  Placement()
  {
    // The apex leans up and back.
    this->Turn =
      (Eigen::AngleAxisd(0.36, Vector3d::UnitX()) * Eigen::AngleAxisd(0.16, Vector3d::UnitY()))
        .toRotationMatrix();
    this->MouthCentre = this->CentreLine(0.0);
    this->MouthAxis = (this->CentreLine(0.0) - this->CentreLine(-0.01)).normalized();
    this->Apex = { 0.0, 0.0, Height * EndRadius * (1.0 - std::pow(Growth, -Whorls)) };
  }
  // Angles run from -2 pi Whorls at the apex to 0 at the mouth.
  double Radius(double angle) const { return EndRadius * std::exp(this->Rate * angle); }
  Vector3d CentreLine(double angle) const
  {
    const double radius = this->Radius(angle);
    const double direction = EndAngle - angle;
    return { radius * std::cos(direction), radius * std::sin(direction),
      Height * (EndRadius - radius) };
  }
};

// One turn of the tube where its centre line has the radius and the angle. At least where the field
// is below the limit the value is right; elsewhere it is only above the limit.
double Whorl(double radius, double angle, double distance, double height, double limit)
{
  const double first = -2.0 * Pi * Whorls;
  const double across = distance - radius;
  const double up = height - Height * (EndRadius - radius);
  // The tube grows out of nothing: less than nothing, so that not even its seam is felt before.
  const double birth = Rise(first, first + 4.0, angle);
  const double tube = Tube * radius * birth - 0.1 * (1.0 - birth);
  const double plain = Length(across, up) - tube;
  if (plain - 2.0 * RibHeight * radius > limit)
  {
    return plain;
  }
  // Growth lines: crests across the tube, swept back on its outside.
  const double side = std::atan2(up, across);
  const double phase = RibsPerWhorl * (angle + 0.10 * std::cos(side - 0.6));
  const double ribs = RibHeight * (std::cos(phase) + 0.25 * std::cos(2.0 * phase)) *
    Rise(0.10, 0.30, radius) * Rise(0.0, 0.6, -angle);
  return plain - tube * ribs;
}

const Placement& GetPlacement()
{
  static const Placement place;
  return place;
}

double Field(const Vector3d& point)
{
  const Placement& place = GetPlacement();
  const Vector3d p = place.Turn * (point - place.Centre);
  const double distance = Length(p.x(), p.y());
  // The last whorl's angle in this direction, in (-2 pi, 0].
  double angle = EndAngle - std::atan2(p.y(), p.x());
  angle -= 2.0 * Pi * std::ceil(angle / (2.0 * Pi));

  // The tube ends in a ball. Right behind the mouth the ball takes the place of the last whorl: it
  // has the same value there, and must not be rounded against it, but against the whorl inside of
  // it.
  double result = (p - place.MouthCentre).norm() - place.MouthRadius;
  double radius = place.Radius(angle);
  double seam = (Suture * Growth * radius + SutureLeast) * Rise(0.5 * Pi, 1.5 * Pi, -angle) + 1e-6;
  while (angle > -2.0 * Pi * Whorls)
  {
    result = Unite(result, Whorl(radius, angle, distance, p.z(), result + seam), seam);
    angle -= 2.0 * Pi;
    seam = Suture * radius + SutureLeast;
    radius /= Growth;
  }
  // What the whorls wind around: a cone inside of them, and the first chamber on its tip.
  const double cone = 0.8 * (distance - 0.72 * (EndRadius - p.z() / Height));
  const double first = (p - place.Apex).norm() - 0.060;
  result = Unite(result, Unite(Intersect(cone, -0.1 - p.z(), 0.1), first, 0.03), 0.04);
  // The lip around the mouth.
  const Vector3d q = p - place.MouthCentre;
  const double along = q.dot(place.MouthAxis);
  const double out = std::sqrt(std::max(q.squaredNorm() - along * along, 0.0));
  const double lip = Length(along, out - place.MouthRadius) - 0.034;
  return Unite(result, lip, 0.07);
}

// No point of the shell is further from here than the radius.
const Vector3d BallCentre(-0.25, 1.08, -0.08);
constexpr double BallRadius = 1.12;
}

namespace body
{
double Field(const Vector3d& p)
{
  const double back =
    Ellipsoid(TurnAboutZ(p - Vector3d(-0.60, 0.16, 0.0), 0.10), { 1.15, 0.19, 0.25 });
  const double middle = Ellipsoid(p - Vector3d(0.10, 0.36, 0.0), { 0.80, 0.36, 0.37 });
  const double neck =
    Ellipsoid(TurnAboutZ(p - Vector3d(0.98, 0.46, 0.0), 0.62), { 0.68, 0.28, 0.27 });
  const double head =
    Ellipsoid(TurnAboutZ(p - Vector3d(1.46, 0.84, 0.0), 0.1), { 0.28, 0.225, 0.22 });
  const double snout = Ellipsoid(p - Vector3d(1.63, 0.74, 0.0), { 0.15, 0.135, 0.165 });

  double result = Unite(back, middle, 0.30);
  result = Unite(result, neck, 0.40);
  result = Unite(result, head, 0.25);
  result = Unite(result, snout, 0.18);
  // The mantle swells out of the shell's mouth.
  const double mantle = Ellipsoid(p - Vector3d(0.10, 0.47, 0.0), { 0.44, 0.35, 0.37 });
  result = Unite(result, mantle, 0.20);

  // Furrows of the skin: warped waves in two directions, stronger on the neck.
  const double u = 19.0 * p.x() + 5.0 * std::sin(3.0 * p.y() + 2.0 * p.z());
  const double v = 17.0 * (p.y() - 0.45 * p.x()) + 3.0 * std::sin(4.0 * p.x());
  const double w = 21.0 * p.z();
  const double skin = std::sin(u + 0.5 * w) * std::sin(v - 0.4 * w);
  const double where = Rise(0.10, 0.30, p.y()) * (1.0 - 0.7 * Rise(1.25, 1.55, p.x()));
  result += 0.010 * where * skin;

  // The foot: a long leaf with a wavy rim, narrow at the tail, and nowhere higher than 0.16.
  const double footSeam = 0.13;
  if (p.y() - 0.16 < result + footSeam)
  {
    const double wave = 0.030 * std::sin(8.0 * p.x()) + 0.018 * std::sin(15.0 * p.x() + 1.0);
    const double width = (0.24 + 0.24 * Rise(-2.1, 0.6, p.x())) * (1.0 + wave);
    const double foot = Ellipsoid(p - Vector3d(-0.36, 0.045, 0.0), { 1.64, 0.115, width });
    result = Unite(result, foot, footSeam);
  }
  return Intersect(result, -p.y(), 0.05);
}

// The two pairs of horns: eyes on the long ones.
double Horns(const Vector3d& p, double limit)
{
  static const std::array<Horn, 4> horns = { {
    { { 1.50, 0.96, 0.10 }, { 1.60, 1.28, 0.20 }, { 1.80, 1.62, 0.32 }, 0.085, 0.040, 0.068 },
    { { 1.50, 0.96, -0.10 }, { 1.54, 1.32, -0.22 }, { 1.60, 1.70, -0.36 }, 0.085, 0.040, 0.068 },
    { { 1.67, 0.78, 0.07 }, { 1.81, 0.80, 0.13 }, { 1.95, 0.72, 0.18 }, 0.055, 0.032, 0.042 },
    { { 1.67, 0.78, -0.07 }, { 1.81, 0.78, -0.14 }, { 1.93, 0.68, -0.20 }, 0.055, 0.032, 0.042 },
  } };
  double result = limit;
  for (const Horn& horn : horns)
  {
    const double seam = 0.03;
    const Vector3d middle = 0.5 * (horn.Root + horn.Tip);
    if ((p - middle).norm() - (horn.Tip - middle).norm() - 0.2 < limit + seam)
    {
      result = Unite(result, horn.Evaluate(p), seam);
    }
  }
  return result;
}
}
}

double SnailField(const Vector3d& point)
{
  // What is further away than the rounding of its seam makes no difference, so the nearer one of
  // body and shell comes first. The box is that of the body with some room.
  const double seam = 0.035;
  const Vector3d outside =
    (point - Vector3d(-0.12, 0.55, 0.0)).cwiseAbs() - Vector3d(2.0, 0.6, 0.55);
  const double toBody = outside.cwiseMax(0.0).norm();
  const double toShell = (point - shell::BallCentre).norm() - shell::BallRadius;
  const bool isBodyFirst = toBody < toShell;
  double result = isBodyFirst ? body::Field(point) : shell::Field(point);
  if ((isBodyFirst ? toShell : toBody) < result + seam)
  {
    result = Unite(result, isBodyFirst ? shell::Field(point) : body::Field(point), seam);
  }
  const double hornSeam = 0.09;
  return Unite(result, body::Horns(point, result + hornSeam), hornSeam);
}

SnailPart FindSnailPart(const Vector3d& point)
{
  constexpr double far = 1.0;
  const double shell = shell::Field(point);
  const double body = body::Field(point);
  const double horns = body::Horns(point, far);
  return horns < std::min(shell, body) ? SnailPart::Horns
    : body < shell                     ? SnailPart::Body
                                       : SnailPart::Shell;
}

double GetDistanceFromApex(const Vector3d& point)
{
  const shell::Placement& place = shell::GetPlacement();
  return (place.Turn * (point - place.Centre) - place.Apex).norm();
}
}
