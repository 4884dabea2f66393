// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRSuggestiveHighlights.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkNPRSuggestiveHighlights);
