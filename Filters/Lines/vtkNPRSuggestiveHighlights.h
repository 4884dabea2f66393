// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPRSuggestiveHighlights
 * @brief Where a highlight along a crest is about to appear: the bright siblings of suggestive
 * contours.
 *
 * The other part of the zero set of the radial curvature kr: where its derivative towards the eye,
 * dwkr, is below minus the threshold. Seen under a light at the eye, suggestive contours follow the
 * valleys of the shading and these lines its crests, so they are mostly drawn white on grey.
 *
 * Source: D. DeCarlo, S. Rusinkiewicz, "Highlight lines for conveying shape", NPAR 2007.
 *
 * @sa vtkNPRFeatureLines vtkNPRSuggestiveContours
 */
#ifndef vtkNPRSuggestiveHighlights_h
#define vtkNPRSuggestiveHighlights_h

#include "vtkNPRSuggestiveContours.h"

class VTKNPRFILTERSLINES_EXPORT vtkNPRSuggestiveHighlights : public vtkNPRSuggestiveContours
{
public:
  static vtkNPRSuggestiveHighlights* New();
  vtkTypeMacro(vtkNPRSuggestiveHighlights, vtkNPRSuggestiveContours);

  const char* GetName() const override { return "suggestive-highlights"; }
  const char* GetDescription() const override
  {
    return "crests of the light at the eye: drawn white on grey";
  }

protected:
  vtkNPRSuggestiveHighlights() = default;
  ~vtkNPRSuggestiveHighlights() override = default;

  double GetSide() const override { return -1.0; }

private:
  vtkNPRSuggestiveHighlights(const vtkNPRSuggestiveHighlights&) = delete;
  void operator=(const vtkNPRSuggestiveHighlights&) = delete;
};

#endif
