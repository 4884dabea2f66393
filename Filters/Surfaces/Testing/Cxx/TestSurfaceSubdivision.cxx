// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// One step against OpenMesh's own subdividers, many against Loop's limit and a sphere; borders,
// creases and arrays.
#include "nprOpenMesh.h"
#include "nprPointValues.h"
#include "nprRemeshing.h"
#include "vtkNPRSurfaceSubdivision.h"

#include <OpenMesh/Tools/Subdivider/Uniform/LoopT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/ModifiedButterFlyT.hh>

using namespace nprtest;

namespace
{
constexpr int Loop = vtkNPRSurfaceSubdivision::LOOP;
constexpr int Butterfly = vtkNPRSurfaceSubdivision::BUTTERFLY;

vtkSmartPointer<vtkPolyData> Subdivide(vtkPolyData* mesh, int scheme, int times)
{
  vtkNew<vtkNPRSurfaceSubdivision> subdivision;
  subdivision->SetInputData(mesh);
  subdivision->SetScheme(scheme);
  subdivision->SetNumberOfSubdivisions(times);
  subdivision->Update();
  return subdivision->GetOutput();
}

using Mesh = npr::HalfEdgeMesh;

/// The points after one step of OpenMesh's, which numbers midpoints by edges, too.
template<typename Subdivider>
std::vector<Vector3d> GetOracle(vtkPolyData* surface)
{
  Mesh mesh;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    const Vector3d p = GetPoint(surface, i);
    mesh.add_vertex(OpenMesh::Vec3d(p.x(), p.y(), p.z()));
  }
  ForTriangles(surface,
    [&](vtkIdType a, vtkIdType b, vtkIdType c)
    {
      using Vertex = Mesh::VertexHandle;
      mesh.add_face(
        Vertex(static_cast<int>(a)), Vertex(static_cast<int>(b)), Vertex(static_cast<int>(c)));
    });
  Subdivider subdivider;
  subdivider.attach(mesh);
  subdivider(1);
  subdivider.detach();
  std::vector<Vector3d> points;
  for (const auto vertex : mesh.vertices())
  {
    const auto& p = mesh.point(vertex);
    points.emplace_back(p[0], p[1], p[2]);
  }
  return points;
}

void Compare(
  Checks& check, vtkPolyData* result, const std::vector<Vector3d>& oracle, const char* what)
{
  if (!check(result->GetNumberOfPoints() == static_cast<vtkIdType>(oracle.size()), what))
  {
    return;
  }
  double largest = 0.0;
  for (std::size_t i = 0; i < oracle.size(); ++i)
  {
    largest = std::max(largest, (GetPoint(result, static_cast<vtkIdType>(i)) - oracle[i]).norm());
  }
  check(largest < 1e-13, what, largest);
}

void TestOracle(Checks& check)
{
  // Points of the sphere have four neighbours or six; a jittered icosphere-like mix comes from the
  // fan of the can: two points with 30 neighbours, others with four and five.
  vtkSmartPointer<vtkPolyData> sphere = MakeSphere(1.0, 2);
  Shake(sphere, 0.05);
  vtkSmartPointer<vtkPolyData> can = MakeCan(1.0, 2.0, 29);
  vtkSmartPointer<vtkPolyData> open = MakeCylinder(1.0, 2.0, 12, 5).Mesh;
  Shake(open, 0.05);
  for (vtkPolyData* mesh : { sphere.Get(), can.Get(), open.Get() })
  {
    Compare(check, Subdivide(mesh, Loop, 1),
      GetOracle<OpenMesh::Subdivider::Uniform::LoopT<Mesh>>(mesh), "Loop as OpenMesh does it");
    Compare(check, Subdivide(mesh, Butterfly, 1),
      GetOracle<OpenMesh::Subdivider::Uniform::ModifiedButterflyT<Mesh>>(mesh),
      "butterfly as OpenMesh does it");
  }
}

void TestLimits(Checks& check)
{
  vtkSmartPointer<vtkPolyData> sphere = MakeSphere(1.0, 1);
  vtkSmartPointer<vtkPolyData> fine = Subdivide(sphere, Loop, 5);
  check(fine->GetNumberOfCells() == 1024 * sphere->GetNumberOfCells(), "four of each");
  const Topology topology = GetTopology(fine);
  check(topology.Euler == 2 && topology.Borders == 0 && topology.Bad == 0, "still a sphere");
  // Where a point of valence n with weights b to its neighbours goes in the end: those get
  // 1 / (3 / (8 b) + n) each. The points of the octahedron have the valence 4.
  for (vtkIdType i = 0; i < sphere->GetNumberOfPoints(); ++i)
  {
    const Vector3d p = GetPoint(sphere, i);
    Vector3d sum = Vector3d::Zero();
    int neighbours = 0; // each twice, once a triangle
    ForTriangles(sphere,
      [&](vtkIdType a, vtkIdType b, vtkIdType c)
      {
        if (a == i || b == i || c == i)
        {
          sum += GetPoint(sphere, a) + GetPoint(sphere, b) + GetPoint(sphere, c) - p;
          neighbours += 2;
        }
      });
    const double n = neighbours / 2.0;
    const double c = 0.375 + 0.25 * std::cos(2.0 * Pi / n);
    const double b = (0.625 - c * c) / n;
    const double share = 1.0 / (0.375 / b + n);
    const Vector3d limit = (1.0 - n * share) * p + share * 0.5 * sum;
    check((GetPoint(fine, i) - limit).norm() < 2e-3, "Loop's limit",
      (GetPoint(fine, i) - limit).norm());
  }

  sphere = MakeSphere(1.0, 2);
  fine = Subdivide(sphere, Butterfly, 4);
  for (vtkIdType i = 0; i < sphere->GetNumberOfPoints(); ++i)
  {
    check(GetPoint(sphere, i) == GetPoint(fine, i), "the butterfly keeps its points");
  }
  // All points of the torus have six neighbours, where the scheme is of the fourth order.
  const vtkSmartPointer<vtkPolyData> torus = MakeTorus(1.0, 0.4, 36, 18).Mesh;
  fine = Subdivide(torus, Butterfly, 3);
  const auto distance = [](const Vector3d& p)
  { return std::hypot(std::hypot(p.x(), p.y()) - 1.0, p.z()) - 0.4; };
  const double before = GetLargestDistance(torus, distance);
  const double after = GetLargestDistance(fine, distance);
  std::cout << "butterfly: distance to the torus " << before << " -> " << after << "\n";
  check(after < 0.05 * before, "the butterfly comes near a smooth surface", after);
}

void TestArrays(Checks& check)
{
  for (int scheme : { Loop, Butterfly })
  {
    vtkSmartPointer<vtkPolyData> torus = MakeTorus(1.0, 0.4, 12, 7).Mesh;
    Shake(torus, 0.02);
    AddArrays(torus);
    AddShapeArrays(torus);
    const vtkSmartPointer<vtkPolyData> before = Copy(torus);
    vtkSmartPointer<vtkPolyData> fine = Subdivide(torus, scheme, 2);
    check(GetTopology(fine).Euler == 0 && GetTopology(fine).Borders == 0, "still a torus");
    double largest = 0.0;
    for (vtkIdType i = 0; i < fine->GetNumberOfPoints(); ++i)
    {
      largest = std::max(largest, (GetTuple<3>(fine, "Coordinates", i) - GetPoint(fine, i)).norm());
    }
    check(largest < 1e-13, "arrays get the weights of the points", largest);
    auto* names =
      vtkStringArray::SafeDownCast(fine->GetPointData()->GetAbstractArray("PointNames"));
    for (vtkIdType i = 0; i < fine->GetNumberOfPoints(); ++i)
    {
      const int number = static_cast<int>(GetValue(fine, "PointNumbers", i));
      check(number >= 0 && number < torus->GetNumberOfPoints() &&
          (i >= torus->GetNumberOfPoints() || number == i),
        "numbers are not mixed");
      check(names && names->GetValue(i) == "point " + std::to_string(number), "nor are names");
    }
    check(fine->GetPointData()->GetScalars() &&
        std::string(fine->GetPointData()->GetScalars()->GetName()) == "Colours",
      "what is active stays active");
    vtkDataArray* cells = fine->GetCellData()->GetArray("CellNumbers");
    for (vtkIdType i = 0; i < fine->GetNumberOfCells(); ++i)
    {
      check(cells->GetComponent(i, 0) == i / 16, "cell arrays pass to the parts");
    }
    check(!fine->GetPointData()->GetNormals() && !fine->GetPointData()->HasArray("MyNormals") &&
        !fine->GetPointData()->HasArray("Normals2") &&
        !fine->GetPointData()->HasArray(npr::names::PrincipalCurvature1) &&
        !fine->GetFieldData()->HasArray(npr::names::NeighbourhoodRadius),
      "what belongs to the old shape is dropped");
    check(torus->GetPointData()->HasArray("MyNormals") &&
        torus->GetFieldData()->HasArray(npr::names::NeighbourhoodRadius) &&
        GetPoint(torus, 5) == GetPoint(before, 5),
      "the input stays as it is");
  }
}

void TestBordersAndCreases(Checks& check)
{
  for (int scheme : { Loop, Butterfly })
  {
    vtkSmartPointer<vtkPolyData> cylinder = MakeCylinder(1.0, 2.0, 16, 6).Mesh;
    vtkSmartPointer<vtkPolyData> fine = Subdivide(cylinder, scheme, 3);
    const Topology topology = GetTopology(fine);
    check(topology.Euler == 0 && topology.Borders == 2 * 16 * 8, "a cylinder keeps its borders");
    double bounds[6];
    fine->GetPoints()->GetBounds(bounds);
    check(bounds[4] == 0.0 && bounds[5] == 2.0, "borders stay in their planes", bounds[5]);

    // Patches that meet along creases, at corners, and a crease that ends within a patch.
    for (const vtkSmartPointer<vtkPolyData>& solid : { MakeCan(1.0, 2.0, 24), MakeCube() })
    {
      vtkSmartPointer<vtkPolyData> patches = Prepare(solid, true);
      check(patches->GetNumberOfPoints() > solid->GetNumberOfPoints(), "there are creases");
      fine = Subdivide(patches, scheme, 3);
      for (vtkIdType i = 0; i < fine->GetNumberOfPoints(); ++i)
      {
        const auto first = static_cast<vtkIdType>(GetValue(fine, npr::names::WeldedPointIds, i));
        check(first >= 0 && first < fine->GetNumberOfPoints() &&
            GetPoint(fine, i) == GetPoint(fine, first),
          "copies stay together");
      }
      const Topology welded = GetTopology(Prepare(fine, false));
      check(welded.Euler == 2 && welded.Borders == 0 && welded.Bad == 0, "a solid stays watertight",
        welded.Borders);
    }
    fine->GetPoints()->GetBounds(bounds);
    check(bounds[0] == 0.0 && bounds[1] == 1.0, "corners of a cube stay");
    check(std::abs(GetArea(fine) - 6.0) < 1e-12, "and so its faces", GetArea(fine));
  }
}
}

int TestSurfaceSubdivision(int, char*[])
{
  Checks check;
  TestOracle(check);
  TestLimits(check);
  TestArrays(check);
  TestBordersAndCreases(check);
  vtkNew<vtkNPRSurfaceSubdivision> subdivision;
  TestObstacles(check, subdivision);
  subdivision->SetSchemeToButterfly();
  TestObstacles(check, subdivision);
  return check.GetResult();
}
