// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// What the stroke mapper tells its shaders.
#include "vtkNPRStrokeMapper.h"

#include "nprInkArea.h"
#include "nprStrokeGraphics.h"

#include <vtkActor.h>
#include <vtkBoundingBox.h>
#include <vtkMath.h>
#include <vtkMatrix3x3.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkOpenGLCamera.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkPlaneCollection.h>
#include <vtkRenderer.h>
#include <vtkShaderProgram.h>

#include <algorithm>
#include <array>
#include <cmath>

//------------------------------------------------------------------------------
npr::InkArea vtkNPRStrokeMapper::SetUniforms(
  vtkRenderer* renderer, vtkActor* actor, vtkShaderProgram* program, const int viewport[4])
{
  const npr::StrokeRecords& records = this->Graphics->GetRecords();
  vtkMatrix4x4* worldToView;
  vtkMatrix3x3* normals;
  vtkMatrix4x4* projection; // transposed, as all that VTK hands to shaders
  vtkMatrix4x4* worldToDevice;
  vtkOpenGLCamera::SafeDownCast(renderer->GetActiveCamera())
    ->GetKeyMatrices(renderer, worldToView, normals, projection, worldToDevice);
  vtkNew<vtkMatrix4x4> matrix;
  for (int i = 0; i < 3; ++i)
  {
    matrix->SetElement(i, 3, records.Origin[i]);
  }
  vtkMatrix4x4::Multiply4x4(actor->GetMatrix(), matrix, matrix);
  matrix->Transpose();
  vtkMatrix4x4::Multiply4x4(matrix, worldToDevice, matrix);
  program->SetUniformMatrix("nprMCDCMatrix", matrix);

  this->SetClippingUniforms(actor, program);

  const float size[2] = { static_cast<float>(viewport[2]), static_cast<float>(viewport[3]) };
  program->SetUniform2f("nprViewportSize", size);
  program->SetUniformf("nprWidth", static_cast<float>(this->Width));
  program->SetUniformi("nprUseWidths", this->UseWidthArray);
  program->SetUniformf("nprMinimumWidthFactor",
    this->StrengthToWidth ? static_cast<float>(this->MinimumWidthFactor) : 1.0f);
  program->SetUniformf("nprMinimumOpacityFactor", this->StrengthToOpacity ? 0.0f : 1.0f);
  program->SetUniformi("nprUseOpacities", this->UseOpacityArray);

  const float depthProjection[4] = { static_cast<float>(projection->GetElement(2, 2)),
    static_cast<float>(projection->GetElement(3, 2)),
    static_cast<float>(projection->GetElement(2, 3)),
    static_cast<float>(projection->GetElement(3, 3)) };
  program->SetUniform4f("nprDepthProjection", depthProjection);
  const double pixelScale = 2.0 / (projection->GetElement(1, 1) * viewport[3]);
  program->SetUniformf("nprPixelScale", static_cast<float>(pixelScale));
  program->SetUniformf(
    "nprWorldPixel", this->WidthUnit == WORLD ? static_cast<float>(pixelScale) : 0.0f);
  double widest = this->Width * (this->UseWidthArray ? records.MaximumWidth : 1.0f);
  if (this->WidthUnit == WORLD)
  {
    vtkCamera* camera = renderer->GetActiveCamera();
    widest /= pixelScale * (camera->GetParallelProjection() ? 1.0 : camera->GetClippingRange()[0]);
  }
  const double mitre = this->Join == MITRE_JOIN ? this->MitreLimit : 1.0;
  const double guard = std::min(0.5 * widest * mitre, 4.0 * std::max(size[0], size[1])) + 2.0;
  program->SetUniformf("nprGuard", static_cast<float>(guard));
  const vtkBoundingBox box(actor->GetBounds());
  program->SetUniformf("nprTolerance", static_cast<float>(this->DepthTolerance));
  program->SetUniformf(
    "nprModelSize", static_cast<float>(box.IsValid() ? box.GetDiagonalLength() : 0.0));
  program->SetUniformf("nprVisibilityRadius", static_cast<float>(this->VisibilityRadius));
  program->SetUniformi("nprVisibilitySamples", 17);
  program->SetUniformi("nprUseHidingLayers", this->UseHidingLayers);
  program->SetUniformf("nprHiddenOpacity", static_cast<float>(this->HiddenOpacity));
  if (this->IsStyled())
  {
    this->Graphics->UploadPageLengths(matrix, size);
    this->SetStyleUniforms(actor, program, viewport);
  }
  const double reach = std::max(guard, this->VisibilityRadius + 2.0);
  return this->Graphics->AreCurvesEvaluated() ? npr::FindInkBounds(records, matrix, size, reach)
                                              : npr::FindInkArea(records, matrix, size, reach);
}

//------------------------------------------------------------------------------
void vtkNPRStrokeMapper::SetStyleUniforms(
  vtkActor* actor, vtkShaderProgram* program, const int viewport[4])
{
  program->SetUniformi("nprCap", this->Cap);
  program->SetUniformi("nprJoin", this->Join);
  program->SetUniformf("nprMitreLimit", static_cast<float>(this->MitreLimit));
  const double reach = this->Join == MITRE_JOIN
    ? std::sqrt(std::max(this->MitreLimit * this->MitreLimit - 1.0, 0.0))
    : 0.0;
  program->SetUniformf("nprMitreReach", static_cast<float>(std::max(reach, 1.0)));
  const auto setDashes = [program](const char* name, const double dashes[2])
  {
    const float values[2] = { static_cast<float>(std::max(dashes[0], 0.0)),
      static_cast<float>(std::max(dashes[1], 0.0)) };
    program->SetUniform2f(name, values);
  };
  setDashes("nprDashes", this->Dashes);
  setDashes("nprHiddenDashes", this->HiddenDashes);
  const double scale = std::cbrt(std::abs(actor->GetMatrix()->Determinant()));
  program->SetUniformf("nprDashScale", this->DashUnit == WORLD ? static_cast<float>(scale) : 0.0f);
  // Strokes are picked where the pen went, also between the grains that it left.
  const bool picked = program->IsUniformUsed("nprPickedColor");
  program->SetUniformi("nprMedium", picked ? static_cast<int>(INK) : this->Medium);
  program->SetUniformf("nprPaperGrain", picked ? 0.0f : static_cast<float>(this->PaperGrain));
  program->SetUniformf("nprGrainSize", static_cast<float>(this->GrainSize));
  program->SetUniformi("nprSeed", this->Seed);
  // A tile is a part of the page.
  vtkOpenGLRenderWindow* window = this->Graphics->GetWindow();
  float origin[2];
  for (int i = 0; i < 2; ++i)
  {
    origin[i] = static_cast<float>(
      std::round(window->GetTileViewport()[i] * window->GetSize()[i]) + viewport[i]);
  }
  program->SetUniform2f("nprPageOrigin", origin);
}

//------------------------------------------------------------------------------

void vtkNPRStrokeMapper::SetClippingUniforms(vtkActor* actor, vtkShaderProgram* program)
{
  constexpr int maximum = 6; // as many as VTK's own mappers
  const std::array<double, 3>& origin = this->Graphics->GetRecords().Origin;
  const int wanted = this->ClippingPlanes ? this->ClippingPlanes->GetNumberOfItems() : 0;
  if (wanted > maximum)
  {
    vtkErrorMacro("There are " << wanted << " clipping planes; the first " << maximum
                               << " are used. Remove the others.");
  }
  const int count = std::min(wanted, maximum);
  float planes[maximum][4] = {};
  for (int i = 0; i < count; ++i)
  {
    double plane[4];
    this->GetClippingPlaneInDataCoords(actor->GetMatrix(), i, plane);
    plane[3] += vtkMath::Dot(plane, origin.data());
    std::copy_n(plane, 4, planes[i]);
  }
  program->SetUniformi("nprNumberOfClippingPlanes", count);
  program->SetUniform4fv("nprClippingPlanes", maximum, planes);
}
