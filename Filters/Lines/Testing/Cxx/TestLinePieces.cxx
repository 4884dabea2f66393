// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// A surface in pieces has the segments that it has as a whole; and a surface without arrays can
// have those that lines need made.
#include "nprBumpyRing.h"
#include "nprSegmentMatching.h"

#include "vtkNPRCurvatureTensor.h"
#include "vtkNPRLineDefinition.h"

#include <vtkExtractPolyDataPiece.h>

#include <string>

using namespace nprtest;

namespace
{
// A ring with a hole, bent so much at one place that there are creases.
vtkSmartPointer<vtkPolyData> MakeRing()
{
  return MakeBumpyRing(90, 40, true,
    [](double u, double v)
    { return 1.0 + 0.2 * std::abs(std::sin(2.0 * u + 0.1)) * std::sin(3.0 * v + 0.2); });
}

void TestPieces(Checks& check)
{
  const auto surface = MakeRing();
  for (const char* name : { "contours", "suggestive", "ridges", "apparent-ridges", "parabolic",
         "mean-curvature", "creases", "boundaries", "contour-edges" })
  {
    vtkNew<vtkExtractPolyDataPiece> pieces;
    pieces->SetInputData(surface);
    vtkNew<vtkNPRFeatureLines> lines;
    vtkNPRLineDefinition* const definition = lines->AddDefinition(name);
    definition->SetParameter("angle", 10.0);
    // What a piece can not know.
    definition->SetParameter("smoothing", 0.0);
    definition->SetParameter("region", 0.0);
    lines->SetCamera(MakeCamera({ 2.0, 1.7, 2.4 }));
    lines->SetLengthScale(1.0);
    lines->SetInputConnection(pieces->GetOutputPort());
    lines->UpdatePiece(0, 1, 0);
    const auto whole = GetSegments(GetChains(lines->GetOutput()));
    check(whole.size() > 30, name, static_cast<double>(whole.size()));
    for (const int count : { 2, 3, 7 })
    {
      std::vector<Segment> all;
      for (int piece = 0; piece < count; ++piece)
      {
        lines->UpdatePiece(piece, count, 0);
        const auto some = GetSegments(GetChains(lines->GetOutput()));
        all.insert(all.end(), some.begin(), some.end());
      }
      // Each piece has its own middle, that coordinates are rounded beside.
      const std::size_t unmatched = CountUnmatched(all, whole, 2.0e-5);
      check(unmatched <= whole.size() / 500, (std::string(name) + " in pieces").c_str(),
        static_cast<double>(unmatched));
    }
  }
}

//------------------------------------------------------------------------------
void TestMissingArrays(Checks& check)
{
  const auto bare = MakeGrid(80, 40, true, true);
  const auto exact = Torus().Make(80, 40);
  bare->SetPoints(exact->GetPoints());
  vtkNew<vtkNPRFeatureLines> lines;
  lines->AddDefinition("contours");
  lines->AddDefinition("suggestive");
  lines->SetCamera(MakeCamera({ 2.0, 1.7, 2.4 }));
  lines->SetInputData(bare);
  const std::string error = GetErrors(lines);
  check(error.find("Normals") != std::string::npos &&
      error.find("vtkNPRSurfaceNormals") != std::string::npos &&
      error.find("ComputeMissingArrays") != std::string::npos,
    "what is missing is named, and what to do");
  lines->ComputeMissingArraysOn();
  check(GetErrors(lines).empty(), "or it is made");
  const auto chains = GetChains(lines->GetOutput());
  CheckSound(chains, check);
  vtkNew<vtkNPRCurvatureTensor> tensor;
  tensor->SetInputData(bare);
  tensor->Update();
  const auto expected =
    Extract(tensor->GetOutput(), { "contours", "suggestive" }, MakeCamera({ 2.0, 1.7, 2.4 }));
  check(GetSegments(chains) == GetSegments(expected), "as the curvature filter makes it");
}
}

//------------------------------------------------------------------------------
int TestLinePieces(int, char*[])
{
  Checks check;
  TestPieces(check);
  TestMissingArrays(check);
  return check.GetResult();
}
