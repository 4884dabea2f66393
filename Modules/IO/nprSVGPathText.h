// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprSVGPathText.h
 * @brief Path data of SVG in few characters.
 */
#ifndef nprSVGPathText_h
#define nprSVGPathText_h

#include "nprPagePath.h"

#include <cstddef>
#include <string>

namespace npr
{
/**
 * @class SVGPathText
 * @brief Writes paths with places in whole multiples of a power of ten, each relative to the last.
 *
 * Places are rounded before they are subtracted, so that errors don't add up.
 */
class SVGPathText
{
public:
  /// Places are rounded to so many decimals, 0 to 9.
  SVGPathText(int decimals, std::string& text);

  /// Appends path data for the commands and points from one place of the path to another.
  void Add(const PagePath& path, std::size_t command, std::size_t commandEnd, std::size_t point);

private:
  using Place = Eigen::Matrix<long long, 2, 1>;

  Place Round(const PagePoint& point) const;
  void AddCommand(char command);
  void AddPlace(const Place& place);
  void AddNumber(long long number);

  int Decimals;
  long long Unit;
  std::string& Text;
  Place Last = Place::Zero();
  char LastCommand = 0;
  bool AfterNumber = false; // the last character belongs to a number
  bool AfterPoint = false;  // which has a decimal point
};
}

#endif
