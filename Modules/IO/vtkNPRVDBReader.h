// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPRVDBReader
 * @brief Read a scalar grid of an OpenVDB file as vtkImageData.
 *
 * Takes grids of float, double, half (which OpenVDB holds as float), 32- and 64-bit integers
 * (the latter as double) and bool (as unsigned char). The output is dense: the box of the active
 * voxels, with one voxel more on each side, so that a surface in it closes. Origin and spacing come
 * from the grid's transform, which must be a scale and a translation along the axes.
 *
 * @par Level sets
 * A level set is a signed distance that is negative inside, so its surface lies at 0 and faces
 * towards larger values, opposite to that of a density. Beyond its narrow band the value is
 * the band's width, with the sign of the side.
 *
 * @sa vtkNPRModelImporter
 * @par Thanks
 * K. Museth, VDB: high-resolution sparse volumes with dynamic topology, 2013.
 */
#ifndef vtkNPRVDBReader_h
#define vtkNPRVDBReader_h

#include "vtkNPRIOModule.h"
#include <vtkImageAlgorithm.h>

#include <memory>

class VTKNPRIO_EXPORT vtkNPRVDBReader : public vtkImageAlgorithm
{
public:
  static vtkNPRVDBReader* New();
  vtkTypeMacro(vtkNPRVDBReader, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// @name File
  /// Path of the file. Default is null.
  ///@{
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /// @name Grid
  /// Name of the grid to read. Default is null: the first level set of floats, or else the first
  /// scalar grid.
  ///@{
  vtkSetStringMacro(GridName);
  vtkGetStringMacro(GridName);
  ///@}

  /// @name Size
  /// An error is raised instead of an image of more voxels than this. Default is 512^3 (half a
  /// gibibyte of floats).
  ///@{
  vtkSetClampMacro(MaximumNumberOfVoxels, vtkIdType, 8, VTK_ID_MAX);
  vtkGetMacro(MaximumNumberOfVoxels, vtkIdType);
  ///@}

  /// @name The file's grids
  /// All grids that the file names, known after UpdateInformation().
  ///@{
  int GetNumberOfGrids() const;
  const char* GetNameOfGrid(int grid) const;
  /// Its type by OpenVDB's name, such as "Tree_float_5_4_3".
  const char* GetTypeOfGrid(int grid) const;
  ///@}

  /// Whether the grid that was read is a level set: negative inside. Known after Update().
  vtkGetMacro(IsLevelSet, bool);

protected:
  vtkNPRVDBReader();
  ~vtkNPRVDBReader() override;

  int RequestInformation(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  char* FileName = nullptr;
  char* GridName = nullptr;
  vtkIdType MaximumNumberOfVoxels = 512 * 512 * 512;
  bool IsLevelSet = false;

private:
  vtkNPRVDBReader(const vtkNPRVDBReader&) = delete;
  void operator=(const vtkNPRVDBReader&) = delete;

  struct Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
