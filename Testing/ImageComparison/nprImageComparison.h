// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprImageComparison.h
 * @brief Compares a picture with its baseline, so that a change of a line drawing is seen.
 *
 * A metric made for photographs is nearly blind to line drawings: most of the picture is paper.
 * Here the ink is found first (see InkStrength() in nprImageMeasures.h) and compared as lines;
 * structural similarity and the plain differences see to the tones. A comparison fails when any
 * one measure passes its limit, and says which.
 */
#ifndef nprImageComparison_h
#define nprImageComparison_h

#include <vtkSmartPointer.h>

#include <string>
#include <vector>

class vtkImageData;
class vtkRenderWindow;

namespace npr
{
/// What two pictures may differ by. The defaults let pass what antialiasing does (two levels of
/// noise, a tenth of a pixel); they fail a shift of two pixels, a line wider by one pixel, lines
/// turned grey, and a missing piece of ten pixels.
struct ImageLimits
{
  double Radius = 1.0;          ///< how far ink may move; pixels
  double InkContrast = 0.25;    ///< contrast with the paper from which on a pixel is ink; (0, 1]
  double InkPrecision = 0.99;   ///< least share of the result's ink within Radius of the baseline's
  double InkRecall = 0.99;      ///< least share of the baseline's ink within Radius of the result's
  double MissingPiece = 3.0;    ///< longest connected piece of ink that may be lost; pixels
  double ExtraPiece = 3.0;      ///< longest connected piece of ink that may be new; pixels
  double InkAmount = 0.05;      ///< largest relative change of the ink's amount (area x contrast)
  double InkTone = 0.12;        ///< largest change of the ink's mean contrast; [0, 1]
  double InkTones = 0.12;       ///< largest distance of the histograms of ink contrast; [0, 1]
  double MeanSSIM = 0.98;       ///< least mean structural similarity
  double LocalSSIM = 0.85;      ///< least structural similarity of any 11x11 window
  double MeanDifference = 0.01; ///< largest mean difference of any one channel; [0, 1]
  double MaxDifference = 1.0;   ///< largest difference of any pixel; [0, 1], 1 is no limit
};

struct ImageMeasure
{
  std::string Name;
  double Value = 0.0;
  double Limit = 0.0;
  bool LimitIsLeast = false; ///< the limit is the least value that passes, not the largest
  bool Passes() const { return this->LimitIsLeast ? Value >= Limit : Value <= Limit; }
};

struct ImageComparison
{
  /// Why nothing could be measured: no image, other sizes, a blank image. Empty otherwise.
  std::string Problem;
  std::vector<ImageMeasure> Measures;
  /// Baseline, result and difference side by side. In the difference, ink that was lost is red, ink
  /// that is new is blue, and other changes are grey. Null if there was nothing to show.
  vtkSmartPointer<vtkImageData> Picture;

  bool Passes() const;
  /// One line a measure, with value, limit and verdict.
  std::string Report() const;
};

/// Compares two-dimensional images of unsigned char with 1 to 4 components.
ImageComparison CompareImages(
  vtkImageData* baseline, vtkImageData* result, const ImageLimits& limits = {});

/**
 * Compares with `<name>.png` in the baseline folder, and returns EXIT_SUCCESS or EXIT_FAILURE.
 *
 * The folders are read from a test's arguments as npr_add_tests() gives them: `-B` for the
 * baselines, `-T` for the output. The result is written as `<name>.png` to the output folder; if
 * the comparison fails, `<name>.difference.png` beside it shows both and what differs. A missing
 * baseline fails, and so does a blank image.
 *
 * The window is rendered and must not be multisampled: those samples differ from driver to driver.
 */
int CompareWithBaseline(vtkRenderWindow* window, const char* name, int argc, char* argv[],
  const ImageLimits& limits = {});
int CompareWithBaseline(
  vtkImageData* result, const char* name, int argc, char* argv[], const ImageLimits& limits = {});

/// Reads a PNG file; null with a message on standard error if it can not be read.
vtkSmartPointer<vtkImageData> ReadImage(const std::string& fileName);
/// Writes a PNG file; false with a message on standard error if it can not be written.
bool WriteImage(vtkImageData* image, const std::string& fileName);
}

#endif
