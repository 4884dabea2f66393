// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprStrokeCurves_h
#define nprStrokeCurves_h

#include "nprSplines.h"
#include "nprStrokeBuffer.h"

#include <cstddef>
#include <vector>

namespace npr
{
/// The default of vtkNPRSplineStrokes.
constexpr double SplineTension = 0.5;

/// What strokes become whose points are control points.
struct CurveSettings
{
  SplineKind Kind = SplineKind::Polyline; // that: they are drawn as they are
  double CornerAngle = 60.0;              // degrees
  double ChordError = 1.0;                // in units of StrokeTolerance::Length
  bool Measured = false;                  // lengths along the strokes are needed

  bool operator==(const CurveSettings& other) const;
};

/// One point of a curve, for the shader that evaluates it.
struct CurvePoint
{
  float Span; // the number of the control point that its span begins with
  float T;    // where on the span, [0, 1]
  float Kind; // as in StrokeRecord
};

struct StrokeCurves
{
  // The Records are control points; each span has one before it and two after its first. The Begins
  // are those of the Points.
  StrokeRecords Strokes;
  std::vector<CurvePoint> Points;
  SplineBasis Basis;
};

/// More control points can't be numbered by a CurvePoint.
constexpr std::size_t MostControlPoints = 1 << 24;

/**
 * Chooses the points by which curves are drawn, without evaluating them but at the ends of spans:
 * as many on each span as it takes to keep to the chord error, and of spans that are straight on
 * from one to the next only those points that SimplifyStroke() keeps.
 *
 * @param colors four numbers for each point, or for each cell; null: none
 */
StrokeCurves MakeStrokeCurves(vtkPolyData* strokes, vtkUnsignedCharArray* colors, bool ofCells,
  const StrokeTolerance& tolerance, const CurveSettings& settings);

/// The same evaluated here, by vtkNPRSplineStrokes, with lengths along the strokes.
StrokeRecords SampleStrokeCurves(vtkPolyData* strokes, vtkUnsignedCharArray* colors, bool ofCells,
  const StrokeTolerance& tolerance, const CurveSettings& settings);

/// How far curves may reach beyond the bounds of their control points, in their coordinates.
double FindOvershoot(vtkPolyData* strokes, SplineKind kind);
}

#endif
