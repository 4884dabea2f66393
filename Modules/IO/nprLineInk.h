// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprLineInk.h
 * @brief How lines of one kind look on paper.
 */
#ifndef nprLineInk_h
#define nprLineInk_h

#include <array>
#include <vector>

namespace npr
{
struct LineInk
{
  enum Caps
  {
    BUTT_CAP,
    ROUND_CAP,
    SQUARE_CAP
  };
  enum Joins
  {
    MITER_JOIN,
    ROUND_JOIN,
    BEVEL_JOIN
  };

  double Width = 0.25;                                 // millimetres
  std::array<double, 3> Color = { { 0.0, 0.0, 0.0 } }; // [0, 1]
  double Opacity = 1.0;                                // [0, 1]
  int Cap = ROUND_CAP;
  int Join = ROUND_JOIN;
  double Taper = 1.0;         // the share of the width that is left where Strength is 0; 1: none
  std::vector<double> Dashes; // lengths of dash, gap, dash ...; millimetres; none: solid
};
}

#endif
