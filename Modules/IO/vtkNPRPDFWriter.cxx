// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRPDFWriter.h"

#include "nprPDFLayers.h"
#include "nprPageComposer.h"

#include <vtkImageData.h>
#include <vtkObjectFactory.h>

#include <cairo-pdf.h>
#include <cairo.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

vtkStandardNewMacro(vtkNPRPDFWriter);

namespace
{
constexpr double PointsPerMillimetre = 72.0 / 25.4;

struct Destroy
{
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  void operator()(cairo_t* context) const { cairo_destroy(context); }
};
using Surface = std::unique_ptr<cairo_surface_t, Destroy>;
using Context = std::unique_ptr<cairo_t, Destroy>;

cairo_status_t AppendBytes(void* bytes, const unsigned char* data, unsigned int length)
{
  static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

/// Path commands from one place of the layer's path to another.
void AddPath(cairo_t* context, const npr::PagePath& path, std::size_t command,
  std::size_t commandEnd, std::size_t point)
{
  for (; command < commandEnd; ++command)
  {
    const npr::PagePath::Command kind = path.Commands[command];
    const npr::PagePoint* const p = path.Points.data() + point;
    switch (kind)
    {
      case npr::PagePath::MOVE:
        cairo_move_to(context, p[0].x(), p[0].y());
        break;
      case npr::PagePath::LINE:
        cairo_line_to(context, p[0].x(), p[0].y());
        break;
      case npr::PagePath::CURVE:
        cairo_curve_to(context, p[0].x(), p[0].y(), p[1].x(), p[1].y(), p[2].x(), p[2].y());
        break;
      case npr::PagePath::CLOSE:
        cairo_close_path(context);
        break;
    }
    point += npr::PagePath::GetNumberOfPoints(kind);
  }
}

void DrawLayer(cairo_t* context, const npr::PageLayer& layer)
{
  constexpr cairo_line_cap_t Caps[] = { CAIRO_LINE_CAP_BUTT, CAIRO_LINE_CAP_ROUND,
    CAIRO_LINE_CAP_SQUARE };
  constexpr cairo_line_join_t Joins[] = { CAIRO_LINE_JOIN_MITER, CAIRO_LINE_JOIN_ROUND,
    CAIRO_LINE_JOIN_BEVEL };
  constexpr double MiterLimit = 4.0; // SVG's default
  const npr::LineInk& ink = layer.Ink;
  const bool isTranslucent = ink.Opacity < 1.0;
  if (isTranslucent)
  {
    cairo_push_group(context);
  }
  cairo_set_source_rgb(context, ink.Color[0], ink.Color[1], ink.Color[2]);
  cairo_set_line_width(context, ink.Width);
  cairo_set_line_cap(context, Caps[ink.Cap]);
  cairo_set_line_join(context, Joins[ink.Join]);
  cairo_set_miter_limit(context, MiterLimit);
  cairo_set_dash(context, ink.Dashes.data(), static_cast<int>(ink.Dashes.size()), 0.0);
  std::size_t command = 0;
  std::size_t point = 0;
  for (const npr::PageShape& shape : layer.Shapes)
  {
    AddPath(context, layer.Path, command, shape.CommandEnd, point);
    shape.Filled ? cairo_fill(context) : cairo_stroke(context);
    command = shape.CommandEnd;
    point = shape.PointEnd;
  }
  for (const npr::PageText& label : layer.Texts)
  {
    cairo_select_font_face(
      context, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(context, label.Height);
    cairo_text_extents_t extents;
    cairo_text_extents(context, label.Text.c_str(), &extents);
    cairo_move_to(context, label.Middle.x() - 0.5 * extents.x_advance, label.Middle.y());
    cairo_show_text(context, label.Text.c_str());
  }
  if (isTranslucent)
  {
    cairo_pop_group_to_source(context);
    cairo_paint_with_alpha(context, ink.Opacity);
  }
}

/// An image as cairo has it: rows from the top, and what is transparent laid on white, for the
/// black behind it would show where viewers interpolate.
std::vector<std::uint32_t> GetPixels(vtkImageData* image)
{
  const int* const size = image->GetDimensions();
  const int components = image->GetNumberOfScalarComponents();
  const bool isGrey = components < 3;
  std::vector<std::uint32_t> pixels;
  pixels.reserve(static_cast<std::size_t>(size[0]) * size[1]);
  const int* const extent = image->GetExtent();
  for (int y = extent[3]; y >= extent[2]; --y)
  {
    for (int x = extent[0]; x <= extent[1]; ++x)
    {
      const auto* const p =
        static_cast<const unsigned char*>(image->GetScalarPointer(x, y, extent[4]));
      const std::uint32_t alpha = components % 2 == 0 ? p[components - 1] : 255;
      std::uint32_t pixel = 0;
      for (int c = 0; c < 3; ++c)
      {
        pixel = pixel << 8 | (p[isGrey ? 0 : c] * alpha + 255 * (255 - alpha) + 127) / 255;
      }
      pixels.push_back(pixel);
    }
  }
  return pixels;
}

void DrawImage(cairo_t* context, const npr::PageDrawing& drawing)
{
  const int* const size = drawing.Image->GetDimensions();
  std::vector<std::uint32_t> pixels = GetPixels(drawing.Image);
  const Surface surface(
    cairo_image_surface_create_for_data(reinterpret_cast<unsigned char*>(pixels.data()),
      CAIRO_FORMAT_RGB24, size[0], size[1], static_cast<int>(size[0] * sizeof(std::uint32_t))));
  const npr::PagePoint corner = drawing.Area.Least;
  const npr::PagePoint area = drawing.Area.GetSize();
  const npr::PageRectangle& place = drawing.ImagePlace;
  cairo_save(context);
  cairo_rectangle(context, corner.x(), corner.y(), area.x(), area.y());
  cairo_clip(context);
  cairo_translate(context, place.Least.x(), place.Least.y());
  cairo_scale(context, place.GetSize().x() / size[0], place.GetSize().y() / size[1]);
  cairo_set_source_surface(context, surface.get(), 0.0, 0.0);
  cairo_paint(context);
  cairo_restore(context);
  cairo_surface_finish(surface.get()); // before the pixels go
}

void DrawTones(cairo_t* context, const npr::PageDrawing& drawing)
{
  const npr::PageRectangle area = drawing.GetPictureArea();
  const npr::PagePoint size = area.GetSize();
  cairo_save(context);
  cairo_rectangle(context, area.Least.x(), area.Least.y(), size.x(), size.y());
  cairo_clip(context);
  cairo_set_fill_rule(context, CAIRO_FILL_RULE_EVEN_ODD);
  for (const npr::PageTone& tone : drawing.Tones)
  {
    cairo_set_source_rgb(context, tone.Color[0], tone.Color[1], tone.Color[2]);
    AddPath(context, tone.Path, 0, tone.Path.Commands.size(), 0);
    cairo_fill(context);
  }
  cairo_restore(context);
}

void TellMetadata(cairo_surface_t* surface, const npr::PageDrawing& drawing)
{
  std::string subject;
  for (const auto& fact : drawing.Facts)
  {
    subject += (subject.empty() ? "" : "; ") + fact.first + ": " + fact.second;
  }
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_TITLE, drawing.Title.c_str());
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_SUBJECT, subject.c_str());
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATOR, "vtkNPR");
  // An empty one keeps cairo from writing the time of day.
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE, drawing.Date.c_str());
}
}

//------------------------------------------------------------------------------
std::string vtkNPRPDFWriter::Encode(const npr::PageDrawing& drawing)
{
  std::string bytes;
  const Surface surface(cairo_pdf_surface_create_for_stream(AppendBytes, &bytes,
    PointsPerMillimetre * drawing.Width, PointsPerMillimetre * drawing.Height));
  TellMetadata(surface.get(), drawing);
  const Context context(cairo_create(surface.get()));
  cairo_scale(context.get(), PointsPerMillimetre, PointsPerMillimetre);
  // Each layer is a page for cairo.
  std::vector<std::string> layers;
  if (drawing.Image)
  {
    DrawImage(context.get(), drawing);
    cairo_show_page(context.get());
    layers.emplace_back(npr::ImageLayerName);
  }
  if (!drawing.Tones.empty())
  {
    DrawTones(context.get(), drawing);
    cairo_show_page(context.get());
    layers.emplace_back(npr::TonesLayerName);
  }
  for (const npr::PageLayer& layer : drawing.Layers)
  {
    DrawLayer(context.get(), layer);
    cairo_show_page(context.get());
    layers.push_back(layer.Name);
  }
  if (layers.empty())
  {
    cairo_show_page(context.get());
  }
  cairo_surface_finish(surface.get());
  for (const cairo_status_t status :
    { cairo_status(context.get()), cairo_surface_status(surface.get()) })
  {
    if (status != CAIRO_STATUS_SUCCESS)
    {
      throw npr::DrawingError("cairo can't make a PDF of it: " +
        std::string(cairo_status_to_string(status)) + ". Write an SVG instead.");
    }
  }
  return npr::LayPagesAsLayers(bytes, layers);
}
