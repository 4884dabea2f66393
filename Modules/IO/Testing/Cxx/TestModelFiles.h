// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
//
// One good file of each format, of a shape whose place, size and outside are known: a unit sphere,
// or a ball in a volume.
#ifndef TestModelFiles_h
#define TestModelFiles_h

#include <vtkActor.h>
#include <vtkAppendFilter.h>
#include <vtkDataSetWriter.h>
#include <vtkFloatArray.h>
#include <vtkGLTFExporter.h>
#include <vtkImageData.h>
#include <vtkMatrix4x4.h>
#include <vtkMetaImageWriter.h>
#include <vtkNIFTIImageWriter.h>
#include <vtkNew.h>
#include <vtkPLYWriter.h>
#include <vtkPNGWriter.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataWriter.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSTLWriter.h>
#include <vtkSphereSource.h>
#include <vtkTriangle.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLImageDataWriter.h>
#include <vtkXMLPolyDataWriter.h>
#include <vtkXMLUnstructuredGridWriter.h>
#include <vtk_zlib.h>

#ifdef NPR_USE_OPENVDB
#include <nprOpenVDB.h>
#include <openvdb/tools/LevelSetSphere.h>
#endif

#include <cmath>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

namespace model_files
{
/// The sphere's centre; all three coordinates differ, so that swapped axes show.
inline constexpr double Center[3] = { 10.0, 20.0, 30.0 };
inline constexpr double Radius = 1.0;
inline constexpr double IsoValue = 5.0;

struct GoodFile
{
  std::string Path;
  bool IsVolume = false;
};

inline void WriteText(const std::string& path, const std::string& text)
{
  std::ofstream(path, std::ios::binary) << text;
}

inline std::string ReadText(const std::string& path)
{
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

inline vtkSmartPointer<vtkPolyData> MakeSphere()
{
  vtkNew<vtkSphereSource> source;
  source->SetCenter(Center[0], Center[1], Center[2]);
  source->SetRadius(Radius);
  source->SetThetaResolution(24);
  source->SetPhiResolution(16);
  source->Update();
  return source->GetOutput();
}

/// Values fall from 10 at the centre to 5 at the sphere.
inline vtkSmartPointer<vtkImageData> MakeBall(bool atOrigin = false)
{
  const int size[3] = { 21, 25, 29 };
  const double spacing[3] = { 0.15, 0.125, 0.1 };
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size);
  image->SetSpacing(spacing);
  double middle[3];
  double origin[3] = { 0.0, 0.0, 0.0 };
  for (int i = 0; i < 3; ++i)
  {
    middle[i] = 0.5 * (size[i] - 1) * spacing[i];
    origin[i] = atOrigin ? 0.0 : Center[i] - middle[i];
    middle[i] += origin[i];
  }
  image->SetOrigin(origin);
  image->AllocateScalars(VTK_FLOAT, 1);
  auto values = static_cast<float*>(image->GetScalarPointer());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double point[3];
    image->GetPoint(i, point);
    const double distance =
      std::hypot(point[0] - middle[0], point[1] - middle[1], point[2] - middle[2]);
    values[i] = static_cast<float>(10.0 - 5.0 * distance / Radius);
  }
  image->GetPointData()->GetScalars()->SetName("Density");
  return image;
}

template<typename Writer>
std::string WriteWith(const std::string& path, vtkDataObject* data)
{
  vtkNew<Writer> writer;
  writer->SetFileName(path.c_str());
  writer->SetInputData(data);
  writer->Write();
  return path;
}

inline void WriteGzip(const std::string& path, const std::string& bytes)
{
  gzFile stream = gzopen(path.c_str(), "wb");
  gzwrite(stream, bytes.data(), static_cast<unsigned int>(bytes.size()));
  gzclose(stream);
}

/// OBJ with texture coordinates, and optionally a material with a texture.
inline void WriteOBJ(const std::string& path, vtkPolyData* surface, const std::string& material)
{
  std::ostringstream text;
  if (!material.empty())
  {
    text << "mtllib " << material << "\nusemtl red\n";
  }
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    const double* p = surface->GetPoint(i);
    text << "v " << p[0] << " " << p[1] << " " << p[2] << "\n";
    text << "vt " << p[0] - Center[0] << " " << p[1] - Center[1] << "\n";
  }
  vtkNew<vtkIdList> cell;
  for (vtkIdType i = 0; i < surface->GetNumberOfPolys(); ++i)
  {
    surface->GetPolys()->GetCellAtId(i, cell);
    text << "f";
    for (vtkIdType j = 0; j < cell->GetNumberOfIds(); ++j)
    {
      text << " " << cell->GetId(j) + 1 << "/" << cell->GetId(j) + 1;
    }
    text << "\n";
  }
  WriteText(path, text.str());
}

inline void WriteGLTF(const std::string& path, vtkPolyData* surface)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(surface);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(1.0, 0.0, 0.5);
  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  vtkNew<vtkRenderWindow> window;
  window->AddRenderer(renderer);
  vtkNew<vtkGLTFExporter> exporter;
  exporter->SetRenderWindow(window);
  exporter->SetFileName(path.c_str());
  exporter->InlineDataOn();
  exporter->Write();
}

inline void WriteNRRD(const std::string& path, vtkImageData* image)
{
  const int* size = image->GetDimensions();
  const double* spacing = image->GetSpacing();
  const double* origin = image->GetOrigin();
  std::ostringstream text;
  text << "NRRD0004\ntype: float\ndimension: 3\nsizes: " << size[0] << " " << size[1] << " "
       << size[2] << "\nspacings: " << spacing[0] << " " << spacing[1] << " " << spacing[2]
       << "\nspace origin: (" << origin[0] << "," << origin[1] << "," << origin[2]
       << ")\nendian: little\nencoding: raw\n\n";
  text.write(static_cast<const char*>(image->GetScalarPointer()),
    static_cast<std::streamsize>(image->GetNumberOfPoints() * sizeof(float)));
  WriteText(path, text.str());
}

/// Writes all of them to the folder, their names starting with prefix.
inline std::vector<GoodFile> WriteGoodFiles(const std::string& folder, const std::string& prefix)
{
  std::vector<GoodFile> files;
  const std::string base = folder + "/" + prefix;
  const auto sphere = MakeSphere();
  const auto add = [&](const std::string& path, bool isVolume = false) {
    files.push_back({ path, isVolume });
  };

  WriteOBJ(base + "Plain.obj", sphere, "");
  add(base + "Plain.obj");
  vtkNew<vtkImageData> texture;
  texture->SetDimensions(4, 4, 1);
  texture->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  texture->GetPointData()->GetScalars()->Fill(200);
  WriteWith<vtkPNGWriter>(base + "Texture.png", texture);
  WriteText(base + "Material.mtl",
    "newmtl red\nKd 1 0 0\nKs 1 1 1\nNs 20\nd 0.5\nmap_Kd " + prefix + "Texture.png\n");
  WriteOBJ(base + "Material.obj", sphere, prefix + "Material.mtl");
  add(base + "Material.obj");

  vtkNew<vtkPolyData> coloured;
  coloured->ShallowCopy(sphere);
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetName("RGB");
  colours->SetNumberOfComponents(3);
  colours->SetNumberOfTuples(sphere->GetNumberOfPoints());
  colours->Fill(99);
  coloured->GetPointData()->SetScalars(colours);
  for (const bool binary : { false, true })
  {
    vtkNew<vtkPLYWriter> writer;
    const std::string path = base + (binary ? "Binary.ply" : "Ascii.ply");
    writer->SetFileName(path.c_str());
    writer->SetFileType(binary ? VTK_BINARY : VTK_ASCII);
    writer->SetArrayName("RGB");
    writer->SetInputData(coloured);
    writer->Write();
    add(path);

    vtkNew<vtkSTLWriter> stl;
    const std::string stlPath = base + (binary ? "Binary.stl" : "Ascii.stl");
    stl->SetFileName(stlPath.c_str());
    stl->SetFileType(binary ? VTK_BINARY : VTK_ASCII);
    stl->SetInputData(sphere);
    stl->Write();
    add(stlPath);
  }
  WriteGzip(base + "Packed.ply.gz", ReadText(base + "Binary.ply"));
  add(base + "Packed.ply.gz");

  add(WriteWith<vtkXMLPolyDataWriter>(base + "Surface.vtp", sphere));
  add(WriteWith<vtkPolyDataWriter>(base + "Surface.vtk", sphere));
  vtkNew<vtkAppendFilter> append;
  append->SetInputData(sphere);
  append->Update();
  add(WriteWith<vtkXMLUnstructuredGridWriter>(base + "Grid.vtu", append->GetOutput()));
  WriteGLTF(base + "Scene.gltf", sphere);
  add(base + "Scene.gltf");

  const auto ball = MakeBall();
  add(WriteWith<vtkXMLImageDataWriter>(base + "Ball.vti", ball), true);
  add(WriteWith<vtkDataSetWriter>(base + "Ball.vtk", ball), true);
  add(WriteWith<vtkMetaImageWriter>(base + "Ball.mha", ball), true);
  add(WriteWith<vtkMetaImageWriter>(base + "Ball.mhd", ball), true);
  WriteNRRD(base + "Ball.nrrd", ball);
  add(base + "Ball.nrrd", true);

  // NIfTI's axes: y is mirrored (a left-handed picture), and the matrix places the ball.
  const auto placed = MakeBall(true);
  vtkNew<vtkMatrix4x4> matrix;
  matrix->SetElement(1, 1, -1.0);
  for (int i = 0; i < 3; ++i)
  {
    const double half = 0.5 * (placed->GetDimensions()[i] - 1) * placed->GetSpacing()[i];
    matrix->SetElement(i, 3, Center[i] - (i == 1 ? -half : half));
  }
  for (const char* name : { "Ball.nii", "Ball.nii.gz" })
  {
    vtkNew<vtkNIFTIImageWriter> writer;
    writer->SetFileName((base + name).c_str());
    writer->SetInputData(placed);
    writer->SetSFormMatrix(matrix);
    writer->Write();
    add(base + name, true);
  }
#ifdef NPR_USE_OPENVDB
  openvdb::initialize();
  const auto grid = openvdb::tools::createLevelSetSphere<openvdb::FloatGrid>(
    Radius, openvdb::Vec3f(Center[0], Center[1], Center[2]), 0.1f);
  grid->setName("surface");
  openvdb::io::File(base + "Sphere.vdb").write({ grid });
  add(base + "Sphere.vdb"); // a level set needs no iso value
#endif
  return files;
}

/// Volume inside of the surface, by the order of its polygons: positive if they face outwards.
inline double SignedVolume(vtkPolyData* surface)
{
  double volume = 0.0;
  vtkNew<vtkIdList> cell;
  for (vtkIdType i = 0; i < surface->GetNumberOfPolys(); ++i)
  {
    surface->GetPolys()->GetCellAtId(i, cell);
    double p[3][3];
    for (vtkIdType j = 2; j < cell->GetNumberOfIds(); ++j)
    {
      surface->GetPoint(cell->GetId(0), p[0]);
      surface->GetPoint(cell->GetId(j - 1), p[1]);
      surface->GetPoint(cell->GetId(j), p[2]);
      for (auto& corner : p)
      {
        for (int k = 0; k < 3; ++k)
        {
          corner[k] -= Center[k];
        }
      }
      volume += vtkMath::Determinant3x3(p[0], p[1], p[2]) / 6.0;
    }
  }
  return volume;
}
}

#endif
