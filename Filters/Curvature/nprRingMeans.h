// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprRingMeans.h
 * @brief Means of what is known at the points of a mesh over the rings of triangles around them.
 */
#ifndef nprRingMeans_h
#define nprRingMeans_h

#include "nprForAll.h"
#include "nprTriangleMesh.h"

#include <vector>

namespace npr
{
/// Replaces the values at the points by the means over the corners of their triangles, so many
/// times: each reaches one ring further. 0 where there are no triangles.
inline void AverageOverRings(const TriangleMesh& mesh, int rings, std::vector<float>& values)
{
  using Index = TriangleMesh::Index;
  std::vector<float> means(values.size());
  for (int ring = 0; ring < rings; ++ring)
  {
    ForAll(values.size(),
      [&](Index point)
      {
        double sum = 0.0;
        for (const Index* t = mesh.IncidentBegin(point); t != mesh.IncidentEnd(point); ++t)
        {
          for (const Index corner : mesh.GetTriangle(*t))
          {
            sum += values[corner];
          }
        }
        const Index count = 3 * mesh.GetNumberOfIncident(point);
        means[point] = count > 0 ? static_cast<float>(sum / count) : 0.0f;
      });
    values.swap(means);
  }
}
}

#endif
