// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprPageComposer.h
 * @brief From strokes in the world, a camera and a page to the finished drawing.
 */
#ifndef nprPageComposer_h
#define nprPageComposer_h

#include "nprPageDrawing.h"

#include <stdexcept>
#include <string>
#include <vector>

class vtkCamera;
class vtkImageData;
class vtkNPRDrawingStyle;
class vtkPolyData;

namespace npr
{
/// Why there can be no drawing: what, where, and what to do.
class DrawingError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

enum class PageFit
{
  Viewport,
  Strokes,
  TrueScale
};

enum class HiddenLines
{
  None,
  Dashed,
  Shown
};

struct PageRequest
{
  vtkCamera* Camera = nullptr;
  int Viewport[2] = { 0, 0 };    // pixels
  double Size[2] = { 0.0, 0.0 }; // millimetres
  double Margin = 0.0;           // millimetres
  PageFit Fit = PageFit::Viewport;
  double MillimetresPerUnit = 1.0; // of the world
  double Scale = 1.0;              // paper to world
  bool ScaleBar = false;
  std::string UnitName;
  HiddenLines Hidden = HiddenLines::None;
  double Tolerance = 0.02;   // millimetres
  double CornerAngle = 45.0; // degrees
  vtkNPRDrawingStyle* Style = nullptr;
  vtkImageData* Image = nullptr;
  vtkImageData* Tones = nullptr;
  std::string Title;
  std::string Date;
};

/// Throws DrawingError. Warnings are appended.
PageDrawing ComposePage(
  const PageRequest& request, vtkPolyData* strokes, std::vector<std::string>& warnings);
}

#endif
