// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprDrawingInks.h"

#include "nprStyleDocument.h"
#include "nprStyleObjects.h"
#include "vtkNPRDrawingStyle.h"
#include "vtkNPRStrokeMapper.h"

#include <vtkNew.h>

namespace npr
{
namespace
{
// Of hidden lines whose style says nothing; thousandths of the shorter side.
constexpr double HiddenDash = 8.0;
constexpr double HiddenGap = 4.0;

int GetJoin(int join)
{
  return join == vtkNPRStrokeMapper::MITRE_JOIN ? vtkNPRDrawingStyle::MITER_JOIN
    : join == vtkNPRStrokeMapper::BEVEL_JOIN    ? vtkNPRDrawingStyle::BEVEL_JOIN
                                                : vtkNPRDrawingStyle::ROUND_JOIN;
}
}

//------------------------------------------------------------------------------
void SetInks(const StyleDocument& document, double millimetresPerUnit, vtkNPRDrawingStyle* inks)
{
  const vtkNew<vtkNPRStrokeMapper> mapper; // knows how far lines taper
  const double mm = millimetresPerUnit;
  inks->SetName(document.Name);
  inks->SetHiddenDashes(mm * HiddenDash, mm * HiddenGap);
  const std::vector<LineStyle> lines = GetDrawnLines(document);
  const std::vector<std::string> names = GetLineNames(document);
  for (std::size_t i = lines.size(); i-- > 0;)
  {
    const LineStyle& line = lines[i];
    const StrokeStyle& stroke = line.Stroke;
    const char* const name = names[i].c_str();
    inks->SetWidth(name, mm * line.Width);
    inks->SetColor(name, line.Ink[0], line.Ink[1], line.Ink[2]);
    inks->SetOpacity(name, line.Opacity);
    inks->SetCap(name,
      stroke.Cap == vtkNPRStrokeMapper::BUTT_CAP ? vtkNPRDrawingStyle::BUTT_CAP
                                                 : vtkNPRDrawingStyle::ROUND_CAP);
    inks->SetJoin(name, GetJoin(stroke.Join));
    inks->SetTaper(name, line.Fade ? 0.0 : line.Taper ? mapper->GetMinimumWidthFactor() : 1.0);
    inks->SetDashes(name, mm * stroke.Dashes[0], mm * stroke.Dashes[1]);
    if (stroke.HiddenDashes[1] > 0.0)
    {
      inks->SetHiddenDashes(mm * stroke.HiddenDashes[0], mm * stroke.HiddenDashes[1]);
    }
    if (stroke.HiddenOpacity > 0.0)
    {
      inks->SetHiddenOpacity(stroke.HiddenOpacity);
    }
  }
}
}
