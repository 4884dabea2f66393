// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPRShadingStyles
 * @brief The list of shading styles: creates one by its name.
 *
 * Style files, the command line and dialogues know styles by this list only.
 *
 * @sa vtkNPRShadingStyle
 */
#ifndef vtkNPRShadingStyles_h
#define vtkNPRShadingStyles_h

#include "vtkNPRRenderingShadingModule.h"
#include <vtkObject.h>

#include <string> // for names

class vtkNPRShadingStyle;

class VTKNPRRENDERINGSHADING_EXPORT vtkNPRShadingStyles : public vtkObject
{
public:
  static vtkNPRShadingStyles* New();
  vtkTypeMacro(vtkNPRShadingStyles, vtkObject);

  static int GetNumberOfStyles();
  /// Lower case. Null out of range.
  static const char* GetStyleName(int index);
  /// One line for help and dialogues. Null out of range.
  static const char* GetStyleDescription(int index);

  /**
   * A new style, which the caller owns, or null if there is none of this name.
   */
  VTK_NEWINSTANCE
  static vtkNPRShadingStyle* CreateStyle(const std::string& name);

protected:
  vtkNPRShadingStyles() = default;
  ~vtkNPRShadingStyles() override = default;

private:
  vtkNPRShadingStyles(const vtkNPRShadingStyles&) = delete;
  void operator=(const vtkNPRShadingStyles&) = delete;
};

#endif
