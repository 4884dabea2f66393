// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// What must not matter: threads and what runs them, the order of points and triangles, the place,
// the turn and the unit of the coordinates.
#include "nprBumpyRing.h"
#include "nprSegmentMatching.h"

#include "vtkNPRLineDefinition.h"

#include <vtkSMPTools.h>

#include <numeric>
#include <random>
#include <string>

using namespace nprtest;

namespace
{
const std::vector<const char*> AllLines = { "contours", "suggestive", "ridges", "valleys",
  "creases", "boundaries" };

// Their curvature is summed up around each point, so its last digits depend on the order there.
const std::vector<const char*> SummedLines = { "parabolic", "mean-curvature" };

// A bumpy ring with a hole cut into it, and all arrays that lines need.
vtkSmartPointer<vtkPolyData> MakeRing()
{
  return MakeBumpyRing(150, 60, true,
    [](double u, double v)
    { return 1.0 + 0.15 * std::sin(5.0 * u + 0.3) * std::sin(3.0 * v + 0.2); });
}

vtkSmartPointer<vtkPolyData> ExtractFrom(vtkPolyData* surface,
  const std::vector<const char*>& names, vtkCamera* camera, double lengthScale = 0.0)
{
  vtkNew<vtkNPRFeatureLines> lines;
  for (const char* name : names)
  {
    vtkNPRLineDefinition* const definition = lines->AddDefinition(name);
    definition->SetParameter("angle", 9.0); // creases: the ring has none that are sharper
    definition->SetParameter("region", 0.01);
  }
  lines->SetCamera(camera);
  lines->SetLengthScale(lengthScale);
  lines->SetInputData(surface);
  lines->Update();
  return lines->GetOutput();
}

//------------------------------------------------------------------------------
// All bytes of the output.
std::string GetBytes(vtkPolyData* lines)
{
  std::string bytes;
  const auto add = [&bytes](vtkDataArray* array)
  {
    bytes.append(static_cast<const char*>(array->GetVoidPointer(0)),
      array->GetNumberOfValues() * array->GetDataTypeSize());
  };
  add(lines->GetPoints()->GetData());
  add(lines->GetLines()->GetOffsetsArray());
  add(lines->GetLines()->GetConnectivityArray());
  for (vtkFieldData* data : { static_cast<vtkFieldData*>(lines->GetPointData()),
         static_cast<vtkFieldData*>(lines->GetCellData()) })
  {
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      add(data->GetArray(i));
    }
  }
  return bytes;
}

void TestThreads(vtkPolyData* surface, vtkCamera* camera, Checks& check)
{
  std::string first;
  // TBB first: once held to one thread, it would not take two again.
  const std::vector<std::pair<const char*, int>> ways = { { "TBB", 2 }, { "Sequential", 1 },
    { "STDThread", 1 }, { "STDThread", 2 }, { "STDThread", 5 } };
  for (const auto& [backend, threads] : ways)
  {
    vtkSMPTools::SetBackend(backend);
    vtkSMPTools::Initialize(threads);
    const std::string bytes = GetBytes(ExtractFrom(surface, AllLines, camera)) +
      GetBytes(ExtractFrom(surface, SummedLines, camera));
    first = first.empty() ? bytes : first;
    check(bytes == first, backend, threads);
  }
  const auto chains = GetChains(ExtractFrom(surface, AllLines, camera));
  CheckSound(chains, check);
  for (int type = 0; type < static_cast<int>(AllLines.size()); ++type)
  {
    check(std::any_of(chains.begin(), chains.end(),
            [type](const Chain& chain) { return chain.Type == type; }),
      "there are lines of all kinds", type);
  }
}

//------------------------------------------------------------------------------
// The same with its points and triangles in another order, and other corners first.
vtkSmartPointer<vtkPolyData> Shuffle(vtkPolyData* surface, unsigned int seed)
{
  std::mt19937 random(seed);
  std::vector<vtkIdType> newId(surface->GetNumberOfPoints());
  std::iota(newId.begin(), newId.end(), 0);
  std::shuffle(newId.begin(), newId.end(), random);
  std::vector<vtkIdType> order(surface->GetNumberOfPolys());
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), random);

  auto shuffled = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(surface->GetNumberOfPoints());
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    points->SetPoint(newId[i], surface->GetPoint(i));
  }
  shuffled->SetPoints(points);
  for (int a = 0; a < surface->GetPointData()->GetNumberOfArrays(); ++a)
  {
    vtkDataArray* const array = surface->GetPointData()->GetArray(a);
    auto copy = AddArray(shuffled, array->GetName(), array->GetNumberOfComponents());
    for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
    {
      copy->SetTuple(newId[i], array->GetTuple(i));
    }
  }
  vtkNew<vtkCellArray> triangles;
  vtkNew<vtkIdList> ids;
  for (const vtkIdType t : order)
  {
    surface->GetPolys()->GetCellAtId(t, ids);
    const vtkIdType turn = t % 3;
    triangles->InsertNextCell({ newId[ids->GetId(turn)], newId[ids->GetId((turn + 1) % 3)],
      newId[ids->GetId((turn + 2) % 3)] });
  }
  shuffled->SetPolys(triangles);
  return shuffled;
}

void TestOrder(vtkPolyData* surface, vtkCamera* camera, Checks& check)
{
  for (const unsigned int seed : { 7u, 8u })
  {
    const auto shuffled = Shuffle(surface, seed);
    for (const char* name : AllLines)
    {
      // The length scale is a sum over the triangles, so its last digit depends on their order.
      const auto before = GetChains(ExtractFrom(surface, { name }, camera, 1.0));
      const auto after = GetChains(ExtractFrom(shuffled, { name }, camera, 1.0));
      check(GetSegments(before) == GetSegments(after),
        (std::string("the order does not matter to ") + name).c_str(), double(after.size()));
      check(GetForms(before) == GetForms(after),
        (std::string("nor to the chains of ") + name).c_str(), double(after.size()));
    }
    for (const char* name : SummedLines)
    {
      const auto before = GetChains(ExtractFrom(surface, { name }, camera, 1.0));
      const auto after = GetChains(ExtractFrom(shuffled, { name }, camera, 1.0));
      check(!before.empty() && before.size() == after.size(),
        (std::string("the order does not matter to the chains of ") + name).c_str(),
        double(after.size()));
      const std::size_t unmatched = CountUnmatched(GetSegments(before), GetSegments(after), 1.0e-5);
      check(unmatched == 0, (std::string("nor, but for rounding, to ") + name).c_str(),
        double(unmatched));
    }
  }
}

//------------------------------------------------------------------------------
// p becomes Scale * Turn * p + Shift.
struct Motion
{
  Eigen::Matrix3d Turn = Eigen::Matrix3d::Identity();
  double Scale = 1.0;
  Vector Shift = Vector::Zero();

  Vector operator()(const Vector& p) const { return this->Scale * (this->Turn * p) + this->Shift; }

  vtkSmartPointer<vtkCamera> Move(vtkCamera* camera) const
  {
    auto moved = vtkSmartPointer<vtkCamera>::New();
    moved->DeepCopy(camera);
    moved->SetPosition((*this)(Vector(camera->GetPosition())).data());
    moved->SetFocalPoint((*this)(Vector(camera->GetFocalPoint())).data());
    moved->SetViewUp(Vector(this->Turn * Vector(camera->GetViewUp())).data());
    return moved;
  }

  vtkSmartPointer<vtkPolyData> Move(vtkPolyData* surface) const
  {
    auto moved = vtkSmartPointer<vtkPolyData>::New();
    moved->DeepCopy(surface);
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(surface->GetNumberOfPoints());
    for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
    {
      points->SetPoint(i, (*this)(Vector(surface->GetPoint(i))).data());
    }
    moved->SetPoints(points);
    for (const char* name :
      { npr::names::Normals, npr::names::PrincipalDirection1, npr::names::PrincipalDirection2 })
    {
      this->ForTuples<3>(moved, name, [this](const Vector& t) { return Vector(this->Turn * t); });
    }
    for (const char* name : { npr::names::PrincipalCurvature1, npr::names::PrincipalCurvature2 })
    {
      this->ForTuples<1>(moved, name, [this](const auto& t) { return (t / this->Scale).eval(); });
    }
    this->ForTuples<4>(moved, npr::names::CurvatureDerivatives,
      [this](const auto& t) { return (t / (this->Scale * this->Scale)).eval(); });
    this->ForTuples<6>(moved, npr::names::CurvatureTensor,
      [this](const auto& t)
      {
        Eigen::Matrix3d tensor;
        tensor << t[0], t[3], t[5], t[3], t[1], t[4], t[5], t[4], t[2];
        tensor = (this->Turn * tensor * this->Turn.transpose() / this->Scale).eval();
        Eigen::Matrix<double, 6, 1> result;
        result << tensor(0, 0), tensor(1, 1), tensor(2, 2), tensor(0, 1), tensor(1, 2),
          tensor(0, 2);
        return result;
      });
    return moved;
  }

private:
  template<int Size, typename Change>
  static void ForTuples(vtkPolyData* surface, const char* name, const Change& change)
  {
    vtkDataArray* const array = surface->GetPointData()->GetArray(name);
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      Eigen::Matrix<double, Size, 1> tuple;
      array->GetTuple(i, tuple.data());
      tuple = change(tuple);
      array->SetTuple(i, tuple.data());
    }
  }
};

std::vector<Segment> Move(const std::vector<Segment>& segments, const Motion& motion)
{
  std::vector<Segment> moved;
  for (const Segment& s : segments)
  {
    const Vector a = motion(Vector(s[0], s[1], s[2]));
    const Vector b = motion(Vector(s[3], s[4], s[5]));
    moved.push_back({ a[0], a[1], a[2], b[0], b[1], b[2] });
  }
  return moved;
}

void TestMotion(const Motion& motion, double tolerance, vtkPolyData* surface, vtkCamera* camera,
  const char* what, Checks& check)
{
  const auto moved = motion.Move(surface);
  const auto movedCamera = motion.Move(camera);
  for (const char* name : AllLines)
  {
    const auto before = GetChains(ExtractFrom(surface, { name }, camera));
    const auto after = GetChains(ExtractFrom(moved, { name }, movedCamera));
    const auto text = std::string(what) + " does not matter to " + name;
    check(GetForms(before) == GetForms(after), (text + ": chains").c_str(), double(after.size()));
    const std::vector<Segment> expected = Move(GetSegments(before), motion);
    const std::size_t unmatched = CountUnmatched(expected, GetSegments(after), tolerance);
    check(unmatched == 0, (text + ": places").c_str(), double(unmatched));
  }
}

void TestMotions(vtkPolyData* surface, vtkCamera* camera, Checks& check)
{
  for (const double scale : { 1.0 / 1048576.0, 4096.0 })
  {
    Motion motion;
    motion.Scale = scale;
    TestMotion(motion, 0.0, surface, camera, "a scale by a power of two", check);
  }
  for (const double scale : { 1.0e-3, 1.0, 1.0e3 })
  {
    Motion motion;
    motion.Scale = scale;
    motion.Turn =
      Eigen::AngleAxisd(0.7 + scale, Vector(1.0, 2.0, -0.5).normalized()).toRotationMatrix();
    motion.Shift = scale * Vector(3.0, -7.0, 2.0);
    // Where the field is nearly flat along an edge, its zero shifts more than the coordinates.
    TestMotion(motion, 1.0e-4 * scale, surface, camera, "a motion", check);
  }
}
}

int TestLinesInvariance(int, char*[])
{
  Checks check;
  const auto surface = MakeRing();
  TestThreads(surface, MakeCamera({ 3.1, 1.2, 3.3 }), check);
  for (const bool parallel : { false, true })
  {
    const auto camera = MakeCamera({ 3.1, 1.2, 3.3 }, parallel);
    TestOrder(surface, camera, check);
    TestMotions(surface, camera, check);
  }
  return check.GetResult();
}
