// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprChordErrors.h"

#include <vtkSMPTools.h>

#include <algorithm>

namespace npr
{
namespace
{
constexpr double LeastAgreement = 0.5; // cosine between the normals at the ends of a curve
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
          // Coordinates may be so large that their squares are no numbers in single precision.
          const Eigen::Vector3d chord =
            mesh.GetPoint(to).cast<double>() - mesh.GetPoint(from).cast<double>();
          const Eigen::Vector3d n0 = normals[from].cast<double>();
          const Eigen::Vector3d n1 = normals[to].cast<double>();
          if (n0.dot(n1) > LeastAgreement)
          {
            const double sum = (n0 + n1).norm(); // 2 for small angles
            const double error =
              (chord.dot(n1) * n1 - chord.dot(n0) * n0).norm() / (sum * (2.0 + sum));
            errors[t] = std::max(errors[t], static_cast<float>(error));
          }
        }
      }
    });
  return errors;
}
}
