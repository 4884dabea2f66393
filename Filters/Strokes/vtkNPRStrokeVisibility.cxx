// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRStrokeVisibility.h"

#include "nprArrayNames.h"
#include "nprHidingEdges.h"
#include "nprHidingSurfaces.h"
#include "nprImageProjection.h"
#include "nprProgress.h"
#include "nprRayTracer.h"
#include "nprStrokePartsOutput.h"
#include "nprStrokeSplitter.h"

#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSMPThreadLocal.h>
#include <vtkSMPTools.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkTrivialProducer.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <chrono>
#include <vector>

vtkStandardNewMacro(vtkNPRStrokeVisibility);
vtkCxxSetSmartPointerMacro(vtkNPRStrokeVisibility, Camera, vtkCamera);
vtkCxxSetSmartPointerMacro(vtkNPRStrokeVisibility, StrokeMatrix, vtkMatrix4x4);

namespace
{
constexpr int StrokePort = 0;
constexpr int SurfacePort = 1;

Eigen::Matrix4d GetToWorld(vtkMatrix4x4* matrix)
{
  Eigen::Matrix4d result = Eigen::Matrix4d::Identity();
  if (matrix)
  {
    result = Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(matrix->GetData());
  }
  return result;
}

/// The strokes relative to a centre of the world.
class WorldStrokes
{
public:
  WorldStrokes(vtkPolyData* strokes, const Eigen::Matrix4d& toWorld, const Eigen::Vector3d& centre)
    : Points(strokes->GetPoints()), Linear(toWorld.topLeftCorner<3, 3>()),
      Offset(toWorld.topRightCorner<3, 1>() - centre)
  {
    vtkDataArray* const normals = strokes->GetPointData()->GetArray(npr::names::Normals);
    const Eigen::Matrix3d turn = this->Linear.inverse().transpose();
    if (normals && normals->GetNumberOfComponents() == 3 && turn.allFinite())
    {
      this->Normals = normals;
      this->NormalsToWorld = turn;
    }
  }

  Eigen::Vector3d GetPoint(vtkIdType id) const
  {
    Eigen::Vector3d point;
    this->Points->GetPoint(id, point.data());
    return this->Linear * point + this->Offset;
  }
  void Read(vtkIdList* ids, std::vector<Eigen::Vector3d>& points,
    std::vector<Eigen::Vector3d>& normals) const
  {
    points.clear();
    normals.clear();
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      points.push_back(this->GetPoint(ids->GetId(i)));
      if (this->Normals)
      {
        Eigen::Vector3d normal;
        this->Normals->GetTuple(ids->GetId(i), normal.data());
        normals.push_back(this->NormalsToWorld * normal);
      }
    }
  }
  vtkPoints* GetPoints() const { return this->Points; }
  bool IsMirrored() const { return this->Linear.determinant() < 0.0; }

  /// Where the strokes are in the image, no farther from its middle than cuts matter.
  Eigen::AlignedBox2d GetBounds(const npr::ImageProjection& projection, double most) const
  {
    struct Local
    {
      Eigen::AlignedBox2d Box;
      bool IsBehind = false;
    };
    vtkSMPThreadLocal<Local> locals;
    vtkSMPTools::For(0, this->Points->GetNumberOfPoints(),
      [&](vtkIdType begin, vtkIdType end)
      {
        Local& local = locals.Local();
        for (vtkIdType i = begin; i < end; ++i)
        {
          const Eigen::Vector3d point = this->GetPoint(i);
          const npr::ImageProjection::Place place = projection.Project(point);
          if (projection.IsInFront(place.Depth) && place.Pixel.allFinite())
          {
            local.Box.extend(place.Pixel);
          }
          else
          {
            local.IsBehind = true;
          }
        }
      });
    const Eigen::AlignedBox2d all(Eigen::Vector2d(-most, -most), Eigen::Vector2d(most, most));
    Eigen::AlignedBox2d box;
    bool isBehind = false;
    for (const Local& local : locals)
    {
      box.extend(local.Box);
      isBehind = isBehind || local.IsBehind;
    }
    return isBehind ? all : box.intersection(all);
  }

private:
  vtkPoints* Points;
  Eigen::Matrix3d Linear;
  Eigen::Vector3d Offset;
  vtkDataArray* Normals = nullptr;
  Eigen::Matrix3d NormalsToWorld = Eigen::Matrix3d::Identity();
};
}

//------------------------------------------------------------------------------
class vtkNPRStrokeVisibility::Internals
{
public:
  /// What the prepared surfaces were made of.
  struct Source
  {
    vtkPolyData* Data;
    vtkMTimeType MTime;
    Eigen::Matrix4d ToWorld;

    bool operator==(const Source& other) const
    {
      return this->Data == other.Data && this->MTime == other.MTime &&
        this->ToWorld == other.ToWorld;
    }
  };

  class StageTimer
  {
  public:
    StageTimer(Internals& internals, StageType stage) : Seconds(internals.StageSeconds[stage]) {}
    ~StageTimer()
    {
      const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - this->Start;
      this->Seconds += passed.count();
    }

  private:
    double& Seconds;
    const std::chrono::steady_clock::time_point Start = std::chrono::steady_clock::now();
  };

  std::vector<vtkSmartPointer<vtkMatrix4x4>> Matrices;
  std::vector<Source> Sources;
  std::unique_ptr<npr::HidingSurfaces> Surfaces;
  std::array<double, NumberOfStages> StageSeconds{};
};

//------------------------------------------------------------------------------
vtkNPRStrokeVisibility::vtkNPRStrokeVisibility() : Internal(new Internals)
{
  this->SetNumberOfInputPorts(2);
}

//------------------------------------------------------------------------------
vtkNPRStrokeVisibility::~vtkNPRStrokeVisibility() = default;

//------------------------------------------------------------------------------
bool vtkNPRStrokeVisibility::IsAvailable()
{
  return npr::RayTracer::IsAvailable();
}

//------------------------------------------------------------------------------
vtkCamera* vtkNPRStrokeVisibility::GetCamera() const
{
  return this->Camera;
}

//------------------------------------------------------------------------------
vtkMatrix4x4* vtkNPRStrokeVisibility::GetStrokeMatrix() const
{
  return this->StrokeMatrix;
}

//------------------------------------------------------------------------------
void vtkNPRStrokeVisibility::AddSurfaceConnection(vtkAlgorithmOutput* surface, vtkMatrix4x4* matrix)
{
  const int index = this->GetNumberOfSurfaces();
  this->AddInputConnection(SurfacePort, surface);
  if (this->GetNumberOfSurfaces() > index)
  {
    this->SetSurfaceMatrix(index, matrix);
  }
}

//------------------------------------------------------------------------------
void vtkNPRStrokeVisibility::AddSurfaceData(vtkPolyData* surface, vtkMatrix4x4* matrix)
{
  vtkNew<vtkTrivialProducer> producer;
  producer->SetOutput(surface);
  this->AddSurfaceConnection(producer->GetOutputPort(), matrix);
}

//------------------------------------------------------------------------------
void vtkNPRStrokeVisibility::RemoveAllSurfaces()
{
  this->RemoveAllInputConnections(SurfacePort);
  this->Internal->Matrices.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkNPRStrokeVisibility::GetNumberOfSurfaces()
{
  return this->GetNumberOfInputConnections(SurfacePort);
}

//------------------------------------------------------------------------------
void vtkNPRStrokeVisibility::SetSurfaceMatrix(int surface, vtkMatrix4x4* matrix)
{
  if (surface < 0)
  {
    vtkErrorMacro("There is no surface " << surface << ": they are numbered from 0.");
    return;
  }
  auto& matrices = this->Internal->Matrices;
  if (static_cast<std::size_t>(surface) >= matrices.size())
  {
    matrices.resize(surface + 1);
  }
  if (matrices[surface] != matrix)
  {
    matrices[surface] = matrix;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkMatrix4x4* vtkNPRStrokeVisibility::GetSurfaceMatrix(int surface) const
{
  const auto& matrices = this->Internal->Matrices;
  return surface < 0 || static_cast<std::size_t>(surface) >= matrices.size()
    ? nullptr
    : matrices[surface].Get();
}

//------------------------------------------------------------------------------
vtkMTimeType vtkNPRStrokeVisibility::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  if (this->Camera)
  {
    time = std::max(time, this->Camera->GetMTime());
  }
  if (this->StrokeMatrix)
  {
    time = std::max(time, this->StrokeMatrix->GetMTime());
  }
  for (const auto& matrix : this->Internal->Matrices)
  {
    time = std::max(time, matrix ? matrix->GetMTime() : 0);
  }
  return time;
}

//------------------------------------------------------------------------------
const char* vtkNPRStrokeVisibility::GetStageName(int stage)
{
  static const std::array<const char*, NumberOfStages> names = { "prepare", "edges", "split",
    "write" };
  return stage >= 0 && stage < NumberOfStages ? names[stage] : nullptr;
}

//------------------------------------------------------------------------------
double vtkNPRStrokeVisibility::GetStageSeconds(int stage) const
{
  return stage >= 0 && stage < NumberOfStages ? this->Internal->StageSeconds[stage] : 0.0;
}

//------------------------------------------------------------------------------
int vtkNPRStrokeVisibility::FillInputPortInformation(int port, vtkInformation* information)
{
  if (port == SurfacePort)
  {
    information->Set(INPUT_IS_REPEATABLE(), 1);
    information->Set(INPUT_IS_OPTIONAL(), 1); // so that what is missing can be said better
  }
  return this->Superclass::FillInputPortInformation(port, information);
}

//------------------------------------------------------------------------------
int vtkNPRStrokeVisibility::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  // A piece of the strokes may be hidden by any piece of the surfaces.
  for (int i = 0; i < inputVector[SurfacePort]->GetNumberOfInformationObjects(); ++i)
  {
    vtkInformation* const surface = inputVector[SurfacePort]->GetInformationObject(i);
    surface->Set(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER(), 0);
    surface->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES(), 1);
    surface->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
  }
  return this->Superclass::RequestUpdateExtent(request, inputVector, outputVector);
}

//------------------------------------------------------------------------------
// All that no view changes. False, after an error, when a matrix has no numbers.
bool vtkNPRStrokeVisibility::PrepareSurfaces(vtkInformationVector* surfaces)
{
  Internals& internal = *this->Internal;
  const Internals::StageTimer timer(internal, PREPARE);
  std::vector<Internals::Source> sources;
  for (int i = 0; i < surfaces->GetNumberOfInformationObjects(); ++i)
  {
    vtkPolyData* const data = vtkPolyData::GetData(surfaces, i);
    const Eigen::Matrix4d toWorld = GetToWorld(this->GetSurfaceMatrix(i));
    if (!toWorld.allFinite())
    {
      vtkErrorMacro("The matrix of surface " << i << " has values that are not numbers.");
      return false;
    }
    if (data)
    {
      sources.push_back({ data, data->GetMTime(), toWorld });
    }
  }
  if (internal.Surfaces && internal.Sources == sources)
  {
    return true;
  }
  std::vector<npr::HidingSurfaces::Surface> given;
  for (const Internals::Source& source : sources)
  {
    given.push_back({ source.Data, source.ToWorld });
  }
  internal.Surfaces.reset(); // so that old and new need no memory at once
  internal.Surfaces = std::make_unique<npr::HidingSurfaces>(given);
  internal.Sources = sources;
  return true;
}

//------------------------------------------------------------------------------
int vtkNPRStrokeVisibility::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* const input = vtkPolyData::GetData(inputVector[StrokePort]);
  vtkPolyData* const output = vtkPolyData::GetData(outputVector);
  Internals& internal = *this->Internal;
  internal.StageSeconds.fill(0.0);
  if (!IsAvailable())
  {
    vtkErrorMacro("This build can not find hidden lines, since it has no Embree: install it "
                  "(Debian package libembree-dev) and configure with -DNPR_USE_EMBREE=ON.");
    return 0;
  }
  if (!this->Camera)
  {
    vtkErrorMacro("What is hidden depends on the view: call SetCamera.");
    return 0;
  }
  if (this->GetNumberOfSurfaces() == 0)
  {
    vtkErrorMacro("There is no surface that could hide anything: call AddSurfaceConnection or "
                  "AddSurfaceData, or leave this filter out if all strokes are to be visible.");
    return 0;
  }
  const Eigen::Matrix4d toWorld = GetToWorld(this->StrokeMatrix);
  if (!toWorld.allFinite())
  {
    vtkErrorMacro("The matrix of the strokes has values that are not numbers.");
    return 0;
  }
  if (!this->PrepareSurfaces(inputVector[SurfacePort]))
  {
    return 0;
  }
  this->UpdateProgress(0.5);
  const npr::HidingSurfaces& surfaces = *internal.Surfaces;
  const npr::ImageProjection projection(
    this->Camera, surfaces.GetCentre(), this->ViewportHeight, surfaces.GetRadius());
  if (!projection.IsValid())
  {
    vtkErrorMacro("The camera has no view: its position must not be its focal point, and its view "
                  "angle or parallel scale must be positive.");
    return 0;
  }
  output->GetFieldData()->PassData(input->GetFieldData());
  vtkNew<vtkPolyData> nothing;
  vtkNew<vtkPoints> noPoints;
  nothing->SetPoints(noPoints);
  vtkPolyData* const strokeData =
    input->GetPoints() && input->GetNumberOfLines() > 0 ? input : nothing.Get();
  const WorldStrokes strokes(strokeData, toWorld, surfaces.GetCentre());
  std::unique_ptr<npr::HidingEdges> edges;
  {
    const Internals::StageTimer timer(internal, EDGES);
    constexpr double heights = 4.0;
    edges = std::make_unique<npr::HidingEdges>(
      surfaces, projection, strokes.GetBounds(projection, heights * this->ViewportHeight));
  }
  this->UpdateProgress(0.6);

  vtkCellArray* const lines = strokeData->GetLines();
  std::vector<std::vector<npr::StrokePart>> parts(lines->GetNumberOfCells());
  {
    const Internals::StageTimer timer(internal, SPLIT);
    vtkSMPTools::For(0, lines->GetNumberOfCells(),
      [&](vtkIdType begin, vtkIdType end)
      {
        npr::StrokeSplitter splitter(
          surfaces, *edges, projection, this->MaximumLayers, strokes.IsMirrored());
        std::vector<Eigen::Vector3d> points;
        std::vector<Eigen::Vector3d> normals;
        vtkNew<vtkIdList> ids;
        for (vtkIdType line = begin; line < end && !this->GetAbortExecute(); ++line)
        {
          lines->GetCellAtId(line, ids);
          strokes.Read(ids, points, normals);
          parts[line] = npr::MergeParts(splitter.Split(points, normals), this->MinimumLength,
            npr::IsClosedStroke(strokes.GetPoints(), ids), points.size() - 1);
        }
      });
  }
  this->UpdateProgress(0.9);
  if (npr::IsAborted(this))
  {
    return 1;
  }
  const Internals::StageTimer timer(internal, WRITE);
  npr::WriteStrokeParts(strokeData, parts, output);
  this->UpdateProgress(1.0);
  return 1;
}

//------------------------------------------------------------------------------
void vtkNPRStrokeVisibility::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Camera: " << this->Camera.Get() << "\n";
  os << indent << "StrokeMatrix: " << this->StrokeMatrix.Get() << "\n";
  os << indent << "MaximumLayers: " << this->MaximumLayers << "\n";
  os << indent << "ViewportHeight: " << this->ViewportHeight << "\n";
  os << indent << "MinimumLength: " << this->MinimumLength << "\n";
}
