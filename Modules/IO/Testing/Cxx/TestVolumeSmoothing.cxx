// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// A ball as a mask of zeros and ones: smoothing takes the steps out of its surface and keeps its
// size, and the iso value that is proposed for a volume lies half way between two materials.
#include "vtkNPRModelImporter.h"

#include <vtkImageData.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkXMLImageDataWriter.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

namespace
{
constexpr int Size = 40;
constexpr double Radius = 14.3;
constexpr double Centre = 0.5 * (Size - 1);

void WriteBall(const std::string& file)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(Size, Size, Size);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double* point = image->GetPoint(i);
    const double centre[3] = { Centre, Centre, Centre };
    const bool inside = vtkMath::Distance2BetweenPoints(point, centre) < Radius * Radius;
    static_cast<unsigned char*>(image->GetScalarPointer())[i] = inside ? 100 : 0;
  }
  vtkNew<vtkXMLImageDataWriter> writer;
  writer->SetInputData(image);
  writer->SetFileName(file.c_str());
  writer->Write();
}

/// Mean and standard deviation of the distances of a surface's points from the centre.
bool MeasureRadius(const std::string& file, double smoothing, double& mean, double& deviation)
{
  vtkNew<vtkNPRModelImporter> importer;
  importer->SetFileName(file.c_str());
  importer->SetIsoValue(50.0);
  importer->SetVolumeSmoothing(smoothing);
  vtkNew<vtkPolyData> surface;
  if (!importer->GetSurface(surface))
  {
    return false;
  }
  const double centre[3] = { Centre, Centre, Centre };
  double sum = 0.0;
  double squares = 0.0;
  const vtkIdType count = surface->GetNumberOfPoints();
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double square = vtkMath::Distance2BetweenPoints(surface->GetPoint(i), centre);
    sum += std::sqrt(square);
    squares += square;
  }
  mean = sum / count;
  deviation = std::sqrt(squares / count - mean * mean);
  return true;
}
}

int TestVolumeSmoothing(int argc, char* argv[])
{
  std::string file = "VolumeSmoothing.vti";
  for (int i = 1; i + 1 < argc; ++i)
  {
    if (std::string(argv[i]) == "-T")
    {
      file = argv[i + 1] + ("/" + file);
    }
  }
  WriteBall(file);
  double rawMean, rawDeviation, mean, deviation;
  if (!MeasureRadius(file, 0.0, rawMean, rawDeviation) ||
    !MeasureRadius(file, 1.0, mean, deviation))
  {
    return EXIT_FAILURE;
  }
  if (deviation > 0.35 * rawDeviation || std::abs(mean - Radius) > 0.15)
  {
    std::cerr << "FAILED: radius " << mean << " +- " << deviation << ", raw " << rawMean << " +- "
              << rawDeviation << "\n";
    return EXIT_FAILURE;
  }

  vtkObject::GlobalWarningDisplayOff();
  vtkNew<vtkNPRModelImporter> importer;
  importer->SetFileName(file.c_str());
  const bool refused = !importer->Read();
  const std::string message = importer->GetErrorMessage();
  if (!refused || message.find("try 50") == std::string::npos)
  {
    std::cerr << "FAILED: no iso value half way is proposed: " << message << "\n";
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
