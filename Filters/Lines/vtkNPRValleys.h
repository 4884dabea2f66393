// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPRValleys
 * @brief Where a surface bends inwards more than anywhere else on the way across.
 *
 * The ridges of the surface seen from inside: the first principal curvature is below minus the
 * threshold and has a minimum along its own direction.
 *
 * @sa vtkNPRFeatureLines vtkNPRRidges
 */
#ifndef vtkNPRValleys_h
#define vtkNPRValleys_h

#include "vtkNPRRidges.h"

class VTKNPRFILTERSLINES_EXPORT vtkNPRValleys : public vtkNPRRidges
{
public:
  static vtkNPRValleys* New();
  vtkTypeMacro(vtkNPRValleys, vtkNPRRidges);

  const char* GetName() const override { return "valleys"; }
  const char* GetDescription() const override
  {
    return "where the surface bends inwards most on the way across";
  }

protected:
  vtkNPRValleys() = default;
  ~vtkNPRValleys() override = default;

  float GetSide() const override { return -1.0f; }

private:
  vtkNPRValleys(const vtkNPRValleys&) = delete;
  void operator=(const vtkNPRValleys&) = delete;
};

#endif
