// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRSurfaceOrder.h"

#include "nprHilbertOrder.h"
#include "nprProgress.h"
#include "nprRemeshedArrays.h"
#include "nprSurfaceArrays.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>
#include <vtkSmartPointer.h>

#include <Eigen/Core>

#include <vector>

vtkStandardNewMacro(vtkNPRSurfaceOrder);

namespace
{
/// The cells' points one after another, and where each cell begins (one more than cells).
struct Corners
{
  std::vector<vtkIdType> Offsets{ 0 };
  std::vector<vtkIdType> Points;

  explicit Corners(vtkCellArray* cells)
  {
    this->Offsets.reserve(cells->GetNumberOfCells() + 1);
    this->Points.reserve(cells->GetNumberOfConnectivityIds());
    auto iterator = vtk::TakeSmartPointer(cells->NewIterator());
    for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
    {
      vtkIdType size;
      const vtkIdType* points;
      iterator->GetCurrentCell(size, points);
      this->Points.insert(this->Points.end(), points, points + size);
      this->Offsets.push_back(static_cast<vtkIdType>(this->Points.size()));
    }
  }
  vtkIdType GetNumberOfCells() const { return static_cast<vtkIdType>(this->Offsets.size()) - 1; }
};

//------------------------------------------------------------------------------
std::vector<Eigen::Vector3d> GetMeans(vtkPoints* points, const Corners& corners)
{
  std::vector<Eigen::Vector3d> means(corners.GetNumberOfCells());
  vtkSMPTools::For(0, corners.GetNumberOfCells(),
    [&](vtkIdType begin, vtkIdType end)
    {
      Eigen::Vector3d point;
      for (vtkIdType c = begin; c < end; ++c)
      {
        means[c] = Eigen::Vector3d::Zero();
        const vtkIdType size = corners.Offsets[c + 1] - corners.Offsets[c];
        for (vtkIdType i = corners.Offsets[c]; i < corners.Offsets[c + 1]; ++i)
        {
          points->GetPoint(corners.Points[i], point.data());
          means[c] += point / static_cast<double>(size);
        }
      }
    });
  return means;
}

//------------------------------------------------------------------------------
/// Numbers points as they come.
class Numbering
{
public:
  explicit Numbering(vtkIdType size) : NewIds(size, -1) { this->OldIds.reserve(size); }

  vtkIdType operator()(vtkIdType point)
  {
    vtkIdType& id = this->NewIds[point];
    if (id < 0)
    {
      id = static_cast<vtkIdType>(this->OldIds.size());
      this->OldIds.push_back(point);
    }
    return id;
  }

  const std::vector<vtkIdType>& NumberAll()
  {
    for (std::size_t i = 0; i < this->NewIds.size(); ++i)
    {
      (*this)(static_cast<vtkIdType>(i));
    }
    return this->OldIds;
  }

private:
  std::vector<vtkIdType> NewIds;
  std::vector<vtkIdType> OldIds;
};

//------------------------------------------------------------------------------
vtkSmartPointer<vtkCellArray> Renumber(
  const Corners& corners, const std::vector<vtkIdType>* order, Numbering& numbering)
{
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->AllocateExact(corners.GetNumberOfCells(), static_cast<vtkIdType>(corners.Points.size()));
  for (vtkIdType i = 0; i < corners.GetNumberOfCells(); ++i)
  {
    const vtkIdType c = order ? (*order)[i] : i;
    cells->InsertNextCell(static_cast<int>(corners.Offsets[c + 1] - corners.Offsets[c]));
    for (vtkIdType p = corners.Offsets[c]; p < corners.Offsets[c + 1]; ++p)
    {
      cells->InsertCellPoint(numbering(corners.Points[p]));
    }
  }
  return cells;
}
}

//------------------------------------------------------------------------------
vtkNPRSurfaceOrder::vtkNPRSurfaceOrder() = default;
vtkNPRSurfaceOrder::~vtkNPRSurfaceOrder() = default;

//------------------------------------------------------------------------------
int vtkNPRSurfaceOrder::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  if (input->GetNumberOfPoints() == 0)
  {
    output->ShallowCopy(input);
    return 1;
  }
  const Corners polygons(input->GetPolys());
  const std::vector<vtkIdType> order = npr::GetHilbertOrder(GetMeans(input->GetPoints(), polygons));
  this->UpdateProgress(0.4);
  if (npr::IsAborted(this))
  {
    output->ShallowCopy(input);
    return 1;
  }
  Numbering numbering(input->GetNumberOfPoints());
  output->SetPolys(Renumber(polygons, &order, numbering));
  output->SetVerts(Renumber(Corners(input->GetVerts()), nullptr, numbering));
  output->SetLines(Renumber(Corners(input->GetLines()), nullptr, numbering));
  output->SetStrips(Renumber(Corners(input->GetStrips()), nullptr, numbering));
  this->UpdateProgress(0.7);
  npr::SelectPoints(input, numbering.NumberAll(), output);

  // Cells are numbered vertices first, then lines, polygons, strips.
  std::vector<vtkIdType> cells(input->GetNumberOfCells());
  const vtkIdType first = input->GetNumberOfVerts() + input->GetNumberOfLines();
  for (std::size_t c = 0; c < cells.size(); ++c)
  {
    const vtkIdType polygon = static_cast<vtkIdType>(c) - first;
    const bool isPolygon = polygon >= 0 && polygon < polygons.GetNumberOfCells();
    cells[c] = isPolygon ? first + order[polygon] : static_cast<vtkIdType>(c);
  }
  npr::SelectTuples(input->GetCellData(), cells, output->GetCellData());
  output->GetFieldData()->PassData(input->GetFieldData());
  npr::RenumberWeldedPointIds(output);
  return 1;
}

//------------------------------------------------------------------------------
void vtkNPRSurfaceOrder::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
