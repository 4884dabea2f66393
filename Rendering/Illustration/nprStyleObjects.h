// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprStyleObjects.h
 * @brief From the names and numbers of a style document to the objects that they stand for.
 *
 * Nothing here knows any line type or shading style: the classes themselves say which names and
 * which parameters they take.
 */
#ifndef nprStyleObjects_h
#define nprStyleObjects_h

#include "nprStyleDocument.h"

#include <vtkSmartPointer.h>

#include <string>
#include <vector>

class vtkNPRLineDefinition;
class vtkNPRShadingStyle;

namespace npr
{
/// The colours as they are for "paper". @throws StyleError when no such style exists or it does not
/// take one of the parameters.
vtkSmartPointer<vtkNPRShadingStyle> MakeShadingStyle(const ShadingStyle& shading);

/// @throws StyleError, with the given path before the key.
vtkSmartPointer<vtkNPRLineDefinition> MakeLineDefinition(
  const LineStyle& line, const std::string& path);

/// Whether lines are made from curvature. @throws StyleError, as MakeLineDefinition().
bool NeedsCurvature(const LineStyle& line, const std::string& path);

/// The lines that are drawn, which are not optional.
std::vector<LineStyle> GetDrawnLines(const StyleDocument& document);

/// What the lines that are drawn are called, each otherwise. @throws StyleError
std::vector<std::string> GetLineNames(const StyleDocument& document);

/// What a word stands for as a parameter of a line: a text, or numbers parted by commas.
ParameterValue ParseLineParameter(
  const LineStyle& line, const std::string& name, const std::string& text);

/// True when surfaces are not shaded at all but take the colour of the paper.
bool IsPaper(const ShadingStyle& shading);

/// Whether surfaces go through the shading pass: as paper, for the sake of an outline.
bool NeedsShading(const StyleDocument& document);

/// Whether everything that the document names exists. @throws StyleError that names the key.
void CheckStyleNames(const StyleDocument& document);
}

#endif
