// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprCurvaturePicture.h
 * @brief Pictures of what vtkNPRCurvatureTensor says about a surface.
 */
#ifndef nprCurvaturePicture_h
#define nprCurvaturePicture_h

#include <string>
#include <vector>

class vtkPolyData;

namespace npr
{
struct ModelOptions;
class Reporter;
struct ViewOptions;

/// What can be shown, by the names that users write.
std::vector<std::string> GetPictureNames();

/// Draw a surface that has all arrays of vtkNPRCurvatureTensor, and write the image.
void DrawCurvature(vtkPolyData* surface, const std::string& what, const ViewOptions& view,
  const ModelOptions& models, const std::string& file, Reporter& reporter);
}

#endif
