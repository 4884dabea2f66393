// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// A surface in pieces has the normals, curvatures and refined triangles that it has whole.
#include "nprCurvaturePipeline.h"
#include "nprFaceCurvature.h"
#include "nprIrregularMeshes.h"
#include "nprLengthScale.h"
#include "nprSurfaceNormals.h"
#include "nprWeldedPoints.h"
#include "vtkNPRSurfaceRefinement.h"

#include <vtkDataSetAttributes.h>
#include <vtkExtractPolyDataPiece.h>
#include <vtkFieldData.h>
#include <vtkUnsignedCharArray.h>

#include <array>
#include <map>
#include <set>
#include <string>
#include <vector>

using namespace nprtest;

namespace
{
/// Each piece is centred on itself, so the last bits of single precision differ; where the normal
/// of a corner hangs on one thin triangle that is up to a hundred times as much.
constexpr double Rounding = 5e-4;

vtkSmartPointer<vtkPolyData> GetPiece(
  vtkPolyDataAlgorithm* filter, int piece, int pieces, int levels)
{
  filter->UpdatePiece(piece, pieces, levels);
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->ShallowCopy(filter->GetOutput());
  return copy;
}

vtkIdType GetNumber(vtkDataSetAttributes* attributes, const char* name, vtkIdType i)
{
  return static_cast<vtkIdType>(attributes->GetArray(name)->GetComponent(i, 0));
}

/// Where the points with the numbers 0, 1, 2 ... are: the source renumbers them, even for one
/// piece.
std::vector<vtkIdType> FindPoints(vtkPolyData* whole)
{
  std::vector<vtkIdType> points(whole->GetNumberOfPoints());
  for (vtkIdType i = 0; i < whole->GetNumberOfPoints(); ++i)
  {
    points[GetNumber(whole->GetPointData(), PointNumbers, i)] = i;
  }
  return points;
}

/// Largest differences, each relative to the largest value on the whole surface.
struct Differences
{
  double Normal = 0.0;
  double Tensor = 0.0;
  double Derivatives = 0.0;
  double Area = 0.0;

  double GetLargest() const
  {
    return std::max({ this->Normal, this->Tensor, this->Derivatives, this->Area });
  }
  void Include(const Differences& other)
  {
    this->Normal = std::max(this->Normal, other.Normal);
    this->Tensor = std::max(this->Tensor, other.Tensor);
    this->Derivatives = std::max(this->Derivatives, other.Derivatives);
    this->Area = std::max(this->Area, other.Area);
  }
};

/// The derivatives over a given frame, so that they do not depend on which principal direction was
/// found first, nor on where frames of tangent planes jump.
Vector4d GetCubic(vtkPolyData* surface, vtkIdType i, const npr::TangentFrame& frame)
{
  const Vector3d normal = GetTuple<3>(surface, npr::names::Normals, i);
  const Vector3d e1 = GetTuple<3>(surface, npr::names::PrincipalDirection1, i);
  return npr::ChangeFrame(
    GetTuple<4>(surface, npr::names::CurvatureDerivatives, i), { e1, normal.cross(e1) }, frame);
}

double GetLargestNorm(vtkPolyData* surface, const char* name)
{
  vtkDataArray* array = surface->GetPointData()->GetArray(name);
  return array ? std::max(array->GetMaxNorm(), 1e-30) : 1.0;
}

Differences Compare(vtkPolyData* piece, vtkPolyData* whole, const std::string& what, Checks& check)
{
  const double largestTensor = GetLargestNorm(whole, npr::names::CurvatureTensor);
  const double largestCubic = GetLargestNorm(whole, npr::names::CurvatureDerivatives);
  const double largestArea = GetLargestNorm(whole, npr::names::PointArea);
  const std::vector<vtkIdType> points = FindPoints(whole);
  Differences worst;
  int wrongFlags = 0;
  for (vtkIdType i = 0; i < piece->GetNumberOfPoints(); ++i)
  {
    const vtkIdType j = points[GetNumber(piece->GetPointData(), PointNumbers, i)];
    const auto difference = [&](const char* name, auto size)
    { return (GetTuple<size>(piece, name, i) - GetTuple<size>(whole, name, j)).norm(); };
    Differences here;
    here.Normal = difference(npr::names::Normals, std::integral_constant<int, 3>());
    here.Tensor =
      difference(npr::names::CurvatureTensor, std::integral_constant<int, 6>()) / largestTensor;
    const npr::TangentFrame frame =
      npr::MakeTangentFrame(GetTuple<3>(whole, npr::names::Normals, j));
    here.Derivatives =
      (GetCubic(piece, i, frame) - GetCubic(whole, j, frame)).norm() / largestCubic;
    here.Area = difference(npr::names::PointArea, std::integral_constant<int, 1>()) / largestArea;
    worst.Include(here);
    for (const char* flag : { npr::names::BorderPoints, npr::names::UnknownCurvature })
    {
      wrongFlags += GetValue(piece, flag, i) != GetValue(whole, flag, j);
    }
  }
  check(wrongFlags == 0, what + ": flags of borders and unknown curvature", wrongFlags);
  return worst;
}

/// A surface that comes in the pieces that are asked for.
struct Source
{
  explicit Source(vtkPolyData* surface) { this->Pieces->SetInputData(surface); }
  vtkNew<vtkExtractPolyDataPiece> Pieces;
};

struct Filters
{
  vtkNew<vtkNPRSurfaceNormals> Normals;
  vtkNew<vtkNPRCurvatureTensor> Tensor;
  vtkNew<vtkNPRCurvatureDerivatives> Derivatives;

  Filters(const Source& source, int estimator)
  {
    this->Normals->SetInputConnection(source.Pieces->GetOutputPort());
    this->Tensor->SetInputConnection(this->Normals->GetOutputPort());
    this->Derivatives->SetInputConnection(this->Tensor->GetOutputPort());
    this->Tensor->SetEstimator(estimator);
    this->Tensor->SetNeighbourhoodRadius(2.5); // an automatic one would be each piece's own
    this->Tensor->OutputPointAreaOn();
  }
};

void CheckCells(vtkPolyData* piece, vtkPolyData* whole, const std::string& what, Checks& check)
{
  vtkNew<vtkIdList> here;
  vtkNew<vtkIdList> there;
  int wrong = 0;
  for (vtkIdType cell = 0; cell < piece->GetNumberOfCells(); ++cell)
  {
    piece->GetCellPoints(cell, here);
    whole->GetCellPoints(GetNumber(piece->GetCellData(), CellNumbers, cell), there);
    for (vtkIdType i = 0; i < here->GetNumberOfIds(); ++i)
    {
      wrong += GetNumber(piece->GetPointData(), PointNumbers, here->GetId(i)) !=
        GetNumber(whole->GetPointData(), PointNumbers, there->GetId(i));
    }
  }
  check(wrong == 0, what + ": cells have their points and data", wrong);
}

/// All pieces of a filter's output against the whole. With no ghost levels each cell comes once.
Differences TestPieces(vtkPolyDataAlgorithm* filter, const std::string& name, Checks& check)
{
  const vtkSmartPointer<vtkPolyData> whole = GetPiece(filter, 0, 1, 0);
  Differences worst;
  for (int pieces : { 2, 3, 7 })
  {
    const std::string what = name + " in " + std::to_string(pieces);
    std::set<vtkIdType> cells;
    vtkIdType numberOfCells = 0;
    for (int piece = 0; piece < pieces; ++piece)
    {
      const vtkSmartPointer<vtkPolyData> output = GetPiece(filter, piece, pieces, 0);
      check(!output->GetCellGhostArray() && !output->GetPointGhostArray(),
        what + ": no ghosts where none are asked for");
      for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
      {
        cells.insert(GetNumber(output->GetCellData(), CellNumbers, cell));
      }
      numberOfCells += output->GetNumberOfCells();
      CheckCells(output, whole, what, check);
      worst.Include(Compare(output, whole, what, check));
    }
    check(numberOfCells == whole->GetNumberOfCells() &&
        static_cast<vtkIdType>(cells.size()) == numberOfCells,
      what + ": each cell once", numberOfCells);
  }
  return worst;
}

/// Ghost levels that are asked for come, are right, and are those that the source would give.
void TestGhostLevels(vtkPolyData* surface, vtkPolyDataAlgorithm* filter, Checks& check)
{
  const vtkSmartPointer<vtkPolyData> whole = GetPiece(filter, 0, 1, 0);
  constexpr int pieces = 3;
  for (int levels : { 1, 2 })
  {
    const std::string what = std::to_string(levels) + " ghost levels";
    std::vector<int> owners(whole->GetNumberOfPoints(), 0);
    for (int piece = 0; piece < pieces; ++piece)
    {
      const vtkSmartPointer<vtkPolyData> output = GetPiece(filter, piece, pieces, levels);
      vtkNew<vtkExtractPolyDataPiece> plain;
      plain->SetInputData(surface);
      plain->UpdatePiece(piece, pieces, levels);
      vtkPolyData* expected = plain->GetOutput();
      vtkUnsignedCharArray* ghosts = output->GetCellGhostArray();
      vtkUnsignedCharArray* pointGhosts = output->GetPointGhostArray();
      if (!check(ghosts && pointGhosts, what + " are flagged"))
      {
        continue;
      }
      std::map<vtkIdType, int> flags;
      for (vtkIdType i = 0; i < expected->GetNumberOfCells(); ++i)
      {
        flags[GetNumber(expected->GetCellData(), CellNumbers, i)] =
          expected->GetCellGhostArray()->GetValue(i);
      }
      check(output->GetNumberOfCells() == expected->GetNumberOfCells() &&
          output->GetNumberOfPoints() == expected->GetNumberOfPoints(),
        what + ": as many as asked for", output->GetNumberOfCells());
      int wrong = 0;
      for (vtkIdType i = 0; i < output->GetNumberOfCells(); ++i)
      {
        const auto found = flags.find(GetNumber(output->GetCellData(), CellNumbers, i));
        wrong += found == flags.end() || found->second != ghosts->GetValue(i);
      }
      check(wrong == 0, what + ": the same cells, flagged alike", wrong);
      for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
      {
        owners[GetNumber(output->GetPointData(), PointNumbers, i)] += !pointGhosts->GetValue(i);
      }
      CheckCells(output, whole, what, check);
      const Differences differences = Compare(output, whole, what, check);
      check(differences.GetLargest() < Rounding, what + ": right, too", differences.GetLargest());
    }
    check(std::count(owners.begin(), owners.end(), 1) == whole->GetNumberOfPoints(),
      what + ": each point belongs to one piece",
      static_cast<double>(std::count(owners.begin(), owners.end(), 1)));
  }
}

/// Refined pieces together are the refined whole.
void TestRefinement(vtkPolyData* surface, Checks& check)
{
  const Source source(surface);
  vtkNew<vtkNPRSurfaceNormals> normals;
  vtkNew<vtkNPRSurfaceRefinement> refinement;
  normals->SetInputConnection(source.Pieces->GetOutputPort());
  refinement->SetInputConnection(normals->GetOutputPort());
  for (bool isUniform : { true, false })
  {
    const std::string name = isUniform ? "uniform refinement" : "adaptive refinement";
    refinement->SetNumberOfLevels(isUniform ? 2 : -1);
    refinement->SetMaximumEdgeLength(0.05);
    const vtkSmartPointer<vtkPolyData> whole = GetPiece(refinement, 0, 1, 0);
    // Each coarse cell has parts; their corners, rounded, in the order of the parts.
    using Corners = std::map<vtkIdType, std::vector<Vector3d>>;
    const auto addCorners = [](vtkPolyData* output, Corners& corners)
    {
      vtkNew<vtkIdList> ids;
      for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
      {
        output->GetCellPoints(cell, ids);
        for (vtkIdType i = 0; i < 3; ++i)
        {
          Vector3d point;
          output->GetPoint(ids->GetId(i), point.data());
          corners[GetNumber(output->GetCellData(), CellNumbers, cell)].push_back(point);
        }
      }
    };
    Corners expected;
    addCorners(whole, expected);
    check(whole->GetNumberOfCells() > 2 * surface->GetNumberOfCells(), name + " refines");
    for (int pieces : { 2, 3, 7 })
    {
      Corners found;
      for (int piece = 0; piece < pieces; ++piece)
      {
        const vtkSmartPointer<vtkPolyData> output = GetPiece(refinement, piece, pieces, 0);
        check(!output->GetCellGhostArray(), name + ": no ghosts");
        addCorners(output, found);
      }
      double worst = 0.0;
      int wrong = 0;
      for (const auto& cell : expected)
      {
        const std::vector<Vector3d>& other = found[cell.first];
        if (other.size() != cell.second.size())
        {
          ++wrong;
          continue;
        }
        for (std::size_t i = 0; i < other.size(); ++i)
        {
          worst = std::max(worst, (other[i] - cell.second[i]).norm());
        }
      }
      check(wrong == 0, name + ": cells have as many parts", wrong);
      check(worst < 1e-5, name + ": parts lie in the same place", worst);
    }
  }
}

/// Which points are copies of each other is known in pieces, too, though their ids are the whole's.
void TestWeldedPoints(Checks& check)
{
  vtkNew<vtkNPRSurfacePreparation> preparation;
  preparation->SetInputData(MakeCube());
  preparation->Update();
  vtkPolyData* cube = preparation->GetOutput();
  AddNumbers(cube->GetPointData(), PointNumbers, cube->GetNumberOfPoints());
  const std::vector<npr::TriangleMesh::Index> whole = npr::GetWeldedPoints(cube);
  const Source source(cube);
  vtkNew<vtkNPRSurfaceNormals> normals;
  normals->SetInputConnection(source.Pieces->GetOutputPort());
  for (int piece = 0; piece < 3; ++piece)
  {
    const vtkSmartPointer<vtkPolyData> output = GetPiece(normals, piece, 3, 0);
    const std::vector<npr::TriangleMesh::Index> part = npr::GetWeldedPoints(output);
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      for (vtkIdType j = 0; j < i; ++j)
      {
        const vtkIdType a = GetNumber(output->GetPointData(), PointNumbers, i);
        const vtkIdType b = GetNumber(output->GetPointData(), PointNumbers, j);
        check((part[i] == part[j]) == (whole[a] == whole[b]), "copies know each other in pieces");
      }
    }
  }
}

/// The preparation keeps ghost cells what they are.
void TestPreparation(vtkPolyData* surface, Checks& check)
{
  const Source source(surface);
  vtkNew<vtkNPRSurfacePreparation> preparation;
  preparation->SetInputConnection(source.Pieces->GetOutputPort());
  const vtkSmartPointer<vtkPolyData> output = GetPiece(preparation, 1, 3, 2);
  vtkPolyData* input = source.Pieces->GetOutput();
  std::map<vtkIdType, int> flags;
  for (vtkIdType i = 0; i < input->GetNumberOfCells(); ++i)
  {
    flags[GetNumber(input->GetCellData(), CellNumbers, i)] =
      input->GetCellGhostArray()->GetValue(i);
  }
  int ghosts = 0;
  int wrong = 0;
  for (vtkIdType i = 0; output->GetCellGhostArray() && i < output->GetNumberOfCells(); ++i)
  {
    const int flag = output->GetCellGhostArray()->GetValue(i);
    ghosts += flag;
    wrong += flag != flags[GetNumber(output->GetCellData(), CellNumbers, i)];
  }
  check(ghosts > 0 && wrong == 0, "prepared ghost cells are ghost cells", ghosts);
}

/// Smoothing reaches far, and its steps follow the piece's own mean triangle: nearly as in the
/// whole.
void TestSmoothing(Checks& check)
{
  const auto surface = MakeIrregular(MakeTorus(1.0, 0.15, 200, 24), 0.002);
  npr::SetLengthScale(surface, 1.0);
  const Source source(surface);
  Filters filters(source, 0);
  for (double radius : { 0.03, 0.1 })
  {
    filters.Normals->SetSmoothingRadius(radius);
    filters.Tensor->SetSmoothingRadius(radius);
    const Differences differences =
      TestPieces(filters.Tensor, "smooth " + std::to_string(radius), check);
    std::cout << "smooth " << radius << ": normal " << differences.Normal << " tensor "
              << differences.Tensor << " derivatives " << differences.Derivatives << "\n";
    check(differences.GetLargest() < 1e-3, "smooth as in the whole", differences.GetLargest());
  }
}

//------------------------------------------------------------------------------
/// Some points alone have the very numbers that they have among all.
void TestSomePoints(vtkPolyData* surface, Checks& check)
{
  npr::TriangleMesh mesh(surface);
  mesh.BuildIncidence();
  const npr::Tuples<3> normals = npr::ComputeNormals(mesh, npr::NormalWeights::Max);
  const npr::FaceCurvature estimator;
  const npr::CurvatureEstimate all = estimator.Estimate(mesh, normals, true, npr::IgnoreProgress);
  const std::vector<npr::TriangleMesh::Index> some = { mesh.GetNumberOfPoints() - 1, 0, 57, 58 };
  const npr::CurvatureEstimate part = estimator.EstimateAt(some, mesh, normals, true);
  check(part.Tensors.size() == some.size() && part.Unknown.size() == some.size(),
    "as many as were asked for", static_cast<double>(part.Tensors.size()));
  for (std::size_t i = 0; i < some.size(); ++i)
  {
    check(part.Tensors[i] == all.Tensors[some[i]] &&
        part.Derivatives[i] == all.Derivatives[some[i]] &&
        part.Unknown[i] == all.Unknown[some[i]] && part.Normals[i] == all.Normals[some[i]],
      "the same at a few points alone", some[i]);
  }
}
}

int TestCurvaturePieces(int, char*[])
{
  Checks check;
  for (int estimator = 0; estimator < vtkNPRCurvatureTensor::GetNumberOfEstimators(); ++estimator)
  {
    for (bool hasBorder : { false, true })
    {
      // The torus is long: pieces with all their ghost levels are far from the whole.
      const auto surface = hasBorder ? MakeIrregular(MakeWaves(30), 0.01)
                                     : MakeIrregular(MakeTorus(1.0, 0.1, 160, 14), 0.003);
      const Source source(surface);
      Filters filters(source, estimator);
      const std::string name = std::string(vtkNPRCurvatureTensor::GetEstimatorName(estimator)) +
        (hasBorder ? ", with border" : ", closed");
      const Differences own = TestPieces(filters.Tensor, name, check);
      std::cout << name << ": normal " << own.Normal << " tensor " << own.Tensor << " derivatives "
                << own.Derivatives << " area " << own.Area << "\n";
      check(own.GetLargest() < Rounding, name + ": as in the whole", own.GetLargest());
      // The filter of derivatives alone.
      filters.Tensor->OutputDerivativesOff();
      const Differences after = TestPieces(filters.Derivatives, name + ", filter", check);
      check(
        after.GetLargest() < Rounding, name + ": derivatives as in the whole", after.Derivatives);
      filters.Tensor->OutputDerivativesOn();
      // Without given normals.
      filters.Tensor->SetInputConnection(source.Pieces->GetOutputPort());
      const Differences bare = TestPieces(filters.Tensor, name + ", no normals", check);
      check(bare.GetLargest() < Rounding, name + ": without normals", bare.GetLargest());
      TestGhostLevels(surface, filters.Tensor, check);
    }
  }
  TestSmoothing(check);
  const auto waves = MakeIrregular(MakeWaves(20), 0.01);
  npr::SetLengthScale(waves, 1.0);
  TestSomePoints(waves, check);
  TestRefinement(waves, check);
  TestWeldedPoints(check);
  TestPreparation(waves, check);
  return check.GetResult();
}
