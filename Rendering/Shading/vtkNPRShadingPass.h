// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPRShadingPass
 * @brief Draws a renderer's lit surfaces in a shading style.
 *
 * ```
 * vtkNew<vtkNPRShadingPass> pass;
 * vtkNew<vtkNPRToonStyle> style;
 * pass->SetStyle(style);
 * renderer->SetPass(pass);
 * ```
 *
 * Everything stays as VTK has it but the colour of lit surfaces: props drawn by a
 * vtkOpenGLPolyDataMapper (glyphs and composite data included) with surface representation and
 * lighting on. Material, vertex colours, mapped scalars, textures, opacity, back faces, flat or
 * smooth normals and lights come through. Lines, points, wireframes, unlit actors, 2-D props and
 * props with the EXCLUDED() key are left to VTK.
 *
 * @par Lights:
 * The first 8 lights that are on: headlights, camera and scene lights, directional, point and spot,
 * with VTK's attenuation and cone, though attenuation never brightens: min(1, 1/(a0 + a1 d +
 * a2 d^2)). In parallel projection the direction to the eye is constant.
 *
 * Style parameters may change between renders at the price of a uniform. The pass and its style
 * may serve several renderers and windows.
 *
 * @sa vtkNPRShadingStyle vtkNPRShadingStyles
 */
#ifndef vtkNPRShadingPass_h
#define vtkNPRShadingPass_h

#include "nprVTKCompat.h"
#include "vtkNPRRenderingShadingModule.h"
#include <vtkOpenGLRenderPass.h>
#include <vtkSmartPointer.h> // for the delegate and the style
#include <vtkWeakPointer.h>  // for the renderer

class vtkNPRShadingStyle;

VTK_ABI_NAMESPACE_BEGIN
class vtkInformationIntegerKey;
class vtkOpenGLRenderWindow;
class vtkRenderer;
VTK_ABI_NAMESPACE_END

class VTKNPRRENDERINGSHADING_EXPORT vtkNPRShadingPass : public vtkOpenGLRenderPass
{
public:
  static vtkNPRShadingPass* New();
  vtkTypeMacro(vtkNPRShadingPass, vtkOpenGLRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The most lights that a style sees.
  static constexpr int MaximumNumberOfLights = 8;

  /// @name Style
  /// How surfaces are shaded; null: as VTK does. Default: a vtkNPRPhongStyle.
  ///@{
  void SetStyle(vtkNPRShadingStyle* style);
  vtkNPRShadingStyle* GetStyle();
  ///@}

  /// @name DelegatePass
  /// What draws the props; null brings back the default, a vtkRenderStepsPass whose translucent
  /// step is the renderer's own (depth peeling and so on, as set there).
  ///@{
  void SetDelegatePass(vtkRenderPass* pass);
  vtkRenderPass* GetDelegatePass();
  ///@}

  /// @name Excluded props
  /// A prop with this key set to 1 among its property keys is left to VTK; SetExcluded() sets it.
  ///@{
  static vtkInformationIntegerKey* EXCLUDED();
  static void SetExcluded(vtkProp* prop, bool excluded);
  static bool GetExcluded(vtkProp* prop);
  ///@}

  void Render(const vtkRenderState* state) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  vtkMTimeType GetMTime() override;

  /// @name Calls from mappers
  ///@{
  bool PreReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool PostReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
    vtkOpenGLVertexArrayObject* vertexArray = nullptr) override;
  vtkMTimeType GetShaderStageMTime() override;
  ///@}

protected:
  vtkNPRShadingPass();
  ~vtkNPRShadingPass() override;

private:
  vtkNPRShadingPass(const vtkNPRShadingPass&) = delete;
  void operator=(const vtkNPRShadingPass&) = delete;

  void CheckCode();
  void ReportBadCode(const std::string& message);

  vtkSmartPointer<vtkNPRShadingStyle> Style;
  vtkSmartPointer<vtkRenderPass> DelegatePass;
  vtkTimeStamp StyleTime;

  // Whether the style's code of CheckedTime compiles.
  bool CodeIsGood = false;
  vtkMTimeType CheckedTime = 0;

  vtkWeakPointer<vtkRenderer> Renderer; // being drawn
  bool WarnedOfLights = false;
};

#endif
