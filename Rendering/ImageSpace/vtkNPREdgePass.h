// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPREdgePass
 * @brief Draws lines where depth, normal or object change from one pixel to the next.
 *
 * It is an opaque step of a frame: its delegate draws the opaque props as ever, and the lines are
 * laid over them before anything translucent is drawn.
 *
 * ```
 * vtkNew<vtkRenderStepsPass> steps;
 * vtkNew<vtkNPREdgePass> edges;
 * steps->SetOpaquePass(edges);
 * renderer->SetPass(steps);
 * ```
 *
 * The props write their normals, distances and objects while they are drawn, so the geometry is
 * drawn once. The lines cost the same for every model. They have no chains, no names and no depth
 * of their own; vtkNPRFeatureLines finds lines that have.
 *
 * Where an edge sinks to half of the thresholds, its line goes on for some pixels, so that it is
 * not broken. What is one pixel wide within an object has none.
 *
 * Lines run between what a vtkOpenGLPolyDataMapper draws. Props that are unlit have no normals and
 * get lines only where they meet other props and the background; parts of assemblies and other
 * props are background. Lines are smooth with and without multisampling. Where a framebuffer takes
 * no second colour, and while props are selected, there are no lines.
 *
 * @sa vtkNPRShadingPass vtkNPRFeatureLines
 */
#ifndef vtkNPREdgePass_h
#define vtkNPREdgePass_h

#include "nprVTKCompat.h"
#include "vtkNPRRenderingImageSpaceModule.h"
#include <vtkOpenGLRenderPass.h>
#include <vtkSmartPointer.h> // for the delegate

#include <memory> // for the images

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderer;
VTK_ABI_NAMESPACE_END

class VTKNPRRENDERINGIMAGESPACE_EXPORT vtkNPREdgePass : public vtkOpenGLRenderPass
{
public:
  static vtkNPREdgePass* New();
  vtkTypeMacro(vtkNPREdgePass, vtkOpenGLRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// @name DelegatePass
  /// What draws the opaque props; null brings back the default, a vtkOpaquePass.
  ///@{
  void SetDelegatePass(vtkRenderPass* pass);
  vtkRenderPass* GetDelegatePass();
  ///@}

  /// @name Width
  /// Of the lines, in pixels, [0.1, 20]. Half of it is on either side of the edge. Default: 2.
  ///@{
  vtkSetClampMacro(Width, double, 0.1, 20.0);
  vtkGetMacro(Width, double);
  ///@}

  /// @name Color and opacity
  /// Each in [0, 1]. Default: opaque black.
  ///@{
  vtkSetVector3Macro(Color, double);
  vtkGetVector3Macro(Color, double);
  vtkSetClampMacro(Opacity, double, 0.0, 1.0);
  vtkGetMacro(Opacity, double);
  ///@}

  /// @name DepthThreshold
  /// How far a surface must be behind the plane of its neighbour, as a share of the distance to the
  /// eye, [0.0001, 1]. In parallel projection that distance is the one at which a perspective view
  /// with the camera's view angle is as large. Default: 0.005.
  ///@{
  vtkSetClampMacro(DepthThreshold, double, 1.0e-4, 1.0);
  vtkGetMacro(DepthThreshold, double);
  ///@}

  /// @name NormalThreshold
  /// By what angle normals must differ, degrees, [1, 180]; 180: no lines by normals. Default: 50.
  ///@{
  vtkSetClampMacro(NormalThreshold, double, 1.0, 180.0);
  vtkGetMacro(NormalThreshold, double);
  ///@}

  /// @name ObjectEdges
  /// Whether there are lines between props, however alike they are. Default: on.
  ///@{
  vtkSetMacro(ObjectEdges, bool);
  vtkGetMacro(ObjectEdges, bool);
  vtkBooleanMacro(ObjectEdges, bool);
  ///@}

  void Render(const vtkRenderState* state) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

  /// @name Calls from mappers
  ///@{
  bool PreReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool PostReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
    vtkOpenGLVertexArrayObject* vertexArray = nullptr) override;
  ///@}

protected:
  vtkNPREdgePass();
  ~vtkNPREdgePass() override;

private:
  vtkNPREdgePass(const vtkNPREdgePass&) = delete;
  void operator=(const vtkNPREdgePass&) = delete;

  void RenderDelegate(const vtkRenderState* state);
  void RenderSurfaces(const vtkRenderState* state);
  void RenderLines();

  vtkSmartPointer<vtkRenderPass> DelegatePass;
  double Width = 2.0;
  double Color[3] = { 0.0, 0.0, 0.0 };
  double Opacity = 1.0;
  double DepthThreshold = 0.005;
  double NormalThreshold = 50.0;
  bool ObjectEdges = true;

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
