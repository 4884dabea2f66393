// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprPageComposer.h"

#include "nprCurveFit.h"
#include "nprLineCover.h"
#include "nprNumberText.h"
#include "nprPageView.h"
#include "nprScaleBar.h"
#include "nprStrokeInput.h"
#include "nprStrokeOutline.h"
#include "nprToneRegions.h"
#include "vtkNPRDrawingStyle.h"

#include <vtkCamera.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace npr
{
namespace
{
// Of a stroke's tolerance, this much is spent on leaving out points that are close together.
constexpr double ThinningShare = 0.25;
// What rounds a polyline by less than this is no corner; millimetres.
constexpr double BendTolerance = 0.1;
// Shorter pieces of hidden lines are not worth a cut; millimetres.
constexpr double LeastHidden = 1.0;
// What is smaller than a square of this is no tone, but dirt.
constexpr double LeastSpotInTolerances = 10.0;
// No border of tones is known more exactly.
constexpr double ToneToleranceInPixels = 0.5;
// Of the width of a stroke; millimetres a millimetre of the way.
constexpr double WidthSlope = 0.2;

/// The strokes of one layer, by their numbers in the input.
struct LayerPlan
{
  std::string Name;
  LineInk Ink;
  StrokeInput::WidthRule Rule;
  std::vector<vtkIdType> Lines;
  bool IsHidden = false;
  std::vector<std::vector<PageChain>> Chains; // of hidden lines, where they are to be seen
};

void Require(bool condition, const std::string& problem)
{
  if (!condition)
  {
    throw DrawingError(problem);
  }
}

bool IsPositive(double value)
{
  return std::isfinite(value) && value > 0.0;
}

std::string SizeText(double width, double height)
{
  return NumberText(width) + " x " + NumberText(height);
}

/// Of a closed polygon.
double GetArea(const std::vector<PagePoint>& points)
{
  double twice = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const PagePoint& here = points[i];
    const PagePoint& next = points[(i + 1) % points.size()];
    twice += here.x() * next.y() - here.y() * next.x();
  }
  return 0.5 * std::abs(twice);
}

std::vector<PageChain> CutAll(
  const std::vector<PageChain>& chains, const LineCover& cover, double distance, double least)
{
  std::vector<PageChain> all;
  for (const PageChain& chain : chains)
  {
    const std::vector<PageChain> parts = cover.Cut(chain, distance, least);
    all.insert(all.end(), parts.begin(), parts.end());
  }
  return all;
}

void CheckRequest(const PageRequest& request)
{
  Require(request.Camera, "There is no camera; give SetCamera() the one that the strokes are for.");
  Require(request.Viewport[0] > 0 && request.Viewport[1] > 0,
    "The viewport is " + SizeText(request.Viewport[0], request.Viewport[1]) +
      " pixels; SetViewportSize() takes a width and height of at least 1.");
  Require(IsPositive(request.Size[0]) && IsPositive(request.Size[1]),
    "The page is " + SizeText(request.Size[0], request.Size[1]) +
      " mm; SetPageSize() takes a positive width and height.");
  Require(
    request.Margin >= 0.0 && 2.0 * request.Margin < std::min(request.Size[0], request.Size[1]),
    "Margins of " + NumberText(request.Margin) + " mm leave nothing of a page of " +
      SizeText(request.Size[0], request.Size[1]) + " mm; set a smaller Margin or a larger page.");
  Require(IsPositive(request.Tolerance),
    "The Tolerance is " + NumberText(request.Tolerance) + " mm; it must be positive.");
  Require(IsPositive(request.Scale) && IsPositive(request.MillimetresPerUnit),
    "Scale is " + NumberText(request.Scale) + " and MillimetresPerUnit " +
      NumberText(request.MillimetresPerUnit) + "; both must be positive.");
  for (vtkImageData* const image : { request.Image, request.Tones })
  {
    Require(!image ||
        (image->GetScalarType() == VTK_UNSIGNED_CHAR && image->GetNumberOfScalarComponents() <= 4 &&
          image->GetNumberOfPoints() > 0 && image->GetDimensions()[2] == 1),
      "The image below the strokes must have one layer of pixels, of 1 to 4 unsigned chars each, "
      "as vtkWindowToImageFilter gives it.");
  }
  const bool parallel = request.Camera->GetParallelProjection();
  Require(parallel || request.Fit != PageFit::TrueScale,
    "A drawing to scale needs a parallel projection: in perspective, what is far away is smaller, "
    "so there is no one scale. Call ParallelProjectionOn() on the camera, or fit to the page.");
  Require(parallel || !request.ScaleBar,
    "A scale bar needs a parallel projection: in perspective, no bar holds for all depths. Call "
    "ParallelProjectionOn() on the camera, or ScaleBarOff().");
}

//------------------------------------------------------------------------------
class Composer
{
public:
  Composer(const PageRequest& request, vtkPolyData* strokes)
    : Request(request), Input(strokes),
      View(request.Camera, request.Viewport[0], request.Viewport[1])
  {
    this->Fit.Tolerance = (1.0 - ThinningShare) * request.Tolerance;
    this->Fit.BendTolerance = std::max(BendTolerance, request.Tolerance);
    // No turn is a corner at 180 degrees, however the cosine is rounded.
    this->Fit.CornerCosine = request.CornerAngle < 180.0
      ? std::cos(vtkMath::RadiansFromDegrees(request.CornerAngle))
      : -2.0;
  }

  PageDrawing Compose(std::vector<std::string>& warnings)
  {
    PageDrawing drawing;
    drawing.Width = this->Request.Size[0];
    drawing.Height = this->Request.Size[1];
    drawing.Title = this->Request.Title;
    drawing.Date = this->Request.Date;
    drawing.Resolution =
      std::min(0.001, std::pow(10.0, std::floor(std::log10(0.1 * this->Request.Tolerance))));

    std::vector<LayerPlan> plans = this->PlanLayers();
    this->PlacePicture(plans, drawing, warnings);
    this->TellFacts(drawing);
    this->FillTones(drawing);
    this->ChooseHiddenLines(plans, drawing.Area);
    for (LayerPlan& plan : plans)
    {
      PageLayer layer = this->DrawLayer(plan);
      if (!layer.Shapes.empty())
      {
        drawing.Layers.push_back(std::move(layer));
      }
    }
    if (this->Request.ScaleBar)
    {
      drawing.Layers.push_back(
        MakeScaleBar(drawing.Area, this->GetMillimetresPerUnit(), this->Request.UnitName));
    }
    return drawing;
  }

private:
  /// On the page, in a parallel projection.
  double GetMillimetresPerUnit() const
  {
    return this->MillimetresPerPixel * this->View.GetPixelsPerUnit();
  }

  /// Hidden layers below all others; within each, the first line type on top.
  std::vector<LayerPlan> PlanLayers() const
  {
    const std::vector<std::string>& types = this->Input.GetTypeNames();
    std::vector<LayerPlan> plans(2 * types.size());
    const auto getPlace = [&](int type, bool hidden)
    { return (hidden ? 1 : 2) * types.size() - 1 - static_cast<std::size_t>(type); };
    for (std::size_t type = 0; type < types.size(); ++type)
    {
      for (const bool hidden : { false, true })
      {
        LayerPlan& plan = plans[getPlace(static_cast<int>(type), hidden)];
        plan.Name = types[type] + (hidden ? " (hidden)" : " (visible)");
        plan.IsHidden = hidden;
        plan.Ink = this->Request.Style->GetInk(types[type], hidden);
        if (hidden && this->Request.Hidden == HiddenLines::Shown)
        {
          plan.Ink.Dashes.clear();
        }
        plan.Rule = { plan.Ink.Width, plan.Ink.Taper };
      }
    }
    for (vtkIdType line = 0; line < this->Input.GetNumberOfLines(); ++line)
    {
      const bool hidden = this->Input.IsHidden(line);
      if (!hidden || this->Request.Hidden != HiddenLines::None)
      {
        plans[getPlace(this->Input.GetType(line), hidden)].Lines.push_back(line);
      }
    }
    return plans;
  }

  /// The pixels around all strokes that are drawn; false if there are none.
  bool FindBounds(const std::vector<LayerPlan>& plans, PageRectangle& bounds) const
  {
    bounds.Least.setConstant(VTK_DOUBLE_MAX);
    bounds.Most.setConstant(-VTK_DOUBLE_MAX);
    vtkNew<vtkIdList> ids;
    std::vector<StrokeInput::Chain> chains;
    for (const LayerPlan& plan : plans)
    {
      for (const vtkIdType line : plan.Lines)
      {
        this->Input.GetChains(line, plan.Rule, ids, chains);
        for (const StrokeInput::Chain& chain : chains)
        {
          for (const WorldPoint& point : chain.Points)
          {
            Eigen::Vector2d pixel;
            if (chain.Points.size() > 1 && this->View.GetPixel(point.Position, pixel))
            {
              bounds.Least = bounds.Least.cwiseMin(pixel);
              bounds.Most = bounds.Most.cwiseMax(pixel);
            }
          }
        }
      }
    }
    return bounds.Least.x() <= bounds.Most.x();
  }

  void PlacePicture(
    const std::vector<LayerPlan>& plans, PageDrawing& drawing, std::vector<std::string>& warnings)
  {
    const PagePoint size(this->Request.Size[0], this->Request.Size[1]);
    const PagePoint margin = PagePoint::Constant(this->Request.Margin);
    drawing.Area = { margin, size - margin };
    const PagePoint room = drawing.Area.GetSize();
    const PagePoint middle = 0.5 * size;

    const Eigen::Vector2d viewport(this->Request.Viewport[0], this->Request.Viewport[1]);
    PageRectangle pixels{ Eigen::Vector2d::Zero(), viewport };
    if (this->Request.Fit != PageFit::Viewport && !this->FindBounds(plans, pixels))
    {
      pixels = { Eigen::Vector2d::Zero(), viewport };
    }
    // Strokes in one line, or one place, have no height, or no size.
    const Eigen::Vector2d extent = pixels.GetSize().cwiseMax(1e-9 * viewport.maxCoeff());
    const Eigen::Vector2d center = 0.5 * (pixels.Least + pixels.Most);
    this->MillimetresPerPixel = room.cwiseQuotient(extent).minCoeff();
    if (this->Request.Fit == PageFit::TrueScale)
    {
      this->MillimetresPerPixel =
        this->Request.Scale * this->Request.MillimetresPerUnit / this->View.GetPixelsPerUnit();
      const PagePoint drawn = this->MillimetresPerPixel * extent;
      if (drawn.x() > room.x() * 1.000001 || drawn.y() > room.y() * 1.000001)
      {
        warnings.push_back("At the scale " + ScaleText(this->Request.Scale) + " the drawing is " +
          SizeText(drawn.x(), drawn.y()) + " mm, and the page has room for " +
          SizeText(room.x(), room.y()) +
          " mm: strokes are cut there. Set a smaller Scale or a larger page.");
      }
    }
    const auto getPlace = [&](const Eigen::Vector2d& pixel) -> PagePoint
    { return middle + this->MillimetresPerPixel * (pixel - center); };
    drawing.Image = this->Request.Image;
    drawing.ImagePlace = { getPlace(Eigen::Vector2d::Zero()), getPlace(viewport) };
    if (this->Request.Fit == PageFit::Viewport)
    {
      drawing.Area = drawing.ImagePlace; // what the window does not show, the page does not
    }
    this->View.Place(center, middle, this->MillimetresPerPixel, drawing.Area);
  }

  void TellFacts(PageDrawing& drawing) const
  {
    vtkCamera* const camera = this->Request.Camera;
    const auto triple = [](const double* v)
    { return NumberText(v[0], 9) + " " + NumberText(v[1], 9) + " " + NumberText(v[2], 9); };
    auto& facts = drawing.Facts;
    facts.emplace_back("style", this->Request.Style->GetName());
    if (this->Request.Fit == PageFit::TrueScale)
    {
      facts.emplace_back("scale", ScaleText(this->Request.Scale));
    }
    if (camera->GetParallelProjection())
    {
      facts.emplace_back("projection", "parallel");
      facts.emplace_back("parallel-scale", NumberText(camera->GetParallelScale(), 9));
      facts.emplace_back("millimetres-per-unit", NumberText(this->GetMillimetresPerUnit(), 9));
    }
    else
    {
      facts.emplace_back("projection", "perspective");
      facts.emplace_back("view-angle", NumberText(camera->GetViewAngle(), 9));
    }
    facts.emplace_back("camera-position", triple(camera->GetPosition()));
    facts.emplace_back("camera-focal-point", triple(camera->GetFocalPoint()));
    facts.emplace_back("camera-view-up", triple(camera->GetViewUp()));
    facts.emplace_back("viewport",
      std::to_string(this->Request.Viewport[0]) + " " + std::to_string(this->Request.Viewport[1]));
  }

  void FillTones(PageDrawing& drawing) const
  {
    if (!this->Request.Tones)
    {
      return;
    }
    const int* const size = this->Request.Tones->GetDimensions();
    const PagePoint pixel = drawing.ImagePlace.GetSize().cwiseQuotient(PagePoint(size[0], size[1]));
    FitSettings fit = this->Fit;
    fit.Tolerance = std::max(fit.Tolerance, ToneToleranceInPixels * std::max(pixel.x(), pixel.y()));
    fit.BendTolerance = std::max(fit.BendTolerance, fit.Tolerance);
    const double leastArea = std::pow(LeastSpotInTolerances * this->Request.Tolerance, 2.0);
    for (const ToneRegion& region : FindToneRegions(this->Request.Tones))
    {
      PageTone tone{ region.Color, {} };
      for (const std::vector<Eigen::Vector2d>& loop : region.Loops)
      {
        PageChain chain;
        chain.Closed = true;
        for (const Eigen::Vector2d& place : loop)
        {
          chain.Points.push_back(drawing.ImagePlace.Least + pixel.cwiseProduct(place));
        }
        if (GetArea(chain.Points) >= leastArea)
        {
          ThinChain(chain, fit.Tolerance);
          FitChain(chain, fit, tone.Path);
        }
      }
      if (!tone.Path.Commands.empty())
      {
        drawing.Tones.push_back(std::move(tone));
      }
    }
  }

  /// Blocks of strokes are drawn by threads and put together in order.
  PageLayer DrawLayer(const LayerPlan& plan) const
  {
    constexpr vtkIdType BlockSize = 64;
    const vtkIdType count = static_cast<vtkIdType>(plan.Lines.size());
    std::vector<PageLayer> blocks((count + BlockSize - 1) / BlockSize);
    vtkSMPTools::For(0, static_cast<vtkIdType>(blocks.size()), 1,
      [&](vtkIdType begin, vtkIdType end)
      {
        vtkNew<vtkIdList> ids;
        for (vtkIdType block = begin; block < end; ++block)
        {
          const vtkIdType last = std::min(count, (block + 1) * BlockSize);
          for (vtkIdType i = block * BlockSize; i < last; ++i)
          {
            std::vector<PageChain> chains =
              plan.IsHidden ? plan.Chains[i] : this->GetPageChains(plan, plan.Lines[i], ids);
            for (PageChain& chain : chains)
            {
              ThinChain(chain, ThinningShare * this->Request.Tolerance);
              this->DrawChain(plan.Ink, chain, blocks[block]);
            }
          }
        }
      });

    PageLayer layer;
    layer.Name = plan.Name;
    layer.Ink = plan.Ink;
    PagePath& path = layer.Path;
    for (PageLayer& block : blocks)
    {
      for (PageShape shape : block.Shapes)
      {
        shape.CommandEnd += path.Commands.size();
        shape.PointEnd += path.Points.size();
        layer.Shapes.push_back(shape);
      }
      path.Commands.insert(
        path.Commands.end(), block.Path.Commands.begin(), block.Path.Commands.end());
      path.Points.insert(path.Points.end(), block.Path.Points.begin(), block.Path.Points.end());
      block = PageLayer();
    }
    return layer;
  }

  std::vector<PageChain> GetPageChains(const LayerPlan& plan, vtkIdType line, vtkIdList* ids) const
  {
    std::vector<StrokeInput::Chain> chains;
    std::vector<PageChain> drawn;
    this->Input.GetChains(line, plan.Rule, ids, chains);
    for (const StrokeInput::Chain& chain : chains)
    {
      this->View.Draw(chain.Points, chain.Closed, drawn);
    }
    return drawn;
  }

  /// Leaves out what of hidden lines would touch lines above. The order of lines counts, so this is
  /// no work for threads.
  void ChooseHiddenLines(std::vector<LayerPlan>& plans, const PageRectangle& area) const
  {
    const bool isAny = std::any_of(plans.begin(), plans.end(),
      [](const LayerPlan& plan) { return plan.IsHidden && !plan.Lines.empty(); });
    if (!isAny)
    {
      return;
    }
    LineCover visible(area);
    LineCover hidden(area);
    double widest = 0.0; // of visible lines
    vtkNew<vtkIdList> ids;
    for (auto plan = plans.rbegin(); plan != plans.rend(); ++plan)
    {
      const double width = plan->Ink.Width;
      const double least = std::max(LeastHidden, 4.0 * width);
      for (const vtkIdType line : plan->Lines)
      {
        std::vector<PageChain> chains = this->GetPageChains(*plan, line, ids);
        if (plan->IsHidden)
        {
          chains = CutAll(chains, visible, 0.5 * widest + width, least);
          chains = CutAll(chains, hidden, width, least);
          plan->Chains.push_back(chains);
        }
        else
        {
          widest = std::max(widest, width);
        }
        for (const PageChain& chain : chains)
        {
          (plan->IsHidden ? hidden : visible).Mark(chain);
        }
      }
    }
  }

  void DrawChain(const LineInk& ink, PageChain& chain, PageLayer& layer) const
  {
    const auto [least, most] = std::minmax_element(chain.Widths.begin(), chain.Widths.end());
    if (chain.Points.size() < 2 || *most <= 0.0)
    {
      return;
    }
    const double tolerance = this->Request.Tolerance;
    const bool isPlain = !ink.Dashes.empty() ||
      (std::abs(*least - ink.Width) <= tolerance && std::abs(*most - ink.Width) <= tolerance);
    if (isPlain)
    {
      FitChain(chain, this->Fit, layer.Path);
    }
    else
    {
      LimitWidthChange(chain, WidthSlope);
      AddOutline(chain, this->Fit, ink.Cap == LineInk::ROUND_CAP, layer.Path);
    }
    layer.Shapes.push_back({ layer.Path.Commands.size(), layer.Path.Points.size(), !isPlain });
  }

  const PageRequest& Request;
  StrokeInput Input;
  PageView View;
  FitSettings Fit;
  double MillimetresPerPixel = 1.0;
};
}

//------------------------------------------------------------------------------
PageDrawing ComposePage(
  const PageRequest& request, vtkPolyData* strokes, std::vector<std::string>& warnings)
{
  CheckRequest(request);
  return Composer(request, strokes).Compose(warnings);
}
}
