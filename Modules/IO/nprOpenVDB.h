// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprOpenVDB.h
 * @brief OpenVDB's headers, as they must be included where symbols are hidden by default.
 *
 * OpenVDB's templates hold static data, such as the name of a tree's type, that libopenvdb sets
 * through functions of namespace std, which are never hidden. If our copy of the data is hidden and
 * our copy of the function is not, then libopenvdb calls ours, which sets ours, and its own stays
 * null: openvdb::initialize() crashes. So nothing of OpenVDB is hidden.
 */
#ifndef nprOpenVDB_h
#define nprOpenVDB_h

#if defined(__GNUC__)
#pragma GCC visibility push(default)
#endif

#include <openvdb/openvdb.h>
#include <openvdb/tools/Dense.h>

#if defined(__GNUC__)
#pragma GCC visibility pop
#endif

#endif
