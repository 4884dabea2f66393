// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPRZeroCurvatureLines
 * @brief Lines where a curvature is zero: the base of parabolic lines and others.
 *
 * They part the surface into regions where the curvature has one sign. Each unevenness of a
 * measured surface has such regions, too, and lines around it that say nothing of the shape. Two
 * things keep them away:
 *
 * - The curvature tensor is smoothed along the surface, for lines that tell of the shape are those
 *   of its larger forms.
 * - A region counts by how much the surface bends in it: an integral over its area that has no unit
 *   and is the same for every size and every mesh of a shape. For a bump it is about the square of
 *   its slopes, however wide it is; the outer half of a torus has as much however slender it is.
 *   Regions that have less than `Region` become a part of what is around them, the least first (see
 *   nprSignRegions.h).
 *
 * What is left are lines of the smoothed curvature, nowhere moved; they fade where it changes its
 * sign slowly.
 *
 * @par Parts with fillets
 * The flat faces of parts from CAD programs have no curvature, and few points, but at their rims
 * those of fillets, where the curvature jumps. What is between them is noise, and its lines are
 * zigzags. So these lines, too, fade out where the derivatives of curvature are in doubt (see
 * npr::ComputeDerivativeDoubt()), on the average over twice the width of the smoothing.
 *
 * @par Pieces
 * Of a surface in pieces each is judged by itself, but regions that reach its ghost triangles are
 * kept. So pieces may have more lines at their borders than the whole, and smoothing reaches just
 * their ghosts. Without both, pieces have the lines of the whole.
 *
 * @sa vtkNPRParabolicLines vtkNPRZeroMeanCurvature
 */
#ifndef vtkNPRZeroCurvatureLines_h
#define vtkNPRZeroCurvatureLines_h

#include "vtkNPRLineDefinition.h"

#ifndef __VTK_WRAP__
namespace npr
{
struct SmoothShape;
}
#endif

class VTKNPRFILTERSLINES_EXPORT vtkNPRZeroCurvatureLines : public vtkNPRLineDefinition
{
public:
  vtkAbstractTypeMacro(vtkNPRZeroCurvatureLines, vtkNPRLineDefinition);

  bool IsViewDependent() const override { return false; }

  ///@{
  /// The least gradient of the curvature on the line, times the power of the length scale that
  /// makes it a number without a unit. Range [0, 1e9].
  vtkSetClampMacro(Threshold, double, 0.0, 1.0e9);
  vtkGetMacro(Threshold, double);
  ///@}

  ///@{
  /// How far above the threshold (in its unit) a line has its full strength. Range [1e-6, 1e9].
  vtkSetClampMacro(Fade, double, 1.0e-6, 1.0e9);
  vtkGetMacro(Fade, double);
  ///@}

  ///@{
  /// Standard deviation of a smoothing of the curvature tensor along the surface, as a fraction of
  /// the length scale; it comes on top of what the input has been smoothed by. 0 takes the tensors
  /// as they are. Range [0, 1].
  vtkSetClampMacro(Smoothing, double, 0.0, 1.0);
  vtkGetMacro(Smoothing, double);
  ///@}

  ///@{
  /// How much the surface bends, at least, in each of the two regions that a line parts. No unit.
  /// Range [0, 1e6]; 0 keeps all.
  vtkSetClampMacro(Region, double, 0.0, 1.0e6);
  vtkGetMacro(Region, double);
  ///@}

#ifndef __VTK_WRAP__
  std::vector<RequiredArray> GetRequiredArrays() const override;
  double GetReach() const override;
  /// They go by gradients of the curvature.
  bool NeedsDerivatives() const override
  {
    return true;
  }
  const float* GetDoubts(const npr::LineSurface&) const override
  {
    return this->Doubts.data();
  }
  void BeginView(const npr::LineSurface& surface, const npr::LineView& view) override;
  void EndView(const npr::LineSurface& surface) override;
  bool HasField() const override
  {
    return true;
  }
  void EvaluateField(const npr::LineSurface& surface, const npr::LineView& view, vtkIdType begin,
    vtkIdType end, float* field) const override;
  bool HasTest() const override
  {
    return true;
  }
  void EvaluateTest(const npr::LineSurface& surface, const npr::LineView& view, const Index* points,
    vtkIdType count, const float* fall, float* test) const override;
#endif

protected:
  /// @param gradient what the threshold is, for people
  vtkNPRZeroCurvatureLines(
    const char* gradient, double threshold, double fade, double smoothing, double region);
  ~vtkNPRZeroCurvatureLines() override = default;

#ifndef __VTK_WRAP__
  /// The curvature that is zero on the lines.
  virtual double GetCurvature(double mean, double gaussian) const = 0;
  /// How much a surface bends, per area, where it has that curvature.
  virtual double GetDensity(double curvature) const = 0;
#endif

private:
#ifndef __VTK_WRAP__
  void SetDoubts(const npr::LineSurface& surface, const npr::SmoothShape& shape);
#endif

  double Threshold;
  double Fade;
  double Smoothing;
  double Region;

  // At the points, from BeginView() to EndView().
  std::vector<float> Field;
  std::vector<float> Gradients;
  std::vector<float> Doubts; // empty where the surface has none

  vtkNPRZeroCurvatureLines(const vtkNPRZeroCurvatureLines&) = delete;
  void operator=(const vtkNPRZeroCurvatureLines&) = delete;
};

#endif
