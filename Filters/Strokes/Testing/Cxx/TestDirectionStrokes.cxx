// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Strokes follow their field, cover the surface evenly, and are where they are wanted.
#include "nprAnalyticSurfaces.h"
#include "nprLengthScale.h"
#include "vtkNPRDirectionStrokes.h"

#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkIdList.h>
#include <vtkPointData.h>

using namespace nprtest;

namespace
{
/// Around the cylinder on its lower half, along it on its upper; signs at random.
vtkSmartPointer<vtkPolyData> MakeCylinderWithField()
{
  AnalyticSurface cylinder = MakeSurface(Cylinder(0.5, 2.0), 60, 40, { 0.3, 5 });
  vtkNew<vtkFloatArray> field;
  field->SetName("Field");
  field->SetNumberOfComponents(3);
  vtkNew<vtkFloatArray> wanted;
  wanted->SetName("Wanted");
  std::mt19937 random(3);
  for (const Truth& truth : cylinder.Truths)
  {
    const Vector3d& axis = truth.Point.z() < 1.0 ? truth.Frame.U : truth.Frame.V;
    const Vector3d turned = random() % 2 ? axis : Vector3d(-axis);
    field->InsertNextTuple(turned.data());
    wanted->InsertNextValue(truth.Point.x() > 0.0 ? 1.0f : 0.0f);
  }
  cylinder.Mesh->GetPointData()->AddArray(field);
  cylinder.Mesh->GetPointData()->AddArray(wanted);
  return cylinder.Mesh;
}

struct Stroke
{
  std::vector<Vector3d> Points;
};

std::vector<Stroke> GetStrokes(vtkPolyData* lines)
{
  std::vector<Stroke> strokes;
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < lines->GetNumberOfLines(); ++i)
  {
    lines->GetLines()->GetCellAtId(i, ids);
    strokes.emplace_back();
    for (vtkIdType j = 0; j < ids->GetNumberOfIds(); ++j)
    {
      Vector3d p;
      lines->GetPoint(ids->GetId(j), p.data());
      strokes.back().Points.push_back(p);
    }
  }
  return strokes;
}
}

int TestDirectionStrokes(int, char*[])
{
  Checks check;
  const auto surface = MakeCylinderWithField();
  const double spacing = 0.06 * npr::GetLengthScale(surface);
  vtkNew<vtkNPRDirectionStrokes> filter;
  filter->SetInputData(surface);
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Field");
  filter->SetSpacing(0.06);
  filter->SetLength(5.0);
  filter->Update();
  const auto strokes = GetStrokes(filter->GetOutput());
  check(strokes.size() > 100, "there are strokes", static_cast<double>(strokes.size()));
  for (const Stroke& stroke : strokes)
  {
    double length = 0.0;
    for (std::size_t i = 1; i < stroke.Points.size(); ++i)
    {
      const Vector3d step = stroke.Points[i] - stroke.Points[i - 1];
      length += step.norm();
      const double z = stroke.Points[i].z();
      const double along = std::abs(step.z()) / step.norm();
      if (std::abs(z - 1.0) > 0.15)
      {
        check(z < 1.0 ? along < 0.05 : along > 0.95, "strokes follow the field", along);
      }
      check(std::abs(stroke.Points[i].head<2>().norm() - 0.5) < 0.01, "they lie on the surface");
    }
    check(length < 5.01 * spacing && length > 0.9 * spacing, "they are of the length asked for",
      length);
  }
  // On the side of one stroke, no other is nearer than half of the spacing; and no place is bare.
  double nearest = 1.0;
  for (std::size_t a = 0; a < strokes.size(); ++a)
  {
    for (std::size_t b = 0; b < a; ++b)
    {
      for (const Vector3d& p : strokes[a].Points)
      {
        for (const Vector3d& q : strokes[b].Points)
        {
          nearest = std::min(nearest, (p - q).norm());
        }
      }
    }
  }
  check(nearest > 0.45 * spacing, "they keep their distance", nearest / spacing);
  double barest = 0.0;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    Vector3d p;
    surface->GetPoint(i, p.data());
    double distance = 1.0;
    for (const Stroke& stroke : strokes)
    {
      for (const Vector3d& q : stroke.Points)
      {
        distance = std::min(distance, (p - q).norm());
      }
    }
    barest = std::max(barest, distance);
  }
  check(barest < 2.5 * spacing, "they cover the surface", barest / spacing);

  filter->SetStrengthArray("Wanted");
  filter->Update();
  check(filter->GetOutput()->GetNumberOfLines() > 50, "there are strokes where they are wanted");
  for (const Stroke& stroke : GetStrokes(filter->GetOutput()))
  {
    for (const Vector3d& p : stroke.Points)
    {
      check(p.x() > -0.06, "and none elsewhere", p.x());
    }
  }

  vtkObject::GlobalWarningDisplayOff();
  filter->SetStrengthArray("Missing");
  filter->Update();
  check(filter->GetOutput()->GetNumberOfLines() == 0, "no strokes without the array");
  vtkNew<vtkFloatArray> ofCells;
  ofCells->SetName("OfCells");
  ofCells->SetNumberOfComponents(3);
  ofCells->SetNumberOfTuples(surface->GetNumberOfCells());
  ofCells->Fill(1.0);
  surface->GetCellData()->AddArray(ofCells);
  filter->SetStrengthArray(nullptr);
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "OfCells");
  filter->Update();
  check(filter->GetOutput()->GetNumberOfLines() == 0, "no strokes along directions of cells");
  vtkNew<vtkPolyData> empty;
  filter->SetInputData(empty);
  filter->Update();
  check(filter->GetOutput()->GetNumberOfLines() == 0, "nothing from nothing");
  return check.GetResult();
}
