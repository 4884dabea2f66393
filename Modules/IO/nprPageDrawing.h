// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprPageDrawing.h
 * @brief A finished drawing on a page: what every writer of drawings writes, and nothing else.
 *
 * All lengths are millimetres, from the upper left corner of the page, y down.
 */
#ifndef nprPageDrawing_h
#define nprPageDrawing_h

#include "nprLineInk.h"
#include "nprPagePath.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace npr
{
struct PageRectangle
{
  PagePoint Least = PagePoint::Zero();
  PagePoint Most = PagePoint::Zero();
  PagePoint GetSize() const { return this->Most - this->Least; }
};

/// A stroke, which ends before these places of its layer's path. A filled one is an outline
/// (nonzero rule), another a line of the layer's width.
struct PageShape
{
  std::size_t CommandEnd;
  std::size_t PointEnd;
  bool Filled;
};

struct PageText
{
  PagePoint Middle; // of its base line
  double Height;    // of the font
  std::string Text;
};

/// Strokes of one look. Where they overlap, translucent ones are not darker.
struct PageLayer
{
  std::string Name;
  LineInk Ink;
  PagePath Path;
  std::vector<PageShape> Shapes;
  std::vector<PageText> Texts;
};

/// An area of one colour, filled by the even-odd rule.
struct PageTone
{
  std::array<double, 3> Color;
  PagePath Path;
};

/// Names of the layers below all strokes.
///@{
constexpr const char* ImageLayerName = "shading";
constexpr const char* TonesLayerName = "tones";
///@}

struct PageDrawing
{
  double Width = 0.0;
  double Height = 0.0;
  PageRectangle Area; // what is drawn on; an image and tones end there
  std::string Title;
  std::string Date;                                       // ISO 8601; none if empty
  std::vector<std::pair<std::string, std::string>> Facts; // such as the scale and the camera
  vtkSmartPointer<vtkImageData> Image;                    // below all layers; may be null
  PageRectangle ImagePlace;
  std::vector<PageTone> Tones;   // above the image, the first one lowest
  std::vector<PageLayer> Layers; // the first one lowest
  double Resolution = 0.001;     // places need not be told more finely

  /// What of the picture is drawn on.
  PageRectangle GetPictureArea() const
  {
    return { this->Area.Least.cwiseMax(this->ImagePlace.Least),
      this->Area.Most.cwiseMin(this->ImagePlace.Most) };
  }
};
}

#endif
