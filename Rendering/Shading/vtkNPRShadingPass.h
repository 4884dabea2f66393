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

#include <vector> // for the actors that have outlines

class vtkNPRShadingStyle;

VTK_ABI_NAMESPACE_BEGIN
class vtkActor;
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

  /// @name Outline
  /// Outlines without extraction, cheap and without control of single lines (vtkNPRFeatureLines has
  /// that; vtkNPREdgePass finds edges of pixels). On opaque surfaces that a style shades.
  ///  - NoOutline: the default.
  ///  - BackFaces: the back faces are drawn again, enlarged by OutlineWidth pixels along their
  ///    normals, so that a rim of them shows around what is closed and has point normals. As smooth
  ///    as surfaces are: use multisampling. Around sharp edges with several normals it has gaps
  ///    unless there is a vtkNPROutlineNormals.
  ///  - Grazing: dark where the cosine between normal and view direction is below
  ///    OutlineThreshold, [0, 1], softened over OutlineSoftness, [0, 1], but at least a pixel. Thin
  ///    where a surface bends strongly, wide where it is flat, and none along sharp edges.
  ///
  /// Default: width 3 (in [0, 100]), threshold 0.25, softness 0.1, black.
  ///@{
  enum OutlineKind
  {
    NoOutline = 0,
    BackFaces = 1,
    Grazing = 2
  };
  void SetOutline(int kind);
  vtkGetMacro(Outline, int);
  vtkSetClampMacro(OutlineWidth, double, 0.0, 100.0);
  vtkGetMacro(OutlineWidth, double);
  vtkSetVector3Macro(OutlineColor, double);
  vtkGetVector3Macro(OutlineColor, double);
  vtkSetClampMacro(OutlineThreshold, double, 0.0, 1.0);
  vtkGetMacro(OutlineThreshold, double);
  vtkSetClampMacro(OutlineSoftness, double, 0.0, 1.0);
  vtkGetMacro(OutlineSoftness, double);
  ///@}

  /// @name DelegatePass
  /// What draws the props; null brings back the default, a vtkRenderStepsPass whose translucent
  /// step is the renderer's own (depth peeling and so on, as set there). BackFaces are drawn with
  /// the default's opaque props; after everything by other delegates.
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

  void DrawBackFaces();
  void SetOutlineParameters(vtkShaderProgram* program);

  int Outline = NoOutline;
  double OutlineWidth = 3.0;
  double OutlineColor[3] = { 0.0, 0.0, 0.0 };
  double OutlineThreshold = 0.25;
  double OutlineSoftness = 0.1;

  vtkWeakPointer<vtkRenderer> Renderer; // being drawn
  std::vector<vtkActor*> Outlined;      // whose back faces are still to be drawn
  bool DrawingBackFaces = false;
  bool WarnedOfLights = false;
};

#endif
