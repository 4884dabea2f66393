// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPRModelImporter
 * @brief Read a model or a volume from any file that we know, by its extension.
 *
 * Meshes: OBJ with its materials, PLY (also compressed by gzip), STL, glTF, and VTK's surfaces and
 * grids (their outside). Volumes: VTI, legacy VTK, NIfTI, NRRD, MetaImage and OpenVDB, of which
 * SetIsoValue() makes a surface; GetFormatExtension() lists them all.
 *
 * @code
 * vtkNew<vtkNPRModelImporter> importer;
 * importer->SetFileName("bunny.obj");
 * if (!importer->ImportInto(renderer)) // or GetSurface(polyData), for the geometry alone
 * {
 *   std::cerr << importer->GetErrorMessage() << "\n"; // vtkErrorMacro has said it, too
 * }
 * @endcode
 *
 * @par Surfaces
 * A part is one surface with one material. Polygons are kept as they are in the file (not
 * triangulated, not welded). The surface of a volume has the normals of its gradient and faces
 * towards smaller values; that of a level set (OpenVDB) faces outwards, towards larger ones. A
 * matrix that mirrors (a part's, or a scanner's) reverses the polygons, so that outside stays
 * outside. A volume of more than one value a voxel gives its first. Points of OBJ and PLY are
 * doubles where they lie so far from the origin that floats would lose details.
 *
 * @par Materials
 * They become VTK's plain ones: the colour (or glTF's base colour, from linear to sRGB) is diffuse,
 * with coefficient 1, ambient 0 and Phong interpolation; physically based properties are left out.
 * Point colours (unsigned char, 3 or 4 components; those of glTF) are shown, other scalars not.
 *
 * @par Errors
 * One message for each failure, by vtkErrorMacro and GetErrorMessage(): which file, what is wrong
 * and what to do. What VTK's readers print is folded into it. While a file is read, VTK's output
 * window and std::cerr are taken over for the whole process.
 *
 * @par Progress
 * ProgressEvent, with a double in 0 .. 1 for each reader that has some.
 *
 * @sa vtkNPRVDBReader vtkNPRSampleSource vtkNPRSurfacePreparation
 */
#ifndef vtkNPRModelImporter_h
#define vtkNPRModelImporter_h

#include "vtkNPRIOModule.h"
#include <vtkObject.h>
#include <vtkTimeStamp.h>

#include <memory>

class vtkPolyData;
class vtkRenderer;

class VTKNPRIO_EXPORT vtkNPRModelImporter : public vtkObject
{
public:
  static vtkNPRModelImporter* New();
  vtkTypeMacro(vtkNPRModelImporter, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// @name File
  /// Path of the file; its extension, in any case, chooses the reader. Default is null.
  ///@{
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /// @name Iso value
  /// At which value of a volume the surface lies, in the unit of the volume. It must be inside of
  /// the range of the values. Volumes need it (level sets of OpenVDB take 0 without it); meshes
  /// warn that it is not used. Setting a value turns UseIsoValue on. Default is off.
  ///@{
  void SetIsoValue(double value);
  vtkGetMacro(IsoValue, double);
  vtkSetMacro(UseIsoValue, bool);
  vtkGetMacro(UseIsoValue, bool);
  vtkBooleanMacro(UseIsoValue, bool);
  ///@}

  /// @name Smoothing of volumes
  /// Standard deviation, in voxels, of the Gauss filter that a volume passes before its surface is
  /// taken, from 0 (none) to 10. One voxel removes the steps that voxels make, at the price of
  /// details of that size. Level sets are smooth already and left alone. Default is 0.
  ///@{
  vtkSetClampMacro(VolumeSmoothing, double, 0.0, 10.0);
  vtkGetMacro(VolumeSmoothing, double);
  ///@}

  /// @name Grid
  /// Which grid of an OpenVDB file. Default is null: its first level set, or else its first scalar
  /// grid.
  ///@{
  vtkSetStringMacro(GridName);
  vtkGetStringMacro(GridName);
  ///@}

  /// Read the file, unless it has been read since the last change of a setting. False, and one
  /// error, if that fails. ImportInto() and GetSurface() call it.
  bool Read();

  /// Add one vtkActor for each part to the renderer.
  bool ImportInto(vtkRenderer* renderer);

  /// Replace the content of surface by all parts in one, each moved by its matrix. Of several parts
  /// the point arrays that all have are kept.
  bool GetSurface(vtkPolyData* surface);

  /// How many parts the last Read() found; 0 if it failed.
  int GetNumberOfParts() const;

  /// Which axis points up in files of this name's kind, by the custom of those who write them: 0, 1
  /// or 2. It is 2 for STL and for the pictures of medicine (NIfTI, NRRD, MetaImage), 1 for all
  /// others and for a name that is not known. Nothing is read for it.
  int GetUpAxis() const;

  /// How far, in degrees, a viewer goes around the up axis from vtkNPRViewpoint's front to see the
  /// front of such files' subjects: 180 for NIfTI, where +Y is the front of the body, else 0.
  double GetFrontAzimuth() const;

  /// Why the last Read() failed, in one line; empty if it did not.
  const char* GetErrorMessage() const;

  /// What the last Read() had to leave out, a line each; empty if there was nothing.
  const char* GetWarnings() const;

  /// @name What is read
  /// Extensions are in lower case with their dot, such as ".ply.gz".
  ///@{
  static int GetNumberOfFormats();
  static const char* GetFormatExtension(int format);
  static const char* GetFormatDescription(int format);
  /// Whether the format may be a volume, and so take an iso value.
  static bool GetFormatIsVolume(int format);
  /// As GetUpAxis(); -1 if there is no such format.
  static int GetFormatUpAxis(int format);
  /// Whether a file of this name would be read.
  static bool IsFileNameKnown(const char* fileName);
  ///@}

protected:
  vtkNPRModelImporter();
  ~vtkNPRModelImporter() override;

  char* FileName = nullptr;
  double IsoValue = 0.0;
  bool UseIsoValue = false;
  double VolumeSmoothing = 0.0;
  char* GridName = nullptr;

private:
  vtkNPRModelImporter(const vtkNPRModelImporter&) = delete;
  void operator=(const vtkNPRModelImporter&) = delete;

  struct Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
