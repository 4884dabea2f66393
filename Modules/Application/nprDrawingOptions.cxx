// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprDrawingOptions.h"

#include "nprImageFile.h"
#include "nprReporter.h"
#include "vtkNPRIllustrationStyle.h"
#include "vtkNPRSVGWriter.h"
#include "vtkNPRStrokeVisibility.h"
#if NPR_HAS_CAIRO
#include "vtkNPRPDFWriter.h"
#endif

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkCamera.h>
#include <vtkDataSet.h>
#include <vtkMapper.h>
#include <vtkMath.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <optional>

namespace npr
{
namespace
{
const std::map<std::string, double> MillimetresOfUnits = { { "um", 0.001 }, { "mm", 1.0 },
  { "cm", 10.0 }, { "m", 1000.0 }, { "in", 25.4 }, { "ft", 304.8 } };
constexpr double SmallestPaper = 30.0; // millimetres
constexpr double LargestPaper = 5000.0;
constexpr double SmallestDrawing = 1.0; // millimetres, its longer side: smaller, it is a dot
/// Of the room on the paper: in smaller drawings styles leave out most lines as too short.
constexpr double SmallShare = 0.1;

/// Two positive numbers with a sign between them.
std::optional<std::array<double, 2>> ParsePair(const std::string& text, char sign)
{
  std::array<double, 2> numbers;
  char found = '\0';
  char rest = '\0';
  const bool good =
    std::sscanf(text.c_str(), "%lf%c%lf%c", &numbers[0], &found, &numbers[1], &rest) == 3 &&
    found == sign;
  const auto isPositive = [](double number) { return std::isfinite(number) && number > 0.0; };
  return good && isPositive(numbers[0]) && isPositive(numbers[1]) ? std::make_optional(numbers)
                                                                  : std::nullopt;
}

void SetPaper(vtkNPRDrawingWriter* writer, const std::string& paper)
{
  const std::string name = CLI::detail::to_lower(paper);
  if (name == "a4" || name == "a3" || name == "letter")
  {
    writer->SetPaper(name == "a4" ? vtkNPRDrawingWriter::A4_PAPER
        : name == "a3"            ? vtkNPRDrawingWriter::A3_PAPER
                                  : vtkNPRDrawingWriter::LETTER_PAPER);
    return;
  }
  const auto size = ParsePair(name, 'x');
  if (!size || std::min((*size)[0], (*size)[1]) < SmallestPaper ||
    std::max((*size)[0], (*size)[1]) > LargestPaper)
  {
    throw CommandError(UsageError,
      "--paper '" + paper + "': write A4, A3, Letter, or WIDTHxHEIGHT in mm, each from 30 to 5000");
  }
  writer->SetPageSize((*size)[0], (*size)[1]);
}

/// What the view shows of the actors' points, from its middle to the right and upwards, in the
/// world.
struct Extent
{
  std::array<double, 2> Least = { VTK_DOUBLE_MAX, VTK_DOUBLE_MAX };
  std::array<double, 2> Most = { -VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX };

  double GetSize(int axis) const { return this->Most[axis] - this->Least[axis]; }
  double GetMiddle(int axis) const { return 0.5 * (this->Most[axis] + this->Least[axis]); }
};

Extent MeasureView(vtkRenderer* renderer)
{
  Extent extent;
  vtkActorCollection* const actors = renderer->GetActors();
  vtkCollectionSimpleIterator cookie;
  actors->InitTraversal(cookie);
  while (vtkActor* const actor = actors->GetNextActor(cookie))
  {
    actor->GetMapper()->Update();
    auto* const data = vtkDataSet::SafeDownCast(actor->GetMapper()->GetInputDataObject(0, 0));
    vtkNew<vtkMatrix4x4> toView;
    vtkMatrix4x4::Multiply4x4(
      renderer->GetActiveCamera()->GetViewTransformMatrix(), actor->GetMatrix(), toView);
    for (vtkIdType i = 0; data && i < data->GetNumberOfPoints(); ++i)
    {
      double point[4] = { 0.0, 0.0, 0.0, 1.0 };
      data->GetPoint(i, point);
      toView->MultiplyPoint(point, point);
      for (int axis = 0; axis < 2; ++axis)
      {
        extent.Least[axis] = std::min(extent.Least[axis], point[axis]);
        extent.Most[axis] = std::max(extent.Most[axis], point[axis]);
      }
    }
  }
  return extent;
}

std::string ToText(double number)
{
  char text[32];
  std::snprintf(text, sizeof(text), "%.4g", number);
  return text;
}

/// The largest of the usual scales (1, 2 and 5, times powers of ten) that is no larger.
std::string FindUsualScale(double largest)
{
  const bool enlarges = largest >= 1.0;
  const double number = enlarges ? largest : 1.0 / largest;
  const double power = std::pow(10.0, std::floor(std::log10(number)));
  double best = enlarges ? power : 10.0 * power;
  for (const double step : { 1.0, 2.0, 5.0 })
  {
    const double usual = step * power;
    best = enlarges ? (usual <= number ? std::max(best, usual) : best)
                    : (usual >= number ? std::min(best, usual) : best);
  }
  return enlarges ? ToText(best) + ":1" : "1:" + ToText(best);
}
}

//------------------------------------------------------------------------------
bool IsDrawingFile(const std::string& file)
{
  const std::string extension = ExtensionOf(file);
  return extension == ".svg" || extension == ".pdf";
}

//------------------------------------------------------------------------------
void DrawingOptions::AddTo(CLI::App& command)
{
  const std::string group = "Options for .svg and .pdf";
  std::vector<std::string> units;
  for (const auto& unit : MillimetresOfUnits)
  {
    units.push_back(unit.first);
  }
  this->Given = {
    command.add_option("--hidden", this->Hidden, "Hidden lines: none, dashed or shown")
      ->check(CLI::IsMember({ "none", "dashed", "shown" }))
      ->capture_default_str(),
    command.add_option("--paper", this->Paper, "A4, A3, Letter, or WIDTHxHEIGHT in mm")
      ->capture_default_str(),
    command.add_option("--scale", this->Scale,
      "PAPER:MODEL, such as 1:2 or 5:1; needs --projection parallel; default: as large as the "
      "paper holds the picture"),
    command.add_flag(
      "--scale-bar", this->ScaleBar, "Draw a scale bar; needs --projection parallel"),
    command
      .add_option("--unit", this->Unit, "What a unit of the model is: um, mm, cm, m, in or ft")
      ->check(CLI::IsMember(units))
      ->capture_default_str(),
    command
      .add_option("--shading", this->Shading,
        "What lies below the lines: image (a picture of the shading), tones (filled areas, of "
        "toon shading), none, or auto: an image where the style shades and no hidden lines are "
        "drawn")
      ->check(CLI::IsMember({ "auto", "image", "tones", "none" }))
      ->capture_default_str(),
  };
  for (CLI::Option* const option : this->Given)
  {
    option->group(group);
  }
}

//------------------------------------------------------------------------------
void DrawingOptions::RefuseFor(const std::string& file) const
{
  for (const CLI::Option* const option : this->Given)
  {
    if (option->count() > 0)
    {
      throw CommandError(UsageError,
        option->get_name() + " is for vector drawings; write .svg or .pdf instead of " + file);
    }
  }
}

//------------------------------------------------------------------------------
double DrawingOptions::GetMillimetresPerUnit() const
{
  return MillimetresOfUnits.at(this->Unit);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkNPRDrawingWriter> DrawingOptions::MakeWriter(
  const std::string& file, bool isParallel, const std::array<int, 2>& size) const
{
  if (!vtkNPRStrokeVisibility::IsAvailable())
  {
    throw CommandError(OtherError,
      "this build can not find hidden lines; build it with -DNPR_USE_EMBREE=ON (npr doctor)");
  }
  vtkSmartPointer<vtkNPRDrawingWriter> writer;
  if (ExtensionOf(file) == ".svg")
  {
    writer = vtkSmartPointer<vtkNPRSVGWriter>::New();
  }
  else
  {
#if NPR_HAS_CAIRO
    writer = vtkSmartPointer<vtkNPRPDFWriter>::New();
#else
    throw CommandError(OtherError,
      file + ": this build can not write PDF; write .svg, or build it with -DNPR_USE_CAIRO=ON");
#endif
  }
  CheckWritable(file);

  SetPaper(writer, this->Paper);
  writer->SetViewportSize(size[0], size[1]);
  writer->SetHiddenLines(this->Hidden == "dashed" ? vtkNPRDrawingWriter::HIDDEN_LINES_DASHED
      : this->Hidden == "shown"                   ? vtkNPRDrawingWriter::HIDDEN_LINES_SHOWN
                                                  : vtkNPRDrawingWriter::HIDDEN_LINES_NONE);
  if (!this->Scale.empty())
  {
    const auto scale = ParsePair(this->Scale, ':');
    if (!scale)
    {
      throw CommandError(
        UsageError, "--scale '" + this->Scale + "': write PAPER:MODEL, such as 1:2 or 5:1");
    }
    writer->SetFit(vtkNPRDrawingWriter::TRUE_SCALE);
    writer->SetScale((*scale)[0] / (*scale)[1]);
    writer->SetMillimetresPerUnit(this->GetMillimetresPerUnit());
  }
  writer->SetScaleBar(this->ScaleBar);
  writer->SetUnitName(this->Unit);
  if (!isParallel && (this->ScaleBar || !this->Scale.empty()))
  {
    throw CommandError(UsageError,
      std::string(this->Scale.empty() ? "--scale-bar" : "--scale") +
        " needs --projection parallel: in perspective, what is far away is smaller");
  }
  return writer;
}

//------------------------------------------------------------------------------
DrawingShading DrawingOptions::GetShading(vtkNPRIllustrationStyle* style) const
{
  if (this->Shading == "tones")
  {
    if (!style->HasShading())
    {
      throw CommandError(UsageError,
        "--shading tones needs a style that shades, and '" + style->GetName() +
          "' does not; take --style toon");
    }
    return DrawingShading::Tones;
  }
  // What is hidden is not seen through a shaded surface.
  const bool isImage = this->Shading == "image" ||
    (this->Shading == "auto" && this->Hidden == "none" && style->HasShading());
  return isImage ? DrawingShading::Image : DrawingShading::None;
}

//------------------------------------------------------------------------------
void DrawingOptions::FitViewToPage(
  vtkRenderer* renderer, vtkNPRDrawingWriter* writer, Reporter& reporter) const
{
  if (writer->GetFit() != vtkNPRDrawingWriter::TRUE_SCALE)
  {
    return;
  }
  const Extent extent = MeasureView(renderer);
  const double millimetres = writer->GetScale() * writer->GetMillimetresPerUnit(); // of a unit
  const std::array<double, 2> drawn = { millimetres * extent.GetSize(0),
    millimetres * extent.GetSize(1) };
  writer->SetOrientation(
    drawn[0] > drawn[1] ? vtkNPRDrawingWriter::LANDSCAPE : vtkNPRDrawingWriter::PORTRAIT);
  std::array<double, 2> room;
  writer->GetPageSize(room.data());
  for (double& side : room)
  {
    side -= 2.0 * writer->GetMargin();
  }
  const double share = std::min(room[0] / drawn[0], room[1] / drawn[1]);
  const std::string sizes = "at the scale " + this->Scale + " the drawing is " + ToText(drawn[0]) +
    " x " + ToText(drawn[1]) + " mm, and the paper " + this->Paper + " has room for " +
    ToText(room[0]) + " x " + ToText(room[1]) + " mm; take --scale " +
    FindUsualScale(share * writer->GetScale());
  if (share < 1.0)
  {
    throw CommandError(UsageError, sizes + ", or a larger --paper");
  }
  const std::string remedies = ", a smaller --paper, or another --unit than " + this->Unit;
  if (std::max(drawn[0], drawn[1]) < SmallestDrawing)
  {
    throw CommandError(UsageError, sizes + remedies);
  }
  if (share * SmallShare > 1.0)
  {
    reporter.Warn(sizes + remedies);
  }

  int size[2];
  writer->GetViewportSize(size);
  const double pixels = std::min(size[0], size[1]) / std::min(room[0], room[1]);
  writer->SetViewportSize(std::max(1, static_cast<int>(std::lround(pixels * room[0]))),
    std::max(1, static_cast<int>(std::lround(pixels * room[1]))));
  renderer->GetRenderWindow()->SetSize(writer->GetViewportSize());
  vtkCamera* const camera = renderer->GetActiveCamera();
  camera->SetParallelScale(0.5 * room[1] / millimetres);
  const double* const right = camera->GetViewTransformMatrix()->GetData();
  std::array<double, 3> eye;
  std::array<double, 3> target;
  for (int i = 0; i < 3; ++i)
  {
    const double move = extent.GetMiddle(0) * right[i] + extent.GetMiddle(1) * right[4 + i];
    eye[i] = camera->GetPosition()[i] + move;
    target[i] = camera->GetFocalPoint()[i] + move;
  }
  camera->SetPosition(eye.data());
  camera->SetFocalPoint(target.data());
  renderer->ResetCameraClippingRange();
}
}
