// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprForAll_h
#define nprForAll_h

#include "nprTriangleMesh.h"

#include <vtkSMPTools.h>
#include <vtkType.h>

#include <cstddef>

namespace npr
{
/// Calls function(i) for all indices below a size, in parallel.
template<typename Function>
void ForAll(std::size_t size, const Function& function)
{
  vtkSMPTools::For(0, static_cast<vtkIdType>(size),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        function(static_cast<TriangleMesh::Index>(i));
      }
    });
}
}

#endif
