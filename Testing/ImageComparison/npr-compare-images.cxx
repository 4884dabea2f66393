// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Compares two PNG files as the image tests do.
#include "nprImageComparison.h"

#include <vtkImageData.h>

#include <CLI/CLI.hpp>

#include <iostream>

int main(int argc, char* argv[])
{
  CLI::App app("Compares a picture with a reference, as the image tests of vtkNPR do. "
               "Returns 0 if they agree, 1 if any measure fails, 2 if a file can not be used.");
  std::string referenceFile;
  std::string resultFile;
  std::string differenceFile;
  npr::ImageLimits limits;
  app.add_option("reference", referenceFile, "PNG file")->required();
  app.add_option("result", resultFile, "PNG file")->required();
  app.add_option("--difference", differenceFile,
    "PNG file to write: reference, result and difference side by side");
  const auto limit = [&](const char* name, double& value, const char* text)
  { app.add_option(name, value, text)->capture_default_str()->group("Limits"); };
  limit("--radius", limits.Radius, "how far ink may move, in pixels");
  limit("--ink-contrast", limits.InkContrast, "contrast from which on a pixel is ink");
  limit("--ink-precision", limits.InkPrecision, "least share of the result's ink that is expected");
  limit("--ink-recall", limits.InkRecall, "least share of the reference's ink that is there");
  limit("--missing-piece", limits.MissingPiece, "longest piece of ink that may miss, in pixels");
  limit("--extra-piece", limits.ExtraPiece, "longest piece of ink that may be new, in pixels");
  limit("--ink-amount", limits.InkAmount, "largest relative change of the amount of ink");
  limit("--ink-tone", limits.InkTone, "largest change of the ink's mean contrast");
  limit("--ink-tones", limits.InkTones, "largest distance of the histograms of ink contrast");
  limit("--mean-ssim", limits.MeanSSIM, "least mean structural similarity");
  limit("--local-ssim", limits.LocalSSIM, "least structural similarity of any window");
  limit("--mean-difference", limits.MeanDifference, "largest mean difference of a channel");
  limit("--max-difference", limits.MaxDifference, "largest difference of any pixel");
  CLI11_PARSE(app, argc, argv);

  const auto reference = npr::ReadImage(referenceFile);
  const auto result = npr::ReadImage(resultFile);
  if (!reference || !result)
  {
    return 2;
  }
  const npr::ImageComparison comparison = npr::CompareImages(reference, result, limits);
  std::cout << comparison.Report();
  if (!differenceFile.empty() && comparison.Picture &&
    !npr::WriteImage(comparison.Picture, differenceFile))
  {
    return 2;
  }
  return comparison.Passes() ? 0 : 1;
}
