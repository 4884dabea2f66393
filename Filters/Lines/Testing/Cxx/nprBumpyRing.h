// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprBumpyRing.h
 * @brief A surface with all arrays that lines need, and all kinds of lines on it.
 */
#ifndef nprBumpyRing_h
#define nprBumpyRing_h

#include "nprLineTesting.h"

#include "vtkNPRCurvatureTensor.h"

namespace nprtest
{
/// A torus of nu x nv points whose tube is swell(u, v) times as thick, if so wanted with a hole cut
/// into it, and its curvature.
template<typename Swell>
vtkSmartPointer<vtkPolyData> MakeBumpyRing(int nu, int nv, bool holed, const Swell& swell)
{
  auto ring = MakeGrid(nu, nv, true, true);
  for (int i = 0; i < nu; ++i)
  {
    for (int j = 0; j < nv; ++j)
    {
      const double u = 2.0 * Pi * i / nu;
      const double v = 2.0 * Pi * j / nv;
      Torus torus;
      torus.r *= swell(u, v);
      ring->GetPoints()->SetPoint(static_cast<vtkIdType>(i) * nv + j, torus.Point(u, v).data());
    }
  }
  vtkNew<vtkNPRCurvatureTensor> tensor;
  tensor->SetEstimator(vtkNPRCurvatureTensor::PER_FACE);
  tensor->SetInputData(ring);
  tensor->Update();
  const vtkSmartPointer<vtkPolyData> output = tensor->GetOutput();
  vtkNew<vtkCellArray> triangles;
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < ring->GetNumberOfPolys(); ++i)
  {
    if (!holed || i % (2 * nv) >= nv / 3 || i > nu * nv / 2)
    {
      ring->GetPolys()->GetCellAtId(i, ids);
      triangles->InsertNextCell(ids);
    }
  }
  output->SetPolys(triangles);
  return output;
}
}

#endif
