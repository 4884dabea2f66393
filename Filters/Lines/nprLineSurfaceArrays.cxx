// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// The arrays of a LineSurface: of points, and of regions of triangles.
#include "nprLineSurface.h"

#include "nprArrayNames.h"

#include <vtkArrayDispatch.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataArrayRange.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <utility>

namespace npr
{
namespace
{
/// Parts regions further by one component of a cell array.
struct RegionSplitter
{
  using Index = LineSurface::Index;

  template<typename Array>
  void operator()(
    Array* array, const LineSurface& surface, int component, std::vector<Index>& regions) const
  {
    const auto tuples = vtk::DataArrayTupleRange(array);
    using Value = typename decltype(tuples)::ComponentType;
    std::vector<Value> values(regions.size());
    std::vector<Index> order(regions.size());
    for (std::size_t t = 0; t < regions.size(); ++t)
    {
      values[t] = tuples[surface.GetCellId(static_cast<Index>(t))][component];
      order[t] = static_cast<Index>(t);
    }
    const auto isLess = [&](Index a, Index b)
    {
      if (regions[a] != regions[b])
      {
        return regions[a] < regions[b];
      }
      const bool isNumber = values[a] == values[a];
      const bool isOtherNumber = values[b] == values[b];
      return isNumber && (!isOtherNumber || values[a] < values[b]);
    };
    vtkSMPTools::Sort(order.begin(), order.end(), isLess);
    std::vector<Index> parted(regions.size());
    for (std::size_t i = 1; i < order.size(); ++i)
    {
      parted[order[i]] = parted[order[i - 1]] + (isLess(order[i - 1], order[i]) ? 1 : 0);
    }
    regions = std::move(parted);
  }
};
}

//------------------------------------------------------------------------------
const LineSurface::Array* LineSurface::FindArray(const char* name) const
{
  for (const Array& array : this->Arrays)
  {
    if (array.Name == name)
    {
      return &array;
    }
  }
  return nullptr;
}

//------------------------------------------------------------------------------
bool LineSurface::LoadArray(vtkPolyData* surface, const char* name, int components)
{
  if (const Array* loaded = this->FindArray(name))
  {
    return components == 0 || static_cast<int>(loaded->Components.size()) == components;
  }
  vtkDataArray* array = surface->GetPointData()->GetArray(name);
  if (!array && std::string(name) == names::Normals)
  {
    array = surface->GetPointData()->GetNormals();
  }
  const Index numberOfPoints = this->Mesh.GetNumberOfPoints();
  if (components == 0 && std::string(name) == names::Normals)
  {
    components = 3; // as everything else takes them
  }
  if (!array || (components > 0 && array->GetNumberOfComponents() != components) ||
    array->GetNumberOfTuples() != numberOfPoints)
  {
    return false;
  }
  components = array->GetNumberOfComponents();
  this->Arrays.push_back({ name, {} });
  std::vector<AlignedVector<float>>& spans = this->Arrays.back().Components;
  spans.assign(components, AlignedVector<float>(numberOfPoints));
  auto* const floats = vtkFloatArray::FastDownCast(array);
  vtkSMPTools::For(0, numberOfPoints,
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<double> tuple(components);
      for (vtkIdType i = begin; i < end; ++i)
      {
        const vtkIdType point = this->PointIds[i];
        if (floats)
        {
          std::copy_n(floats->GetPointer(point * components), components, tuple.begin());
        }
        else
        {
          array->GetTuple(point, tuple.data());
        }
        for (int c = 0; c < components; ++c)
        {
          spans[c][i] = static_cast<float>(tuple[c]);
        }
      }
    });
  return true;
}

//------------------------------------------------------------------------------
void LineSurface::SetArray(const std::string& name, std::vector<AlignedVector<float>> components)
{
  const auto found = std::find_if(this->Arrays.begin(), this->Arrays.end(),
    [&name](const Array& array) { return array.Name == name; });
  if (found != this->Arrays.end())
  {
    found->Components = std::move(components);
  }
  else
  {
    this->Arrays.push_back({ name, std::move(components) });
  }
}

//------------------------------------------------------------------------------
bool LineSurface::LoadRegions(vtkPolyData* surface, const std::string& name)
{
  if (this->Regions.count(name) > 0)
  {
    return true;
  }
  vtkDataArray* const array = surface->GetCellData()->GetArray(name.c_str());
  if (!array || array->GetNumberOfTuples() != surface->GetNumberOfCells())
  {
    return false;
  }
  std::vector<Index> regions(this->Mesh.GetNumberOfTriangles(), 0);
  const RegionSplitter split;
  for (int c = 0; c < array->GetNumberOfComponents(); ++c)
  {
    if (!vtkArrayDispatch::Dispatch::Execute(array, split, *this, c, regions))
    {
      split(array, *this, c, regions);
    }
  }
  this->Regions.emplace(name, std::move(regions));
  return true;
}
}
