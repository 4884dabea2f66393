// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPRToonStyle
 * @brief Cartoon shading: a few flat tones with smooth borders.
 *
 * Ka + sum over the lights of f(d) I (Kd rampD(n.l) + Ks rampS((n.h)^s)): Phong's illumination with
 * its two cosines replaced by ramps (A. Lake et al., Stylized Rendering Techniques for Scalable
 * Real-Time 3D Animation, NPAR 2000). A ramp is a row of levels or colours, equal steps over [0,
 * 1]; the first goes on below 0.
 *
 * Borders between tones are antialiased: the shader takes the mean of the ramp over
 * SmoothingWidth pixels, or one step of the ramp if that is less.
 *
 * @sa vtkNPRShadingPass
 */
#ifndef vtkNPRToonStyle_h
#define vtkNPRToonStyle_h

#include "vtkNPRShadingStyle.h"
#include <vtkNew.h>          // for the ramps
#include <vtkSmartPointer.h> // for the ramps

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkTextureObject;
VTK_ABI_NAMESPACE_END

class VTKNPRRENDERINGSHADING_EXPORT vtkNPRToonStyle : public vtkNPRShadingStyle
{
public:
  static vtkNPRToonStyle* New();
  vtkTypeMacro(vtkNPRToonStyle, vtkNPRShadingStyle);

  std::string GetCode() override;
  void SetUniforms(vtkShaderProgram* program) override;
  void Activate(vtkOpenGLRenderWindow* window) override;
  void Deactivate() override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  vtkMTimeType GetMTime() override;

  /// @name NumberOfTones
  /// How many tones the diffuse part has where no DiffuseRamp is given, from 1 to 256: two are 0.3
  /// and 1; three 0.3, 0.7 and 1; more go evenly from 0.3 to 1. Default: 3.
  ///@{
  vtkSetClampMacro(NumberOfTones, int, 1, 256);
  vtkGetMacro(NumberOfTones, int);
  ///@}

  /// @name DiffuseRamp, SpecularRamp
  /// The tones from dark to bright, each a tuple of one component (a level) or three (a colour,
  /// red, green, blue), usually from 0 to 1, at most 4096. Where steps should not be equal, repeat
  /// tones. Default: none, that is, NumberOfTones tones, and a highlight that is off below 0.5.
  ///@{
  void SetDiffuseRamp(vtkDataArray* ramp);
  vtkDataArray* GetDiffuseRamp();
  void SetSpecularRamp(vtkDataArray* ramp);
  vtkDataArray* GetSpecularRamp();
  ///@}

  /// @name SmoothingWidth
  /// Width of the borders between tones in pixels, from 0 (jagged) to 64. Default: 1.5.
  ///@{
  vtkSetClampMacro(SmoothingWidth, double, 0.0, 64.0);
  vtkGetMacro(SmoothingWidth, double);
  ///@}

protected:
  vtkNPRToonStyle();
  ~vtkNPRToonStyle() override;

private:
  vtkNPRToonStyle(const vtkNPRToonStyle&) = delete;
  void operator=(const vtkNPRToonStyle&) = delete;

  bool AcceptRamp(vtkDataArray* ramp);

  int NumberOfTones = 3;
  double SmoothingWidth = 1.5;
  vtkSmartPointer<vtkDataArray> DiffuseRamp;
  vtkSmartPointer<vtkDataArray> SpecularRamp;

  vtkNew<vtkTextureObject> DiffuseTexture;
  vtkNew<vtkTextureObject> SpecularTexture;
  vtkTimeStamp UploadTime;
};

#endif
