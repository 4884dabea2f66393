// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Succeeds if a PNG file shows an illustration: dark lines, on a picture that is mostly light.
#include "nprImageComparison.h"

#include <vtkImageData.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>

int main(int argc, char* argv[])
{
  if (argc != 2)
  {
    std::cerr << "Usage: HasInk PICTURE.png\n";
    return EXIT_FAILURE;
  }
  const auto image = npr::ReadImage(argv[1]);
  if (!image)
  {
    return EXIT_FAILURE;
  }
  const int components = image->GetNumberOfScalarComponents();
  const auto* bytes = static_cast<const unsigned char*>(image->GetScalarPointer());
  const vtkIdType pixels = image->GetNumberOfPoints();
  vtkIdType dark = 0;
  vtkIdType light = 0;
  for (vtkIdType i = 0; i < pixels; ++i, bytes += components)
  {
    const auto [least, most] = std::minmax_element(bytes, bytes + std::min(components, 3));
    dark += *most < 80;
    light += *least > 150;
  }
  const double darkShare = static_cast<double>(dark) / pixels;
  const double lightShare = static_cast<double>(light) / pixels;
  std::cout << argv[1] << ": dark " << 100.0 * darkShare << " %, light " << 100.0 * lightShare
            << " %\n";
  return darkShare > 0.001 && darkShare < 0.2 && lightShare > 0.5 ? EXIT_SUCCESS : EXIT_FAILURE;
}
