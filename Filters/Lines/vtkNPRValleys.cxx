// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRValleys.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkNPRValleys);
