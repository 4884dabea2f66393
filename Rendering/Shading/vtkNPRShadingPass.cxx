// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRShadingPass.h"

#include "nprShadingLights.h"
#include "nprShadingSteps.h"
#include "vtkNPROutlineFS.h"
#include "vtkNPROutlineNormals.h"
#include "vtkNPROutlineVS.h"
#include "vtkNPRPhongStyle.h"
#include "vtkNPRShadingFS.h"
#include "vtkNPRShadingStyle.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkHardwareSelector.h>
#include <vtkInformation.h>
#include <vtkInformationIntegerKey.h>
#include <vtkMatrix4x4.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLError.h>
#include <vtkOpenGLHelper.h>
#include <vtkOpenGLPolyDataMapper.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLShaderCache.h>
#include <vtkOpenGLState.h>
#include <vtkProperty.h>
#include <vtkRenderState.h>
#include <vtkRenderer.h>
#include <vtkShader.h>
#include <vtkShaderProgram.h>

#include <algorithm>
#include <cmath>
#include <vector>

vtkStandardNewMacro(vtkNPRShadingPass);
vtkInformationKeyMacro(vtkNPRShadingPass, EXCLUDED, Integer);

namespace
{
// Where our code goes; put in before the mapper fills its tags, replaced after.
const char* const DeclarationTag = "//NPR::Shading::Dec\n";
const char* const UniformFlowTag = "//NPR::Shading::UniformFlow\n";
const char* const ImplementationTag = "//NPR::Shading::Impl\n";
const char* const OutlineTag = "//NPR::Shading::Outline\n";

// Main program's parts; the names on the right are those of VTK's template. Derivatives are taken
// where all fragments of a quad still run.
const char* const UniformFlow = R"(
  vec3 nprPositionStep[2];
  nprPositionStep[0] = dFdx(vertexVC.xyz);
  nprPositionStep[1] = dFdy(vertexVC.xyz);
  vec3 nprNormalStep[2];
  nprNormalStep[0] = NPR_NORMAL_STEP(dFdx);
  nprNormalStep[1] = NPR_NORMAL_STEP(dFdy);
)";
const char* const NormalMacro[] = {
  "#define NPR_NORMAL_STEP(difference) vec3(0.0)\n",
  "#define NPR_NORMAL_STEP(difference) "
  "((gl_FrontFacing ? 1.0 : -1.0) * difference(normalize(normalVCVSOutput)))\n",
};
const char* const Implementation = R"(
  NprSurface nprSurface;
  nprSurface.position = vertexVC.xyz;
  nprSurface.normal = normalVCVSOutput;
  nprSurface.view = nprToEye(vertexVC.xyz);
  nprSurface.ambient = ambientColor;
  nprSurface.diffuse = NPR_BASE_COLOR;
  nprSurface.specular = NPR_SPECULAR_COLOR;
  nprSurface.power = specularPower;
  nprSurface.opacity = opacity;
  nprSurface.positionStep = nprPositionStep;
  nprSurface.normalStep = nprNormalStep;
  gl_FragData[0] = vec4(nprShade(nprSurface), opacity);
)";
// After textures, which do not colour an outline.
const char* const OutlineImplementation =
  "  gl_FragData[0].rgb = nprOutline(nprSurface, gl_FragData[0].rgb);\n";
const char* const PushImplementation = "  gl_Position = nprPush(gl_Position, NPR_PUSH_NORMAL);\n";

// Physically based materials have linear colours.
const char* const PlainColor = "diffuseColor";
const char* const PhysicalColor = "pow(max(albedo, vec3(0.0)), vec3(1.0 / 2.2))";

// The compiler drops highlights that are black, and the surface's position where no light needs it;
// in software each fragment would pay for them.
const char* GetSpecularColor(vtkActor* actor)
{
  vtkProperty* const property = actor->GetProperty();
  const double* const color = property->GetSpecularColor();
  const bool isBlack = property->GetSpecular() == 0.0 ||
    std::all_of(color, color + 3, [](double c) { return c == 0.0; });
  return isBlack && !actor->GetBackfaceProperty() ? "vec3(0.0)" : "specularColor";
}

// Which primitives a mapper is drawing, and what else its vertices have, is protected there, and
// says more than the shader's text.
struct MapperAccess : vtkOpenGLPolyDataMapper
{
  static bool HasAttribute(vtkOpenGLPolyDataMapper* mapper, const char* name)
  {
    return (mapper->*(&MapperAccess::ExtraAttributes)).count(name) > 0;
  }

  static bool DrawsTriangles(vtkOpenGLPolyDataMapper* mapper)
  {
    const vtkOpenGLHelper* helper = mapper->*(&MapperAccess::LastBoundBO);
    return helper &&
      (helper->PrimitiveType == PrimitiveTris || helper->PrimitiveType == PrimitiveTriStrips);
  }
};

std::string GetDeclarations(vtkNPRShadingStyle* style, int outline, int lightCount, int lightKind)
{
  return "#define NPR_OUTLINE " + std::to_string(outline) + "\n#define NPR_LIGHT_COUNT " +
    std::to_string(std::max(lightCount, 1)) + "\n#define NPR_LIGHT_KIND " +
    std::to_string(lightKind) + "\n" + vtkNPRShadingFS + "\n" + vtkNPROutlineFS + "\n#line 0\n" +
    style->GetCode() + "\n";
}

bool Contains(const std::string& text, const char* part)
{
  return text.find(part) != std::string::npos;
}
}

//------------------------------------------------------------------------------
vtkNPRShadingPass::vtkNPRShadingPass()
{
  this->SetStyle(vtkSmartPointer<vtkNPRPhongStyle>::New());
  this->SetDelegatePass(nullptr);
}

//------------------------------------------------------------------------------
vtkNPRShadingPass::~vtkNPRShadingPass() = default;

//------------------------------------------------------------------------------
void vtkNPRShadingPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Style: " << (this->Style ? this->Style->GetClassName() : "(none)") << "\n";
  if (this->Style)
  {
    this->Style->PrintSelf(os, indent.GetNextIndent());
  }
  os << indent << "Outline: " << this->Outline << "\n";
  os << indent << "OutlineWidth: " << this->OutlineWidth << "\n";
  os << indent << "OutlineColor: " << this->OutlineColor[0] << " " << this->OutlineColor[1] << " "
     << this->OutlineColor[2] << "\n";
  os << indent << "OutlineThreshold: " << this->OutlineThreshold << "\n";
  os << indent << "OutlineSoftness: " << this->OutlineSoftness << "\n";
  os << indent << "DelegatePass: " << this->DelegatePass->GetClassName() << "\n";
}

//------------------------------------------------------------------------------
void vtkNPRShadingPass::SetStyle(vtkNPRShadingStyle* style)
{
  if (this->Style != style)
  {
    this->Style = style;
    this->StyleTime.Modified();
    this->CheckedTime = 0;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkNPRShadingStyle* vtkNPRShadingPass::GetStyle()
{
  return this->Style;
}

//------------------------------------------------------------------------------
void vtkNPRShadingPass::SetOutline(int kind)
{
  kind = std::clamp(kind, int(NoOutline), int(Grazing));
  if (this->Outline != kind)
  {
    this->Outline = kind;
    this->StyleTime.Modified();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkNPRShadingPass::SetDelegatePass(vtkRenderPass* pass)
{
  if (pass && this->DelegatePass == pass)
  {
    return;
  }
  if (pass)
  {
    this->DelegatePass = pass;
  }
  else
  {
    this->DelegatePass = npr::MakeShadingSteps([this]() { this->DrawBackFaces(); });
  }
  this->Modified();
}

//------------------------------------------------------------------------------
vtkRenderPass* vtkNPRShadingPass::GetDelegatePass()
{
  return this->DelegatePass;
}

//------------------------------------------------------------------------------
void vtkNPRShadingPass::SetExcluded(vtkProp* prop, bool excluded)
{
  if (!prop->GetPropertyKeys())
  {
    vtkNew<vtkInformation> keys;
    prop->SetPropertyKeys(keys);
  }
  prop->GetPropertyKeys()->Set(EXCLUDED(), excluded ? 1 : 0);
}

//------------------------------------------------------------------------------
bool vtkNPRShadingPass::GetExcluded(vtkProp* prop)
{
  vtkInformation* keys = prop->GetPropertyKeys();
  return keys && keys->Has(EXCLUDED()) && keys->Get(EXCLUDED()) != 0;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkNPRShadingPass::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->Style ? this->Style->GetMTime() : 0);
}

//------------------------------------------------------------------------------
vtkMTimeType vtkNPRShadingPass::GetShaderStageMTime()
{
  return std::max(this->StyleTime.GetMTime(), this->Style ? this->Style->GetCodeMTime() : 0);
}

//------------------------------------------------------------------------------
void vtkNPRShadingPass::Render(const vtkRenderState* state)
{
  this->NumberOfRenderedProps = 0;
  this->Renderer = state->GetRenderer();
  if (vtkHardwareSelector* const selector = this->Renderer->GetSelector())
  {
    // Only renderers without a pass leave the props to the selector.
    this->Renderer->GetActiveCamera()->Render(this->Renderer);
    this->NumberOfRenderedProps =
      selector->Render(this->Renderer, state->GetPropArray(), state->GetPropArrayCount());
    return;
  }
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(this->Renderer->GetRenderWindow());
  if (this->Style && this->CheckedTime != this->Style->GetCodeMTime())
  {
    this->CheckCode();
  }

  // Mappers ask the passes in their prop's keys: a prop without ours is drawn by VTK alone.
  std::vector<vtkProp*> props;
  const bool shading = this->Style && this->CodeIsGood;
  if (shading)
  {
    std::copy_if(state->GetPropArray(), state->GetPropArray() + state->GetPropArrayCount(),
      std::back_inserter(props), [](vtkProp* prop) { return !GetExcluded(prop); });
    this->Style->Activate(window);
  }
  this->Outlined.clear();
  if (this->Outline == BackFaces)
  {
    for (vtkProp* prop : props)
    {
      auto* actor = vtkActor::SafeDownCast(prop);
      if (actor && actor->GetVisibility() && actor->HasOpaqueGeometry() &&
        actor->GetProperty()->GetRepresentation() == VTK_SURFACE &&
        actor->GetProperty()->GetLighting())
      {
        this->Outlined.push_back(actor);
      }
    }
  }
  vtkRenderState shaded(this->Renderer);
  shaded.SetPropArrayAndCount(props.data(), static_cast<int>(props.size()));
  this->PreRender(&shaded);
  this->DelegatePass->Render(state);
  this->NumberOfRenderedProps += this->DelegatePass->GetNumberOfRenderedProps();
  if (!this->Outlined.empty())
  {
    this->Renderer->GetActiveCamera()->UpdateViewport(this->Renderer);
    this->DrawBackFaces();
  }
  this->PostRender(&shaded);
  if (shading)
  {
    this->Style->Deactivate();
  }
}

//------------------------------------------------------------------------------
void vtkNPRShadingPass::DrawBackFaces()
{
  std::vector<vtkActor*> actors;
  actors.swap(this->Outlined);
  if (actors.empty())
  {
    return;
  }
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(this->Renderer->GetRenderWindow());
  vtkOpenGLState* state = window->GetState();
  {
    vtkOpenGLState::ScopedglEnableDisable culling(state, GL_CULL_FACE);
    this->DrawingBackFaces = true;
    for (vtkActor* actor : actors)
    {
      actor->RenderOpaqueGeometry(this->Renderer);
    }
    this->DrawingBackFaces = false;
  }
  state->vtkglCullFace(GL_BACK);
}

//------------------------------------------------------------------------------
void vtkNPRShadingPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Superclass::ReleaseGraphicsResources(window);
  this->DelegatePass->ReleaseGraphicsResources(window);
  if (this->Style)
  {
    this->Style->ReleaseGraphicsResources(window);
  }
}

//------------------------------------------------------------------------------
// A mapper whose shader does not compile crashes in some versions of VTK, so the style's code is
// compiled alone first, which also gives a message about nothing but that code.
void vtkNPRShadingPass::CheckCode()
{
  this->CheckedTime = this->Style->GetCodeMTime();
  this->CodeIsGood = true;
  vtkNew<vtkShader> shader;
  shader->SetType(vtkShader::Fragment);
  shader->SetSource("#version 150\n" +
    GetDeclarations(this->Style, this->Outline, MaximumNumberOfLights, 3) +
    "uniform NprSurface nprSurface;\n"
    "out vec4 nprColor;\n"
    "void main() { nprColor = vec4(nprShade(nprSurface), nprSurface.opacity); }\n");
  if (!shader->Compile())
  {
    const std::string log = shader->GetError(); // ends in empty lines
    this->ReportBadCode(log.substr(0, log.find_last_not_of(" \n") + 1));
  }
  shader->Cleanup();
}

//------------------------------------------------------------------------------
void vtkNPRShadingPass::ReportBadCode(const std::string& message)
{
  this->CodeIsGood = false;
  vtkErrorMacro("The GLSL of the shading style "
    << this->Style->GetClassName()
    << " does not compile. Surfaces are drawn with VTK's own shading "
    << "until the style's code changes. Lines are counted from the first of the code. " << message);
}

//------------------------------------------------------------------------------
bool vtkNPRShadingPass::PreReplaceShaderValues(std::string& vertexShader, std::string&,
  std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp*)
{
  if (vtkOpenGLPolyDataMapper::SafeDownCast(mapper))
  {
    // VTK's lighting stays: where it is there, ours takes its place afterwards, and the compiler
    // drops the former.
    vtkShaderProgram::Substitute(fragmentShader, "//VTK::Light::Dec",
      std::string("//VTK::Light::Dec\n") + DeclarationTag, false);
    vtkShaderProgram::Substitute(fragmentShader, "//VTK::UniformFlow::Impl",
      std::string("//VTK::UniformFlow::Impl\n") + UniformFlowTag, false);
    vtkShaderProgram::Substitute(fragmentShader, "//VTK::Light::Impl",
      std::string("//VTK::Light::Impl\n") + ImplementationTag, false);
    vtkShaderProgram::Substitute(fragmentShader, "//VTK::TCoord::Impl",
      std::string("//VTK::TCoord::Impl\n") + OutlineTag, false);
    vtkShaderProgram::Substitute(vertexShader, "//VTK::Light::Dec",
      std::string("//VTK::Light::Dec\n") + DeclarationTag, false);
    vtkShaderProgram::Substitute(
      vertexShader, "//VTK::Light::Impl", std::string("//VTK::Light::Impl\n") + OutlineTag, false);
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkNPRShadingPass::PostReplaceShaderValues(std::string& vertexShader,
  std::string& geometryShader, std::string& fragmentShader, vtkAbstractMapper* mapper,
  vtkProp* prop)
{
  auto* polyDataMapper = vtkOpenGLPolyDataMapper::SafeDownCast(mapper);
  auto* actor = vtkActor::SafeDownCast(prop);
  if (!polyDataMapper || !actor || !this->CodeIsGood ||
    !MapperAccess::DrawsTriangles(polyDataMapper) ||
    actor->GetProperty()->GetRepresentation() != VTK_SURFACE ||
    !Contains(fragmentShader, "vec4 vertexVC =") ||
    !Contains(fragmentShader, "vec3 normalVCVSOutput =") ||
    !Contains(fragmentShader, "float specularPower ="))
  {
    return true;
  }
  std::string shaded = fragmentShader;
  // VTK builds shaders anew when number or kind of lights change.
  const npr::ShadingLights lights(this->Renderer);
  const bool smooth = Contains(shaded, "in vec3 normalVCVSOutput;");
  vtkShaderProgram::Substitute(shaded, DeclarationTag,
    NormalMacro[smooth] + GetDeclarations(this->Style, this->Outline, lights.Count, lights.Kind),
    false);
  vtkShaderProgram::Substitute(shaded, UniformFlowTag, UniformFlow, false);
  vtkShaderProgram::Substitute(shaded, ImplementationTag, Implementation, false);
  vtkShaderProgram::Substitute(shaded, "NPR_BASE_COLOR",
    Contains(shaded, "vec3 albedo =") ? PhysicalColor : PlainColor, false);
  vtkShaderProgram::Substitute(shaded, "NPR_SPECULAR_COLOR", GetSpecularColor(actor), false);

  std::string pushed = vertexShader;
  if (this->Outline != NoOutline)
  {
    vtkShaderProgram::Substitute(shaded, OutlineTag, OutlineImplementation, false);
  }
  if (this->Outline == BackFaces && smooth)
  {
    const std::string attribute = vtkNPROutlineNormals::GetAttributeName();
    const bool hasOwn = MapperAccess::HasAttribute(polyDataMapper, attribute.c_str());
    vtkShaderProgram::Substitute(pushed, DeclarationTag,
      "uniform int nprParallelProjection;\n" + (hasOwn ? "in vec3 " + attribute + ";\n" : "") +
        vtkNPROutlineVS,
      false);
    vtkShaderProgram::Substitute(pushed, OutlineTag, PushImplementation, false);
    vtkShaderProgram::Substitute(pushed, "NPR_PUSH_NORMAL",
      hasOwn ? "normalMatrix * " + attribute : "normalVCVSOutput", false);
  }

  // The style's code may be good alone, but use a name that is one of VTK's. The program is cached,
  // so the mapper's own request costs nothing.
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(this->Renderer->GetRenderWindow());
  if (window->GetShaderCache()->ReadyShaderProgram(
        pushed.c_str(), shaded.c_str(), geometryShader.c_str()))
  {
    vertexShader = pushed;
    fragmentShader = shaded;
  }
  else
  {
    this->ReportBadCode(
      "It fails together with VTK's shader, whose messages stand before this one; "
      "a name at global scope may be one of VTK's.");
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkNPRShadingPass::SetShaderParameters(
  vtkShaderProgram* program, vtkAbstractMapper*, vtkProp*, vtkOpenGLVertexArrayObject*)
{
  const npr::ShadingLights lights(this->Renderer);
  if (lights.TooMany && !this->WarnedOfLights)
  {
    this->WarnedOfLights = true;
    vtkWarningMacro(
      "More than " << MaximumNumberOfLights << " lights are on; only the first of them shade.");
  }
  program->SetUniformi(
    "nprParallelProjection", this->Renderer->GetActiveCamera()->GetParallelProjection());
  if (lights.Count > 0)
  {
    program->SetUniform3fv("nprLightColor", lights.Count, lights.Color);
    program->SetUniform3fv("nprLightAxis", lights.Count, lights.Axis);
    program->SetUniform4fv("nprLightPosition", lights.Count, lights.Position);
    program->SetUniform3fv("nprLightAttenuation", lights.Count, lights.Attenuation);
    program->SetUniform2fv("nprLightCone", lights.Count, lights.Cone);
  }
  this->Style->SetUniforms(program);
  this->SetOutlineParameters(program);
  return true;
}

//------------------------------------------------------------------------------
void vtkNPRShadingPass::SetOutlineParameters(vtkShaderProgram* program)
{
  if (this->Outline == NoOutline)
  {
    return;
  }
  program->SetUniform3f("nprOutlineColor", this->OutlineColor);
  program->SetUniformf("nprOutlineThreshold", static_cast<float>(this->OutlineThreshold));
  program->SetUniformf("nprOutlineSoftness", static_cast<float>(this->OutlineSoftness));
  program->SetUniformi("nprOutlineTurn", this->DrawingBackFaces);
  int width = 1;
  int height = 1;
  this->Renderer->GetTiledSize(&width, &height);
  const float size[3] = { static_cast<float>(width), static_cast<float>(height),
    this->DrawingBackFaces ? static_cast<float>(this->OutlineWidth) : 0.0f };
  program->SetUniform3f("nprOutlineSize", size);
  vtkMatrix4x4* matrix = this->Renderer->GetActiveCamera()->GetProjectionTransformMatrix(
    this->Renderer->GetTiledAspectRatio(), -1.0, 1.0);
  const float projection[4] = { static_cast<float>(matrix->GetElement(0, 0)),
    static_cast<float>(matrix->GetElement(1, 1)), static_cast<float>(matrix->GetElement(2, 2)),
    static_cast<float>(matrix->GetElement(2, 3)) };
  program->SetUniform4f("nprOutlineProjection", projection);
  if (this->DrawingBackFaces)
  {
    // Only now, as the actor's property has its own idea of it.
    auto* window = vtkOpenGLRenderWindow::SafeDownCast(this->Renderer->GetRenderWindow());
    window->GetState()->vtkglEnable(GL_CULL_FACE);
    window->GetState()->vtkglCullFace(GL_FRONT);
  }
}
