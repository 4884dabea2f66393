// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPRViewpoint
 * @brief Points a renderer's camera at what it shows, as an illustrator would.
 *
 * A view is a direction: a name ("front", "back", "left", "right", "top", "bottom",
 * "three-quarter") or an azimuth and an elevation. The model is framed tightly: its outline, not
 * its bounding sphere, fills the image up to a margin.
 *
 * Y is up, and "front" looks along -Z, as in the file formats that say so (glTF) and in VTK's own
 * default camera. Azimuth turns the viewer to the right around Y, elevation lifts the viewer.
 *
 * @sa vtkNPRIllustration
 */
#ifndef vtkNPRViewpoint_h
#define vtkNPRViewpoint_h

#include "vtkNPRRenderingIllustrationModule.h"
#include <vtkObject.h>

#include <string> // for names of views
#include <vector> // for lists of names

class vtkRenderer;

class VTKNPRRENDERINGILLUSTRATION_EXPORT vtkNPRViewpoint : public vtkObject
{
public:
  static vtkNPRViewpoint* New();
  vtkTypeMacro(vtkNPRViewpoint, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// @name Direction, in degrees
  /// Azimuth: default 30; elevation: -90..90, default 20.
  ///@{
  vtkSetMacro(Azimuth, double);
  vtkGetMacro(Azimuth, double);
  vtkSetClampMacro(Elevation, double, -90.0, 90.0);
  vtkGetMacro(Elevation, double);
  ///@}

  /// @name Which axis of the model points up: 0 (X), 1 (Y, the default) or 2 (Z)
  /// With Z up, "front" looks along +Y, as in CAD programs.
  ///@{
  vtkSetClampMacro(UpAxis, int, 0, 2);
  vtkGetMacro(UpAxis, int);
  ///@}

  /// Set the direction by name; false, with an error, when there is no such view.
  bool SetViewByName(const std::string& name);
  static std::vector<std::string> GetViewNames();

  /// @name Parallel projection; default off
  ///@{
  vtkSetMacro(ParallelProjection, bool);
  vtkGetMacro(ParallelProjection, bool);
  vtkBooleanMacro(ParallelProjection, bool);
  ///@}

  /// @name The empty part of the image on each side, as a fraction; 0..0.45, default 0.06
  ///@{
  vtkSetClampMacro(Margin, double, 0.0, 0.45);
  vtkGetMacro(Margin, double);
  ///@}

  /// Set the camera of a renderer from the direction and frame all its visible actors.
  void Apply(vtkRenderer* renderer);

  /// Keep the camera's direction, and move it so that all visible actors are framed.
  void Frame(vtkRenderer* renderer);

protected:
  vtkNPRViewpoint() = default;
  ~vtkNPRViewpoint() override = default;

private:
  vtkNPRViewpoint(const vtkNPRViewpoint&) = delete;
  void operator=(const vtkNPRViewpoint&) = delete;

  double Azimuth = 30.0;
  double Elevation = 20.0;
  int UpAxis = 1;
  bool ParallelProjection = false;
  double Margin = 0.06;
};

#endif
