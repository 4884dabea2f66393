// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprLineFlicker.h
 * @brief How much of the lines comes and goes while the camera turns.
 */
#ifndef nprLineFlicker_h
#define nprLineFlicker_h

class vtkPolyData;

namespace nprbench
{
/// Shares of the ink that one frame has and the other has not, there and back.
struct LineFlicker
{
  double Faded = 0.0;  // ink is length weighted by strength
  double Drawn = 0.0;  // all of a line counts alike, as if it were drawn without fading
  double Pixels = 0.0; // of line in a frame
};

/**
 * The mean over the steps of a camera that turns around the surface. The lines of each frame are
 * drawn as the camera of the next sees them, which is where they were if they stood still on the
 * surface; the two drawings are compared within a pixel and a half, on pictures of a thousand
 * pixels' height. Hidden lines count, too.
 */
LineFlicker MeasureFlicker(vtkPolyData* surface, const char* lineName, int steps, double degrees);
}

#endif
