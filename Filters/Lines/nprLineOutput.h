// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprLineOutput_h
#define nprLineOutput_h

#include "nprChainIds.h"
#include "nprLineChains.h"
#include "nprLineQuantities.h"
#include "nprLineView.h"
#include "nprVTKCompat.h"
#include "vtkNPRFiltersLinesModule.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <cstddef>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;
VTK_ABI_NAMESPACE_END

namespace npr
{
/// Those of a definition's chains that are written, and their numbers.
struct LineChoice
{
  std::vector<std::size_t> Chains;
  std::vector<int> Ids; ///< may be ChainIds::NoId before they are written
};

/**
 * @class LineOutput
 * @brief Writes the chains of all definitions into one vtkPolyData.
 *
 * What no view has changed since the last time is not written again; the arrays are the last ones
 * where nobody else holds them.
 */
class VTKNPRFILTERSLINES_EXPORT LineOutput
{
public:
  /// What is left out, and what is written of the rest.
  struct Options
  {
    double MinimumLength = 0.0; ///< heights of the view
    float MinimumStrength = 0.0f;
    double Hysteresis = 0.0; ///< by how much less will do for chains that were there before
    const LineRuler* Ruler = nullptr; ///< null where there is no camera
  };

  /// The point arrays that all lines may have.
  static const std::vector<std::string>& GetOwnArrays();

  /// Begins an output. The origin is what the chains' positions are relative to.
  void Begin(const Eigen::Vector3d& origin, const Options& options);
  /// Which chains of a definition are wanted. For several definitions at once, if need be.
  LineChoice Choose(const LineChains& chains, const ChainIds& ids) const;
  /// Adds the chosen chains, which must live until the output after this has been written. `type`
  /// is the definition's number, `levels` its levels. Gives numbers from `nextId` on, which goes
  /// on, to chains without.
  void Add(const LineChains& chains, int type, const std::vector<double>& levels,
    LineChoice& choice, int& nextId);
  /// The chains of a definition as they were written last. False, and nothing is added, if they
  /// would be at another place or others might be chosen now.
  bool AddLast(const LineChains& chains, int type);
  /// Points, lines, and their arrays.
  void Write(vtkPolyData* output);
  /// Point arrays of what the lines carry of the surface. After Write().
  void WriteQuantities(const LineSurface& surface, const LineView& view,
    const std::vector<LineQuantity>& quantities, vtkPolyData* output);

private:
  struct Line
  {
    const LineChains* Chains;
    std::size_t Chain;
    vtkIdType FirstPoint;
    vtkIdType FirstCorner;
    double Level;
    int Type;
    int Id;
    bool IsUnchanged;
  };
  struct Arrays
  {
    vtkSmartPointer<vtkDoubleArray> Positions;
    vtkSmartPointer<vtkFloatArray> Normals;
    vtkSmartPointer<vtkFloatArray> Strengths;
    vtkSmartPointer<vtkFloatArray> ArcLengths;
    vtkSmartPointer<vtkFloatArray> Distances;
    std::vector<vtkSmartPointer<vtkFloatArray>> Quantities;
    vtkSmartPointer<vtkIdTypeArray> SourceCells;
    vtkSmartPointer<vtkIdTypeArray> SourceEdges;
    vtkSmartPointer<vtkIntArray> Types;
    vtkSmartPointer<vtkDoubleArray> Levels;
    vtkSmartPointer<vtkIntArray> Ids;
    vtkSmartPointer<vtkIdTypeArray> Offsets;
    vtkSmartPointer<vtkIdTypeArray> Corners;
    vtkSmartPointer<vtkPoints> Points;
    vtkSmartPointer<vtkCellArray> Cells;
  };
  bool IsWanted(const LineChains& chains, std::size_t chain, const ChainIds::Claim& claim) const;
  void WriteLines();
  void WriteDistances(const Line& line);

  Eigen::Vector3d Origin = Eigen::Vector3d::Zero();
  Options Settings;
  std::vector<Line> Lines;
  std::vector<Line> LastLines;
  bool MayKeepLast = false; // whether the same chains would be chosen again
  vtkIdType NumberOfPoints = 0;
  vtkIdType NumberOfCorners = 0;
  Arrays Written;
};
}

#endif
