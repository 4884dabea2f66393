// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprBuiltInStyles.h
 * @brief The style files in Styles/, compiled into the library.
 */
#ifndef nprBuiltInStyles_h
#define nprBuiltInStyles_h

#include <vector>

namespace npr
{
struct BuiltInStyle
{
  const char* Name;
  const char* Json;
};

/// In the order in which they are shown to people.
const std::vector<BuiltInStyle>& GetBuiltInStyles();
}

#endif
