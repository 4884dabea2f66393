// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprDrawingOfAllKinds.h
 * @brief A drawing with one of everything that writers of drawings write.
 */
#ifndef nprDrawingOfAllKinds_h
#define nprDrawingOfAllKinds_h

#include "nprArrayNames.h"
#include "nprChecks.h"
#include "nprDrawingTesting.h"
#include "vtkNPRDrawingStyle.h"

#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>

#include <cmath>

namespace nprtest
{
/// One of everything: corners, loops, tapers, widths, hidden lines, translucent crossings.
inline vtkSmartPointer<vtkPolyData> MakeStrokesOfAllKinds()
{
  std::vector<Line3> lines{ { { -40, 30, 0 }, { -20, 45, 0 }, { -10, 25, 0 }, { 5, 45, 0 } } };
  for (int k = 0; k < 4; ++k)
  {
    Line3 line;
    for (int i = 0; i <= 100; ++i)
    {
      const double t = 2 * Pi * (i % 100) / 100;
      line.push_back(k < 2 ? Eigen::Vector3d(20 * k - 25 + 14 * std::cos(t), 9 * std::sin(t), 0)
                           : Eigen::Vector3d(0.9 * i - 60, 9 * k - 50 + 4 * std::sin(0.1 * i), 0));
    }
    lines.push_back(line);
  }
  vtkSmartPointer<vtkPolyData> strokes = MakeStrokes(lines);
  vtkNew<vtkFloatArray> strength;
  strength->SetName(npr::names::Strength);
  for (vtkIdType i = 0; i < strokes->GetNumberOfPoints(); ++i)
  {
    strength->InsertNextValue(static_cast<float>(0.5 - 0.5 * std::cos(0.06 * i)));
  }
  vtkNew<vtkIntArray> types;
  types->SetName(npr::names::LineType);
  vtkNew<vtkIntArray> hiding;
  hiding->SetName(npr::names::HidingLayers);
  for (const int type : { 0, 1, 1, 2, 0 })
  {
    types->InsertNextValue(type);
    hiding->InsertNextValue(hiding->GetNumberOfTuples() == 4);
  }
  vtkNew<vtkStringArray> names;
  names->SetName(npr::names::LineTypeNames);
  for (const char* name : { "contours", "veils", "suggestive" })
  {
    names->InsertNextValue(name);
  }
  strokes->GetPointData()->AddArray(strength);
  strokes->GetCellData()->AddArray(types);
  strokes->GetCellData()->AddArray(hiding);
  strokes->GetFieldData()->AddArray(names);
  return strokes;
}

inline vtkSmartPointer<vtkImageData> MakeImage()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(200, 150, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  auto* pixel = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int y = 0; y < 150; ++y)
  {
    for (int x = 0; x < 200; ++x, pixel += 4)
    {
      pixel[0] = 255;
      pixel[1] = static_cast<unsigned char>(200 + x / 4);
      pixel[2] = static_cast<unsigned char>(150 + y / 2);
      pixel[3] = static_cast<unsigned char>(y < 20 ? 0 : 255);
    }
  }
  return image;
}

/// A ring of one tone in another, in the lower right corner.
inline vtkSmartPointer<vtkImageData> MakeTones()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(400, 300, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  auto* pixel = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int y = 0; y < 300; ++y)
  {
    for (int x = 0; x < 400; ++x, pixel += 4)
    {
      const double radius = std::hypot(x - 330.0, y - 80.0);
      pixel[0] = pixel[1] = static_cast<unsigned char>(radius > 30 && radius < 60 ? 180 : 230);
      pixel[2] = 200;
      pixel[3] = static_cast<unsigned char>(radius < 90 ? 255 : 0);
    }
  }
  return image;
}

/// Gives it to the writer.
inline void SetDrawingOfAllKinds(vtkNPRDrawingWriter* writer)
{
  vtkNew<vtkNPRDrawingStyle> style;
  style->SetWidth("veils", 2.0);
  style->SetColor("veils", 0.1, 0.3, 0.7);
  style->SetOpacity("veils", 0.5);
  style->SetCap("veils", vtkNPRDrawingStyle::BUTT_CAP);
  style->SetWidth("suggestive", 1.0);
  style->SetJoin("contours", vtkNPRDrawingStyle::MITER_JOIN);
  SetPlainPage(writer, MakeStrokesOfAllKinds());
  writer->SetStyle(style);
  writer->SetViewportSize(1000, 750);
  writer->SetPageSize(120, 90);
  writer->SetMargin(5);
  writer->SetHiddenLines(vtkNPRDrawingWriter::HIDDEN_LINES_DASHED);
  writer->SetImage(MakeImage());
  writer->SetTones(MakeTones());
  writer->ScaleBarOn();
  writer->SetUnitName("mm");
  writer->SetTitle("One of everything");
}
}

#endif
