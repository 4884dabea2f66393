// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRSampleSource.h"

#include "nprArrayNames.h"
#include "nprSnail.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace
{
using Eigen::Vector3d;

constexpr int RelaxationSteps = 6;

// The field on a grid, exact near the surface: a block that the surface can not reach is filled
// with one value, any other is split until it is small.
class Grid
{
public:
  explicit Grid(int resolution);
  vtkImageData* GetImage() const { return this->Image; }

private:
  void Fill(const std::array<int, 3>& first, int blockSize);

  vtkNew<vtkImageData> Image;
  float* Values = nullptr;
  std::array<int, 3> Size;
  double Spacing;
  Vector3d Origin;
};

Grid::Grid(int resolution)
  : Spacing((npr::SnailBounds[1] - npr::SnailBounds[0]) / resolution),
    Origin(npr::SnailBounds[0], npr::SnailBounds[2], npr::SnailBounds[4])
{
  constexpr int blockSize = 16;
  std::array<int, 3> blocks;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double length = npr::SnailBounds[2 * axis + 1] - npr::SnailBounds[2 * axis];
    this->Size[axis] = static_cast<int>(std::ceil(length / this->Spacing)) + 1;
    blocks[axis] = (this->Size[axis] + blockSize - 1) / blockSize;
  }
  this->Image->SetDimensions(this->Size.data());
  this->Image->SetSpacing(this->Spacing, this->Spacing, this->Spacing);
  this->Image->SetOrigin(this->Origin.data());
  this->Image->AllocateScalars(VTK_FLOAT, 1);
  this->Values = static_cast<float*>(this->Image->GetScalarPointer());
  vtkSMPTools::For(0, vtkIdType(blocks[0]) * blocks[1] * blocks[2], 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType block = begin; block < end; ++block)
      {
        this->Fill({ static_cast<int>(block % blocks[0]) * blockSize,
                     static_cast<int>(block / blocks[0] % blocks[1]) * blockSize,
                     static_cast<int>(block / blocks[0] / blocks[1]) * blockSize },
          blockSize);
      }
    });
}

void Grid::Fill(const std::array<int, 3>& first, int blockSize)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (first[axis] >= this->Size[axis])
    {
      return;
    }
  }
  const Vector3d corner = this->Origin + this->Spacing * Vector3d(first[0], first[1], first[2]);
  const double half = 0.5 * (blockSize - 1) * this->Spacing;
  const double atMiddle =
    blockSize > 1 ? npr::SnailField(corner + Vector3d::Constant(half)) : npr::SnailField(corner);
  // One cell more than the block, so that no edge from it to its neighbours crosses the surface.
  const double reach = npr::SnailLipschitz * (half + this->Spacing) * std::sqrt(3.0);
  if (blockSize > 1 && std::abs(atMiddle) < reach)
  {
    const int next = blockSize / 2;
    for (int child = 0; child < 8; ++child)
    {
      this->Fill({ first[0] + (child & 1 ? next : 0), first[1] + (child & 2 ? next : 0),
                   first[2] + (child & 4 ? next : 0) },
        next);
    }
    return;
  }
  for (int k = first[2]; k < std::min(first[2] + blockSize, this->Size[2]); ++k)
  {
    for (int j = first[1]; j < std::min(first[1] + blockSize, this->Size[1]); ++j)
    {
      float* row = this->Values + (vtkIdType(k) * this->Size[1] + j) * this->Size[0];
      // Contours face towards smaller values, so that inside must be positive.
      std::fill(row + first[0], row + std::min(first[0] + blockSize, this->Size[0]),
        static_cast<float>(-atMiddle));
    }
  }
}

// A point of the mesh on its way to its place, and the field's gradient near it.
struct Vertex
{
  Vector3d Position;
  Vector3d Gradient;

  // One of Newton's steps towards the surface.
  void Project(bool isGradientNew)
  {
    const double value = npr::SnailField(this->Position);
    if (isGradientNew)
    {
      constexpr double step = 1e-5;
      for (int axis = 0; axis < 3; ++axis)
      {
        Vector3d beside = this->Position;
        beside[axis] += step;
        this->Gradient[axis] = (npr::SnailField(beside) - value) / step;
      }
    }
    this->Position -= value * this->Gradient / std::max(this->Gradient.squaredNorm(), 0.01);
  }
};

// The points joined to each point.
struct Neighbours
{
  std::vector<vtkIdType> Offsets;
  std::vector<vtkIdType> Points;

  Neighbours(vtkCellArray* triangles, vtkIdType numberOfPoints)
    : Offsets(static_cast<std::size_t>(numberOfPoints) + 1, 0),
      Points(static_cast<std::size_t>(3 * triangles->GetNumberOfCells()))
  {
    // On a closed surface each edge is met once in each direction, so one of the two is enough.
    vtkNew<vtkIdList> cell;
    for (const bool isFilling : { false, true })
    {
      for (vtkIdType t = 0; t < triangles->GetNumberOfCells(); ++t)
      {
        triangles->GetCellAtId(t, cell);
        for (int corner = 0; corner < 3; ++corner)
        {
          const vtkIdType from = cell->GetId(corner);
          if (isFilling)
          {
            this->Points[this->Offsets[from]++] = cell->GetId((corner + 1) % 3);
          }
          else
          {
            ++this->Offsets[from + 1];
          }
        }
      }
      if (!isFilling)
      {
        for (std::size_t i = 1; i < this->Offsets.size(); ++i)
        {
          this->Offsets[i] += this->Offsets[i - 1];
        }
      }
    }
    // Filling has moved each offset to the next one's place.
    this->Offsets.insert(this->Offsets.begin(), 0);
    this->Offsets.pop_back();
  }
};
}

vtkStandardNewMacro(vtkNPRSampleSource);

vtkNPRSampleSource::vtkNPRSampleSource()
{
  this->SetNumberOfInputPorts(0);
}

vtkNPRSampleSource::~vtkNPRSampleSource() = default;

int vtkNPRSampleSource::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(Grid(this->Resolution).GetImage());
  contour->SetValue(0, 0.0);
  contour->ComputeNormalsOff();
  contour->ComputeScalarsOff();
  contour->Update();
  vtkPolyData* raw = contour->GetOutput();
  this->UpdateProgress(0.3);

  const vtkIdType count = raw->GetNumberOfPoints();
  std::vector<Vertex> vertices(static_cast<std::size_t>(count));
  vtkSMPTools::For(0, count,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        raw->GetPoints()->GetPoint(i, vertices[i].Position.data());
        vertices[i].Project(true);
      }
    });
  const Neighbours neighbours(raw->GetPolys(), count);
  std::vector<Vertex> moved(vertices.size());
  for (int step = 0; step < RelaxationSteps; ++step)
  {
    vtkSMPTools::For(0, count,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          Vector3d sum = Vector3d::Zero();
          for (vtkIdType n = neighbours.Offsets[i]; n < neighbours.Offsets[i + 1]; ++n)
          {
            sum += vertices[neighbours.Points[n]].Position;
          }
          const auto valence = neighbours.Offsets[i + 1] - neighbours.Offsets[i];
          const Vector3d normal = vertices[i].Gradient.normalized();
          const Vector3d pull =
            sum / static_cast<double>(std::max<vtkIdType>(valence, 1)) - vertices[i].Position;
          moved[i] = vertices[i];
          moved[i].Position += 0.5 * (pull - normal * normal.dot(pull));
          // The gradient changes little on the way, so it is taken anew once.
          moved[i].Project(step == RelaxationSteps / 2);
        }
      });
    vertices.swap(moved);
    this->UpdateProgress(0.3 + 0.6 * (step + 1) / RelaxationSteps);
  }

  vtkNew<vtkPoints> points;
  points->SetNumberOfPoints(count);
  vtkNew<vtkFloatArray> normals;
  normals->SetName(npr::names::Normals);
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(count);
  vtkNew<vtkFloatArray> distances;
  distances->SetName("DistanceFromApex");
  distances->SetNumberOfValues(count);
  vtkSMPTools::For(0, count,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        vertices[i].Project(true);
        const Vector3d normal = vertices[i].Gradient.normalized();
        points->SetPoint(i, vertices[i].Position.data());
        normals->SetTuple(i, normal.data());
        distances->SetValue(i, static_cast<float>(npr::GetDistanceFromApex(vertices[i].Position)));
      }
    });
  vtkNew<vtkIntArray> parts;
  parts->SetName("RegionId");
  parts->SetNumberOfValues(raw->GetNumberOfPolys());
  vtkSMPTools::For(0, parts->GetNumberOfValues(),
    [&](vtkIdType begin, vtkIdType end)
    {
      vtkNew<vtkIdList> corners;
      for (vtkIdType t = begin; t < end; ++t)
      {
        raw->GetPolys()->GetCellAtId(t, corners);
        Vector3d sum = Vector3d::Zero();
        for (const vtkIdType corner : *corners)
        {
          sum += vertices[corner].Position;
        }
        parts->SetValue(t, static_cast<int>(npr::FindSnailPart(sum / 3.0)));
      }
    });
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  output->SetPoints(points);
  output->SetPolys(raw->GetPolys());
  output->GetPointData()->SetNormals(normals);
  output->GetPointData()->AddArray(distances);
  output->GetCellData()->AddArray(parts);
  this->UpdateProgress(1.0);
  return 1;
}

void vtkNPRSampleSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Resolution: " << this->Resolution << "\n";
}
