// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Volumes, and the iso-surfaces taken from them.
#include "nprFileFormats.h"

#include <vtkDataArrayRange.h>
#include <vtkDataSetReader.h>
#include <vtkEventForwarderCommand.h>
#include <vtkFloatArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageCast.h>
#include <vtkImageData.h>
#include <vtkImageGaussianSmooth.h>
#include <vtkInformation.h>
#include <vtkMath.h>
#include <vtkNIFTIImageReader.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkTriangle.h>
#include <vtkXMLImageDataReader.h>

#ifdef NPR_USE_OPENVDB
#include "vtkNPRVDBReader.h"
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <sstream>

namespace npr
{
namespace
{
// No compression that these formats know packs better than zlib at its best.
constexpr double LargestCompression = 1032.0;

// The value that parts the histogram best in two (N. Otsu, A threshold selection method from
// gray-level histograms, 1979).
double OtsuThreshold(vtkDataArray* scalars, const double range[2])
{
  constexpr int bins = 256;
  std::array<double, bins> histogram{};
  const double scale = (bins - 1) / (range[1] - range[0]);
  for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
  {
    const double value = scalars->GetComponent(i, 0);
    if (value >= range[0] && value <= range[1])
    {
      // The nearest: a bin stands for the value in its middle, and rounding must not move the last.
      histogram[static_cast<std::size_t>(std::lround((value - range[0]) * scale))] += 1.0;
    }
  }
  double total = 0.0;
  double sum = 0.0;
  for (int i = 0; i < bins; ++i)
  {
    total += histogram[i];
    sum += i * histogram[i];
  }
  double below = 0.0;
  double sumBelow = 0.0;
  double best = -1.0;
  double threshold = 0.5 * bins;
  for (int i = 0; i + 1 < bins; ++i)
  {
    below += histogram[i];
    sumBelow += i * histogram[i];
    const double above = total - below;
    if (below > 0.0 && above > 0.0)
    {
      const double difference = sumBelow / below - (sum - sumBelow) / above;
      const double variance = below * above * difference * difference;
      if (variance > best)
      {
        // Between the means of the two sides: where hardly any values lie between two materials,
        // that is halfway, not at the edge of one of them.
        best = variance;
        threshold = 0.5 * (sumBelow / below + (sum - sumBelow) / above);
      }
    }
  }
  return range[0] + threshold / scale;
}

std::string Text(double value)
{
  std::ostringstream text;
  text.precision(4);
  text << value;
  return text.str();
}

// VTK's contour filters order their triangles after the axes of the image; a negative spacing or
// axes of the left hand would turn the surface inside out against its own normals.
void OrderPolygonsByNormals(vtkPolyData* surface)
{
  vtkDataArray* normals = surface->GetPointData()->GetNormals();
  double agreement = 0.0;
  const vtkIdType count = surface->GetNumberOfPolys();
  const vtkIdType step = std::max<vtkIdType>(1, count / 1000);
  vtkNew<vtkIdList> points;
  for (vtkIdType cell = 0; cell < count; cell += step)
  {
    surface->GetPolys()->GetCellAtId(cell, points);
    double corner[3][3];
    for (int i = 0; i < 3; ++i)
    {
      surface->GetPoint(points->GetId(i), corner[i]);
    }
    double normal[3];
    vtkTriangle::ComputeNormal(corner[0], corner[1], corner[2], normal);
    const double product = vtkMath::Dot(normal, normals->GetTuple(points->GetId(0)));
    agreement += std::isfinite(product) ? product : 0.0;
  }
  if (agreement < 0.0)
  {
    ReversePolygons(surface);
  }
}

}

void CheckSize(vtkAlgorithm* reader, std::uint64_t bytes)
{
  reader->UpdateInformation();
  int extent[6] = { 0, -1, 0, -1, 0, -1 };
  vtkInformation* information = reader->GetOutputInformation(0);
  if (information->Has(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()))
  {
    information->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent);
  }
  double voxels = 1.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    voxels *= double(extent[2 * axis + 1]) - double(extent[2 * axis]) + 1.0;
  }
  if (voxels > LargestCompression * static_cast<double>(bytes))
  {
    throw ModelError("its header announces " + Text(voxels) + " voxels, which its " +
      std::to_string(bytes) + " bytes can not hold; it is damaged, copy or export it again");
  }
}

/// Without the steps that voxels make at the rim of a mask, if that is asked for.
vtkSmartPointer<vtkImageData> Smooth(vtkImageData* image, const ModelFile& file)
{
  if (file.VolumeSmoothing <= 0.0)
  {
    return image;
  }
  constexpr double StandardDeviations = 3.0;
  vtkNew<vtkImageCast> cast;
  cast->SetInputData(image);
  cast->SetOutputScalarTypeToFloat();
  vtkNew<vtkImageGaussianSmooth> smooth;
  file.Watch(smooth);
  smooth->SetInputConnection(cast->GetOutputPort());
  smooth->SetStandardDeviation(file.VolumeSmoothing);
  smooth->SetRadiusFactor(StandardDeviations);
  smooth->Update();
  return smooth->GetOutput();
}

void AddIsoSurface(ModelFile& file, vtkImageData* image, vtkMatrix4x4* matrix, bool isLevelSet)
{
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  int dimensions[3];
  image->GetDimensions(dimensions);
  if (!scalars || *std::min_element(dimensions, dimensions + 3) < 2)
  {
    throw ModelError("it holds no volume of at least 2 x 2 x 2 scalar values (it has " +
      std::to_string(dimensions[0]) + " x " + std::to_string(dimensions[1]) + " x " +
      std::to_string(dimensions[2]) + ")");
  }
  double range[2];
  scalars->GetFiniteRange(range, 0);
  if (!(range[0] < range[1]))
  {
    throw ModelError(
      "all its values are the same or none is finite, so that there is no surface in it");
  }
  const std::string rangeText = Text(range[0]) + " .. " + Text(range[1]);
  if (!file.IsoValue && !isLevelSet)
  {
    throw ModelError("it is a volume, and a surface in it needs an iso value; its values are " +
      rangeText + ", try " + Text(OtsuThreshold(scalars, range)));
  }
  const double iso = file.IsoValue.value_or(0.0);
  if (!(iso > range[0] && iso < range[1]))
  {
    throw ModelError("the iso value " + Text(iso) + " is not inside of its values' range " +
      rangeText + "; try " + Text(OtsuThreshold(scalars, range)));
  }
  if (scalars->GetNumberOfComponents() > 1)
  {
    file.Warnings.push_back("The volume has " + std::to_string(scalars->GetNumberOfComponents()) +
      " values a voxel; the first is taken.");
  }

  vtkNew<vtkFlyingEdges3D> contour;
  file.Watch(contour);
  contour->SetInputData(isLevelSet ? image : Smooth(image, file).Get());
  contour->SetValue(0, iso);
  contour->ComputeNormalsOn();
  contour->ComputeScalarsOff();
  contour->Update();
  vtkSmartPointer<vtkPolyData> surface = contour->GetOutput();
  if (surface->GetNumberOfPolys() == 0)
  {
    throw ModelError("there is no surface at the iso value " + Text(iso) + "; its values are " +
      rangeText + ", try " + Text(OtsuThreshold(scalars, range)));
  }
  OrderPolygonsByNormals(surface);
  if (isLevelSet)
  {
    // Inside is where the values are small.
    ReversePolygons(surface);
    vtkDataArray* normals = surface->GetPointData()->GetNormals();
    for (auto& value : vtk::DataArrayValueRange(vtkArrayDownCast<vtkFloatArray>(normals)))
    {
      value = -value;
    }
  }
  if (matrix && !matrix->IsIdentity())
  {
    surface = TransformSurface(surface, matrix);
  }
  file.AddPart(surface);
}

void ReadVTI(ModelFile& file)
{
  vtkNew<vtkXMLImageDataReader> reader;
  file.Watch(reader);
  reader->SetFileName(file.Path.c_str());
  CheckSize(reader, std::filesystem::file_size(file.Path));
  reader->Update();
  AddIsoSurface(file, reader->GetOutput());
}

void ReadNIFTI(ModelFile& file)
{
  vtkNew<vtkNIFTIImageReader> reader;
  file.Watch(reader);
  reader->SetFileName(file.Path.c_str());
  CheckSize(reader, std::filesystem::file_size(file.Path));
  reader->Update();
  // The scanner's coordinates where the file has them; VTK's image itself keeps the plain axes.
  vtkMatrix4x4* matrix =
    reader->GetSFormMatrix() ? reader->GetSFormMatrix() : reader->GetQFormMatrix();
  AddIsoSurface(file, reader->GetOutput(), matrix);
}

void ReadLegacyVTK(ModelFile& file)
{
  vtkNew<vtkDataSetReader> reader;
  file.Watch(reader);
  reader->SetFileName(file.Path.c_str());
  reader->Update();
  vtkDataSet* data = reader->GetOutput();
  if (auto surface = vtkPolyData::SafeDownCast(data))
  {
    file.AddPart(surface);
  }
  else if (auto image = vtkImageData::SafeDownCast(data))
  {
    AddIsoSurface(file, image);
  }
  else if (data)
  {
    AddOutside(file, data);
  }
}

void ReadVDB(ModelFile& file)
{
#ifdef NPR_USE_OPENVDB
  vtkNew<vtkNPRVDBReader> reader;
  file.Watch(reader);
  reader->SetFileName(file.Path.c_str());
  reader->SetGridName(file.GridName.empty() ? nullptr : file.GridName.c_str());
  reader->Update();
  AddIsoSurface(file, reader->GetOutput(), nullptr, reader->GetIsLevelSet());
#else
  throw ModelError("this build has no OpenVDB; configure it with -DNPR_USE_OPENVDB=ON");
#endif
}
}
