// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprChordErrors.h"

#include <vtkSMPTools.h>

#include <algorithm>

namespace npr
{
namespace
{
constexpr float LeastAgreement = 0.5f; // cosine between the normals at the ends of a curve
}

//------------------------------------------------------------------------------
std::vector<float> MeasureChordErrors(const TriangleMesh& mesh, const Tuples<3>& normals)
{
  using Index = TriangleMesh::Index;
  std::vector<float> errors(mesh.GetNumberOfTriangles(), 0.0f);
  vtkSMPTools::For(0, mesh.GetNumberOfTriangles(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (auto t = static_cast<Index>(begin); t < end; ++t)
      {
        const TriangleMesh::Triangle& corners = mesh.GetTriangle(t);
        for (int e = 0; e < 3; ++e)
        {
          const Index from = corners[e];
          const Index to = corners[(e + 1) % 3];
          const TriangleMesh::Vector chord = mesh.GetPoint(to) - mesh.GetPoint(from);
          const auto& n0 = normals[from];
          const auto& n1 = normals[to];
          if (n0.dot(n1) > LeastAgreement)
          {
            const float sum = (n0 + n1).norm(); // 2 for small angles
            const float error =
              (chord.dot(n1) * n1 - chord.dot(n0) * n0).norm() / (sum * (2.0f + sum));
            errors[t] = std::max(errors[t], error);
          }
        }
      }
    });
  return errors;
}
}
