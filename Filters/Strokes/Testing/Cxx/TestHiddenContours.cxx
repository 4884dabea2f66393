// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Contours are neither hidden by their own surface nor shine through it: against the formula of a
// torus, against brute force, and with any number of threads.
#include "nprHiddenStrokes.h"

#include "nprAnalyticSurfaces.h"
#include "nprVisibilityOracle.h"
#include "vtkNPRCurvatureTensor.h"
#include "vtkNPRFeatureLines.h"
#include "vtkNPRSurfacePreparation.h"

#include <vtkFloatArray.h>
#include <vtkMatrix4x4.h>
#include <vtkSMPTools.h>

using namespace nprtest;

namespace
{
Checks check;
constexpr double Radius = 1.0;
constexpr double Tube = 0.4;

/// A torus around z with its true normals, and if wanted bumps on its tube and normals estimated.
Data MakeRing(int columns, double bumps)
{
  auto ring = MakeTorus(Radius, Tube, columns, columns / 2);
  if (bumps == 0.0)
  {
    vtkNew<vtkFloatArray> normals;
    normals->SetName(npr::names::Normals);
    normals->SetNumberOfComponents(3);
    for (const Truth& truth : ring.Truths)
    {
      normals->InsertNextTuple(truth.Normal.data());
    }
    ring.Mesh->GetPointData()->AddArray(normals);
    return ring.Mesh;
  }
  for (vtkIdType i = 0; i < ring.Mesh->GetNumberOfPoints(); ++i)
  {
    const Truth& truth = ring.Truths[i];
    const double bump = bumps * std::sin(9.0 * truth.Point.x()) * std::sin(11.0 * truth.Point.y()) *
      std::cos(8.0 * truth.Point.z());
    const Vector3d point = truth.Point + bump * truth.Normal;
    ring.Mesh->GetPoints()->SetPoint(i, point.data());
  }
  vtkNew<vtkNPRCurvatureTensor> tensor;
  tensor->SetInputData(ring.Mesh);
  tensor->Update();
  return tensor->GetOutput();
}

Data MakeContours(vtkPolyData* surface, vtkCamera* camera, const std::vector<const char*>& names)
{
  vtkNew<vtkNPRFeatureLines> lines;
  lines->SetInputData(surface);
  lines->SetCamera(camera);
  for (const char* name : names)
  {
    lines->AddDefinition(name);
  }
  lines->Update();
  return lines->GetOutput();
}

/// How deep inside of the torus the way from a point to the eye comes.
double GetDepthInTorus(const Vector3d& point, const Vector3d& toEye)
{
  double deepest = 0.0;
  for (double t = 0.0; t < 4.0; t += 0.005)
  {
    const Vector3d p = point + t * toEye;
    deepest = std::max(deepest, Tube - std::hypot(std::hypot(p.x(), p.y()) - Radius, p.z()));
  }
  return deepest;
}

/// The share of the contours' length that is wrong, and whether there are cusps at all.
void TestTorus()
{
  const Vector3d eye = Vector3d(0.0, -8.0, 4.0);
  const auto camera = MakeCamera(eye);
  double most = 0.01; // cusps are no better known than by the length of a piece
  for (const int columns : { 40, 80, 160 })
  {
    const Data ring = MakeRing(columns, 0.0);
    const Parts parts =
      GetParts(MakeFilter(MakeContours(ring, camera, { "contours" }), { ring }, camera));
    double all = 0.0;
    double hidden = 0.0;
    double wrong = 0.0;
    for (const Part& part : parts)
    {
      for (std::size_t i = 1; i < part.Line.size(); ++i)
      {
        const double length = (part.Line[i] - part.Line[i - 1]).norm();
        const Vector3d middle = 0.5 * (part.Line[i] + part.Line[i - 1]);
        // Onto the true torus. A contour that is not hidden touches it: that is not yet inside.
        const Vector3d core = Radius * Vector3d(middle.x(), middle.y(), 0.0).normalized();
        const Vector3d place = core + Tube * (middle - core).normalized();
        const double touching = 0.2 * Tube * std::pow(Pi / columns, 2);
        const bool isHidden = GetDepthInTorus(place, eye.normalized()) > touching;
        all += length;
        hidden += part.Layers > 0 ? length : 0.0;
        wrong += (part.Layers > 0) != isHidden ? length : 0.0;
      }
    }
    check(
      hidden > 0.1 * all && hidden < 0.5 * all, "a torus hides some of its contours", hidden / all);
    check(wrong < most * all, "contours of a torus that are wrong", wrong / all);
    std::cout << columns << " columns: " << 100.0 * wrong / all << " % wrong\n";
    most *= 0.6;
  }
}

/// In a mirror as much is hidden: there contours have the front on their right.
void TestMirror()
{
  const Vector3d eye = Vector3d(0.0, -8.0, 4.0);
  const auto camera = MakeCamera(eye);
  const Data ring = MakeRing(80, 0.0);
  const Data contours = MakeContours(ring, camera, { "contours" });
  const auto getHiddenLength = [](const Parts& parts)
  {
    double hidden = 0.0;
    for (const Part& part : parts)
    {
      hidden += part.Layers > 0 ? part.GetLength() : 0.0;
    }
    return hidden;
  };
  const double hidden = getHiddenLength(GetParts(MakeFilter(contours, { ring }, camera)));
  vtkNew<vtkMatrix4x4> mirror;
  mirror->SetElement(0, 0, -1.0);
  const auto filter = MakeFilter(contours, { ring }, camera);
  filter->SetStrokeMatrix(mirror);
  filter->SetSurfaceMatrix(0, mirror);
  const double mirrored = getHiddenLength(GetParts(filter));
  check(std::abs(mirrored - hidden) < 1e-3 * hidden, "a mirror hides as much", mirrored / hidden);
}

/// A bent sheet, whose front is its hollow side, hides nothing of its own contour.
void TestSheet()
{
  constexpr int Steps = 40;
  Points corners;
  std::vector<std::vector<vtkIdType>> cells;
  vtkNew<vtkFloatArray> normals;
  normals->SetName(npr::names::Normals);
  normals->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i <= Steps; ++i)
  {
    const double angle = Pi * (0.1 + 0.8 * i / Steps);
    for (double z : { -1.0, 0.0, 1.0 })
    {
      corners.emplace_back(std::cos(angle), std::sin(angle), z);
      normals->InsertNextTuple3(-std::cos(angle), -std::sin(angle), 0.0);
    }
    for (vtkIdType c = 3 * i; i < Steps && c < 3 * i + 2; ++c)
    {
      cells.push_back({ c, c + 1, c + 4 });
      cells.push_back({ c, c + 4, c + 3 });
    }
  }
  const Data sheet = MakePolygons(corners, cells);
  sheet->GetPointData()->AddArray(normals);
  for (const double height : { 0.1, 1.0, 2.0 })
  {
    const auto camera = MakeCamera({ 8.0, height, 0.3 }, false);
    const Parts parts =
      GetParts(MakeFilter(MakeContours(sheet, camera, { "contours" }), { sheet }, camera));
    double visible = 0.0;
    double hidden = 0.0;
    for (const Part& part : parts)
    {
      // Not those along the border.
      if (std::abs(part.Line.front().z() - part.Line.back().z()) > 0.99 * part.GetLength())
      {
        (part.Layers > 0 ? hidden : visible) += part.GetLength();
      }
    }
    check(hidden == 0.0 && visible > 1.99, "a bent sheet does not hide its contour", hidden);
  }
}

/// Where nothing is in front of it, no piece of a contour is hidden, however coarse the mesh.
void TestConvex()
{
  for (const int level : { 1, 2, 3, 5 })
  {
    vtkNew<vtkNPRSurfacePreparation> weld;
    weld->SetInputData(MakeOctasphere(1.0, level));
    weld->SetSplitCreases(false);
    vtkNew<vtkNPRCurvatureTensor> tensor;
    tensor->SetInputConnection(weld->GetOutputPort());
    tensor->Update();
    for (const Vector3d& eye : { Vector3d(9.0, 1.0, 2.0), Vector3d(8.0, -3.0, 5.0) })
    {
      const auto camera = MakeCamera(eye, false);
      const Parts parts =
        GetParts(MakeFilter(MakeContours(tensor->GetOutput(), camera, { "contours" }),
          { tensor->GetOutput() }, camera));
      for (const Part& part : parts)
      {
        check(part.Layers == 0, "contours of something convex are visible", part.GetLength());
      }
    }
  }
}

/// A closed disc with a sharp rim, convex, whose two sides meet the plane of the rim at angles.
Data MakeLens(double above, double below, int rings, int sectors)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  for (const double rise : { std::tan(above), -std::tan(below) })
  {
    const vtkIdType first = points->GetNumberOfPoints();
    for (int ring = 0; ring <= rings; ++ring)
    {
      for (int sector = 0; sector < sectors; ++sector)
      {
        const double r = 1.0 - static_cast<double>(ring) / rings;
        const double angle = 2.0 * Pi * sector / sectors;
        points->InsertNextPoint(
          r * std::cos(angle), r * std::sin(angle), 0.5 * rise * (1.0 - r * r));
        const vtkIdType here = first + ring * sectors + sector;
        const vtkIdType next = first + ring * sectors + (sector + 1) % sectors;
        if (ring < rings)
        {
          cells->InsertNextCell(
            { here, rise > 0.0 ? next : here + sectors, rise > 0.0 ? here + sectors : next });
        }
        if (ring + 1 < rings)
        {
          cells->InsertNextCell({ next, rise > 0.0 ? next + sectors : here + sectors,
            rise > 0.0 ? here + sectors : next + sectors });
        }
      }
    }
  }
  const auto lens = Data::New();
  lens->SetPoints(points);
  lens->SetPolys(cells);
  return lens;
}

/// The contour leaves the rim for the side that turns away just there. That side is hidden by the
/// other, but not the contour, where it is next to the rim.
void TestRim()
{
  constexpr double degree = Pi / 180.0;
  struct Mesh
  {
    int Sectors;
    int Rings;
    double MostHidden; // in all views together, as a length on a lens of radius 1
  };
  for (const Mesh& mesh : { Mesh{ 48, 8, 0.3 }, Mesh{ 96, 8, 0.15 }, Mesh{ 96, 16, 0.09 } })
  {
    vtkNew<vtkNPRSurfacePreparation> prepare;
    prepare->SetInputData(MakeLens(60.0 * degree, 17.0 * degree, mesh.Rings, mesh.Sectors));
    vtkNew<vtkNPRCurvatureTensor> tensor;
    tensor->SetInputConnection(prepare->GetOutputPort());
    tensor->Update();
    double hidden = 0.0;
    for (double elevation = 8.0; elevation <= 20.0; elevation += 0.5)
    {
      const Vector3d eye(std::cos(elevation * degree), 0.08, -std::sin(elevation * degree));
      const auto camera = MakeCamera(9.0 * eye, false);
      const Parts parts =
        GetParts(MakeFilter(MakeContours(tensor->GetOutput(), camera, { "contours" }),
          { tensor->GetOutput() }, camera));
      for (const Part& part : parts)
      {
        hidden += part.Layers > 0 ? part.GetLength() : 0.0;
      }
    }
    check(hidden < mesh.MostHidden, "contours beside a sharp rim are visible", hidden);
  }
}

void TestAgainstOracle()
{
  const Data ring = MakeRing(160, 0.12);
  VisibilityOracle oracle;
  oracle.AddSurface(ring, Eigen::Matrix4d::Identity());
  oracle.Prepare();
  for (const bool parallel : { true, false })
  {
    const auto camera = MakeCamera({ 1.0, -8.0, 3.0 }, parallel);
    const Data strokes = MakeContours(ring, camera, { "contours", "suggestive", "ridges" });
    const auto filter = MakeFilter(strokes, { ring }, camera);
    filter->SetMinimumLength(0.0);
    filter->Update();
    vtkPolyData* const output = filter->GetOutput();
    oracle.SetView(camera, filter->GetViewportHeight());
    vtkDataArray* const layers = output->GetCellData()->GetArray(npr::names::HidingLayers);
    vtkDataArray* const normals = output->GetPointData()->GetArray(npr::names::Normals);
    const auto getNormal = [normals](vtkIdType id)
    { return Vector3d(Eigen::Map<const Vector3d>(normals->GetTuple3(id))); };
    double all = 0.0;
    double wrong = 0.0;
    double wrongLayers = 0.0;
    vtkNew<vtkIdList> ids;
    for (vtkIdType line = 0; line < output->GetNumberOfLines(); ++line)
    {
      output->GetLines()->GetCellAtId(line, ids);
      for (vtkIdType i = 1; i < ids->GetNumberOfIds(); ++i)
      {
        const Vector3d from(output->GetPoint(ids->GetId(i - 1)));
        const Vector3d to(output->GetPoint(ids->GetId(i)));
        const Vector3d normalFrom = getNormal(ids->GetId(i - 1));
        const Vector3d normalTo = getNormal(ids->GetId(i));
        for (const double t : { 0.13, 0.37, 0.62, 0.88 })
        {
          const int truth = oracle.CountLayers(
            from + t * (to - from), normalFrom + t * (normalTo - normalFrom), to - from);
          const auto label = static_cast<int>(layers->GetComponent(line, 0));
          all += (to - from).norm();
          wrong += (truth > 0) != (label > 0) ? (to - from).norm() : 0.0;
          wrongLayers += truth != label ? (to - from).norm() : 0.0;
        }
      }
    }
    check(wrong < 0.005 * all, "what brute force sees otherwise", wrong / all);
    check(wrongLayers < 0.01 * all, "other numbers of layers by brute force", wrongLayers / all);
    std::cout << 100.0 * wrong / all << " % wrong, layers " << 100.0 * wrongLayers / all << " %\n";
  }
}

bool AreAlike(vtkDataSetAttributes* a, vtkDataSetAttributes* b)
{
  bool areAlike = a->GetNumberOfArrays() == b->GetNumberOfArrays();
  for (int i = 0; areAlike && i < a->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* const one = a->GetArray(i);
    vtkDataArray* const other = b->GetArray(i);
    areAlike = one->GetNumberOfValues() == other->GetNumberOfValues();
    for (vtkIdType v = 0; areAlike && v < one->GetNumberOfValues(); ++v)
    {
      areAlike = one->GetVariantValue(v) == other->GetVariantValue(v);
    }
  }
  return areAlike;
}

void TestThreads()
{
  const std::string backend = vtkSMPTools::GetBackend();
  const Data ring = MakeRing(160, 0.12);
  const auto camera = MakeCamera({ 1.0, -8.0, 3.0 }, false);
  const Data strokes = MakeContours(ring, camera, { "contours", "suggestive", "ridges" });
  Filter first;
  for (const int threads : { 1, 2, 7 })
  {
    vtkSMPTools::SetBackend(threads == 1 ? "Sequential" : "STDThread");
    vtkSMPTools::Initialize(threads);
    const auto filter = MakeFilter(strokes, { ring }, camera);
    filter->Update();
    if (!first)
    {
      first = filter;
      continue;
    }
    vtkPolyData* const one = first->GetOutput();
    vtkPolyData* const other = filter->GetOutput();
    bool areAlike = one->GetNumberOfPoints() == other->GetNumberOfPoints() &&
      one->GetNumberOfLines() == other->GetNumberOfLines() && one->GetNumberOfLines() > 100;
    for (vtkIdType i = 0; areAlike && i < one->GetNumberOfPoints(); ++i)
    {
      areAlike = Vector3d(one->GetPoint(i)) == Vector3d(other->GetPoint(i));
    }
    check(areAlike && AreAlike(one->GetPointData(), other->GetPointData()) &&
        AreAlike(one->GetCellData(), other->GetCellData()),
      "the same with any number of threads", threads);
  }
  vtkSMPTools::SetBackend(backend.c_str());
  vtkSMPTools::Initialize();

  // A new view leaves what no view changes.
  const double before = first->GetStageSeconds(vtkNPRStrokeVisibility::PREPARE);
  camera->Azimuth(10.0);
  first->Update();
  const double after = first->GetStageSeconds(vtkNPRStrokeVisibility::PREPARE);
  check(after < 0.1 * before, "surfaces are prepared once", after / before);
}
}

int TestHiddenContours(int, char*[])
{
  TestTorus();
  TestMirror();
  TestSheet();
  TestConvex();
  TestRim();
  TestAgainstOracle();
  TestThreads();
  return check.GetResult();
}
