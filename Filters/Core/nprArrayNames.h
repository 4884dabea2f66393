// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprArrayNames.h
 * @brief The names of the arrays that filters hand to each other, each with its shape and unit.
 *
 * These names are the contract between filters, and users read them in ParaView; they stand here
 * and nowhere else. Signs and conventions: a sphere of radius r with outward normals has the
 * curvature +1/r, and |PrincipalCurvature1| >= |PrincipalCurvature2|.
 */
#ifndef nprArrayNames_h
#define nprArrayNames_h

namespace npr
{
namespace names
{
// Point arrays of surfaces.
inline constexpr const char* Normals = "Normals"; // 3, unit, outward
/// Before the number of a scale, from 1 on: Normals1, Normals2, each smoother than the last.
inline constexpr const char* ScaleNormalsPrefix = "Normals";      // 3, unit, outward
inline constexpr const char* CurvatureTensor = "CurvatureTensor"; // 6, XX YY ZZ XY YZ XZ; 1/length
inline constexpr const char* PrincipalCurvature1 = "PrincipalCurvature1"; // 1, 1/length
inline constexpr const char* PrincipalCurvature2 = "PrincipalCurvature2"; // 1, 1/length
inline constexpr const char* PrincipalDirection1 = "PrincipalDirection1"; // 3, unit
inline constexpr const char* PrincipalDirection2 = "PrincipalDirection2"; // 3, unit
inline constexpr const char* MeanCurvature = "MeanCurvature";             // 1, 1/length
inline constexpr const char* GaussianCurvature = "GaussianCurvature";     // 1, 1/length^2
inline constexpr const char* CurvatureDerivatives =
  "CurvatureDerivatives"; // 4, P Q S T; 1/length^2
/// How doubtful CurvatureDerivatives are: from 1 on they mean nothing (nprDerivativeDoubt.h).
inline constexpr const char* DerivativeDoubt = "DerivativeDoubt";   // 1, in [0, 10]
inline constexpr const char* ShapeIndex = "ShapeIndex";             // 1, in [-1, 1]: cup to cap
inline constexpr const char* Curvedness = "Curvedness";             // 1, 1/length
inline constexpr const char* PointArea = "PointArea";               // 1, length^2
inline constexpr const char* BorderPoints = "BorderPoints";         // 1, 1 on a border, else 0
inline constexpr const char* UnknownCurvature = "UnknownCurvature"; // 1, 1 without estimate, else 0
/// The point of the welded surface that a point is a copy of, where the preparation split a crease.
inline constexpr const char* WeldedPointIds = "WeldedPointIds"; // 1

// Cell arrays of surfaces.
/// How exact the surface is: how far triangles were, before a refinement, from the smooth surface.
inline constexpr const char* ChordError = "ChordError"; // 1, length

// Field data of surfaces.
inline constexpr const char* LengthScale = "LengthScale"; // 1 tuple; length
/// What the preparation found and did: a component with a name for each count.
inline constexpr const char* PreparationCounts = "PreparationCounts"; // 1 tuple
/// What an automatic neighbourhood came to; where the input has it, it holds.
inline constexpr const char* NeighbourhoodRadius = "NeighbourhoodRadius"; // 1 tuple; edge lengths

// Arrays of lines and strokes.
inline constexpr const char* LineType = "LineType";   // cells, 1, index into LineTypeNames
inline constexpr const char* LineLevel = "LineLevel"; // cells, 1, the field's value on the line
/// A line's number: that of the line at its place in the view before, where there was one.
inline constexpr const char* ChainId = "ChainId"; // cells, 1
/// How many surfaces are in front: 0 where it is visible.
inline constexpr const char* HidingLayers = "HidingLayers";   // cells, 1
inline constexpr const char* LineTypeNames = "LineTypeNames"; // field data, strings
inline constexpr const char* Strength = "Strength";           // points, 1, in [0, 1]
inline constexpr const char* ArcLength = "ArcLength";         // points, 1, length
inline constexpr const char* ViewDistance = "ViewDistance";   // points, 1, length in the world
inline constexpr const char* SourceCell = "SourceCell";       // points, 1, a cell of the surface
inline constexpr const char* SourceEdge = "SourceEdge";       // points, 2, points of the surface
inline constexpr const char* Visibility = "Visibility";       // points, 1, in [0, 1]
inline constexpr const char* Width = "Width";                 // points, 1, a factor
inline constexpr const char* Opacity = "Opacity";             // points, 1, a factor in [0, 1]
/// How much the curve itself bends, not the surface: times a length that its maker says.
inline constexpr const char* CurveCurvature = "CurveCurvature"; // points, 1, no unit
/// The cosine of the angle between the surface's normal and the light.
inline constexpr const char* Shade = "Shade"; // points, 1, in [-1, 1]
/// How far from a contour the surface is dark, as it is seen.
inline constexpr const char* IsophoteDistance = "IsophoteDistance"; // points, 1, view heights
/// The radial curvature, times LengthScale: as expressions have it.
inline constexpr const char* RadialCurvature = "kr"; // points, 1, no unit
}
}

#endif
