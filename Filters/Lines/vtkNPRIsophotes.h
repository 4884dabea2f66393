// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPRIsophotes
 * @brief Lines of equal light: where the angle between the normal and the light is the same.
 *
 * n.l = c for even steps of c between a minimum and 1, with l the unit vector to the light. The
 * light is at the eye, or shines from a direction that keeps its place beside the viewer, or from
 * one that stays with the model (then no view changes the lines).
 *
 * Lines end where the surface hardly bends towards the light (the length of II(l), l along the
 * surface): on flat parts they would show the noise, or the perspective, and no shape. They also
 * end where they crowd as the eye sees them, as at the rim, where they would only blacken.
 *
 * Source: Poeschl, "Detecting surface irregularities using isophotes", Computer Aided Geometric
 * Design 1, 1984.
 *
 * @par Scaled props
 * Normals are those of the model itself, also where a prop scales it unevenly.
 *
 * @par Smoothing
 * Is done once for a surface, and again when its points move: for animations that need not wait,
 * set it to 0. Of a surface in pieces, it reaches just their ghost triangles, so that lines may be
 * elsewhere near their borders; without it, pieces have the lines of the whole.
 *
 * @sa vtkNPRFeatureLines
 */
#ifndef vtkNPRIsophotes_h
#define vtkNPRIsophotes_h

#include "vtkNPRLineDefinition.h"

#include <string>

class VTKNPRFILTERSLINES_EXPORT vtkNPRIsophotes : public vtkNPRLineDefinition
{
public:
  static vtkNPRIsophotes* New();
  vtkTypeMacro(vtkNPRIsophotes, vtkNPRLineDefinition);

  const char* GetName() const override { return "isophotes"; }
  const char* GetDescription() const override
  {
    return "lines of equal light, from the eye or a direction";
  }
  bool IsViewDependent() const override;

  ///@{
  /// How many levels there are; a whole number. Range [1, 1000]. Default is 6.
  vtkSetClampMacro(Levels, double, 1.0, 1000.0);
  vtkGetMacro(Levels, double);
  ///@}

  ///@{
  /// The levels part the cosines from this one to 1 into equal steps; it is itself none of them, as
  /// 0 is the contour of the light. -1 has levels on the side away from the light, too. Range
  /// [-1, 0.999]. Default is 0.
  vtkSetClampMacro(Minimum, double, -1.0, 0.999);
  vtkGetMacro(Minimum, double);
  ///@}

  /// @name Where the light is, beside the viewer
  /// In degrees to the right of and above the viewer, as the lights of styles. At 0 and 0 it is
  /// the eye itself, else so far away that only its direction counts. Ranges [-360, 360] and
  /// [-90, 90]. Defaults are 0.
  ///@{
  vtkSetClampMacro(Azimuth, double, -360.0, 360.0);
  vtkGetMacro(Azimuth, double);
  vtkSetClampMacro(Elevation, double, -90.0, 90.0);
  vtkGetMacro(Elevation, double);
  ///@}

  ///@{
  /// The direction to a light that stays with the model, in its coordinates and of any length;
  /// (0, 0, 0) for the one beside the viewer. Default is (0, 0, 0).
  vtkSetVector3Macro(Direction, double);
  vtkGetVector3Macro(Direction, double);
  ///@}

  ///@{
  /// The standard deviation of a smoothing of normals and curvature along the surface, over the
  /// length scale (no unit): lines show the form, and do not fray on the grain of a scan. Range
  /// [0, 1]. Default is 0.03.
  vtkSetClampMacro(Smoothing, double, 0.0, 1.0);
  vtkGetMacro(Smoothing, double);
  ///@}

  ///@{
  /// The least curvature towards the light, times the length scale (no unit). With this, the
  /// distance and the smoothing at 0 lines run everywhere, and no curvature is needed. Range [0,
  /// 1e6]. Default is 0.1.
  vtkSetClampMacro(Threshold, double, 0.0, 1.0e6);
  vtkGetMacro(Threshold, double);
  ///@}

  ///@{
  /// How far above the threshold (in its unit) a line has its full strength. Range [1e-6, 1e6].
  /// Default is 0.2.
  vtkSetClampMacro(Fade, double, 1.0e-6, 1.0e6);
  vtkGetMacro(Fade, double);
  ///@}

  ///@{
  /// The least distance between a line and that of the next level, in length scales (no unit), as
  /// the eye sees it: across the line of sight, or along the surface where the light stays with the
  /// model. Lines have their full strength at twice the distance. Range [0, 1e3]; 0 lets them
  /// crowd. Default is 0.006.
  vtkSetClampMacro(Distance, double, 0.0, 1.0e3);
  vtkGetMacro(Distance, double);
  ///@}

#ifndef __VTK_WRAP__
  std::vector<RequiredArray> GetRequiredArrays() const override;
  bool HasField() const override
  {
    return true;
  }
  double GetReach() const override;
  void PrepareSurface(npr::LineSurface& surface) override;
  std::vector<float> GetLevels(const npr::LineSurface& surface) const override;
  void EvaluateField(const npr::LineSurface& surface, const npr::LineView& view, vtkIdType begin,
    vtkIdType end, float* field) const override;
  bool HasTest() const override
  {
    return this->Threshold > 0.0 || this->Distance > 0.0;
  }
  void EvaluateTest(const npr::LineSurface& surface, const npr::LineView& view, const Index* points,
    vtkIdType count, const float* fall, float* test) const override;
#endif

protected:
  vtkNPRIsophotes();
  ~vtkNPRIsophotes() override = default;

private:
  class Light;
  double GetStep() const;
  // Of the arrays that lines are made from.
  std::string GetNormals() const;
  std::string GetTensor() const;
  double Levels = 6.0;
  double Minimum = 0.0;
  double Azimuth = 0.0;
  double Elevation = 0.0;
  double Direction[3] = { 0.0, 0.0, 0.0 };
  double Smoothing = 0.03;
  double Threshold = 0.1;
  double Fade = 0.2;
  double Distance = 0.006;

  vtkNPRIsophotes(const vtkNPRIsophotes&) = delete;
  void operator=(const vtkNPRIsophotes&) = delete;
};

#endif
