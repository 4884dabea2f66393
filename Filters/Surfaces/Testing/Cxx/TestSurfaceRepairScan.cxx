// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// A scan with unreferenced points and thousands of non-manifold edges becomes a manifold.
#include "nprAnalyticSurfaces.h"
#include "nprManifoldChecks.h"
#include "nprPointFans.h"
#include "nprTestModels.h"
#include "vtkNPRSurfacePreparation.h"

#include <vtkPLYReader.h>

using namespace nprtest;

int TestSurfaceRepairScan(int, char*[])
{
  const std::string path = npr::TestModel("dragon/dragon_vrip_res2.ply");
  if (path.empty())
  {
    return npr::SkipTest;
  }
  vtkNew<vtkPLYReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  Checks check;
  npr::TriangleMesh raw(reader->GetOutput());
  raw.BuildNeighbours();
  const npr::NonManifoldCounts found = npr::CountNonManifold(raw);
  check(found.Edges == 2534, "non-manifold edges", static_cast<double>(found.Edges));

  vtkNew<vtkNPRSurfacePreparation> preparation;
  preparation->SetInputConnection(reader->GetOutputPort());
  preparation->SplitCreasesOff();
  preparation->Update();
  std::cout << preparation->GetReport() << "\n";
  check(preparation->GetNumberOfUnusedPoints() == 43 + 418, "unused points, and tips of folds",
    static_cast<double>(preparation->GetNumberOfUnusedPoints()));
  check(preparation->GetNumberOfFoldTriangles() > 2000, "decimation left folds");
  check(preparation->GetNumberOfNonManifoldEdges() < 300 &&
      preparation->GetNumberOfBoundaryEdges() < 100,
    "without which it is nearly whole");
  const Shape split = GetShape(preparation->GetOutput());
  check(split.IsManifold() && split.Disagreements == 0, "it becomes an oriented manifold");

  // With all the rest, too; a coarser one, which is as bad and quicker looked through.
  reader->SetFileName(npr::TestModel("dragon/dragon_vrip_res4.ply").c_str());
  preparation->SplitCreasesOn();
  preparation->SetFillHoles(1.0);
  preparation->Update();
  std::cout << preparation->GetReport() << "\n";
  const Shape all = GetShape(preparation->GetOutput());
  check(all.IsManifold() && all.Disagreements == 0, "a coarser one, too");
  return check.GetResult();
}
