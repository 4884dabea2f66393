// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprWorldLines_h
#define nprWorldLines_h

#include <vtkPolyDataAlgorithm.h>
#include <vtkSmartPointer.h>

#include <vector>

class vtkAlgorithmOutput;
class vtkMatrix4x4;

namespace npr
{
/**
 * @class WorldLines
 * @brief The lines of several sources in one set, in the world, each known by the number of its
 * source: its LineType, which vtkNPRLineSelection takes out again.
 */
class WorldLines : public vtkPolyDataAlgorithm
{
public:
  static WorldLines* New();
  vtkTypeMacro(WorldLines, vtkPolyDataAlgorithm);

  struct Source
  {
    vtkAlgorithmOutput* Lines;
    vtkMatrix4x4* Matrix; ///< To the world; is followed.
    int Number;
  };
  /// Nothing is modified where they are the same as before.
  void SetSources(const std::vector<Source>& sources);

  vtkMTimeType GetMTime() override;

protected:
  WorldLines();
  int FillInputPortInformation(int port, vtkInformation* information) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  /// What belongs to an input, by its index.
  struct Origin
  {
    vtkSmartPointer<vtkMatrix4x4> Matrix;
    int Number;
  };
  bool HasSources(const std::vector<Source>& sources);

  std::vector<Origin> Origins;
};
}

#endif
