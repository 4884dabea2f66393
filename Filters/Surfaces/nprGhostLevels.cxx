// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprGhostLevels.h"

#include "nprSurfaceArrays.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCellData.h>
#include <vtkDataSetAttributes.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationIntegerKey.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <vector>

namespace npr
{
namespace
{
using Pipeline = vtkStreamingDemandDrivenPipeline;

/// Calls function(cell, number of points, points) for all cells, as a vtkPolyData numbers them, but
/// for those with points that do not exist.
template<typename Function>
void ForCells(vtkPolyData* surface, const Function& function)
{
  vtkIdType cell = 0;
  for (vtkCellArray* cells :
    { surface->GetVerts(), surface->GetLines(), surface->GetPolys(), surface->GetStrips() })
  {
    auto iterator = vtk::TakeSmartPointer(cells->NewIterator());
    for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
    {
      vtkIdType size;
      const vtkIdType* points;
      iterator->GetCurrentCell(size, points);
      if (std::all_of(points, points + size,
            [&](vtkIdType point) { return point >= 0 && point < surface->GetNumberOfPoints(); }))
      {
        function(cell, size, points);
      }
      ++cell;
    }
  }
}

//------------------------------------------------------------------------------
/// For each cell 1 if it is the piece's own or at most `levels` rings away from those, sharing a
/// point being near.
std::vector<unsigned char> FindKeptCells(
  vtkPolyData* surface, vtkUnsignedCharArray* ghosts, int levels)
{
  std::vector<unsigned char> kept(surface->GetNumberOfCells());
  for (std::size_t cell = 0; cell < kept.size(); ++cell)
  {
    kept[cell] =
      !(ghosts->GetValue(static_cast<vtkIdType>(cell)) & vtkDataSetAttributes::DUPLICATECELL);
  }
  std::vector<unsigned char> reached(surface->GetNumberOfPoints(), 0);
  for (int level = 0; level < levels; ++level)
  {
    ForCells(surface,
      [&](vtkIdType cell, vtkIdType size, const vtkIdType* points)
      {
        for (vtkIdType i = 0; i < size && kept[cell]; ++i)
        {
          reached[points[i]] = 1;
        }
      });
    ForCells(surface,
      [&](vtkIdType cell, vtkIdType size, const vtkIdType* points)
      {
        kept[cell] |=
          std::any_of(points, points + size, [&](vtkIdType point) { return reached[point]; });
      });
  }
  return kept;
}

//------------------------------------------------------------------------------
/// The points of kept cells, and those that no cell has.
std::vector<vtkIdType> FindKeptPoints(
  vtkPolyData* surface, const std::vector<unsigned char>& keptCells)
{
  constexpr unsigned char unused = 0;
  constexpr unsigned char dropped = 1;
  constexpr unsigned char kept = 2;
  std::vector<unsigned char> states(surface->GetNumberOfPoints(), unused);
  ForCells(surface,
    [&](vtkIdType cell, vtkIdType size, const vtkIdType* points)
    {
      for (vtkIdType i = 0; i < size; ++i)
      {
        states[points[i]] = std::max(states[points[i]], keptCells[cell] ? kept : dropped);
      }
    });
  std::vector<vtkIdType> ids;
  for (std::size_t i = 0; i < states.size(); ++i)
  {
    if (states[i] != dropped)
    {
      ids.push_back(static_cast<vtkIdType>(i));
    }
  }
  return ids;
}

//------------------------------------------------------------------------------
/// The surface with the kept cells only.
vtkSmartPointer<vtkPolyData> Select(vtkPolyData* surface, const std::vector<unsigned char>& kept)
{
  auto selection = vtkSmartPointer<vtkPolyData>::New();
  const std::vector<vtkIdType> points = FindKeptPoints(surface, kept);
  std::vector<vtkIdType> numbers(surface->GetNumberOfPoints(), -1);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    numbers[points[i]] = static_cast<vtkIdType>(i);
  }
  SelectPoints(surface, points, selection);

  const std::array<vtkIdType, 4> sizes = { surface->GetNumberOfVerts(), surface->GetNumberOfLines(),
    surface->GetNumberOfPolys(), surface->GetNumberOfStrips() };
  std::array<vtkNew<vtkCellArray>, 4> cells;
  std::vector<vtkIdType> keptCells;
  int kind = 0;
  vtkIdType end = sizes[0];
  ForCells(surface,
    [&](vtkIdType cell, vtkIdType size, const vtkIdType* corners)
    {
      while (cell >= end)
      {
        end += sizes[++kind];
      }
      if (kept[cell])
      {
        keptCells.push_back(cell);
        cells[kind]->InsertNextCell(static_cast<int>(size));
        for (vtkIdType i = 0; i < size; ++i)
        {
          cells[kind]->InsertCellPoint(numbers[corners[i]]);
        }
      }
    });
  selection->SetVerts(cells[0]);
  selection->SetLines(cells[1]);
  selection->SetPolys(cells[2]);
  selection->SetStrips(cells[3]);
  SelectTuples(surface->GetCellData(), keptCells, selection->GetCellData());
  selection->GetFieldData()->PassData(surface->GetFieldData());
  return selection;
}
}

//------------------------------------------------------------------------------
bool IsPiece(vtkInformation* output)
{
  return output->Has(Pipeline::UPDATE_NUMBER_OF_PIECES()) &&
    output->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()) > 1;
}

//------------------------------------------------------------------------------
void RequestGhostLevels(vtkInformation* input, vtkInformation* output, int rings)
{
  if (IsPiece(output))
  {
    input->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(),
      output->Get(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS()) + rings);
  }
}

//------------------------------------------------------------------------------
void DropExtraGhostLevels(vtkPolyData* surface, vtkInformation* output)
{
  vtkUnsignedCharArray* ghosts = surface->GetCellGhostArray();
  if (!IsPiece(output) || !ghosts || ghosts->GetNumberOfTuples() != surface->GetNumberOfCells())
  {
    return;
  }
  const int levels = output->Get(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS());
  const std::vector<unsigned char> kept = FindKeptCells(surface, ghosts, levels);
  if (std::find(kept.begin(), kept.end(), 0) != kept.end())
  {
    surface->ShallowCopy(Select(surface, kept));
  }
  if (levels == 0)
  {
    surface->GetCellData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
    surface->GetPointData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
  }
}
}
