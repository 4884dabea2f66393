// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprCurveEvaluation.h"

#include "nprStrokeCurves.h"
#include "vtkNPRStrokeCurveVS.h"

#include <vtkNew.h>
#include <vtkOpenGLBufferObject.h>
#include <vtkOpenGLError.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLShaderCache.h>
#include <vtkOpenGLVertexArrayObject.h>
#include <vtkShaderProgram.h>
#include <vtkTextureObject.h>
#include <vtkTransformFeedback.h>

#include <cstddef>
#include <string>

namespace npr
{
namespace
{
const char* const NoFragments = R"(//VTK::System::Dec
//VTK::Output::Dec
void main()
{
  gl_FragData[0] = vec4(0.0);
}
)";

/// What the shader writes: programs that differ in it are linked again, so all share one.
vtkTransformFeedback* GetCapture(bool colors)
{
  static const vtkNew<vtkTransformFeedback> records;
  static const vtkNew<vtkTransformFeedback> ofColors;
  if (records->GetVaryings().empty())
  {
    records->AddVarying(vtkTransformFeedback::Vertex_ClipCoordinate_F, "nprPlaceVSOut");
    records->AddVarying(vtkTransformFeedback::Color_RGBA_F, "nprMoreVSOut");
    ofColors->AddVarying(vtkTransformFeedback::Color_RGBA_F, "nprColorVSOut");
  }
  return colors ? ofColors : records;
}

void SetBasis(const SplineBasis& basis, vtkShaderProgram* program)
{
  float columns[16]; // column k: the weights in the coefficient of t^k
  for (int k = 0; k < 4; ++k)
  {
    for (int j = 0; j < 4; ++j)
    {
      columns[4 * k + j] = static_cast<float>(basis[k][j]);
    }
  }
  program->SetUniformMatrix4x4("nprBasis", columns);
}

/// One run of the shader over all points, into a buffer.
bool Capture(const StrokeCurves& curves, vtkOpenGLRenderWindow* window,
  vtkOpenGLBufferObject* points, vtkTextureObject* controls, bool colors, vtkOpenGLBufferObject* to)
{
  std::string vertex = vtkNPRStrokeCurveVS;
  vtkShaderProgram::Substitute(
    vertex, "//NPR::Variant::Dec", colors ? "#define NPR_COLORED\n" : "");
  vtkTransformFeedback* const capture = GetCapture(colors);
  vtkShaderProgram* const program =
    window->GetShaderCache()->ReadyShaderProgram(vertex.c_str(), NoFragments, "", capture);
  if (!program)
  {
    return false;
  }
  const auto count = static_cast<GLsizei>(curves.Points.size());
  to->GenerateBuffer(vtkOpenGLBufferObject::TextureBuffer);
  const auto handle = static_cast<GLuint>(to->GetHandle());
  glBindBuffer(GL_TRANSFORM_FEEDBACK_BUFFER, handle);
  glBufferData(GL_TRANSFORM_FEEDBACK_BUFFER,
    static_cast<GLsizeiptr>(curves.Points.size() * capture->GetBytesPerVertex()), nullptr,
    GL_STATIC_DRAW);
  vtkNew<vtkOpenGLVertexArrayObject> array;
  array->Bind();
  array->AddAttributeArray(
    program, points, "nprCurvePoint", 0, sizeof(CurvePoint), VTK_FLOAT, 3, false);
  SetBasis(curves.Basis, program);
  controls->Activate();
  program->SetUniformi("nprControls", controls->GetTextureUnit());
  glEnable(GL_RASTERIZER_DISCARD);
  glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, handle);
  glBeginTransformFeedback(GL_POINTS);
  glDrawArrays(GL_POINTS, 0, count);
  glEndTransformFeedback();
  glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
  glDisable(GL_RASTERIZER_DISCARD);
  controls->Deactivate();
  array->Release();
  array->ReleaseGraphicsResources();
  return true;
}
}

//------------------------------------------------------------------------------
bool EvaluateCurves(const StrokeCurves& curves, vtkOpenGLRenderWindow* window,
  vtkOpenGLBufferObject* records, vtkOpenGLBufferObject* colors)
{
  const std::vector<StrokeRecord>& controls = curves.Strokes.Records;
  vtkNew<vtkOpenGLBufferObject> points;
  points->Upload(
    &curves.Points[0].Span, 3 * curves.Points.size(), vtkOpenGLBufferObject::ArrayBuffer);
  vtkNew<vtkOpenGLBufferObject> buffer;
  vtkNew<vtkTextureObject> texture;
  texture->SetContext(window);
  const std::size_t floats = sizeof(StrokeRecord) / sizeof(float);
  buffer->Upload(
    controls[0].Position, floats * controls.size(), vtkOpenGLBufferObject::TextureBuffer);
  texture->CreateTextureBuffer(
    static_cast<unsigned int>(floats * controls.size() / 4), 4, VTK_FLOAT, buffer);
  bool compiled = Capture(curves, window, points, texture, false, records);
  if (compiled && !curves.Strokes.Colors.empty())
  {
    buffer->Upload(curves.Strokes.Colors, vtkOpenGLBufferObject::TextureBuffer);
    texture->ResetFormatAndType();
    texture->CreateTextureBuffer(
      static_cast<unsigned int>(controls.size()), 4, VTK_UNSIGNED_CHAR, buffer);
    compiled = Capture(curves, window, points, texture, true, colors);
  }
  texture->ReleaseGraphicsResources(window);
  buffer->ReleaseGraphicsResources();
  points->ReleaseGraphicsResources();
  return compiled;
}
}
