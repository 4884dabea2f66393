// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprDrawingTesting.h
 * @brief Strokes to draw, and drawings read back from SVG by a parser of its own.
 */
#ifndef nprDrawingTesting_h
#define nprDrawingTesting_h

#include "vtkNPRDrawingWriter.h"
#include "vtkNPRSVGWriter.h"

#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLUtilities.h>

#include <Eigen/Core>

#include <array>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace nprtest
{
using Point2 = Eigen::Vector2d;
using Cubic = std::array<Point2, 4>;
using Line3 = std::vector<Eigen::Vector3d>;

inline std::string OutputFolder(int argc, char* argv[])
{
  for (int i = 1; i + 1 < argc; ++i)
  {
    if (std::strcmp(argv[i], "-T") == 0)
    {
      return std::string(argv[i + 1]) + "/";
    }
  }
  return "./";
}

/// Each line a polyline of points of its own, in double precision.
inline vtkSmartPointer<vtkPolyData> MakeStrokes(const std::vector<Line3>& lines)
{
  auto strokes = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  for (const Line3& line : lines)
  {
    cells->InsertNextCell(static_cast<int>(line.size()));
    for (const Eigen::Vector3d& point : line)
    {
      cells->InsertCellPoint(points->InsertNextPoint(point.data()));
    }
  }
  strokes->SetPoints(points);
  strokes->SetLines(cells);
  return strokes;
}

/// A camera that looks down at the xy plane, `height` of it high.
inline vtkSmartPointer<vtkCamera> LookDown(double height)
{
  auto camera = vtkSmartPointer<vtkCamera>::New();
  camera->SetPosition(0, 0, 100);
  camera->SetClippingRange(1, 200);
  camera->ParallelProjectionOn();
  camera->SetParallelScale(0.5 * height);
  return camera;
}

/// A page of 100 x 100 mm without margins that shows the world's (x, y) at (50 + x, 50 - y).
inline void SetPlainPage(vtkNPRDrawingWriter* writer, vtkPolyData* strokes)
{
  writer->SetInputData(strokes);
  writer->SetCamera(LookDown(100));
  writer->SetViewportSize(1000, 1000);
  writer->SetPageSize(100, 100);
  writer->SetMargin(0);
}

struct Path
{
  std::vector<std::vector<Cubic>> Parts; // straight pieces, too
  std::vector<bool> Closed;
  bool Filled = false;

  Point2 Start(std::size_t part = 0) const { return this->Parts[part].front()[0]; }
  Point2 End(std::size_t part = 0) const { return this->Parts[part].back()[3]; }
};

inline Point2 Evaluate(const Cubic& c, double t)
{
  const double s = 1 - t;
  return s * s * s * c[0] + 3 * s * s * t * c[1] + 3 * s * t * t * c[2] + t * t * t * c[3];
}

inline std::vector<Point2> Sample(const std::vector<Cubic>& curves, int steps)
{
  std::vector<Point2> points{ curves.front()[0] };
  for (const Cubic& curve : curves)
  {
    for (int i = 1; i <= steps; ++i)
    {
      points.push_back(Evaluate(curve, static_cast<double>(i) / steps));
    }
  }
  return points;
}

inline double DistanceToSegment(const Point2& p, const Point2& a, const Point2& b)
{
  const Point2 way = b - a;
  const double length = way.squaredNorm();
  const double t = length > 0 ? std::min(1.0, std::max(0.0, (p - a).dot(way) / length)) : 0.0;
  return (p - a - t * way).norm();
}

inline double DistanceToPolyline(const Point2& p, const std::vector<Point2>& line)
{
  double least = (p - line.front()).norm();
  for (std::size_t i = 1; i < line.size(); ++i)
  {
    least = std::min(least, DistanceToSegment(p, line[i - 1], line[i]));
  }
  return least;
}

/// Reads SVG's path data: M, m, l, c and z.
inline Path ParsePath(const std::string& text)
{
  Path path;
  const char* at = text.c_str();
  char command = 0;
  Point2 here(0, 0), start(0, 0);
  const auto number = [&]()
  {
    while (*at == ' ' || *at == ',')
    {
      ++at;
    }
    // strtod would read "1.2.3" as 1.2 and .3, as SVG means it.
    char* end = nullptr;
    const double value = std::strtod(at, &end);
    at = end > at ? end : at + std::strlen(at);
    return value;
  };
  const auto point = [&]()
  {
    const double x = number();
    const double y = number();
    return Point2(x, y);
  };
  while (*at)
  {
    if (std::strchr("MmlczLCZ", *at))
    {
      command = *at++;
      if (command == 'z')
      {
        if ((here - start).norm() > 1e-6)
        {
          path.Parts.back().push_back(
            { here, here + (start - here) / 3, start - (start - here) / 3, start });
        }
        path.Closed.back() = true;
        here = start;
      }
      continue;
    }
    if (command == 'M' || command == 'm')
    {
      here = command == 'M' ? point() : Point2(here + point());
      start = here;
      path.Parts.emplace_back();
      path.Closed.push_back(false);
      command = 'l';
    }
    else if (command == 'l')
    {
      const Point2 end = here + point();
      path.Parts.back().push_back({ here, here + (end - here) / 3, end - (end - here) / 3, end });
      here = end;
    }
    else
    {
      const Point2 a = here + point();
      const Point2 b = here + point();
      const Point2 end = here + point();
      path.Parts.back().push_back({ here, a, b, end });
      here = end;
    }
  }
  return path;
}

struct Layer
{
  std::string Name;
  vtkXMLDataElement* Element = nullptr;
  std::vector<Path> Paths;

  std::string Get(const char* attribute) const
  {
    const char* const value = this->Element->GetAttribute(attribute);
    return value ? value : "";
  }
};

struct Drawing
{
  vtkSmartPointer<vtkXMLDataElement> Root; // null if the file is no well-formed XML
  std::vector<Layer> Layers;

  const Layer* Find(const std::string& name) const
  {
    for (const Layer& layer : this->Layers)
    {
      if (layer.Name == name)
      {
        return &layer;
      }
    }
    return nullptr;
  }
};

inline std::string ReadFile(const std::string& file)
{
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream bytes;
  bytes << stream.rdbuf();
  return bytes.str();
}

inline Drawing ReadDrawing(const std::string& file)
{
  Drawing drawing;
  drawing.Root =
    vtkSmartPointer<vtkXMLDataElement>::Take(vtkXMLUtilities::ReadElementFromFile(file.c_str()));
  for (int i = 0; drawing.Root && i < drawing.Root->GetNumberOfNestedElements(); ++i)
  {
    vtkXMLDataElement* const group = drawing.Root->GetNestedElement(i);
    if (std::strcmp(group->GetName(), "g") != 0)
    {
      continue;
    }
    Layer layer;
    layer.Element = group;
    layer.Name = layer.Get("inkscape:label");
    for (int j = 0; j < group->GetNumberOfNestedElements(); ++j)
    {
      vtkXMLDataElement* const element = group->GetNestedElement(j);
      if (std::strcmp(element->GetName(), "path") == 0)
      {
        layer.Paths.push_back(ParsePath(element->GetAttribute("d")));
        layer.Paths.back().Filled = element->GetAttribute("fill") != nullptr;
      }
    }
    drawing.Layers.push_back(layer);
  }
  return drawing;
}

/// Writes by the writer, and reads the file.
inline Drawing Draw(vtkNPRSVGWriter* writer, const std::string& file)
{
  writer->SetFileName(file.c_str());
  return writer->Write() ? ReadDrawing(file) : Drawing();
}
}

#endif
