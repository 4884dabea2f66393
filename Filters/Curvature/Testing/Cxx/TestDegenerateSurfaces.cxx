// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Input of every bad kind goes through all filters, with every estimator: no crash, nothing that is
// not finite, and where there is no curvature a flag, zeros, and one warning that counts.
#include "nprCurvaturePipeline.h"
#include "nprIrregularMeshes.h"
#include "nprLengthScale.h"
#include "vtkNPRSurfaceRefinement.h"

#include <vtkCallbackCommand.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkFloatArray.h>
#include <vtkObject.h>

#include <limits>
#include <string>

using namespace nprtest;

namespace
{
const double NaN = std::numeric_limits<double>::quiet_NaN();
const double Infinity = std::numeric_limits<double>::infinity();

vtkSmartPointer<vtkPolyData> Make(
  const std::vector<Vector3d>& points, const std::vector<std::vector<vtkIdType>>& cells)
{
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> meshPoints;
  for (const Vector3d& point : points)
  {
    meshPoints->InsertNextPoint(point.data());
  }
  vtkNew<vtkCellArray> polygons;
  for (const auto& cell : cells)
  {
    polygons->InsertNextCell(static_cast<vtkIdType>(cell.size()), cell.data());
  }
  mesh->SetPoints(meshPoints);
  mesh->SetPolys(polygons);
  return mesh;
}

/// What a filter warns of and complains about.
class Messages
{
public:
  explicit Messages(vtkObject* object) : Object(object)
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback(
      [](vtkObject*, unsigned long event, void* data, void* text)
      {
        Messages* self = static_cast<Messages*>(data);
        (event == vtkCommand::WarningEvent ? self->Warnings : self->Errors)
          .push_back(static_cast<const char*>(text));
      });
    object->AddObserver(vtkCommand::WarningEvent, this->Command);
    object->AddObserver(vtkCommand::ErrorEvent, this->Command);
  }
  ~Messages() { this->Object->RemoveObserver(this->Command); }

  std::vector<std::string> Warnings;
  std::vector<std::string> Errors;

private:
  vtkObject* Object;
  vtkNew<vtkCallbackCommand> Command;
};

/// All arrays, whoever made them.
void CheckFinite(vtkPolyData* output, const std::string& name, Checks& check)
{
  for (vtkDataSetAttributes* attributes :
    { static_cast<vtkDataSetAttributes*>(output->GetPointData()),
      static_cast<vtkDataSetAttributes*>(output->GetCellData()) })
  {
    const bool isPoints = attributes == output->GetPointData();
    const vtkIdType size = isPoints ? output->GetNumberOfPoints() : output->GetNumberOfCells();
    for (int a = 0; a < attributes->GetNumberOfArrays(); ++a)
    {
      vtkDataArray* values = attributes->GetArray(a);
      const std::string what = name + ": " + values->GetName();
      check(values->GetNumberOfTuples() == size, what + " has its size",
        static_cast<double>(values->GetNumberOfTuples()));
      int wrong = 0;
      for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
      {
        for (int c = 0; c < values->GetNumberOfComponents(); ++c)
        {
          wrong += !std::isfinite(values->GetComponent(i, c));
        }
      }
      check(wrong == 0, what + " is finite", wrong);
    }
  }
  int wrong = 0;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    wrong += !(std::abs(GetTuple<3>(output, npr::names::Normals, i).norm() - 1.0) < 1e-5);
  }
  check(wrong == 0, name + ": unit normals", wrong);
}

/// Points that no triangle has can have no curvature.
void CheckPointsWithoutTriangles(vtkPolyData* output, const std::string& name, Checks& check)
{
  std::vector<unsigned char> hasTriangle(output->GetNumberOfPoints(), 0);
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < output->GetPolys()->GetNumberOfCells(); ++cell)
  {
    output->GetPolys()->GetCellAtId(cell, corners);
    for (vtkIdType i = 0; corners->GetNumberOfIds() == 3 && i < 3; ++i)
    {
      const vtkIdType point = corners->GetId(i);
      if (point >= 0 && point < output->GetNumberOfPoints())
      {
        hasTriangle[point] = 1;
      }
    }
  }
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    check(hasTriangle[i] || GetValue(output, npr::names::UnknownCurvature, i) == 1.0,
      name + ": nothing is known without a triangle", static_cast<double>(i));
  }
}

/// Zeros where there is no curvature, and one warning that says how many.
void CheckUnknown(
  vtkPolyData* output, const Messages& messages, const std::string& name, Checks& check)
{
  int unknown = 0;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    if (GetValue(output, npr::names::UnknownCurvature, i) == 0.0)
    {
      continue;
    }
    ++unknown;
    for (const char* array :
      { npr::names::PrincipalCurvature1, npr::names::PrincipalCurvature2, npr::names::MeanCurvature,
        npr::names::GaussianCurvature, npr::names::ShapeIndex, npr::names::Curvedness })
    {
      check(GetValue(output, array, i) == 0.0, name + ": zero where it is unknown: " + array);
    }
    check(GetTuple<6>(output, npr::names::CurvatureTensor, i).isZero(0.0) &&
        GetTuple<4>(output, npr::names::CurvatureDerivatives, i).isZero(0.0),
      name + ": no tensor where it is unknown");
  }
  check(messages.Errors.empty(), name + ": no error");
  check(messages.Warnings.size() == (unknown > 0 ? 1u : 0u), name + ": warned once",
    static_cast<double>(messages.Warnings.size()));
  check(unknown == 0 ||
      messages.Warnings.front().find(" " + std::to_string(unknown) + " of ") != std::string::npos,
    name + ": the warning counts", unknown);
}

/// Through all filters, with and without the preparation, with the first estimators or every one.
void TestInput(const std::string& input, vtkPolyData* mesh, Checks& check,
  int estimators = vtkNPRCurvatureTensor::GetNumberOfEstimators())
{
  AddNumbers(mesh->GetPointData(), PointNumbers, mesh->GetNumberOfPoints());
  AddNumbers(mesh->GetCellData(), CellNumbers, mesh->GetNumberOfCells());
  for (int estimator = 0; estimator < estimators; ++estimator)
  {
    for (bool isPrepared : { true, false })
    {
      const std::string name = input + ", " + vtkNPRCurvatureTensor::GetEstimatorName(estimator) +
        (isPrepared ? ", prepared" : ", raw");
      Pipeline pipeline(mesh);
      pipeline.Tensor->SetEstimator(estimator);
      pipeline.Tensor->OutputShapeIndexOn();
      pipeline.Tensor->OutputCurvednessOn();
      pipeline.Tensor->OutputPointAreaOn();
      vtkNew<vtkNPRSurfaceRefinement> refinement;
      refinement->SetMaximumNumberOfTriangles(5000);
      refinement->SetInputConnection(pipeline.Tensor->GetOutputPort());
      pipeline.Derivatives->SetInputConnection(refinement->GetOutputPort());
      if (!isPrepared)
      {
        pipeline.Normals->SetInputData(mesh);
      }
      {
        const Messages messages(pipeline.Tensor);
        pipeline.Tensor->Update();
        vtkPolyData* output = pipeline.Tensor->GetOutput();
        CheckFinite(output, name, check);
        CheckUnknown(output, messages, name, check);
        CheckPointsWithoutTriangles(output, name, check);
        // Cells stay as they are: what is no triangle, too.
        check(isPrepared ||
            (output->GetNumberOfCells() == mesh->GetNumberOfCells() &&
              output->GetPointData()->GetArray(PointNumbers)->GetNumberOfTuples() ==
                mesh->GetNumberOfPoints()),
          name + ": cells and points pass");
      }
      pipeline.Normals->SetSmoothingRadius(0.1);
      pipeline.Tensor->SetSmoothingRadius(0.1);
      pipeline.Derivatives->SetSmoothingRadius(0.1);
      vtkObject::GlobalWarningDisplayOff();
      vtkPolyData* output = pipeline.Update();
      vtkObject::GlobalWarningDisplayOn();
      CheckFinite(output, name + ", smooth and refined", check);
    }
  }
}

void TestMissingArrays(Checks& check)
{
  // The curvature without normals makes its own; with bad ones it mends them.
  AnalyticSurface torus = MakeTorus(1.0, 0.4, 32, 16);
  vtkNew<vtkNPRCurvatureTensor> tensor;
  tensor->SetEstimatorToPerFace(); // which takes the normals as they are
  tensor->SetInputData(torus.Mesh);
  tensor->Update();
  const double right = GetValue(tensor->GetOutput(), npr::names::PrincipalCurvature1, 5);
  check(std::abs(right - 2.5) < 0.1, "curvature without given normals", right);

  vtkNew<vtkFloatArray> normals;
  normals->SetName(npr::names::Normals);
  normals->SetNumberOfComponents(3);
  for (const Truth& truth : torus.Truths)
  {
    // Any length will do; one is zero and one is nothing.
    const Vector3d n = 7.0 * truth.Normal;
    normals->InsertNextTuple(n.data());
  }
  normals->SetTuple3(5, NaN, 0, 0);
  normals->SetTuple3(6, 0, 0, 0);
  torus.Mesh->GetPointData()->SetNormals(normals);
  tensor->Update();
  check(std::abs(GetValue(tensor->GetOutput(), npr::names::PrincipalCurvature1, 5) - 2.5) < 0.1,
    "curvature mends bad normals");

  // Of another type, and of sizes that are wrong.
  vtkNew<vtkDoubleArray> doubles;
  doubles->DeepCopy(normals);
  doubles->SetName("Doubles");
  torus.Mesh->GetPointData()->SetNormals(doubles);
  tensor->Update();
  check(std::abs(GetValue(tensor->GetOutput(), npr::names::PrincipalCurvature1, 5) - 2.5) < 0.1,
    "curvature takes normals of double precision");
  CheckFinite(tensor->GetOutput(), "bad normals", check);
  torus.Mesh->GetPointData()->Initialize();
  for (int components : { 2, 3 })
  {
    vtkNew<vtkFloatArray> few;
    few->SetName(npr::names::Normals);
    few->SetNumberOfComponents(components);
    few->SetNumberOfTuples(components == 3 ? 7 : torus.Mesh->GetNumberOfPoints());
    few->Fill(1.0);
    torus.Mesh->GetPointData()->AddArray(few);
    torus.Mesh->Modified();
    tensor->Update();
    check(std::abs(GetValue(tensor->GetOutput(), npr::names::PrincipalCurvature1, 5) - 2.5) < 0.1,
      "curvature does without normals of the wrong size");
    torus.Mesh->GetPointData()->Initialize();
  }
}

vtkSmartPointer<vtkFloatArray> MakeArray(const char* name, int components, vtkIdType tuples)
{
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  array->Fill(1.0);
  return array;
}

/// What vtkNPRCurvatureDerivatives needs may be missing or wrong.
void TestBadTensors(Checks& check)
{
  AnalyticSurface torus = MakeTorus(1.0, 0.4, 32, 16);
  const vtkIdType size = torus.Mesh->GetNumberOfPoints();
  const auto update = [&](vtkNPRCurvatureDerivatives* derivatives, vtkPolyData* surface)
  {
    const Messages messages(derivatives);
    const Messages ofExecutive(derivatives->GetExecutive());
    derivatives->SetInputData(surface);
    derivatives->Update();
    return messages.Errors;
  };
  vtkNew<vtkNPRCurvatureDerivatives> derivatives;
  for (const auto& array :
    { vtkSmartPointer<vtkFloatArray>(), MakeArray(npr::names::CurvatureTensor, 9, size),
      MakeArray(npr::names::CurvatureTensor, 6, 7) })
  {
    vtkNew<vtkPolyData> surface;
    surface->ShallowCopy(torus.Mesh);
    if (array)
    {
      surface->GetPointData()->AddArray(array);
    }
    const std::vector<std::string> errors = update(derivatives, surface);
    check(!errors.empty() && errors.front().find(npr::names::CurvatureTensor) != std::string::npos,
      "without a tensor an error says so", static_cast<double>(errors.size()));
    check(!derivatives->GetOutput()->GetPointData()->HasArray(npr::names::CurvatureDerivatives),
      "no derivatives without a tensor");
  }

  // With a tensor and no directions, or wrong ones, they make their own; what is not finite is
  // none.
  vtkNew<vtkNPRCurvatureTensor> tensor;
  tensor->SetInputData(torus.Mesh);
  tensor->Update();
  vtkNew<vtkPolyData> expected;
  update(derivatives, tensor->GetOutput());
  expected->DeepCopy(derivatives->GetOutput());
  for (vtkIdType tuples : { vtkIdType(-1), vtkIdType(3), size })
  {
    vtkNew<vtkPolyData> surface;
    surface->DeepCopy(tensor->GetOutput());
    surface->GetPointData()->RemoveArray(npr::names::PrincipalDirection1);
    if (tuples >= 0)
    {
      auto directions = MakeArray(npr::names::PrincipalDirection1, 3, tuples);
      directions->Fill(tuples == size ? NaN : 1.0);
      surface->GetPointData()->AddArray(directions);
    }
    check(update(derivatives, surface).empty(), "derivatives from the tensor alone");
    vtkPolyData* output = derivatives->GetOutput();
    CheckFinite(output, "derivatives with directions that are none", check);
    double worst = 0.0;
    for (vtkIdType i = 0; i < size; ++i)
    {
      worst = std::max(worst,
        (GetTuple<4>(output, npr::names::CurvatureDerivatives, i) -
          GetTuple<4>(expected, npr::names::CurvatureDerivatives, i))
          .norm());
    }
    check(worst < 1e-3, "derivatives in frames of their own", worst);
  }
  tensor->GetOutput()
    ->GetPointData()
    ->GetArray(npr::names::CurvatureTensor)
    ->SetTuple6(5, NaN, 0, 0, Infinity, 0, 0);
  tensor->GetOutput()->Modified();
  update(derivatives, tensor->GetOutput());
  vtkDataArray* values =
    derivatives->GetOutput()->GetPointData()->GetArray(npr::names::CurvatureDerivatives);
  check(values && std::isfinite(values->GetMaxNorm()) && !std::isnan(values->GetComponent(5, 0)),
    "derivatives of tensors that are not finite");
}

/// Where the points are, and in what unit, loses no digit; nor how ids and coordinates are stored.
void TestStorage(Checks& check)
{
  struct Case
  {
    double Offset;
    double Scale;
    int PointType;
    bool Is64Bit;
    double Tolerance;
  };
  for (int estimator = 0; estimator < vtkNPRCurvatureTensor::GetNumberOfEstimators(); ++estimator)
  {
    // The first is what the others are compared with.
    std::vector<Vector3d> normals;
    std::vector<npr::SymmetricTensor> tensors;
    double lengthScale = 0.0;
    for (const Case& c :
      { Case{ 0.0, 1.0, VTK_DOUBLE, true, 0.0 }, Case{ 0.0, 1.0, VTK_DOUBLE, false, 0.0 },
        Case{ 0.0, 1.0, VTK_FLOAT, true, 1e-4 }, Case{ 1e8, 1.0, VTK_DOUBLE, true, 1e-3 },
        Case{ 0.0, 1e-9, VTK_DOUBLE, true, 1e-4 }, Case{ 0.0, 1e9, VTK_DOUBLE, false, 1e-4 },
        Case{ 0.0, 1e9, VTK_FLOAT, true, 1e-4 }, Case{ 0.0, 1e-9, VTK_FLOAT, true, 1e-4 } })
    {
      const std::string name = std::string(vtkNPRCurvatureTensor::GetEstimatorName(estimator)) +
        ", offset " + std::to_string(c.Offset) + ", scale " + std::to_string(c.Scale) + ", type " +
        std::to_string(c.PointType) + (c.Is64Bit ? ", 64 bit" : ", 32 bit");
      AnalyticSurface torus = MakeTorus(1.0, 0.4, 64, 32);
      vtkNew<vtkPoints> points;
      points->SetDataType(c.PointType);
      for (const Truth& truth : torus.Truths)
      {
        const Vector3d point = c.Scale * truth.Point + Vector3d::Constant(c.Offset);
        points->InsertNextPoint(point.data());
      }
      torus.Mesh->SetPoints(points);
      check(c.Is64Bit ? torus.Mesh->GetPolys()->ConvertTo64BitStorage()
                      : torus.Mesh->GetPolys()->ConvertTo32BitStorage(),
        name + ": stored so");
      Pipeline pipeline(torus.Mesh);
      pipeline.Preparation->SetWeldTolerance(1e-6);
      pipeline.Tensor->SetEstimator(estimator);
      pipeline.Tensor->Update();
      vtkPolyData* output = pipeline.Tensor->GetOutput();
      if (!check(output->GetNumberOfPoints() == torus.Mesh->GetNumberOfPoints(),
            name + ": nothing is welded", output->GetNumberOfPoints()))
      {
        continue;
      }
      if (tensors.empty())
      {
        lengthScale = npr::GetLengthScale(output);
        for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
        {
          normals.push_back(GetTuple<3>(output, npr::names::Normals, i));
          tensors.emplace_back(GetTuple<6>(output, npr::names::CurvatureTensor, i));
        }
        check(tensors.front().norm() > 2.0, name + ": has curvature", tensors.front().norm());
        continue;
      }
      double worst = 0.0;
      for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
      {
        worst = std::max({ worst, (GetTuple<3>(output, npr::names::Normals, i) - normals[i]).norm(),
          (c.Scale * GetTuple<6>(output, npr::names::CurvatureTensor, i) - tensors[i]).norm() });
      }
      check(worst <= c.Tolerance, name + ": the same curvature", worst);
      check(std::abs(npr::GetLengthScale(output) / c.Scale - lengthScale) < 1e-6 * lengthScale,
        name + ": the same length scale", npr::GetLengthScale(output));
      vtkNew<vtkNPRSurfaceRefinement> refinement;
      refinement->SetInputConnection(pipeline.Tensor->GetOutputPort());
      refinement->SetNumberOfLevels(1);
      refinement->Update();
      check(refinement->GetOutput()->GetPoints()->GetDataType() == c.PointType,
        name + ": refined points are as precise");
      double farthest = 0.0; // from the tube
      for (vtkIdType i = 0; i < refinement->GetOutput()->GetNumberOfPoints(); ++i)
      {
        Vector3d p;
        refinement->GetOutput()->GetPoint(i, p.data());
        p = (p - Vector3d::Constant(c.Offset)) / c.Scale;
        farthest =
          std::max(farthest, std::abs(std::hypot(std::hypot(p.x(), p.y()) - 1.0, p.z()) - 0.4));
      }
      check(farthest < 2e-3, name + ": refined points are on the surface", farthest);
    }
  }
}

/// A point with many triangles: a disc, slightly a cone, and every other triangle a needle.
vtkSmartPointer<vtkPolyData> MakeFan(int size)
{
  std::vector<Vector3d> points{ Vector3d(0, 0, 0.1) };
  std::vector<std::vector<vtkIdType>> cells;
  for (int i = 0; i < size; ++i)
  {
    const double angle = 2.0 * Pi * (i - (i % 2 ? 0.9 : 0.0)) / size;
    points.emplace_back(std::cos(angle), std::sin(angle), 0.0);
    cells.push_back({ 0, i + 1, (i + 1) % size + 1 });
  }
  return Make(points, cells);
}

/// Vertices, lines, triangles, quads, and strips.
vtkSmartPointer<vtkPolyData> MakeAllKinds(bool hasTriangles)
{
  const auto insert = [](vtkCellArray* cells, const std::vector<vtkIdType>& points)
  { cells->InsertNextCell(static_cast<vtkIdType>(points.size()), points.data()); };
  std::vector<Vector3d> points;
  for (int i = 0; i < 16; ++i)
  {
    points.emplace_back(i % 4, i / 4, 0.1 * (i % 3));
  }
  auto mesh = Make(points, {});
  vtkNew<vtkCellArray> vertices;
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkCellArray> strips;
  insert(vertices, { 0 });
  insert(vertices, { 3, 15 });
  insert(lines, { 0, 5, 10 });
  insert(strips, { 8, 12, 9, 13, 10, 14 });
  if (hasTriangles)
  {
    insert(mesh->GetPolys(), { 0, 1, 5 });
    insert(mesh->GetPolys(), { 0, 5, 4 });
  }
  insert(mesh->GetPolys(), { 1, 2, 6, 5 });
  if (hasTriangles)
  {
    insert(mesh->GetPolys(), { 2, 3, 7 });
    insert(mesh->GetPolys(), { 2, 7, 6 });
  }
  insert(mesh->GetPolys(), { 4, 5, 6, 10, 9 });
  mesh->SetVerts(vertices);
  mesh->SetLines(lines);
  mesh->SetStrips(strips);
  return mesh;
}
}

int TestDegenerateSurfaces(int, char*[])
{
  Checks check;
  const Vector3d o = Vector3d::Zero();
  const Vector3d x = Vector3d::UnitX();
  const Vector3d y = Vector3d::UnitY();
  const Vector3d z = Vector3d::UnitZ();
  vtkNew<vtkPolyData> nothing;
  TestInput("nothing", nothing, check);
  TestInput("only points", Make({ o, x, y }, {}), check);
  TestInput("one triangle", Make({ o, x, y }, { { 0, 1, 2 } }), check);
  TestInput("unused points", Make({ z, o, x, y, z }, { { 1, 2, 3 } }), check);
  TestInput(
    "no area", Make({ o, x, 2.0 * x, y }, { { 0, 1, 2 }, { 0, 2, 3 }, { 1, 1, 3 } }), check);
  TestInput("all in one place", Make({ x, x, x, x }, { { 0, 1, 2 }, { 1, 2, 3 } }), check);
  TestInput("points that are no numbers",
    Make({ o, x, y, { NaN, 0, 0 }, { 0, Infinity, 0 } }, { { 0, 1, 2 }, { 1, 2, 3 }, { 0, 2, 4 } }),
    check);
  TestInput("points that do not exist",
    Make({ o, x, y }, { { 0, 1, 2 }, { 0, 1, 99 }, { -1, 1, 2 } }), check);
  TestInput(
    "duplicates", Make({ o, x, y, o, x, y }, { { 0, 1, 2 }, { 3, 4, 5 }, { 5, 4, 3 } }), check);
  TestInput("three sheets at an edge",
    Make({ o, x, y, -y, z }, { { 0, 1, 2 }, { 1, 0, 3 }, { 0, 1, 4 } }), check);
  TestInput("two cones tip to tip",
    Make({ o, x + z, y + z, -x - y + z, x - z, y - z, -x - y - z },
      { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 1 }, { 0, 5, 4 }, { 0, 6, 5 }, { 0, 4, 6 } }),
    check);
  TestInput("a fold", Make({ o, x, y, y }, { { 0, 1, 2 }, { 1, 0, 3 } }), check);
  TestInput("a needle", Make({ o, x, 1e-7 * y + 0.5 * x, y }, { { 0, 2, 1 }, { 0, 1, 3 } }), check);
  TestInput("tiny polygons", Make({ o, x, y, z }, { {}, { 0 }, { 0, 1 }, { 0, 1, 2, 3 } }), check);
  TestInput("all kinds of cells", MakeAllKinds(true), check);
  TestInput("no triangle among the cells", MakeAllKinds(false), check);
  TestInput("against each other",
    Make({ o, x, y, x + y + 0.2 * z, 2.0 * x + y, 2.0 * x + z },
      { { 0, 1, 2 }, { 1, 2, 3 }, { 1, 3, 4 }, { 4, 1, 5 } }),
    check);
  TestInput("thin needles",
    Make({ o, x, 2.0 * x + 1e-5 * y, 3.0 * x + 3e-6 * z, 2.0 * x + y },
      { { 0, 1, 2 }, { 1, 3, 2 }, { 0, 2, 4 }, { 2, 3, 4 } }),
    check);
  TestInput("very large and very small",
    Make(
      { o, 1e15 * x, 1e15 * y, 1e-15 * z, 1e-15 * x }, { { 0, 1, 2 }, { 0, 3, 4 }, { 1, 4, 3 } }),
    check);
  TestInput("two sheets at a point",
    Make({ o, x, y, x + z, y + z, 2.0 * x, 2.0 * y },
      { { 0, 1, 2 }, { 0, 3, 4 }, { 1, 5, 2 }, { 2, 5, 6 } }),
    check);
  TestInput("a large fan", MakeFan(1000), check);
  TestInput("a huge fan", MakeFan(10000), check, vtkNPRCurvatureTensor::PER_FACE + 1);
  const Vector3d away = Vector3d::Constant(1e30);
  TestInput("too far for single precision",
    Make({ away, away + 1e20 * x, 1e30 * y, o }, { { 0, 1, 2 }, { 1, 2, 3 } }), check);
  TestMissingArrays(check);
  TestBadTensors(check);
  TestStorage(check);
  return check.GetResult();
}
