// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprSVGDocument.h"

#include "nprNumberText.h"
#include "nprSVGPathText.h"

#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>

namespace npr
{
namespace
{
std::string ColorText(const std::array<double, 3>& color)
{
  std::string text = "#";
  for (const double part : color)
  {
    const int byte = static_cast<int>(std::lround(255.0 * std::clamp(part, 0.0, 1.0)));
    text += "0123456789abcdef"[byte / 16];
    text += "0123456789abcdef"[byte % 16];
  }
  return text;
}

std::string Attribute(const char* name, const std::string& value)
{
  return " " + std::string(name) + "=\"" + EscapeXML(value) + "\"";
}

std::string Attribute(const char* name, double value)
{
  return Attribute(name, NumberText(value));
}

/// A name for references in the file: letters, digits and hyphens.
std::string MakeId(const std::string& name)
{
  std::string id;
  for (const char c : name)
  {
    const unsigned char byte = static_cast<unsigned char>(c);
    if (byte < 128 && std::isalnum(byte))
    {
      id += c;
    }
    else if (!id.empty() && id.back() != '-')
    {
      id += '-';
    }
  }
  while (!id.empty() && id.back() == '-')
  {
    id.pop_back();
  }
  return id;
}

std::string Base64(const unsigned char* bytes, std::size_t count)
{
  constexpr char Letters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((count + 2) / 3 * 4);
  for (std::size_t i = 0; i < count; i += 3)
  {
    const std::size_t left = count - i;
    const unsigned int three =
      bytes[i] << 16 | (left > 1 ? bytes[i + 1] << 8 : 0) | (left > 2 ? bytes[i + 2] : 0);
    text += Letters[three >> 18 & 63];
    text += Letters[three >> 12 & 63];
    text += left > 1 ? Letters[three >> 6 & 63] : '=';
    text += left > 2 ? Letters[three & 63] : '=';
  }
  return text;
}

std::string RectangleAttributes(const PageRectangle& rectangle)
{
  const PagePoint size = rectangle.GetSize();
  return Attribute("x", rectangle.Least.x()) + Attribute("y", rectangle.Least.y()) +
    Attribute("width", size.x()) + Attribute("height", size.y());
}

std::string LayerStart(const std::string& name)
{
  return "<g" + Attribute("id", MakeId(name)) + " inkscape:groupmode=\"layer\"" +
    Attribute("inkscape:label", name);
}

void AddImage(const PageDrawing& drawing, std::string& text)
{
  vtkNew<vtkPNGWriter> png;
  png->SetInputData(drawing.Image);
  png->WriteToMemoryOn();
  png->Write();
  vtkUnsignedCharArray* const bytes = png->GetResult();
  const PageRectangle& area = drawing.Area;
  const bool isCut = (drawing.ImagePlace.Least.array() < area.Least.array() - 1e-6).any() ||
    (drawing.ImagePlace.Most.array() > area.Most.array() + 1e-6).any();
  if (isCut)
  {
    text += "<clipPath id=\"area\"><rect" + RectangleAttributes(area) + "/></clipPath>\n";
  }
  text += LayerStart(ImageLayerName) + (isCut ? " clip-path=\"url(#area)\"" : "") + ">\n<image" +
    RectangleAttributes(drawing.ImagePlace) +
    " preserveAspectRatio=\"none\" xlink:href=\"data:image/png;base64,";
  text += Base64(bytes->GetPointer(0), static_cast<std::size_t>(bytes->GetNumberOfValues()));
  text += "\"/>\n</g>\n";
}

void AddTones(const PageDrawing& drawing, int decimals, std::string& text)
{
  // What reaches the picture's border goes on beyond it.
  text += "<clipPath id=\"picture\"><rect" + RectangleAttributes(drawing.GetPictureArea()) +
    "/></clipPath>\n" + LayerStart(TonesLayerName) +
    " fill-rule=\"evenodd\" clip-path=\"url(#picture)\">\n";
  for (const PageTone& tone : drawing.Tones)
  {
    text += "<path" + Attribute("fill", ColorText(tone.Color)) + " d=\"";
    SVGPathText(decimals, text).Add(tone.Path, 0, tone.Path.Commands.size(), 0);
    text += "\"/>\n";
  }
  text += "</g>\n";
}

void AddLayer(const PageLayer& layer, int decimals, std::string& text)
{
  const char* const caps[] = { "butt", "round", "square" };
  const char* const joins[] = { "miter", "round", "bevel" };
  const LineInk& ink = layer.Ink;
  const std::string color = ColorText(ink.Color);
  text += LayerStart(layer.Name) + " fill=\"none\"" + Attribute("stroke", color) +
    Attribute("stroke-width", ink.Width) + Attribute("stroke-linecap", caps[ink.Cap]) +
    Attribute("stroke-linejoin", joins[ink.Join]);
  if (!ink.Dashes.empty())
  {
    std::string dashes;
    for (const double dash : ink.Dashes)
    {
      dashes += (dashes.empty() ? "" : " ") + NumberText(dash);
    }
    text += Attribute("stroke-dasharray", dashes);
  }
  if (ink.Opacity < 1.0)
  {
    text += Attribute("opacity", ink.Opacity);
  }
  text += ">\n";

  const std::string filled = Attribute("fill", color) + " stroke=\"none\"";
  SVGPathText path(decimals, text);
  std::size_t command = 0;
  std::size_t point = 0;
  for (const PageShape& shape : layer.Shapes)
  {
    text += shape.Filled ? "<path" + filled + " d=\"" : "<path d=\"";
    path.Add(layer.Path, command, shape.CommandEnd, point);
    text += "\"/>\n";
    command = shape.CommandEnd;
    point = shape.PointEnd;
  }
  for (const PageText& label : layer.Texts)
  {
    text += "<text" + Attribute("x", label.Middle.x()) + Attribute("y", label.Middle.y()) + filled +
      Attribute("font-size", label.Height) + " font-family=\"sans-serif\" text-anchor=\"middle\">" +
      EscapeXML(label.Text) + "</text>\n";
  }
  text += "</g>\n";
}
}

//------------------------------------------------------------------------------
std::string EscapeXML(const std::string& text)
{
  std::string escaped;
  for (const char c : text)
  {
    switch (c)
    {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        escaped += static_cast<unsigned char>(c) < 32 ? '?' : c;
    }
  }
  return escaped;
}

//------------------------------------------------------------------------------
std::string EncodeSVG(const PageDrawing& drawing)
{
  const std::string width = NumberText(drawing.Width);
  const std::string height = NumberText(drawing.Height);
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                     "<svg xmlns=\"http://www.w3.org/2000/svg\" "
                     "xmlns:xlink=\"http://www.w3.org/1999/xlink\" "
                     "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" "
                     "xmlns:npr=\"urn:vtknpr:drawing\" version=\"1.1\"";
  text += Attribute("width", width + "mm") + Attribute("height", height + "mm") +
    Attribute("viewBox", "0 0 " + width + " " + height) + ">\n";
  if (!drawing.Title.empty())
  {
    text += "<title>" + EscapeXML(drawing.Title) + "</title>\n";
  }
  text += "<metadata>\n<npr:drawing";
  if (!drawing.Date.empty())
  {
    text += Attribute("date", drawing.Date);
  }
  for (const auto& fact : drawing.Facts)
  {
    text += Attribute(fact.first.c_str(), fact.second);
  }
  text += "/>\n</metadata>\n";

  if (drawing.Image)
  {
    AddImage(drawing, text);
  }
  const int decimals =
    std::clamp(static_cast<int>(std::lround(-std::log10(drawing.Resolution))), 0, 9);
  if (!drawing.Tones.empty())
  {
    AddTones(drawing, decimals, text);
  }
  for (const PageLayer& layer : drawing.Layers)
  {
    AddLayer(layer, decimals, text);
  }
  text += "</svg>\n";
  return text;
}
}
