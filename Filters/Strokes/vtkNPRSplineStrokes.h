// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPRSplineStrokes
 * @brief Turns chains of points into smooth strokes.
 *
 * Each polyline of the input becomes a spline, sampled finely enough to look smooth. Chains whose
 * first and last points coincide (by id or by place) are closed: they wrap without a seam. The
 * polyline is cut where it turns by more than CornerAngle, so that corners stay sharp. Open ends
 * keep their place for every spline type: Catmull-Rom repeats the end point once, the B-spline
 * as often as it takes to reach it.
 *
 * Consecutive points in one place count once. A chain is split at points that are not finite, and
 * what is shorter than one segment is dropped; a closed chain of fewer than three points is treated
 * as an open one.
 *
 * Output: one polyline for each chain, without shared points (a closed one repeats its first point
 * at its end, for ArcLength differs there). Numeric point arrays are interpolated linearly between
 * the two control points around each sample; cell arrays are copied; field data is passed.
 * The point array `ArcLength` (float; unit: length) runs from 0 along each polyline.
 * Vertices, polygons and strips are not passed on.
 *
 * The result does not depend on the number of threads.
 *
 * @par Thanks:
 * Catmull-Rom splines: E. Catmull, R. Rom: A class of local interpolating splines, 1974. Uniform
 * cubic B-splines: C. de Boor: A Practical Guide to Splines, 1978. Simplification: D. Douglas,
 * T. Peucker, 1973.
 *
 * @sa vtkNPRStrokeMapper, vtkSplineFilter
 */
#ifndef vtkNPRSplineStrokes_h
#define vtkNPRSplineStrokes_h

#include "vtkNPRFiltersStrokesModule.h"
#include <vtkPolyDataAlgorithm.h>

class VTKNPRFILTERSSTROKES_EXPORT vtkNPRSplineStrokes : public vtkPolyDataAlgorithm
{
public:
  static vtkNPRSplineStrokes* New();
  vtkTypeMacro(vtkNPRSplineStrokes, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Values of SplineType. NONE keeps the polyline (smoothed and resampled if asked); CATMULL_ROM
   * passes through its points (C1): for contours; B_SPLINE stays inside the hull of its points
   * without passing through them (C2): for lines from second derivatives, for it smooths noise.
   */
  enum SplineTypes
  {
    NONE = 0,
    CATMULL_ROM = 1,
    B_SPLINE = 2
  };

  ///@{
  /** Which spline. Default: CATMULL_ROM. */
  vtkSetClampMacro(SplineType, int, NONE, B_SPLINE);
  vtkGetMacro(SplineType, int);
  void SetSplineTypeToNone() { this->SetSplineType(NONE); }
  void SetSplineTypeToCatmullRom() { this->SetSplineType(CATMULL_ROM); }
  void SetSplineTypeToBSpline() { this->SetSplineType(B_SPLINE); }
  ///@}

  ///@{
  /** Tension of Catmull-Rom, [0, 1]; 0 gives straight segments. Default: 0.5. */
  vtkSetClampMacro(Tension, double, 0.0, 1.0);
  vtkGetMacro(Tension, double);
  ///@}

  ///@{
  /**
   * Samples a span of the spline, 1 or more, where neither MaximumSegmentLength nor
   * MaximumChordError is set. Default: 4.
   */
  vtkSetClampMacro(Subdivisions, int, 1, MaximumSubdivisions);
  vtkGetMacro(Subdivisions, int);
  ///@}

  ///@{
  /**
   * If positive, each span gets as many samples as it takes to keep segments at most this long
   * (unit: length). Default: 0, off.
   */
  vtkSetClampMacro(MaximumSegmentLength, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumSegmentLength, double);
  ///@}

  ///@{
  /**
   * If positive, each span gets as many samples as it takes to keep the polyline within this
   * distance of the spline (unit: length). For strokes that look smooth, a quarter of a pixel's
   * size in the world. Default: 0, off.
   */
  vtkSetClampMacro(MaximumChordError, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumChordError, double);
  ///@}

  ///@{
  /**
   * The chain turning by more than this is a corner; by more than half of it where a span is so
   * much shorter than the next that splines would make a loop of it. Degrees, [0, 180]; 180: none.
   * Default: 60.
   */
  vtkSetClampMacro(CornerAngle, double, 0.0, 180.0);
  vtkGetMacro(CornerAngle, double);
  ///@}

  ///@{
  /**
   * If positive, how far CATMULL_ROM may leave the chain (unit: length), estimated from the turn
   * and the spans at each point: where it would leave it farther, the point is a corner. For lines
   * whose points lie dense where they bend, as on refined surfaces, so that what is long and turns
   * belongs to a body with edges. Default: 0, off.
   */
  vtkSetClampMacro(MaximumBulge, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumBulge, double);
  ///@}

  ///@{
  /**
   * How often each inner point is first moved to (a + 2 b + c) / 4 of itself and its neighbours:
   * takes the zig-zag out of chains. It rounds corners, too. Default: 0.
   */
  vtkSetClampMacro(SmoothingIterations, int, 0, VTK_INT_MAX);
  vtkGetMacro(SmoothingIterations, int);
  ///@}

  ///@{
  /**
   * If positive, how far the smoothing may move a point (unit: length), so that it takes out what
   * is small, but keeps long edges in place. Default: 0, off.
   */
  vtkSetClampMacro(MaximumShift, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumShift, double);
  ///@}

  ///@{
  /**
   * If positive, samples are left out as long as the polyline passes each of them within this
   * distance (unit: length), so that strokes have few points where they are straight. Ends and
   * corners stay, and ArcLength is as it was along all samples. Point arrays don't count: what
   * changes between the points that stay is lost. Default: 0, off.
   */
  vtkSetClampMacro(MaximumDeviation, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumDeviation, double);
  ///@}

  /** The most samples that any span gets. */
  static constexpr int MaximumSubdivisions = 1024;

protected:
  vtkNPRSplineStrokes() = default;
  ~vtkNPRSplineStrokes() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int SplineType = CATMULL_ROM;
  double Tension = 0.5;
  int Subdivisions = 4;
  double MaximumSegmentLength = 0.0;
  double MaximumChordError = 0.0;
  double CornerAngle = 60.0;
  double MaximumBulge = 0.0;
  int SmoothingIterations = 0;
  double MaximumShift = 0.0;
  double MaximumDeviation = 0.0;

private:
  vtkNPRSplineStrokes(const vtkNPRSplineStrokes&) = delete;
  void operator=(const vtkNPRSplineStrokes&) = delete;
};

#endif
