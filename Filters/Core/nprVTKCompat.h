// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprVTKCompat.h
 * @brief The one place where differences between VTK 9.1 and later versions are met.
 */
#ifndef nprVTKCompat_h
#define nprVTKCompat_h

#include <vtkVersionMacros.h>

// VTK 9.3 brought a namespace for its symbols; forward declarations must stand inside it.
#ifndef VTK_ABI_NAMESPACE_BEGIN
#define VTK_ABI_NAMESPACE_BEGIN
#define VTK_ABI_NAMESPACE_END
#endif

#define NPR_VTK_AT_LEAST(major, minor) \
  (VTK_MAJOR_VERSION > (major) || (VTK_MAJOR_VERSION == (major) && VTK_MINOR_VERSION >= (minor)))

#endif
