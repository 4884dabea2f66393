// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprPagePath.h
 * @brief A path on paper: straight and cubic pieces, as SVG and PDF have them.
 */
#ifndef nprPagePath_h
#define nprPagePath_h

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace npr
{
/// A place on the page or a direction there; millimetres from its upper left corner, y down.
using PagePoint = Eigen::Vector2d;

/**
 * @class PagePath
 * @brief Commands and their points, in two arrays: millions of short paths cost little.
 */
class PagePath
{
public:
  enum Command : unsigned char
  {
    MOVE,  // 1 point
    LINE,  // 1 point
    CURVE, // 3 points: two controls and the end
    CLOSE  // none
  };
  static constexpr int GetNumberOfPoints(Command command)
  {
    return command == CURVE ? 3 : command == CLOSE ? 0 : 1;
  }

  void MoveTo(const PagePoint& point) { this->Add(MOVE, point); }
  void LineTo(const PagePoint& point) { this->Add(LINE, point); }
  void CurveTo(const PagePoint& control1, const PagePoint& control2, const PagePoint& end)
  {
    this->Commands.push_back(CURVE);
    this->Points.insert(this->Points.end(), { control1, control2, end });
  }
  void Close() { this->Commands.push_back(CLOSE); }

  std::vector<Command> Commands;
  std::vector<PagePoint> Points;

private:
  void Add(Command command, const PagePoint& point)
  {
    this->Commands.push_back(command);
    this->Points.push_back(point);
  }
};
}

#endif
