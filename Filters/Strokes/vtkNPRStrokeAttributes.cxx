// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRStrokeAttributes.h"

#include "nprArrayNames.h"
#include "nprIsophoteDistance.h"
#include "nprLatticeNoise.h"
#include "nprLengthScale.h"
#include "nprProgress.h"
#include "nprStrokeCuts.h"
#include "nprStrokeMeasure.h"
#include "nprStrokeShaper.h"

#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIdList.h>
#include <vtkInformationVector.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <cmath>

namespace
{
vtkSmartPointer<vtkFloatArray> AddArray(vtkPolyData* output, const char* name)
{
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName(name);
  array->SetNumberOfValues(output->GetNumberOfPoints());
  vtkDataArray* before = output->GetPointData()->GetArray(name);
  const bool isFactor = before && before->GetNumberOfComponents() == 1;
  for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
  {
    const double value = isFactor ? before->GetComponent(i, 0) : 1.0;
    array->SetValue(i, std::isfinite(value) ? static_cast<float>(std::max(value, 0.0)) : 0.0f);
  }
  output->GetPointData()->AddArray(array);
  return array;
}

/// What averages need to know of the strokes, where the parts of one that has been cut are joined
/// again: strokes do not change their width where others cross them.
std::vector<npr::ShapedStrokes> JoinParts(
  const std::vector<npr::ShapedStrokes>& strokes, const npr::StrokeCuts& cuts)
{
  const auto isWhole = [&](std::size_t line)
  { return strokes[line].Sizes.size() == 1 && !strokes[line].Closed.front(); };
  std::vector<npr::ShapedStrokes> joined;
  for (std::size_t first = 0, next = 0; first < strokes.size(); first = next)
  {
    npr::ShapedStrokes whole;
    whole.Sizes = strokes[first].Sizes;
    whole.Lengths = strokes[first].Lengths;
    whole.Reaches = strokes[first].Reaches;
    whole.Closed = strokes[first].Closed;
    whole.Areas = strokes[first].Areas;
    const auto continues = [&cuts](std::size_t line, std::size_t other)
    { return cuts.Continues(static_cast<vtkIdType>(line), static_cast<vtkIdType>(other)); };
    for (next = first + 1;
         next < strokes.size() && isWhole(first) && isWhole(next) && continues(next, next - 1);
         ++next)
    {
      const float end = whole.Lengths.back();
      for (const float length : strokes[next].Lengths)
      {
        whole.Lengths.push_back(end + length);
      }
      whole.Sizes.front() += strokes[next].Sizes.front();
      whole.Areas.front() += strokes[next].Areas.front();
      whole.Reaches.front() = std::max(whole.Reaches.front(), strokes[next].Reaches.front());
    }
    if (next > first + 1)
    {
      whole.Closed.front() = continues(first, next - 1);
    }
    joined.push_back(std::move(whole));
  }
  return joined;
}

/// Along each stroke.
void Average(const std::vector<npr::ShapedStrokes>& strokes, vtkFloatArray* array)
{
  float* values = array->GetPointer(0);
  for (const npr::ShapedStrokes& stroke : strokes)
  {
    stroke.Average(values);
    values += stroke.Lengths.size();
  }
}

/// Nothing where there are no normals.
void AddShade(vtkPolyData* output, const npr::StrokeMeasure& measure, const double light[3],
  const std::vector<npr::ShapedStrokes>& strokes)
{
  vtkDataArray* normals = output->GetPointData()->GetArray(npr::names::Normals);
  if (!normals || normals->GetNumberOfComponents() != 3)
  {
    return;
  }
  const Eigen::Vector3d direction = Eigen::Vector3d(light).stableNormalized();
  vtkNew<vtkFloatArray> shade;
  shade->SetName(npr::names::Shade);
  shade->SetNumberOfValues(output->GetNumberOfPoints());
  for (vtkIdType i = 0; i < shade->GetNumberOfValues(); ++i)
  {
    Eigen::Vector3d normal;
    normals->GetTuple(i, normal.data());
    shade->SetValue(i, static_cast<float>(measure.GetCosine(normal, direction)));
  }
  Average(strokes, shade);
  output->GetPointData()->AddArray(shade);
}

/// Nothing where there are no normals, no radial curvature, or no length that it is relative to.
void AddIsophoteDistance(vtkPolyData* output, const npr::StrokeMeasure& measure,
  const double light[3], double level, const std::vector<npr::ShapedStrokes>& strokes)
{
  vtkDataArray* normals = output->GetPointData()->GetArray(npr::names::Normals);
  vtkDataArray* curvatures = output->GetPointData()->GetArray(npr::names::RadialCurvature);
  const double scale = npr::GetLengthScale(output);
  if (!normals || normals->GetNumberOfComponents() != 3 || !curvatures || !(scale > 0.0))
  {
    return;
  }
  const Eigen::Vector3d direction = Eigen::Vector3d(light).stableNormalized();
  vtkNew<vtkFloatArray> distances;
  distances->SetName(npr::names::IsophoteDistance);
  distances->SetNumberOfValues(output->GetNumberOfPoints());
  for (vtkIdType i = 0; i < distances->GetNumberOfValues(); ++i)
  {
    Eigen::Vector3d normal;
    normals->GetTuple(i, normal.data());
    npr::Vector3 point;
    output->GetPoint(i, point.data());
    const double distance = npr::GetIsophoteDistance(curvatures->GetComponent(i, 0) / scale,
      measure.GetCosine(normal, direction), measure.GetDirectionToEye(point).dot(direction), level,
      scale);
    npr::Vector3 end;
    for (int c = 0; c < 3; ++c)
    {
      end[c] = point[c] - distance * normal[c];
    }
    const double seen = (measure.GetPlace(end) - measure.GetPlace(point)).norm();
    distances->SetValue(i, std::isfinite(seen) ? static_cast<float>(seen) : 0.0f);
  }
  Average(strokes, distances);
  output->GetPointData()->AddArray(distances);
}
}

vtkStandardNewMacro(vtkNPRStrokeAttributes);

//------------------------------------------------------------------------------
vtkNPRStrokeAttributes::vtkNPRStrokeAttributes() = default;
vtkNPRStrokeAttributes::~vtkNPRStrokeAttributes() = default;

//------------------------------------------------------------------------------
void vtkNPRStrokeAttributes::SetCamera(vtkCamera* camera)
{
  if (this->Camera != camera)
  {
    this->Camera = camera;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkCamera* vtkNPRStrokeAttributes::GetCamera() const
{
  return this->Camera;
}

//------------------------------------------------------------------------------
void vtkNPRStrokeAttributes::SetMatrix(vtkMatrix4x4* matrix)
{
  if (this->Matrix != matrix)
  {
    this->Matrix = matrix;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkMatrix4x4* vtkNPRStrokeAttributes::GetMatrix() const
{
  return this->Matrix;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkNPRStrokeAttributes::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  if (this->LengthUnit == VIEW)
  {
    time = this->Camera ? std::max(time, this->Camera->GetMTime()) : time;
    time = this->Matrix ? std::max(time, this->Matrix->GetMTime()) : time;
  }
  return time;
}

//------------------------------------------------------------------------------
int vtkNPRStrokeAttributes::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  output->GetFieldData()->PassData(input->GetFieldData());
  vtkCellArray* lines = input->GetLines();
  const vtkIdType numberOfLines = lines->GetNumberOfCells();
  if (numberOfLines == 0 || !input->GetPoints())
  {
    return 1;
  }
  if (this->LengthUnit == VIEW && !this->Camera)
  {
    vtkErrorMacro("lengths are in heights of the view, but there is no camera; call SetCamera(), "
                  "or SetLengthUnit() with another unit");
    return 0;
  }
  if (this->LengthUnit != VIEW && this->Uses(npr::names::IsophoteDistance))
  {
    vtkErrorMacro("the distance to an isophote is one on the page; call SetLengthUnitToView() and "
                  "SetCamera()");
    return 0;
  }
  const npr::StrokeMeasure measure = this->LengthUnit == VIEW
    ? npr::StrokeMeasure(this->Camera, this->Matrix)
    : npr::StrokeMeasure(1.0);
  if (!measure.IsValid())
  {
    vtkErrorMacro("the view of the strokes has no size: the matrix has no inverse, or the "
                  "camera's position, angle or scale is not valid");
    return 0;
  }

  npr::StrokeShape shape;
  shape.RelativeToStroke = this->LengthUnit == STROKE;
  shape.Reach = this->Reach;
  shape.Curvatures = this->Uses(npr::names::CurveCurvature);
  shape.TaperLength = this->TaperLength;
  shape.OvershootLength = this->OvershootLength;
  shape.WobbleAmplitude = this->WobbleAmplitude;
  shape.WobbleWavelength = this->WobbleWavelength;
  if (this->LengthUnit == MODEL)
  {
    const double scale = npr::GetLengthScale(input);
    shape.CurvatureUnit = scale > 0.0 ? scale : input->GetLength();
  }

  const npr::StrokeCuts cuts(input);
  vtkDataArray* const chainIds = npr::GetCellNumbers(input, npr::names::ChainId);
  vtkDataArray* const arcLengths = input->GetPointData()->GetArray(npr::names::ArcLength);
  const vtkIdType firstCell = input->GetNumberOfVerts();
  const std::uint32_t seed = npr::HashInteger(static_cast<std::uint32_t>(this->Seed));
  std::vector<npr::ShapedStrokes> strokes(numberOfLines);
  vtkSMPTools::For(0, numberOfLines,
    [&](vtkIdType begin, vtkIdType end)
    {
      vtkNew<vtkIdList> ids;
      for (vtkIdType line = begin; line < end && !this->GetAbortExecute(); ++line)
      {
        lines->GetCellAtId(line, ids);
        const double number =
          chainIds ? chainIds->GetComponent(firstCell + line, 0) : static_cast<double>(line);
        npr::StrokeTraits traits;
        traits.Seed = npr::HashInteger(
          static_cast<std::uint32_t>(std::isfinite(number) ? std::llround(number) : 0) + seed);
        for (const npr::StrokeChain& chain : npr::MakeStrokeChains(input->GetPoints(), ids))
        {
          if (chain.Points.size() < 2)
          {
            continue;
          }
          traits.StartIsTrue = !cuts.IsCut(line, chain.Points.front().Position);
          traits.EndIsTrue = !cuts.IsCut(line, chain.Points.back().Position);
          const double first =
            arcLengths ? arcLengths->GetComponent(chain.Points.front().Id, 0) : 0.0;
          npr::ShapeStroke(
            chain, measure, shape, traits, std::isfinite(first) ? first : 0.0, strokes[line]);
        }
      }
    });
  this->UpdateProgress(0.5);
  if (npr::IsAborted(this))
  {
    return 1;
  }
  npr::WriteStrokes(input, npr::PointersTo(strokes), output);

  auto widths = AddArray(output, npr::names::Width);
  auto opacities = AddArray(output, npr::names::Opacity);
  vtkNew<vtkFloatArray> curvatures;
  curvatures->SetName(npr::names::CurveCurvature);
  vtkIdType point = 0;
  for (const npr::ShapedStrokes& stroke : strokes)
  {
    for (const float taper : stroke.Tapers)
    {
      const auto blend = [taper](double atEnd)
      { return static_cast<float>(atEnd + taper * (1.0 - atEnd)); };
      widths->SetValue(point,
        widths->GetValue(point) * static_cast<float>(this->ConstantWidth) *
          blend(this->TaperedWidth));
      opacities->SetValue(point,
        std::min(opacities->GetValue(point), 1.0f) * static_cast<float>(this->ConstantOpacity) *
          blend(this->TaperedOpacity));
      ++point;
    }
    for (const float curvature : stroke.Curvatures)
    {
      curvatures->InsertNextValue(curvature);
    }
  }
  const std::vector<npr::ShapedStrokes> whole = JoinParts(strokes, cuts);
  if (this->Uses(npr::names::CurveCurvature))
  {
    Average(whole, curvatures);
    output->GetPointData()->AddArray(curvatures);
  }
  if (this->Uses(npr::names::Shade))
  {
    AddShade(output, measure, this->LightDirection, whole);
  }
  if (this->Uses(npr::names::IsophoteDistance))
  {
    AddIsophoteDistance(output, measure, this->LightDirection, this->IsophoteLevel, whole);
  }
  for (const Term& term : this->Terms)
  {
    if (output->GetNumberOfPoints() == 0)
    {
      break;
    }
    vtkNew<vtkFloatArray> factors;
    factors->SetNumberOfValues(output->GetNumberOfPoints());
    factors->FillValue(1.0f);
    if (!this->MultiplyTerm(term, output, factors->GetPointer(0)))
    {
      output->Initialize();
      return 0;
    }
    if (term.Average)
    {
      Average(whole, factors);
    }
    vtkFloatArray* const product = term.Attribute == WIDTH ? widths : opacities;
    for (vtkIdType i = 0; i < factors->GetNumberOfValues(); ++i)
    {
      product->SetValue(i, product->GetValue(i) * factors->GetValue(i));
    }
  }
  if (this->WidthPerSize > 0.0)
  {
    float* width = widths->GetPointer(0);
    for (const npr::ShapedStrokes& stroke : whole)
    {
      stroke.LimitWidths(width, this->WidthPerSize, shape.RelativeToStroke);
      width += stroke.Lengths.size();
    }
  }
  this->UpdateProgress(1.0);
  return 1;
}

//------------------------------------------------------------------------------
void vtkNPRStrokeAttributes::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ConstantWidth: " << this->ConstantWidth << "\n";
  os << indent << "ConstantOpacity: " << this->ConstantOpacity << "\n";
  for (const Term& term : this->Terms)
  {
    os << indent << "Term: " << (term.Attribute == WIDTH ? "Width" : "Opacity") << " by "
       << term.Array << " from " << term.From << " to " << term.To << ": " << term.AtFrom << " to "
       << term.AtTo << (term.Shape == SMOOTH ? ", smooth" : "")
       << (term.Average ? ", averaged\n" : "\n");
  }
  os << indent << "LengthUnit: " << this->LengthUnit << "\n";
  os << indent << "Camera: " << this->Camera.Get() << "\n";
  os << indent << "Matrix: " << this->Matrix.Get() << "\n";
  os << indent << "Reach: " << this->Reach << "\n";
  os << indent << "LightDirection: " << this->LightDirection[0] << " " << this->LightDirection[1]
     << " " << this->LightDirection[2] << "\n";
  os << indent << "IsophoteLevel: " << this->IsophoteLevel << "\n";
  os << indent << "TaperLength: " << this->TaperLength << "\n";
  os << indent << "TaperedWidth: " << this->TaperedWidth << "\n";
  os << indent << "TaperedOpacity: " << this->TaperedOpacity << "\n";
  os << indent << "WidthPerSize: " << this->WidthPerSize << "\n";
  os << indent << "OvershootLength: " << this->OvershootLength << "\n";
  os << indent << "WobbleAmplitude: " << this->WobbleAmplitude << "\n";
  os << indent << "WobbleWavelength: " << this->WobbleWavelength << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
}
