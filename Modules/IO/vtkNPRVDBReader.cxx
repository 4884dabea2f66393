// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRVDBReader.h"

#include "nprOpenVDB.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkTypeTraits.h>

#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

struct vtkNPRVDBReader::Internals
{
  std::vector<std::string> Names;
  std::vector<std::string> Types;
  openvdb::GridBase::Ptr Grid;
  openvdb::CoordBBox Box;
};

namespace
{
template<typename GridType, typename Value>
bool CopyAs(const openvdb::GridBase& base, const openvdb::CoordBBox& box, vtkImageData* image)
{
  if (!base.isType<GridType>())
  {
    return false;
  }
  image->AllocateScalars(vtkTypeTraits<Value>::VTKTypeID(), 1);
  openvdb::tools::Dense<Value, openvdb::tools::LayoutXYZ> dense(
    box, static_cast<Value*>(image->GetScalarPointer()));
  openvdb::tools::copyToDense(static_cast<const GridType&>(base), dense);
  return true;
}

bool CopyToImage(const openvdb::GridBase& grid, const openvdb::CoordBBox& box, vtkImageData* image)
{
  return CopyAs<openvdb::FloatGrid, float>(grid, box, image) ||
    CopyAs<openvdb::DoubleGrid, double>(grid, box, image) ||
    CopyAs<openvdb::Int32Grid, int>(grid, box, image) ||
    CopyAs<openvdb::Int64Grid, double>(grid, box, image) ||
    CopyAs<openvdb::BoolGrid, unsigned char>(grid, box, image);
}

bool IsScalar(const openvdb::GridBase& grid)
{
  return grid.isType<openvdb::FloatGrid>() || grid.isType<openvdb::DoubleGrid>() ||
    grid.isType<openvdb::Int32Grid>() || grid.isType<openvdb::Int64Grid>() ||
    grid.isType<openvdb::BoolGrid>();
}

// The grid to read, by its name or by our preference, with metadata only.
openvdb::GridBase::Ptr ChooseGrid(const openvdb::GridPtrVec& grids, const char* name)
{
  std::string list;
  openvdb::GridBase::Ptr chosen;
  for (const auto& grid : grids)
  {
    list += (list.empty() ? "'" : ", '") + grid->getName() + "' (" + grid->valueType() + ")";
    if (name ? grid->getName() == name
             : IsScalar(*grid) &&
          (!chosen ||
            (chosen->getGridClass() != openvdb::GRID_LEVEL_SET &&
              grid->getGridClass() == openvdb::GRID_LEVEL_SET)))
    {
      chosen = grid;
    }
  }
  if (!chosen)
  {
    throw std::runtime_error(name
        ? "it has no grid '" + std::string(name) + "'; choose one of " + list
        : "it has no scalar grid, only " + (list.empty() ? "nothing" : list));
  }
  if (!IsScalar(*chosen))
  {
    throw std::runtime_error("its grid '" + chosen->getName() + "' holds " + chosen->valueType() +
      ", and only scalars can be read; choose another one of " + list);
  }
  return chosen;
}

// Spacing and origin of a transform that only scales and moves.
void GetPlacement(const openvdb::math::Transform& transform, double spacing[3], double origin[3])
{
  if (!transform.isLinear())
  {
    throw std::runtime_error("its grid lies in a frustum, and an image can not; resample the grid "
                             "with a linear transform");
  }
  const openvdb::Vec3d zero = transform.indexToWorld(openvdb::Vec3d(0.0));
  for (int axis = 0; axis < 3; ++axis)
  {
    openvdb::Vec3d unit(0.0);
    unit[axis] = 1.0;
    const openvdb::Vec3d step = transform.indexToWorld(unit) - zero;
    origin[axis] = zero[axis];
    spacing[axis] = step[axis];
    for (int other = 0; other < 3; ++other)
    {
      if (other != axis && std::abs(step[other]) > 1e-6 * step.length())
      {
        throw std::runtime_error("its grid is rotated or sheared, and an image can not be; "
                                 "resample the grid with a transform along the axes");
      }
    }
    if (!(spacing[axis] > 0.0))
    {
      throw std::runtime_error("its voxels have no positive size; write the grid again");
    }
  }
}
}

vtkStandardNewMacro(vtkNPRVDBReader);

vtkNPRVDBReader::vtkNPRVDBReader() : Internal(std::make_unique<Internals>())
{
  this->SetNumberOfInputPorts(0);
}

vtkNPRVDBReader::~vtkNPRVDBReader()
{
  this->SetFileName(nullptr);
  this->SetGridName(nullptr);
}

int vtkNPRVDBReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  Internals& internal = *this->Internal;
  internal = Internals();
  this->IsLevelSet = false;
  if (!this->FileName)
  {
    vtkErrorMacro("No file is named; call SetFileName().");
    return 0;
  }
  try
  {
    openvdb::initialize();
    openvdb::io::File file(this->FileName);
    file.open(false); // all of it now, so that a damaged file shows here
    const openvdb::GridPtrVecPtr grids = file.readAllGridMetadata();
    for (const auto& grid : *grids)
    {
      internal.Names.push_back(grid->getName());
      internal.Types.push_back(grid->type());
    }
    internal.Grid = file.readGrid(ChooseGrid(*grids, this->GridName)->getName());
    this->IsLevelSet = internal.Grid->getGridClass() == openvdb::GRID_LEVEL_SET;

    double spacing[3];
    double origin[3];
    GetPlacement(internal.Grid->transform(), spacing, origin);
    internal.Box = internal.Grid->evalActiveVoxelBoundingBox();
    if (internal.Box.empty())
    {
      throw std::runtime_error("its grid '" + internal.Grid->getName() + "' has no active voxel");
    }
    internal.Box.expand(1);
    double voxels = 1.0;
    int extent[6];
    for (int axis = 0; axis < 3; ++axis)
    {
      voxels *= double(internal.Box.max()[axis]) - internal.Box.min()[axis] + 1.0;
      extent[2 * axis] = internal.Box.min()[axis];
      extent[2 * axis + 1] = internal.Box.max()[axis];
    }
    if (voxels > static_cast<double>(this->MaximumNumberOfVoxels))
    {
      throw std::runtime_error("its grid '" + internal.Grid->getName() + "' would take " +
        std::to_string(static_cast<long long>(std::min(voxels, 9e18))) + " voxels, more than " +
        std::to_string(this->MaximumNumberOfVoxels) +
        "; resample it, or raise MaximumNumberOfVoxels");
    }
    vtkInformation* information = outputs->GetInformationObject(0);
    information->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
    information->Set(vtkDataObject::SPACING(), spacing, 3);
    information->Set(vtkDataObject::ORIGIN(), origin, 3);
  }
  catch (const std::exception& error)
  {
    internal.Grid.reset();
    vtkErrorMacro(<< "Cannot read '" << this->FileName << "': " << error.what() << ".");
    return 0;
  }
  return 1;
}

int vtkNPRVDBReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  Internals& internal = *this->Internal;
  if (!internal.Grid)
  {
    return 0; // RequestInformation() has said why
  }
  vtkImageData* image = vtkImageData::GetData(outputs);
  vtkInformation* information = outputs->GetInformationObject(0);
  int extent[6];
  information->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent);
  image->SetExtent(extent);
  image->SetSpacing(information->Get(vtkDataObject::SPACING()));
  image->SetOrigin(information->Get(vtkDataObject::ORIGIN()));
  try
  {
    if (!CopyToImage(*internal.Grid, internal.Box, image))
    {
      vtkErrorMacro(<< "The grid '" << internal.Grid->getName() << "' is not scalar.");
      return 0;
    }
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< "Cannot read '" << this->FileName << "': " << error.what() << ".");
    return 0;
  }
  const std::string name = internal.Grid->getName();
  image->GetPointData()->GetScalars()->SetName(name.empty() ? "Value" : name.c_str());
  this->UpdateProgress(1.0);
  return 1;
}

int vtkNPRVDBReader::GetNumberOfGrids() const
{
  return static_cast<int>(this->Internal->Names.size());
}

const char* vtkNPRVDBReader::GetNameOfGrid(int grid) const
{
  return grid >= 0 && grid < this->GetNumberOfGrids() ? this->Internal->Names[grid].c_str()
                                                      : nullptr;
}

const char* vtkNPRVDBReader::GetTypeOfGrid(int grid) const
{
  return grid >= 0 && grid < this->GetNumberOfGrids() ? this->Internal->Types[grid].c_str()
                                                      : nullptr;
}

void vtkNPRVDBReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "GridName: " << (this->GridName ? this->GridName : "(none)") << "\n";
  os << indent << "MaximumNumberOfVoxels: " << this->MaximumNumberOfVoxels << "\n";
  os << indent << "IsLevelSet: " << this->IsLevelSet << "\n";
}
