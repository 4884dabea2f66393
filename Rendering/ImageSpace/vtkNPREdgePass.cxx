// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPREdgePass.h"

#include "nprEdgeBuffers.h"
#include "vtkNPREdgeBlocksFS.h"
#include "vtkNPREdgeDetectFS.h"
#include "vtkNPREdgeFitFS.h"
#include "vtkNPREdgeInkFS.h"
#include "vtkNPREdgeLinkFS.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkMath.h>
#include <vtkMatrix4x4.h>
#include <vtkObjectFactory.h>
#include <vtkOpaquePass.h>
#include <vtkOpenGLError.h>
#include <vtkOpenGLPolyDataMapper.h>
#include <vtkOpenGLQuadHelper.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLShaderCache.h>
#include <vtkOpenGLState.h>
#include <vtkRenderState.h>
#include <vtkRenderer.h>
#include <vtkShaderProgram.h>
#include <vtkWeakPointer.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <unordered_map>
#include <vector>

vtkStandardNewMacro(vtkNPREdgePass);

namespace
{
// Where our code goes; put in before the mapper fills its tags, replaced after.
const char* const DeclarationTag = "//NPR::Edges::Dec\n";
const char* const ImplementationTag = "//NPR::Edges::Impl\n";

// At the middle of a pixel that a triangle covers only partly, its depth and normal are
// extrapolated far where it is seen at a grazing angle; at the centroid they are its own.
const char* const VertexDeclaration = R"(
centroid out vec4 nprEdgePlace;
centroid out vec3 nprEdgeNormal;
)";
const char* const VertexImplementation = R"(
  nprEdgePlace = gl_Position;
  nprEdgeNormal = NPR_EDGE_NORMAL;
)";
const char* const FragmentDeclaration = R"(
centroid in vec4 nprEdgePlace;
centroid in vec3 nprEdgeNormal;
uniform float nprEdgeObject;
uniform vec3 nprEdgeRange; // of clip coordinates: dot(nprEdgeRange, (z, w, 1)) is the distance
)";
const char* const FragmentImplementation = R"(
  {
    vec3 nprNormal = NPR_EDGE_NORMAL;
    gl_FragData[1] = vec4(nprNormal.xy / max(1.0 + nprNormal.z, 0.001),
      dot(nprEdgeRange, vec3(nprEdgePlace.zw, 1.0)), NPR_EDGE_OBJECT);
  }
)";
const char* const SmoothNormal = "(gl_FrontFacing ? 1.0 : -1.0) * normalize(nprEdgeNormal)";
// With shaders that make lines wide nothing more can be passed on.
const char* const PlainDeclaration = "uniform float nprEdgeObject;\n";
const char* const PlainImplementation = "  gl_FragData[1] = vec4(0.0, 0.0, 0.0, -nprEdgeObject);\n";

struct View
{
  int Viewport[4]; // x, y, width, height
  bool IsParallel = false;
  double Distance = 1.0;
  float Ray[4];
  float Range[3];

  explicit View(vtkRenderer* renderer)
  {
    renderer->GetTiledSizeAndOrigin(
      &this->Viewport[2], &this->Viewport[3], &this->Viewport[0], &this->Viewport[1]);
    vtkCamera* camera = renderer->GetActiveCamera();
    this->IsParallel = camera->GetParallelProjection() != 0;
    this->Distance = camera->GetParallelScale() /
      std::tan(0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle()));
    vtkMatrix4x4* matrix =
      camera->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1.0, 1.0);
    const auto at = [matrix](int row, int column) { return matrix->GetElement(row, column); };
    // Of clip coordinates to the view: x = (X w - m02 z - m03) / m00, where z = -distance, and w is
    // the distance or 1.
    for (int i = 0; i < 2; ++i)
    {
      this->Ray[i] = static_cast<float>(1.0 / at(i, i));
      this->Ray[i + 2] = static_cast<float>((this->IsParallel ? -at(i, 3) : at(i, 2)) / at(i, i));
    }
    const double scale = at(2, 2);
    const double range[2][3] = { { 0.0, 1.0, 0.0 }, { -1.0 / scale, 0.0, at(2, 3) / scale } };
    std::copy_n(range[this->IsParallel], 3, this->Range);
  }
};

void Draw(vtkOpenGLRenderWindow* window, std::unique_ptr<vtkOpenGLQuadHelper>& quad,
  const std::string& code, const std::function<void(vtkShaderProgram*)>& setUniforms)
{
  if (!quad)
  {
    quad = std::make_unique<vtkOpenGLQuadHelper>(window, nullptr, code.c_str(), "");
  }
  else
  {
    window->GetShaderCache()->ReadyShaderProgram(quad->Program);
  }
  if (quad->Program && quad->Program->GetCompiled())
  {
    setUniforms(quad->Program);
    quad->Render();
  }
}
}

//------------------------------------------------------------------------------
class vtkNPREdgePass::Internals
{
public:
  void Release(vtkWindow* window)
  {
    this->Buffers.ReleaseGraphicsResources(window);
    this->Detect.reset();
    this->DetectMultisampled.reset();
    this->Link.reset();
    this->Fit.reset();
    this->Blocks.reset();
    this->Ink.reset();
  }

  vtkRenderer* Renderer = nullptr;              // being drawn
  vtkWeakPointer<vtkOpenGLRenderWindow> Window; // whose the images are
  std::unique_ptr<View> Seen;
  std::unordered_map<vtkProp*, int> Objects;
  npr::EdgeBuffers Buffers;
  std::unique_ptr<vtkOpenGLQuadHelper> Detect;
  std::unique_ptr<vtkOpenGLQuadHelper> DetectMultisampled;
  std::unique_ptr<vtkOpenGLQuadHelper> Link;
  std::unique_ptr<vtkOpenGLQuadHelper> Fit;
  std::unique_ptr<vtkOpenGLQuadHelper> Blocks;
  std::unique_ptr<vtkOpenGLQuadHelper> Ink;
};

//------------------------------------------------------------------------------
vtkNPREdgePass::vtkNPREdgePass() : Internal(std::make_unique<Internals>())
{
  this->SetDelegatePass(nullptr);
}

//------------------------------------------------------------------------------
vtkNPREdgePass::~vtkNPREdgePass() = default;

//------------------------------------------------------------------------------
void vtkNPREdgePass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "DelegatePass: " << this->DelegatePass->GetClassName() << "\n";
  os << indent << "Width: " << this->Width << "\n";
  os << indent << "Color: " << this->Color[0] << " " << this->Color[1] << " " << this->Color[2]
     << "\n";
  os << indent << "Opacity: " << this->Opacity << "\n";
  os << indent << "DepthThreshold: " << this->DepthThreshold << "\n";
  os << indent << "NormalThreshold: " << this->NormalThreshold << "\n";
  os << indent << "ObjectEdges: " << this->ObjectEdges << "\n";
}

//------------------------------------------------------------------------------
void vtkNPREdgePass::SetDelegatePass(vtkRenderPass* pass)
{
  if (pass)
  {
    this->DelegatePass = pass;
  }
  else
  {
    this->DelegatePass = vtkSmartPointer<vtkOpaquePass>::New();
  }
  this->Modified();
}

//------------------------------------------------------------------------------
vtkRenderPass* vtkNPREdgePass::GetDelegatePass()
{
  return this->DelegatePass;
}

//------------------------------------------------------------------------------
void vtkNPREdgePass::Render(const vtkRenderState* state)
{
  this->NumberOfRenderedProps = 0;
  vtkRenderer* renderer = state->GetRenderer();
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  this->Internal->Renderer = renderer;
  if (this->Internal->Window != window)
  {
    if (this->Internal->Window)
    {
      this->Internal->Release(this->Internal->Window);
    }
    this->Internal->Window = window;
  }
  this->Internal->Seen = std::make_unique<View>(renderer);
  if (renderer->GetSelector() ||
    !this->Internal->Buffers.BeginSurfaces(window, this->Internal->Seen->Viewport))
  {
    this->RenderDelegate(state);
    return;
  }
  this->RenderSurfaces(state);
  this->Internal->Buffers.EndSurfaces();
  this->RenderLines();
}

//------------------------------------------------------------------------------
void vtkNPREdgePass::RenderDelegate(const vtkRenderState* state)
{
  this->DelegatePass->Render(state);
  this->NumberOfRenderedProps += this->DelegatePass->GetNumberOfRenderedProps();
}

//------------------------------------------------------------------------------
void vtkNPREdgePass::RenderSurfaces(const vtkRenderState* state)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(this->Internal->Renderer->GetRenderWindow());
  // What does not ask us for its shaders goes first, without a second colour.
  std::vector<vtkProp*> props(
    state->GetPropArray(), state->GetPropArray() + state->GetPropArrayCount());
  const auto firstActor = std::stable_partition(
    props.begin(), props.end(), [](vtkProp* prop) { return !vtkActor::SafeDownCast(prop); });
  this->Internal->Objects.clear();
  std::for_each(firstActor, props.end(),
    [&](vtkProp* prop)
    {
      const int object = static_cast<int>(this->Internal->Objects.size()) + 1;
      this->Internal->Objects.emplace(prop, object);
    });
  vtkRenderState part(this->Internal->Renderer);
  part.SetFrameBuffer(state->GetFrameBuffer());
  const auto others = static_cast<int>(firstActor - props.begin());
  if (others > 0)
  {
    this->Internal->Buffers.EnableSurfaces(false);
    part.SetPropArrayAndCount(props.data(), others);
    this->RenderDelegate(&part);
    this->Internal->Buffers.EnableSurfaces(true);
  }
  part.SetPropArrayAndCount(props.data() + others, static_cast<int>(props.size()) - others);
  this->PreRender(&part);
  this->RenderDelegate(&part);
  this->PostRender(&part);
  // As VTK has it for all colours at once.
  if (window->GetState()->GetEnumState(GL_BLEND))
  {
    glEnablei(GL_BLEND, 1);
  }
}

//------------------------------------------------------------------------------
void vtkNPREdgePass::RenderLines()
{
  Internals& internal = *this->Internal;
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(internal.Renderer->GetRenderWindow());
  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable scissor(state, GL_SCISSOR_TEST);
  vtkOpenGLState::ScopedglEnableDisable cullFace(state, GL_CULL_FACE);
  vtkOpenGLState::ScopedglDepthMask depthMask(state);
  vtkOpenGLState::ScopedglBlendFuncSeparate blendFunction(state);
  vtkOpenGLState::ScopedglViewport viewport(state);
  state->vtkglDisable(GL_BLEND);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglDepthMask(GL_FALSE);

  const View& view = *internal.Seen;
  const int* origin = view.Viewport;
  const int* size = view.Viewport + 2;
  state->PushFramebufferBindings();
  state->vtkglViewport(0, 0, size[0], size[1]);
  internal.Buffers.BindEdges();
  const bool multisampled = internal.Buffers.GetSamples() > 0;
  vtkTextureObject* surfaces = internal.Buffers.GetSurfaces();
  surfaces->Activate();
  Draw(window, multisampled ? internal.DetectMultisampled : internal.Detect,
    std::string("//VTK::System::Dec\n#define NPR_SURFACE_SAMPLER ") +
      (multisampled ? "sampler2DMS\n" : "sampler2D\n") + vtkNPREdgeDetectFS,
    [&](vtkShaderProgram* program)
    {
      program->SetUniformi("nprSurfaces", surfaces->GetTextureUnit());
      program->SetUniform2i("nprOrigin", origin);
      program->SetUniform2i("nprSize", size);
      program->SetUniform4f("nprRay", view.Ray);
      program->SetUniformi("nprParallelProjection", view.IsParallel);
      program->SetUniformf("nprViewDistance", static_cast<float>(view.Distance));
      program->SetUniformf("nprDepthThreshold", static_cast<float>(this->DepthThreshold));
      // No angle is larger than 180 degrees, whatever rounding does.
      program->SetUniformf("nprNormalCosine",
        this->NormalThreshold >= 180.0
          ? -2.0f
          : static_cast<float>(std::cos(vtkMath::RadiansFromDegrees(this->NormalThreshold))));
      program->SetUniformi("nprObjectEdges", this->ObjectEdges);
    });
  surfaces->Deactivate();

  // From one image to the next.
  const auto derive =
    [&](std::unique_ptr<vtkOpenGLQuadHelper>& quad, const char* code, vtkTextureObject* edges)
  {
    edges->Activate();
    Draw(window, quad, code,
      [&](vtkShaderProgram* program)
      {
        program->SetUniformi("nprEdges", edges->GetTextureUnit());
        program->SetUniform2i("nprSize", size);
      });
    edges->Deactivate();
  };
  internal.Buffers.BindLinked();
  derive(internal.Link, vtkNPREdgeLinkFS, internal.Buffers.GetEdges());
  internal.Buffers.BindLines();
  derive(internal.Fit, vtkNPREdgeFitFS, internal.Buffers.GetLinked());
  constexpr int Block = npr::EdgeBuffers::BlockSize;
  internal.Buffers.BindBlocks();
  state->vtkglViewport(0, 0, (size[0] + Block - 1) / Block, (size[1] + Block - 1) / Block);
  derive(internal.Blocks, vtkNPREdgeBlocksFS, internal.Buffers.GetLines());
  state->PopFramebufferBindings();

  state->vtkglViewport(origin[0], origin[1], size[0], size[1]);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFuncSeparate(
    GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  vtkTextureObject* lines = internal.Buffers.GetLines();
  vtkTextureObject* blocks = internal.Buffers.GetBlocks();
  lines->Activate();
  blocks->Activate();
  Draw(window, internal.Ink, vtkNPREdgeInkFS,
    [&](vtkShaderProgram* program)
    {
      const float ink[4] = { static_cast<float>(this->Color[0]), static_cast<float>(this->Color[1]),
        static_cast<float>(this->Color[2]), static_cast<float>(this->Opacity) };
      program->SetUniformi("nprLines", lines->GetTextureUnit());
      program->SetUniformi("nprBlocks", blocks->GetTextureUnit());
      program->SetUniform2i("nprSize", size);
      program->SetUniformf("nprWidth", static_cast<float>(this->Width));
      program->SetUniform4f("nprInk", ink);
    });
  blocks->Deactivate();
  lines->Deactivate();
}

//------------------------------------------------------------------------------
void vtkNPREdgePass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Superclass::ReleaseGraphicsResources(window);
  this->DelegatePass->ReleaseGraphicsResources(window);
  this->Internal->Release(window);
}

//------------------------------------------------------------------------------
bool vtkNPREdgePass::PreReplaceShaderValues(std::string& vertexShader, std::string&,
  std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp*)
{
  if (vtkOpenGLPolyDataMapper::SafeDownCast(mapper))
  {
    const auto addAfter = [](std::string& shader, const std::string& tag, const char* ours)
    { vtkShaderProgram::Substitute(shader, tag, tag + "\n" + ours, false); };
    addAfter(vertexShader, "//VTK::Light::Dec", DeclarationTag);
    addAfter(vertexShader, "//VTK::Light::Impl", ImplementationTag);
    addAfter(fragmentShader, "//VTK::Light::Dec", DeclarationTag);
    addAfter(fragmentShader, "//VTK::TCoord::Impl", ImplementationTag);
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkNPREdgePass::PostReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
  std::string& fragmentShader, vtkAbstractMapper*, vtkProp*)
{
  const auto replace = [](std::string& shader, const char* ours, const char* code)
  { vtkShaderProgram::Substitute(shader, ours, code, false); };
  const auto contains = [&](const char* part)
  { return fragmentShader.find(part) != std::string::npos; };
  if (!geometryShader.empty())
  {
    replace(fragmentShader, DeclarationTag, PlainDeclaration);
    replace(fragmentShader, ImplementationTag, PlainImplementation);
    return true;
  }
  const bool isSmooth = contains("in vec3 normalVCVSOutput;");
  const bool isFlat = !isSmooth && contains("vec3 normalVCVSOutput =");
  replace(vertexShader, DeclarationTag, VertexDeclaration);
  replace(vertexShader, ImplementationTag, VertexImplementation);
  replace(vertexShader, "NPR_EDGE_NORMAL", isSmooth ? "normalVCVSOutput" : "vec3(0.0)");
  replace(fragmentShader, DeclarationTag, FragmentDeclaration);
  replace(fragmentShader, ImplementationTag, FragmentImplementation);
  replace(fragmentShader, "NPR_EDGE_NORMAL",
    isSmooth   ? SmoothNormal
      : isFlat ? "normalVCVSOutput"
               : "vec3(0.0)");
  replace(
    fragmentShader, "NPR_EDGE_OBJECT", isSmooth || isFlat ? "nprEdgeObject" : "-nprEdgeObject");
  return true;
}

//------------------------------------------------------------------------------
bool vtkNPREdgePass::SetShaderParameters(
  vtkShaderProgram* program, vtkAbstractMapper*, vtkProp* prop, vtkOpenGLVertexArrayObject*)
{
  // Blending would mix objects. VTK switches it on for all colours at once.
  glDisablei(GL_BLEND, 1);
  const auto found = this->Internal->Objects.find(prop);
  if (found != this->Internal->Objects.end() && program->IsUniformUsed("nprEdgeObject"))
  {
    program->SetUniformf("nprEdgeObject", static_cast<float>(found->second));
    program->SetUniform3f("nprEdgeRange", this->Internal->Seen->Range);
  }
  return true;
}
