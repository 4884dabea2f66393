// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRDepthVisibility.h"

#include "nprArrayNames.h"
#include "nprDepthImage.h"
#include "nprStrokeParts.h"
#include "nprStrokePartsOutput.h"

#include <vtkCellArray.h>
#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkInformationVector.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <cmath>
#include <vector>

vtkStandardNewMacro(vtkNPRDepthVisibility);
vtkCxxSetSmartPointerMacro(vtkNPRDepthVisibility, StrokeMatrix, vtkMatrix4x4);

namespace
{
constexpr double SamplesPerPixel = 1.0;
constexpr double MostSamples = 10000.0; // of a segment
constexpr int Halvings = 4;             // of the way between two samples, where a cut is

/// The parts of one stroke.
class Cutter
{
public:
  Cutter(const npr::DepthImage& image, const npr::DepthImage::Rule& rule) : Image(image), Rule(rule)
  {
  }

  /// \p cosines between surface and view at the points; 0 where they are not known.
  std::vector<npr::StrokePart> Cut(
    const std::vector<Eigen::Vector3d>& points, const std::vector<double>& cosines)
  {
    this->Parts.clear();
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
    {
      this->Cosine = std::min(cosines[i], cosines[i + 1]);
      this->CutSegment(static_cast<double>(i), points[i], points[i + 1]);
    }
    return std::move(this->Parts);
  }

private:
  void CutSegment(double segment, const Eigen::Vector3d& from, const Eigen::Vector3d& to)
  {
    if (!from.allFinite() || !to.allFinite())
    {
      this->Append(npr::StrokePart::Nowhere, segment, segment + 1.0, 0.0);
      return;
    }
    const Eigen::Vector4d begin = this->Image.Project(from);
    const Eigen::Vector4d end = this->Image.Project(to);
    const auto at = [&](double t) { return Eigen::Vector4d(begin + t * (end - begin)); };
    const bool isSeen = this->Image.IsInView(begin) && this->Image.IsInView(end);
    const double length =
      isSeen ? (this->Image.GetPixel(end) - this->Image.GetPixel(begin)).norm() : MostSamples;
    const int count =
      static_cast<int>(std::ceil(std::clamp(SamplesPerPixel * length, 1.0, MostSamples)));
    double before = 0.0;
    int layers = this->Look(at(0.5 / count));
    for (int i = 0; i < count; ++i)
    {
      double cut = 1.0;
      const int here = layers;
      if (i + 1 < count)
      {
        layers = this->Look(at((i + 1.5) / count));
        cut = here == layers ? (i + 1.0) / count
                             : this->FindCut(at, (i + 0.5) / count, (i + 1.5) / count, here);
      }
      const double pixels = here == npr::StrokePart::Nowhere
        ? 0.0
        : (this->Image.GetPixel(at(cut)) - this->Image.GetPixel(at(before))).norm();
      this->Append(here, segment + before, segment + cut, pixels);
      before = cut;
    }
  }

  /// Between two places, the first of which has the layers.
  template<typename At>
  double FindCut(const At& at, double first, double second, int layers) const
  {
    for (int i = 0; i < Halvings; ++i)
    {
      const double middle = 0.5 * (first + second);
      (this->Look(at(middle)) == layers ? first : second) = middle;
    }
    return 0.5 * (first + second);
  }

  int Look(const Eigen::Vector4d& clip) const
  {
    return !this->Image.IsInView(clip)                       ? npr::StrokePart::Nowhere
      : this->Image.IsHidden(clip, this->Cosine, this->Rule) ? 1
                                                             : 0;
  }

  void Append(int layers, double begin, double end, double length)
  {
    if (!this->Parts.empty() && this->Parts.back().Layers == layers)
    {
      this->Parts.back().End = end;
      this->Parts.back().Length += length;
    }
    else
    {
      this->Parts.push_back({ layers, begin, end, length });
    }
  }

  const npr::DepthImage& Image;
  const npr::DepthImage::Rule& Rule;
  std::vector<npr::StrokePart> Parts;
  double Cosine = 0.0;
};

double GetSize(vtkPolyData* strokes, vtkMatrix4x4* matrix)
{
  const double scale = matrix ? std::cbrt(std::abs(matrix->Determinant())) : 1.0;
  return scale * strokes->GetLength();
}
}

//------------------------------------------------------------------------------
vtkNPRDepthVisibility::vtkNPRDepthVisibility() = default;

vtkNPRDepthVisibility::~vtkNPRDepthVisibility()
{
  this->SetRenderer(nullptr);
}

//------------------------------------------------------------------------------
void vtkNPRDepthVisibility::SetRenderer(vtkRenderer* renderer)
{
  if (this->Renderer == renderer)
  {
    return;
  }
  if (this->Renderer)
  {
    this->Renderer->RemoveObserver(this->EndObserver);
  }
  this->Renderer = renderer;
  if (renderer)
  {
    this->EndObserver =
      renderer->AddObserver(vtkCommand::EndEvent, this, &vtkNPRDepthVisibility::Modified);
  }
  this->Modified();
}

vtkRenderer* vtkNPRDepthVisibility::GetRenderer() const
{
  return this->Renderer;
}

//------------------------------------------------------------------------------
vtkMatrix4x4* vtkNPRDepthVisibility::GetStrokeMatrix() const
{
  return this->StrokeMatrix;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkNPRDepthVisibility::GetMTime()
{
  const vtkMTimeType time = this->Superclass::GetMTime();
  return this->StrokeMatrix ? std::max(time, this->StrokeMatrix->GetMTime()) : time;
}

//------------------------------------------------------------------------------
int vtkNPRDepthVisibility::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* const input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* const output = vtkPolyData::GetData(outputVector);
  vtkRenderWindow* const window = this->Renderer ? this->Renderer->GetRenderWindow() : nullptr;
  if (!window || window->GetNeverRendered())
  {
    vtkErrorMacro("There is no picture whose depths could tell what is hidden: give the renderer "
                  "of a window to SetRenderer(), and call Render() of the window first.");
    return 0;
  }
  output->GetFieldData()->PassData(input->GetFieldData());
  if (!input->GetPoints() || input->GetNumberOfLines() == 0)
  {
    return 1;
  }
  const npr::DepthImage image(this->Renderer, this->StrokeMatrix);
  if (!image.IsValid())
  {
    vtkErrorMacro("The depth buffer of the window can not be read.");
    return 0;
  }
  const npr::DepthImage::Rule rule = { this->DepthTolerance, this->VisibilityRadius,
    GetSize(input, this->StrokeMatrix) };
  vtkDataArray* normals = input->GetPointData()->GetArray(npr::names::Normals);
  normals = normals && normals->GetNumberOfComponents() == 3 ? normals : nullptr;
  vtkCellArray* const lines = input->GetLines();
  std::vector<std::vector<npr::StrokePart>> parts(lines->GetNumberOfCells());
  vtkSMPTools::For(0, lines->GetNumberOfCells(),
    [&](vtkIdType begin, vtkIdType end)
    {
      Cutter cutter(image, rule);
      std::vector<Eigen::Vector3d> points;
      std::vector<double> cosines;
      vtkNew<vtkIdList> ids;
      for (vtkIdType line = begin; line < end && !this->GetAbortExecute(); ++line)
      {
        lines->GetCellAtId(line, ids);
        points.resize(ids->GetNumberOfIds());
        cosines.assign(points.size(), 0.0);
        for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
        {
          input->GetPoint(ids->GetId(i), points[i].data());
          if (normals)
          {
            Eigen::Vector3d normal;
            normals->GetTuple(ids->GetId(i), normal.data());
            cosines[i] = image.GetCosine(points[i], normal);
          }
        }
        parts[line] = npr::MergeParts(cutter.Cut(points, cosines), this->MinimumLength,
          npr::IsClosedStroke(input->GetPoints(), ids), points.size() - 1);
      }
    });
  npr::WriteStrokeParts(input, parts, output);
  return 1;
}

//------------------------------------------------------------------------------
void vtkNPRDepthVisibility::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Renderer: " << this->Renderer.Get() << "\n";
  os << indent << "StrokeMatrix: " << this->StrokeMatrix.Get() << "\n";
  os << indent << "DepthTolerance: " << this->DepthTolerance << "\n";
  os << indent << "VisibilityRadius: " << this->VisibilityRadius << "\n";
  os << indent << "MinimumLength: " << this->MinimumLength << "\n";
}
