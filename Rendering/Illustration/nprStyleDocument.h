// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprStyleDocument.h
 * @brief A style as data: what a style file says, checked, before any of it is turned into objects.
 *
 * Widths and lengths on the page are given in thousandths of the image's shorter side, so that one
 * style draws the same picture at every image size. Colours are "#rrggbb", an HTML colour name, or
 * [r, g, b] with each in 0..1.
 */
#ifndef nprStyleDocument_h
#define nprStyleDocument_h

#include <array>
#include <map>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

namespace npr
{
using Color = std::array<double, 3>;
/// Numbers or a text, which is a colour where the parameter takes one.
using ParameterValue = std::variant<std::vector<double>, std::string>;
/// Parameters that go to a shading style or a line definition by their names.
using Parameters = std::map<std::string, ParameterValue>;

/// What is wrong with a style, and at which key.
struct StyleError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// A factor by an array of the lines.
struct TermStyle
{
  std::string Array;
  std::array<double, 2> Range = { 0.0, 0.0 }; ///< Of its values; of the lines in view, where equal.
  std::array<double, 2> Factors = { 0.0, 1.0 }; ///< At both.
  bool Smooth = false;

  /// Those that there are.
  static const std::vector<std::string>& GetArrays();
};

/// How strokes look, besides their width and colour. Lengths are in thousandths of the shorter
/// side.
struct StrokeStyle
{
  int Cap = 0; ///< of vtkNPRStrokeMapper, as Join and Medium
  int Join = 0;
  double MitreLimit = 4.0;                           ///< widths, 1..100
  std::array<double, 2> Dashes = { 0.0, 0.0 };       ///< on and off; not dashed without off
  double HiddenOpacity = 0.0;                        ///< 0..1, of parts behind surfaces
  std::array<double, 2> HiddenDashes = { 0.0, 0.0 }; ///< of parts behind surfaces
  int Medium = 0;
  double Grain = 0.0; ///< 0..1, how much the tooth of the paper shows
  double GrainSize = 2.0;
  double TaperLength = 0.0;
  double TaperedWidth = 0.0;   ///< 0..1, factor at the ends
  double TaperedOpacity = 1.0; ///< 0..1, factor at the ends
  double WidthLimit = 0.0;     ///< 0..1, share of a stroke's size; 0: none
  double Overshoot = 0.0;
  double Wobble = 0.0;
  double WobbleLength = 60.0;
  double BendReach = 20.0;     ///< what bends within less is no bend, and so for shade
  double IsophoteLevel = -0.5; ///< -1..1, the cosine of normal and light up to which it is dark
  int Seed = 0;
  std::vector<TermStyle> WidthBy;
  std::vector<TermStyle> OpacityBy;

  /// Whether it takes more than a mapper.
  bool NeedsAttributes() const;
  /// What lines must carry of the surface: names that vtkNPRFeatureLines knows.
  std::vector<std::string> GetQuantities() const;
};

struct LineStyle
{
  std::string Type;   ///< A name that vtkNPRLineDefinition knows.
  double Width = 2.0; ///< Thousandths of the shorter side, > 0.
  Color Ink = { 0.0, 0.0, 0.0 };
  double Opacity = 1.0;               ///< 0..1
  std::string Spline = "catmull-rom"; ///< catmull-rom, b-spline or none.
  int Smoothing = 0;          ///< How often the chain is smoothed before the spline; 0..1000.
  bool Taper = false;         ///< Weak parts of a line are thinner.
  bool Fade = false;          ///< Weak parts of a line are more transparent. A number under this
                              ///< key is a parameter of the definition instead.
  double MinimumLength = 0.0; ///< Thousandths of the shorter side; shorter chains are dropped.
  StrokeStyle Stroke;
  bool Optional = false; ///< Only drawn where this kind of line is asked for by its name.
  Parameters DefinitionParameters;
  std::string CommonKeys; ///< Those that all lines have, for a message.
};

struct LightStyle
{
  double Azimuth = -35.0;  ///< Degrees to the right of the viewer.
  double Elevation = 40.0; ///< Degrees above the viewer.
  double Intensity = 1.0;  ///< >= 0
  Color Tint = { 1.0, 1.0, 1.0 };
};

struct ShadingStyle
{
  std::string Style = "phong";       ///< A name that vtkNPRShadingStyle knows, or "paper" for none.
  Color Surface = { 0.8, 0.8, 0.8 }; ///< Of surfaces that bring no colour of their own.
  double Ambient = 0.0;
  double Diffuse = 1.0;
  double Specular = 0.0;
  double SpecularPower = 20.0;
  Parameters StyleParameters;
  std::string CommonKeys; ///< Those that all styles have, for a message.
};

struct GeometryStyle
{
  double CreaseAngle = 40.0; ///< Degrees, 0..180; sharper edges separate smooth patches.
  double Smoothing = 2.5;    ///< Thousandths; details of this size draw no line. 0 for none.
  double Refinement = 8.0; ///< Thousandths; longer edges of a coarse mesh are refined. 0 for none.
  /// Of curvature: a name that vtkNPRCurvatureTensor knows; empty takes jets on meshes with
  /// well-shaped triangles, per-face on others, such as those of CAD programs.
  std::string Estimator;
};

/// Outlines that are drawn without extraction of lines.
struct OutlineStyle
{
  enum Kinds
  {
    None, ///< as vtkNPRIllustrationStyle::OutlineKind has them
    BackFaces,
    Grazing,
    ImageEdges
  };
  int Kind = None;
  double Width = 3.0; ///< Thousandths of the shorter side; of grazing outlines the threshold tells.
  Color Ink = { 0.0, 0.0, 0.0 };
  double GrazingThreshold = 0.25; ///< Cosine of normal and view, 0..1.
  double GrazingSoftness = 0.1;   ///< Range of that cosine, 0..1.
  double DepthThreshold = 0.005;  ///< Share of the distance, 0.0001..1.
  double NormalThreshold = 50.0;  ///< Degrees, 1..180.
  bool ObjectEdges = true;

  static const std::vector<std::string>& GetKindNames();
};

struct StyleDocument
{
  std::string Name;
  std::string Description;
  Color BackgroundBottom = { 1.0, 1.0, 1.0 };
  Color BackgroundTop = { 1.0, 1.0, 1.0 };
  ShadingStyle Shading;
  std::vector<LightStyle> Lights;
  GeometryStyle Geometry;
  OutlineStyle Outline;
  std::vector<LineStyle> Lines;
  std::vector<std::string> Quantities; ///< That lines carry of the surface, besides.
};

/// Whether a line is of the kind, or has the name as a parameter.
bool IsCalled(const LineStyle& line, const std::string& name);

/// @throws StyleError that names the key (as a JSON pointer) or the place of a syntax error.
StyleDocument ParseStyle(const std::string& json);

/// @throws StyleError when the text is no colour.
Color ParseColor(const std::string& text);
}

#endif
