// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprFaceCurvature.h"

#include "nprFaceAverages.h"
#include "nprFaceFits.h"
#include "nprTangentFrame.h"

#include <vtkSMPTools.h>

#include <algorithm>
#include <utility>

namespace npr
{
namespace
{
/// A form over MakeTangent(normal) as a tensor in space.
Eigen::Matrix<float, 6, 1> MakeTensor(
  const QuadraticForm<float>& form, const Eigen::Vector3f& normal)
{
  const Eigen::Vector3f u = MakeTangent(normal);
  const Eigen::Vector3f v = normal.cross(u);
  const Eigen::Vector3f a = (form.Mean + form.Rest.Re) * u + form.Rest.Im * v;
  const Eigen::Vector3f b = form.Rest.Im * u + (form.Mean - form.Rest.Re) * v;
  Eigen::Matrix<float, 6, 1> tensor;
  tensor << a.x() * u.x() + b.x() * v.x(), a.y() * u.y() + b.y() * v.y(),
    a.z() * u.z() + b.z() * v.z(), a.x() * u.y() + b.x() * v.y(), a.y() * u.z() + b.y() * v.z(),
    a.x() * u.z() + b.x() * v.z();
  return tensor;
}
}

//------------------------------------------------------------------------------
CurvatureEstimate FaceCurvature::Estimate(const TriangleMesh& mesh, const Tuples<3>& normals,
  bool derivatives, const Progress& progress) const
{
  CurvatureEstimate estimate;
  if (!progress(0.0))
  {
    return estimate;
  }
  Tuples<4> forms;
  {
    // What the averages need most memory for is given back before the results take theirs.
    FaceAverages averages(mesh, normals);
    forms = averages.AverageForms();
    if (!progress(0.4))
    {
      return estimate;
    }
    if (derivatives)
    {
      estimate.Derivatives = averages.AverageDerivatives(forms);
    }
  }
  progress(0.9);
  estimate.Normals = normals;
  estimate.Tensors.resize(forms.size());
  estimate.Unknown.resize(forms.size());
  const float perUnit = 1.0f / mesh.GetUnit();
  vtkSMPTools::For(0, mesh.GetNumberOfPoints(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        estimate.Unknown[i] = !(forms[i][0] > 0.0f);
        estimate.Tensors[i] = perUnit * MakeTensor(ReadQuadratic(forms[i]), normals[i]);
        if (derivatives)
        {
          estimate.Derivatives[i] =
            perUnit * perUnit * GetComponents(ReadCubic(estimate.Derivatives[i]));
        }
      }
    });
  progress(1.0);
  return estimate;
}
//------------------------------------------------------------------------------
CurvatureEstimate FaceCurvature::EstimateAt(const std::vector<TriangleMesh::Index>& points,
  const TriangleMesh& mesh, const Tuples<3>& normals, bool derivatives) const
{
  using Index = TriangleMesh::Index;
  // The points of the part that is needed: those asked for, then ring by ring what is around.
  std::vector<Index> part = points;
  std::vector<Index> numbers(mesh.GetNumberOfPoints(), -1);
  for (std::size_t i = 0; i < part.size(); ++i)
  {
    numbers[part[i]] = static_cast<Index>(i);
  }
  std::vector<Index> faces;
  std::size_t first = 0;
  for (int ring = 0; ring < this->GetReach(); ++ring)
  {
    for (const std::size_t last = part.size(); first < last; ++first)
    {
      for (const Index* t = mesh.IncidentBegin(part[first]); t != mesh.IncidentEnd(part[first]);
           ++t)
      {
        faces.push_back(*t);
        for (const Index corner : mesh.GetTriangle(*t))
        {
          if (numbers[corner] < 0)
          {
            numbers[corner] = static_cast<Index>(part.size());
            part.push_back(corner);
          }
        }
      }
    }
  }
  // In the mesh's order, so that all is added up in the same.
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  std::vector<TriangleMesh::Vector> places(part.size());
  Tuples<3> partNormals(part.size());
  for (std::size_t i = 0; i < part.size(); ++i)
  {
    places[i] = mesh.GetPoint(part[i]);
    partNormals[i] = normals[part[i]];
  }
  std::vector<TriangleMesh::Triangle> triangles(faces.size());
  std::transform(faces.begin(), faces.end(), triangles.begin(),
    [&](Index face)
    {
      const TriangleMesh::Triangle& corners = mesh.GetTriangle(face);
      return TriangleMesh::Triangle{ numbers[corners[0]], numbers[corners[1]],
        numbers[corners[2]] };
    });
  TriangleMesh around(std::move(places), std::move(triangles), mesh.GetOrigin());
  around.BuildIncidence();
  CurvatureEstimate estimate = this->Estimate(around, partNormals, derivatives, IgnoreProgress);
  estimate.Normals.resize(points.size());
  estimate.Tensors.resize(points.size());
  estimate.Derivatives.resize(derivatives ? points.size() : 0);
  estimate.Unknown.resize(points.size());
  return estimate;
}
}
