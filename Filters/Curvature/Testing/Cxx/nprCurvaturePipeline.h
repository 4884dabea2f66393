// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprCurvaturePipeline.h
 * @brief From a mesh to its derivatives of curvature, and the errors against the truth.
 */
#ifndef nprCurvaturePipeline_h
#define nprCurvaturePipeline_h

#include "nprAnalyticSurfaces.h"
#include "nprArrayNames.h"
#include "nprCurvatureDerivatives.h"
#include "nprPointValues.h"
#include "vtkNPRCurvatureDerivatives.h"
#include "vtkNPRCurvatureTensor.h"
#include "vtkNPRSurfaceNormals.h"
#include "vtkNPRSurfacePreparation.h"

#include <algorithm>

namespace nprtest
{
struct Pipeline
{
  vtkNew<vtkNPRSurfacePreparation> Preparation;
  vtkNew<vtkNPRSurfaceNormals> Normals;
  vtkNew<vtkNPRCurvatureTensor> Tensor;
  vtkNew<vtkNPRCurvatureDerivatives> Derivatives;

  /// With the estimator that vtkNPRCurvatureDerivatives belongs to; see TestCurvatureJets for the
  /// default one.
  explicit Pipeline(vtkPolyData* mesh)
  {
    this->Tensor->SetEstimatorToPerFace();
    this->Preparation->SetInputData(mesh);
    this->Normals->SetInputConnection(this->Preparation->GetOutputPort());
    this->Tensor->SetInputConnection(this->Normals->GetOutputPort());
    this->Derivatives->SetInputConnection(this->Tensor->GetOutputPort());
  }
  vtkPolyData* Update()
  {
    this->Derivatives->Update();
    return this->Derivatives->GetOutput();
  }
};

/// All arrays that the filters make.
inline std::vector<const char*> GetArrayNames()
{
  return { npr::names::Normals, npr::names::CurvatureTensor, npr::names::PrincipalCurvature1,
    npr::names::PrincipalCurvature2, npr::names::PrincipalDirection1,
    npr::names::PrincipalDirection2, npr::names::MeanCurvature, npr::names::GaussianCurvature,
    npr::names::CurvatureDerivatives, npr::names::BorderPoints };
}

/// Errors at one point: of the normal, of the form (relative to the surface's largest curvature),
/// of the principal values against those of the true form, and of the cubic form.
struct Errors
{
  double Normal = 0.0;
  double Form = 0.0;
  double Principal = 0.0;
  double Direction = 0.0;
  double Cubic = 0.0;

  void Include(const Errors& other)
  {
    this->Normal = std::max(this->Normal, other.Normal);
    this->Form = std::max(this->Form, other.Form);
    this->Principal = std::max(this->Principal, other.Principal);
    this->Direction = std::max(this->Direction, other.Direction);
    this->Cubic = std::max(this->Cubic, other.Cubic);
  }
};

inline Errors GetErrors(vtkPolyData* surface, vtkIdType point, const Truth& truth)
{
  Errors errors;
  const Vector3d normal = GetTuple<3>(surface, npr::names::Normals, point);
  errors.Normal = (normal - truth.Normal).norm();
  const npr::SymmetricTensor tensor = GetTuple<6>(surface, npr::names::CurvatureTensor, point);
  errors.Form = (tensor - npr::FromFrame(truth.Form, truth.Frame)).norm();

  const double mean = 0.5 * (truth.Form[0] + truth.Form[2]);
  const double half = 0.5 * (truth.Form[0] - truth.Form[2]);
  const double radius = std::hypot(half, truth.Form[1]);
  double k1 = mean + radius;
  double k2 = mean - radius;
  double angle = 0.5 * std::atan2(truth.Form[1], half);
  if (std::abs(k1) < std::abs(k2))
  {
    std::swap(k1, k2);
    angle += 0.5 * Pi;
  }
  const double estimated1 = GetValue(surface, npr::names::PrincipalCurvature1, point);
  const double estimated2 = GetValue(surface, npr::names::PrincipalCurvature2, point);
  const Vector3d e1 = GetTuple<3>(surface, npr::names::PrincipalDirection1, point);
  // Near |k1| = |k2| either may come first: there only the tensor can be compared.
  if (std::abs(std::abs(k1) - std::abs(k2)) > 0.2 * std::abs(k1))
  {
    errors.Principal = std::max(std::abs(k1 - estimated1), std::abs(k2 - estimated2));
    const Vector3d direction = std::cos(angle) * truth.Frame.U + std::sin(angle) * truth.Frame.V;
    errors.Direction = e1.cross(direction).norm();
  }
  const npr::MinimalRotation rotation(normal, truth.Normal);
  const npr::TangentFrame own{ e1, normal.cross(e1) };
  const Vector4d cubic = npr::ChangeFrame(
    GetTuple<4>(surface, npr::names::CurvatureDerivatives, point), rotation(own), truth.Frame);
  errors.Cubic = (cubic - truth.Cubic).norm();
  return errors;
}
}

#endif
