// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Grids of OpenVDB come as images with their values, their place and their names; what an image can
// not hold is refused.
#include <nprOpenVDB.h>
#include <vtkNPRVDBReader.h>

#include <openvdb/tools/LevelSetSphere.h>

#include <vtkCallbackCommand.h>
#include <vtkDataArray.h>
#include <vtkExecutive.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <string>

namespace
{
int Failures = 0;

void Expect(bool condition, const std::string& what)
{
  if (!condition)
  {
    std::cerr << "FAILED: " << what << "\n";
    ++Failures;
  }
}

std::string ErrorOf(vtkNPRVDBReader* reader)
{
  std::string message;
  vtkNew<vtkCallbackCommand> keep;
  keep->SetClientData(&message);
  keep->SetCallback([](vtkObject*, unsigned long, void* data, void* text)
    { *static_cast<std::string*>(data) += static_cast<const char*>(text); });
  reader->AddObserver(vtkCommand::ErrorEvent, keep);
  reader->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, keep);
  reader->Update();
  return message;
}

void ExpectError(const std::string& path, const char* grid, const std::string& word)
{
  vtkNew<vtkNPRVDBReader> reader;
  reader->SetFileName(path.c_str());
  reader->SetGridName(grid);
  const std::string message = ErrorOf(reader);
  Expect(message.find(word) != std::string::npos,
    path + " should say '" + word + "', but says '" + message + "'");
}
}

int TestVDBReader(int argc, char* argv[])
{
  std::string folder = ".";
  for (int i = 1; i + 1 < argc; ++i)
  {
    folder = std::strcmp(argv[i], "-T") == 0 ? argv[i + 1] : folder;
  }
  openvdb::initialize();

  // A ramp of doubles over a box, a level set, and vectors.
  const auto ramp = openvdb::DoubleGrid::create(-1.0);
  for (int i = 2; i <= 5; ++i)
  {
    for (int j = -3; j <= 4; ++j)
    {
      for (int k = 10; k <= 12; ++k)
      {
        ramp->tree().setValue(openvdb::Coord(i, j, k), i + 10.0 * j + 100.0 * k);
      }
    }
  }
  ramp->setName("ramp");
  const auto placed = openvdb::math::Transform::createLinearTransform(0.5);
  placed->postTranslate(openvdb::Vec3d(1.0, 2.0, 3.0));
  ramp->setTransform(placed);
  const auto sphere = openvdb::tools::createLevelSetSphere<openvdb::FloatGrid>(
    1.0f, openvdb::Vec3f(4.0f, 5.0f, 6.0f), 0.1f);
  sphere->setName("sphere");
  const auto vectors = openvdb::Vec3SGrid::create();
  vectors->setName("velocity");
  vectors->tree().setValue(openvdb::Coord(0, 0, 0), openvdb::Vec3s(1.0f, 0.0f, 0.0f));
  const auto turned = ramp->deepCopy();
  turned->setName("turned");
  const auto rotation = openvdb::math::Transform::createLinearTransform(0.5);
  rotation->postRotate(0.3, openvdb::math::X_AXIS);
  turned->setTransform(rotation);
  const auto wide = openvdb::FloatGrid::create();
  wide->setName("wide");
  wide->tree().setValue(openvdb::Coord(0, 0, 0), 1.0f);
  wide->tree().setValue(openvdb::Coord(1000000, 1000000, 1000000), 1.0f);
  const auto bare = openvdb::FloatGrid::create();
  bare->setName("bare");
  const std::string path = folder + "/Grids.vdb";
  openvdb::io::File(path).write({ ramp, sphere, vectors, turned, wide, bare });

  vtkNew<vtkNPRVDBReader> reader;
  reader->SetFileName(path.c_str());
  reader->SetGridName("ramp");
  reader->Update();
  vtkImageData* image = reader->GetOutput();
  Expect(reader->GetNumberOfGrids() == 6 && !reader->GetNameOfGrid(6), "six grids are listed");
  Expect(!reader->GetIsLevelSet(), "the ramp is no level set");
  Expect(image->GetScalarType() == VTK_DOUBLE && image->GetDimensions()[0] == 6 &&
      image->GetDimensions()[1] == 10 && image->GetDimensions()[2] == 5,
    "the ramp has its box and one voxel around it");
  double worst = 0.0;
  for (int i = 2; i <= 5; ++i)
  {
    for (int j = -3; j <= 4; ++j)
    {
      const double value = image->GetScalarComponentAsDouble(i, j, 11, 0);
      worst = std::max(worst, std::abs(value - (i + 10.0 * j + 1100.0)));
    }
  }
  Expect(worst == 0.0, "the ramp has its values");
  Expect(image->GetScalarComponentAsDouble(1, 0, 11, 0) == -1.0, "around it is the background");
  double bounds[6];
  image->GetBounds(bounds);
  const double expected[6] = { 1.5, 4.0, 0.0, 4.5, 7.5, 9.5 };
  for (int i = 0; i < 6; ++i)
  {
    Expect(
      std::abs(bounds[i] - expected[i]) < 1e-9, "the ramp's bound " + std::to_string(bounds[i]));
  }

  reader->SetGridName(nullptr);
  reader->Update();
  image = reader->GetOutput();
  Expect(reader->GetIsLevelSet(), "the level set is the default grid");
  image->GetBounds(bounds);
  Expect(std::abs(0.5 * (bounds[4] + bounds[5]) - 6.0) < 1e-5, "the sphere is in its place");
  const auto centre = image->FindPoint(4.0, 5.0, 6.0);
  Expect(image->GetPointData()->GetScalars()->GetComponent(centre, 0) < 0.0,
    "a level set is negative inside");

  ExpectError(path, "nothing", "'ramp' (double)");
  ExpectError(path, "velocity", "only scalars");
  ExpectError(path, "turned", "rotated");
  ExpectError(path, "wide", "MaximumNumberOfVoxels");
  ExpectError(path, "bare", "no active voxel");
  ExpectError(folder + "/missing.vdb", nullptr, "missing.vdb");
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
