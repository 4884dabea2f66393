// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprCurvaturePicture.h"

#include "nprArrayNames.h"
#include "nprCurvatureStatistics.h"
#include "nprImageFile.h"
#include "nprLegend.h"
#include "nprLengthScale.h"
#include "nprRenderJob.h"
#include "nprReporter.h"
#include "nprViewOptions.h"
#include "vtkNPRDirectionStrokes.h"
#include "vtkNPRFeatureLines.h"
#include "vtkNPRSplineStrokes.h"
#include "vtkNPRStrokeMapper.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

namespace npr
{
namespace
{
constexpr Colour Paper = { 1.0, 1.0, 1.0 };
constexpr Colour Ink = { 0.13, 0.13, 0.15 };
constexpr Colour FirstInk = { 0.16, 0.17, 0.24 };
constexpr Colour SecondInk = { 0.80, 0.62, 0.50 };
constexpr const char* Directions = "directions";
constexpr double LeastContour = 0.006; // of the picture's height: the specks of a scan draw no line

/// A quantity that is shown by colours.
struct Quantity
{
  const char* Name;
  const char* Array;
  const char* Title;
  enum
  {
    Signed,   ///< diverging colours; zero is neutral
    Positive, ///< from paper to dark
    Shape     ///< the shape index
  } Kind;
};

/// Where there is one first direction, strokes along it are drawn: it is arbitrary where the
/// curvatures are equal, and means nothing on a plane.
void AddDirectionStrength(vtkPolyData* surface)
{
  const double usual = Distribution(surface, names::Curvedness).GetMedian();
  vtkPointData* data = surface->GetPointData();
  vtkDataArray* k1 = data->GetArray(names::PrincipalCurvature1);
  vtkDataArray* k2 = data->GetArray(names::PrincipalCurvature2);
  vtkNew<vtkFloatArray> strength;
  strength->SetName(names::Strength);
  for (vtkIdType i = 0; i < k1->GetNumberOfTuples(); ++i)
  {
    const double first = std::abs(k1->GetTuple1(i));
    const double difference = std::abs(k1->GetTuple1(i) - k2->GetTuple1(i));
    const double distinct = first > 0.0 ? std::min(1.0, difference / (0.5 * first)) : 0.0;
    const double bent = usual > 0.0 ? std::min(1.0, 0.15 + first / usual) : 1.0;
    strength->InsertNextValue(static_cast<float>(distinct * bent));
  }
  data->AddArray(strength);
}

constexpr Quantity Quantities[] = {
  { "k1", names::PrincipalCurvature1, "first curvature k1 (1/length)", Quantity::Signed },
  { "k2", names::PrincipalCurvature2, "second curvature k2 (1/length)", Quantity::Signed },
  { "mean", names::MeanCurvature, "mean curvature H (1/length)", Quantity::Signed },
  { "gaussian", names::GaussianCurvature, "Gaussian curvature K (1/length²)", Quantity::Signed },
  { "shape-index", names::ShapeIndex, "shape index", Quantity::Shape },
  { "curvedness", names::Curvedness, "curvedness (1/length)", Quantity::Positive },
};

vtkSmartPointer<vtkColorTransferFunction> MakeColours(
  const std::vector<Colour>& colours, double minimum, double maximum)
{
  auto function = vtkSmartPointer<vtkColorTransferFunction>::New();
  function->SetColorSpaceToLab();
  for (std::size_t i = 0; i < colours.size(); ++i)
  {
    const double place = minimum + (maximum - minimum) * i / (colours.size() - 1);
    function->AddRGBPoint(place, colours[i][0], colours[i][1], colours[i][2]);
  }
  return function;
}

std::string Write(double value)
{
  char text[32];
  std::snprintf(text, sizeof(text), "%.3g", value);
  return text;
}

/// Hollows are blue, hills are red; what a twentieth of the surface exceeds has the last colour.
Legend MakeLegend(const Quantity& quantity, vtkPolyData* surface)
{
  Legend legend;
  legend.Title = quantity.Title;
  if (quantity.Kind == Quantity::Shape)
  {
    legend.Minimum = -1.0;
    legend.Marks = { { -1.0, "cup" }, { -0.5, "valley" }, { 0.0, "saddle" }, { 0.5, "ridge" },
      { 1.0, "cap" } };
    legend.Colours = MakeColours({ { 0.10, 0.45, 0.35 }, { 0.16, 0.50, 0.72 }, { 0.96, 0.95, 0.91 },
                                   { 0.95, 0.74, 0.22 }, { 0.78, 0.16, 0.14 } },
      legend.Minimum, legend.Maximum);
    return legend;
  }
  const Distribution magnitude(
    surface, quantity.Array, [](double value) { return std::abs(value); });
  legend.Maximum = magnitude.GetHigh() > 0.0 ? magnitude.GetHigh() : 1.0;
  if (quantity.Kind == Quantity::Positive)
  {
    legend.Colours = MakeColours(
      { { 0.97, 0.96, 0.92 }, { 0.96, 0.75, 0.47 }, { 0.80, 0.32, 0.28 }, { 0.38, 0.10, 0.30 } },
      0.0, legend.Maximum);
  }
  else
  {
    legend.Minimum = -legend.Maximum;
    legend.Colours = MakeColours({ { 0.09, 0.22, 0.50 }, { 0.33, 0.58, 0.80 }, { 0.96, 0.95, 0.92 },
                                   { 0.92, 0.53, 0.36 }, { 0.61, 0.08, 0.13 } },
      legend.Minimum, legend.Maximum);
  }
  for (int i = 0; i <= 4; ++i)
  {
    const double value = legend.Minimum + (legend.Maximum - legend.Minimum) * i / 4;
    legend.Marks.emplace_back(value, Write(value));
  }
  legend.Marks.back().second = "> " + legend.Marks.back().second;
  if (quantity.Kind == Quantity::Signed)
  {
    legend.Marks.front().second = "< " + legend.Marks.front().second;
  }
  return legend;
}

void AddSurface(vtkRenderer* renderer, vtkPolyData* surface, const Quantity* quantity,
  vtkScalarsToColors* colours)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(surface);
  mapper->SetScalarVisibility(quantity != nullptr);
  if (quantity)
  {
    mapper->SetScalarModeToUsePointFieldData();
    mapper->SelectColorArray(quantity->Array);
    mapper->SetLookupTable(colours);
    mapper->UseLookupTableScalarRangeOn();
  }
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(1.0, 1.0, 1.0);
  // Soft: even where it is darkest, its colour is told.
  actor->GetProperty()->SetAmbient(0.55);
  actor->GetProperty()->SetDiffuse(0.5);
  renderer->AddActor(actor);
  vtkNew<vtkLight> light;
  light->SetLightTypeToCameraLight();
  light->SetPosition(-0.5, 0.6, 1.0);
  renderer->AddLight(light);
}

/// Strokes of one length and distance on the page, whatever the model's size.
vtkSmartPointer<vtkNPRDirectionStrokes> MakeHatching(vtkRenderer* renderer, vtkPolyData* surface,
  const char* directions, double spacing, double length)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  const double height = camera->GetParallelProjection() ? 2.0 * camera->GetParallelScale()
                                                        : 2.0 * camera->GetDistance() *
      std::tan(0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle()));
  auto strokes = vtkSmartPointer<vtkNPRDirectionStrokes>::New();
  strokes->SetInputData(surface);
  strokes->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, directions);
  strokes->SetStrengthArray(names::Strength);
  strokes->SetSpacing(spacing * height / GetLengthScale(surface));
  strokes->SetLength(length);
  return strokes;
}

void AddInk(vtkRenderer* renderer, vtkAlgorithmOutput* lines, const Colour& colour, double width)
{
  vtkNew<vtkNPRStrokeMapper> mapper;
  mapper->SetInputConnection(lines);
  mapper->SetWidth(width);
  mapper->StrengthToWidthOn();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
  renderer->AddActor(actor);
}
}

//------------------------------------------------------------------------------
std::vector<std::string> GetPictureNames()
{
  std::vector<std::string> names;
  for (const Quantity& quantity : Quantities)
  {
    names.emplace_back(quantity.Name);
  }
  names.emplace_back(Directions);
  return names;
}

//------------------------------------------------------------------------------
void DrawCurvature(vtkPolyData* surface, const std::string& what, const ViewOptions& view,
  const ModelOptions& models, const std::string& file, Reporter& reporter)
{
  reporter.BeginStage("draw");
  const auto* const quantity = std::find_if(std::begin(Quantities), std::end(Quantities),
    [&](const Quantity& known) { return what == known.Name; });
  const bool hasColours = quantity != std::end(Quantities);
  Legend legend;
  if (!hasColours)
  {
    AddDirectionStrength(surface);
  }
  else
  {
    legend = MakeLegend(*quantity, surface);
  }
  const std::array<int, 2> size = view.GetSize();
  const int height = GetLegendHeight(size);
  const auto window = MakeWindow(reporter, { size[0], size[1] - height });
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(Paper[0], Paper[1], Paper[2]);
  renderer->AutomaticLightCreationOff();
  window->AddRenderer(renderer);
  AddSurface(renderer, surface, hasColours ? quantity : nullptr, legend.Colours);
  view.Apply(renderer, models);

  vtkNew<vtkNPRFeatureLines> contours;
  contours->SetInputData(surface);
  contours->AddDefinition("contours");
  contours->SetMinimumLength(LeastContour);
  contours->SetCamera(renderer->GetActiveCamera());
  vtkNew<vtkNPRSplineStrokes> strokes;
  strokes->SetInputConnection(contours->GetOutputPort());
  AddInk(renderer, strokes->GetOutputPort(), Ink, std::max(1.0, size[1] / 600.0));

  if (!hasColours)
  {
    const double width = size[1] / 480.0;
    const auto second = MakeHatching(renderer, surface, names::PrincipalDirection2, 0.016, 3.0);
    AddInk(renderer, second->GetOutputPort(), SecondInk, 0.8 * width);
    const auto first = MakeHatching(renderer, surface, names::PrincipalDirection1, 0.009, 5.0);
    AddInk(renderer, first->GetOutputPort(), FirstInk, width);
    legend.Strokes = { { FirstInk, "first principal direction" },
      { SecondInk, "second principal direction" } };
  }
  vtkSmartPointer<vtkImageData> image = GrabImage(window, reporter);
  if (height > 0)
  {
    image = AddLegend(image, legend, height, Paper);
  }
  reporter.BeginStage("write");
  WriteImage(image, file);
  reporter.EndStage();
}
}
