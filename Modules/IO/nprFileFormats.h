// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprFileFormats.h
 * @brief What vtkNPRModelImporter reads: a table with one line a format.
 *
 * To add a format, write a function that appends to ModelFile::Parts, and its line in the table in
 * nprFileFormats.cxx.
 */
#ifndef nprFileFormats_h
#define nprFileFormats_h

#include <vtkMatrix4x4.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkSmartPointer.h>
#include <vtkTexture.h>

#include <array>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

class vtkAlgorithm;
class vtkDataSet;
class vtkEventForwarderCommand;
class vtkImageData;
class vtkPointSet;

namespace npr
{
/// Why a file can not be read: one sentence or two, with what to do, without the file's name.
class ModelError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// One surface with one material.
struct ModelPart
{
  vtkSmartPointer<vtkPolyData> Surface;
  vtkSmartPointer<vtkMatrix4x4> Matrix;  // null: where it is
  vtkSmartPointer<vtkProperty> Property; // null: VTK's default
  vtkSmartPointer<vtkTexture> Texture;   // may be null
};

/// A file on its way in: what was asked for, and what came of it.
struct ModelFile
{
  std::string Path;
  std::optional<double> IsoValue;
  double VolumeSmoothing = 0.0; // standard deviation in voxels
  std::string GridName;
  vtkSmartPointer<vtkEventForwarderCommand> Progress;

  std::vector<ModelPart> Parts;
  std::vector<std::string> Warnings;

  /// Let the importer's observers see the progress of a reader.
  void Watch(vtkAlgorithm* reader) const;
  void AddPart(vtkPolyData* surface);
};

struct FileFormat
{
  const char* Extension; // in lower case with its dot
  const char* Description;
  bool IsVolume; // takes an iso value
  int UpAxis;    // which axis points up by the custom of those who write it: 0, 1 or 2
  void (*Read)(ModelFile&);
  double FrontAzimuth = 0.0; // degrees around the up axis to where the front is seen from
};

const std::vector<FileFormat>& GetFileFormats();
/// The format with the longest extension that the path ends in, in any case; null if there is none.
const FileFormat* FindFileFormat(const std::string& path);

/// @name Readers
///@{
void ReadOBJ(ModelFile& file);
void ReadPLY(ModelFile& file);
void ReadSTL(ModelFile& file);
void ReadVTP(ModelFile& file);
void ReadXMLDataSet(ModelFile& file);
void ReadLegacyVTK(ModelFile& file);
void ReadGLTF(ModelFile& file);
void ReadVTI(ModelFile& file);
void ReadNIFTI(ModelFile& file);
void ReadNRRD(ModelFile& file);
void ReadMetaImage(ModelFile& file);
void ReadVDB(ModelFile& file);
///@}

/// Throws where a volume's header announces more voxels than that many bytes can hold.
void CheckSize(vtkAlgorithm* reader, std::uint64_t bytes);
/// Adds the surface at the file's iso value (0 for a level set without one), facing towards smaller
/// values (a level set's: towards larger). The matrix takes the image's coordinates to the world's.
void AddIsoSurface(
  ModelFile& file, vtkImageData* image, vtkMatrix4x4* matrix = nullptr, bool isLevelSet = false);
/// The text with '?' for what can not be printed, so that damage to a file does not damage a
/// message.
std::string Printable(std::string text);
/// The whole file, unpacked if it is compressed by gzip.
std::string ReadBytes(const std::string& path);
/// A surface's colour as VTK's plain lighting shows it: diffuse alone, so that styles see the
/// colour.
vtkSmartPointer<vtkProperty> MakePlainProperty(const double diffuse[3], double opacity);
/// The texture in an image file; null, with a warning, where it can not be read.
vtkSmartPointer<vtkTexture> ReadTexture(ModelFile& file, const std::string& path);
/// The texture in the bytes of a PNG or JPEG; the name is for the warning.
vtkSmartPointer<vtkTexture> ReadTextureBytes(
  ModelFile& file, const std::string& bytes, const std::string& name);
/// Whether points lie so far from the origin, for the size of their box, that floats would lose
/// details.
bool NeedsDouble(const std::vector<std::array<double, 3>>& points);
/// Reverse all polygons of a surface.
void ReversePolygons(vtkPolyData* surface);
/// Points, normals and the order of polygons, taken through a matrix; a mirror keeps outside out.
vtkSmartPointer<vtkPolyData> TransformSurface(vtkPolyData* surface, vtkMatrix4x4* matrix);
/// Adds the outside of any data set, such as a grid of cells.
void AddOutside(ModelFile& file, vtkDataSet* data);
/// Throws where a cell refers to a point that is not there.
void CheckCells(vtkPointSet* data);
}

#endif
