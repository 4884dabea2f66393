// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprOrientation.h"

#include <Eigen/Geometry>

#include <vector>

namespace npr
{
namespace
{
using Index = TriangleMesh::Index;
using Triangle = TriangleMesh::Triangle;
using Eigen::Vector3d;
}

//------------------------------------------------------------------------------
void OrientTriangles(TriangleMesh& mesh)
{
  const Index numberOfTriangles = mesh.GetNumberOfTriangles();
  std::vector<unsigned char> seen(numberOfTriangles, 0);
  std::vector<unsigned char> turned(numberOfTriangles, 0);
  std::vector<Index> component;
  for (Index seed = 0; seed < numberOfTriangles; ++seed)
  {
    if (seen[seed])
    {
      continue;
    }
    component.assign(1, seed);
    seen[seed] = 1;
    bool isClosed = true;
    std::size_t numberOfTurned = 0;
    double volume = 0.0;
    const Vector3d apex = mesh.GetPoint(mesh.GetTriangle(seed)[0]).cast<double>();
    for (std::size_t i = 0; i < component.size(); ++i)
    {
      const Index t = component[i];
      const Triangle corners = mesh.GetTriangle(t);
      numberOfTurned += turned[t];
      volume +=
        (mesh.GetPoint(corners[0]).cast<double>() - apex).dot(mesh.GetAreaNormal(t).cast<double>());
      for (int e = 0; e < 3; ++e)
      {
        const Index next = mesh.GetNeighbour(t, e);
        if (next < 0)
        {
          isClosed = false;
        }
        else if (!seen[next])
        {
          seen[next] = 1;
          component.push_back(next);
          const Triangle& other = mesh.GetTriangle(next);
          for (int o = 0; o < 3; ++o)
          {
            if (other[o] == corners[e] && other[(o + 1) % 3] == corners[(e + 1) % 3])
            {
              turned[next] = 1;
              mesh.Flip(next);
              break;
            }
          }
        }
      }
    }
    const bool turnAll =
      isClosed && volume != 0.0 ? volume < 0.0 : 2 * numberOfTurned > component.size();
    if (turnAll)
    {
      for (Index t : component)
      {
        mesh.Flip(t);
      }
    }
  }
}
}
