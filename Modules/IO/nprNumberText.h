// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprNumberText.h
 * @brief Numbers as text, the same in every locale.
 */
#ifndef nprNumberText_h
#define nprNumberText_h

#include <charconv>
#include <string>

namespace npr
{
/// With at most so many significant digits.
inline std::string NumberText(double value, int digits = 6)
{
  char text[32];
  const auto end =
    std::to_chars(text, text + sizeof(text), value, std::chars_format::general, digits).ptr;
  return std::string(text, end);
}
}

#endif
