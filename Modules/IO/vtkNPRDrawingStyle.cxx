// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRDrawingStyle.h"

#include "nprLineInk.h"

#include <vtkObjectFactory.h>

#include <algorithm>
#include <map>

vtkStandardNewMacro(vtkNPRDrawingStyle);

struct vtkNPRDrawingStyle::Internals
{
  std::map<std::string, npr::LineInk> Inks;

  /// A line type's ink, to be changed.
  npr::LineInk& operator[](const char* lineType) { return this->Inks[lineType ? lineType : ""]; }
};

namespace
{
constexpr double Tapered = 0.2;

struct Default
{
  const char* LineType;
  double Width;
  double Taper;
};
constexpr Default Defaults[] = { { "contours", 0.5, 1.0 }, { "contour-edges", 0.5, 1.0 },
  { "boundaries", 0.35, 1.0 }, { "creases", 0.25, 1.0 }, { "non-manifold", 0.25, 1.0 },
  { "region-borders", 0.25, 1.0 }, { "suggestive", 0.35, Tapered },
  { "suggestive-highlights", 0.25, Tapered }, { "principal-highlights", 0.25, Tapered },
  { "ridges", 0.3, Tapered }, { "valleys", 0.3, Tapered }, { "apparent-ridges", 0.3, Tapered },
  { "demarcating", 0.25, Tapered }, { "parabolic", 0.25, Tapered },
  { "mean-curvature", 0.25, Tapered }, { "isophotes", 0.18, 1.0 }, { "topographic", 0.18, 1.0 },
  { "isolines", 0.18, 1.0 } };
}

//------------------------------------------------------------------------------
vtkNPRDrawingStyle::vtkNPRDrawingStyle() : Internal(new Internals)
{
  for (const Default& line : Defaults)
  {
    npr::LineInk& ink = (*this->Internal)[line.LineType];
    ink.Width = line.Width;
    ink.Taper = line.Taper;
  }
}

vtkNPRDrawingStyle::~vtkNPRDrawingStyle() = default;

//------------------------------------------------------------------------------
void vtkNPRDrawingStyle::SetWidth(const char* lineType, double millimetres)
{
  (*this->Internal)[lineType].Width = std::max(millimetres, 0.0);
  this->Modified();
}

double vtkNPRDrawingStyle::GetWidth(const char* lineType) const
{
  return this->GetInk(lineType ? lineType : "", false).Width;
}

void vtkNPRDrawingStyle::SetWidthInPoints(const char* lineType, double points)
{
  this->SetWidth(lineType, points * 25.4 / 72.0);
}

void vtkNPRDrawingStyle::SetColor(const char* lineType, double red, double green, double blue)
{
  (*this->Internal)[lineType].Color = { { red, green, blue } };
  this->Modified();
}

void vtkNPRDrawingStyle::SetOpacity(const char* lineType, double opacity)
{
  (*this->Internal)[lineType].Opacity = std::clamp(opacity, 0.0, 1.0);
  this->Modified();
}

void vtkNPRDrawingStyle::SetCap(const char* lineType, int cap)
{
  (*this->Internal)[lineType].Cap = std::clamp<int>(cap, BUTT_CAP, SQUARE_CAP);
  this->Modified();
}

void vtkNPRDrawingStyle::SetJoin(const char* lineType, int join)
{
  (*this->Internal)[lineType].Join = std::clamp<int>(join, MITER_JOIN, BEVEL_JOIN);
  this->Modified();
}

void vtkNPRDrawingStyle::SetTaper(const char* lineType, double share)
{
  (*this->Internal)[lineType].Taper = std::clamp(share, 0.0, 1.0);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkNPRDrawingStyle::SetDashes(
  const char* lineType, double dash, double gap, double secondDash, double secondGap)
{
  std::vector<double>& dashes = (*this->Internal)[lineType].Dashes;
  dashes.clear();
  if (dash > 0.0 && gap > 0.0)
  {
    dashes = { dash, gap };
  }
  if (!dashes.empty() && secondDash >= 0.0 && secondGap > 0.0)
  {
    dashes.insert(dashes.end(), { secondDash, secondGap });
  }
  this->Modified();
}

//------------------------------------------------------------------------------
npr::LineInk vtkNPRDrawingStyle::GetInk(const std::string& lineType, bool hidden) const
{
  const auto found = this->Internal->Inks.find(lineType);
  npr::LineInk ink = found != this->Internal->Inks.end() ? found->second : npr::LineInk();
  if (hidden)
  {
    ink.Width *= this->HiddenWidthFactor;
    ink.Opacity *= this->HiddenOpacity;
    ink.Taper = 1.0;
    ink.Dashes.clear();
    if (this->HiddenDashes[0] > 0.0 && this->HiddenDashes[1] > 0.0)
    {
      ink.Cap = npr::LineInk::BUTT_CAP;
      ink.Dashes = { this->HiddenDashes[0], this->HiddenDashes[1] };
    }
  }
  return ink;
}

//------------------------------------------------------------------------------
void vtkNPRDrawingStyle::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Name: " << this->Name << "\n";
  os << indent << "HiddenWidthFactor: " << this->HiddenWidthFactor << "\n";
  os << indent << "HiddenOpacity: " << this->HiddenOpacity << "\n";
  os << indent << "HiddenDashes: " << this->HiddenDashes[0] << " " << this->HiddenDashes[1] << "\n";
  for (const auto& line : this->Internal->Inks)
  {
    os << indent << line.first << ": " << line.second.Width << " mm\n";
  }
}
