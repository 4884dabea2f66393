// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRLevelLines.h"

#include "nprLineLevels.h"

#include <vtkSMPTools.h>

#include <cmath>
#include <sstream>

namespace
{
npr::FieldRange GetRange(const vtkNPRLevelLines& lines, const npr::LineSurface& surface)
{
  std::vector<float> field(surface.GetMesh().GetNumberOfPoints());
  vtkSMPTools::For(0, static_cast<vtkIdType>(field.size()),
    [&](vtkIdType begin, vtkIdType end)
    { lines.EvaluateField(surface, npr::LineView(), begin, end, field.data()); });
  return npr::GetFieldRange(surface, field.data());
}
}

//------------------------------------------------------------------------------
vtkNPRLevelLines::vtkNPRLevelLines(double levels) : Levels(levels)
{
  this->AddParameter("levels", "how many levels there are", this->Levels, 1.0, MaximumLevels);
  this->AddParameter("spacing",
    "the distance from level to level, in units of the input; 0 for so many levels", this->Spacing,
    0.0, VTK_DOUBLE_MAX);
}

//------------------------------------------------------------------------------
std::vector<float> vtkNPRLevelLines::GetLevels(const npr::LineSurface& surface) const
{
  const npr::FieldRange range = GetRange(*this, surface);
  return this->Spacing > 0.0
    ? npr::GetLevelsBySpacing(range, this->Spacing, this->GetLevelOffset(surface))
    : npr::GetLevelsByCount(range, static_cast<int>(std::round(this->Levels)));
}

//------------------------------------------------------------------------------
std::string vtkNPRLevelLines::FindError(const npr::LineSurface& surface) const
{
  if (this->Spacing > 0.0)
  {
    const npr::FieldRange range = GetRange(*this, surface);
    const double count =
      npr::CountLevelsBySpacing(range, this->Spacing, this->GetLevelOffset(surface));
    if (count > MaximumLevels)
    {
      std::ostringstream text;
      text << "a spacing of " << this->Spacing << " gives " << count
           << " levels over a range as long as " << range.Maximum - range.Minimum
           << "; there can be " << MaximumLevels << ", so make it larger";
      return text.str();
    }
  }
  return {};
}
