// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A good file of each format comes in as the same sphere: its place, its size, its outside, its
// colours.
#include "TestModelFiles.h"

#include <vtkNPRModelImporter.h>

#include <vtkActorCollection.h>
#include <vtkCallbackCommand.h>
#include <vtkMapper.h>
#include <vtkTexture.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <cstring>

namespace
{
int Failures = 0;

void Expect(bool condition, const std::string& what)
{
  if (!condition)
  {
    std::cerr << "FAILED: " << what << "\n";
    ++Failures;
  }
}

bool EndsWith(const std::string& text, const std::string& end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

void CheckFile(const model_files::GoodFile& file)
{
  vtkNew<vtkNPRModelImporter> importer;
  int progress = 0;
  vtkNew<vtkCallbackCommand> count;
  count->SetClientData(&progress);
  count->SetCallback(
    [](vtkObject*, unsigned long, void* data, void*) { ++*static_cast<int*>(data); });
  importer->AddObserver(vtkCommand::ProgressEvent, count);
  importer->SetFileName(file.Path.c_str());
  if (file.IsVolume)
  {
    importer->SetIsoValue(model_files::IsoValue);
  }
  vtkNew<vtkPolyData> surface;
  Expect(importer->GetSurface(surface), file.Path + " is read");
  Expect(std::strlen(importer->GetErrorMessage()) == 0, file.Path + " has no error");
  Expect(
    std::strlen(importer->GetWarnings()) == 0, file.Path + " warns: " + importer->GetWarnings());
  Expect(importer->GetNumberOfParts() == 1, file.Path + " has one part");
  double bounds[6];
  surface->GetBounds(bounds);
  for (int i = 0; i < 6; ++i)
  {
    const double expected = model_files::Center[i / 2] + (i % 2 ? 1.0 : -1.0) * model_files::Radius;
    Expect(std::abs(bounds[i] - expected) < 0.03,
      file.Path + " has the bound " + std::to_string(bounds[i]) + ", not " +
        std::to_string(expected));
  }
  const double volume = model_files::SignedVolume(surface);
  Expect(volume > 3.9 && volume < 4.25, file.Path + " has the volume " + std::to_string(volume));
  const bool hasNormals = surface->GetPointData()->GetNormals() != nullptr;
  Expect(hasNormals || !(file.IsVolume || EndsWith(file.Path, ".vdb")), file.Path + " has normals");
  if (hasNormals)
  {
    double least = 1.0;
    for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
    {
      const double* normal = surface->GetPointData()->GetNormals()->GetTuple3(i);
      const double* p = surface->GetPoint(i);
      double radial[3] = { p[0] - model_files::Center[0], p[1] - model_files::Center[1],
        p[2] - model_files::Center[2] };
      vtkMath::Normalize(radial);
      least = std::min(least, vtkMath::Dot(normal, radial));
    }
    Expect(least > 0.99, file.Path + " has outward normals, at least " + std::to_string(least));
  }
  const bool hasProgress =
    file.IsVolume || EndsWith(file.Path, ".vtp") || EndsWith(file.Path, ".vtu");
  Expect(!hasProgress || progress > 0, file.Path + " shows progress");

  vtkNew<vtkRenderer> renderer;
  Expect(importer->ImportInto(renderer), file.Path + " comes into a renderer");
  Expect(renderer->GetActors()->GetNumberOfItems() == 1, file.Path + " is one actor");
}

vtkActor* OnlyActor(vtkRenderer* renderer)
{
  return renderer->GetActors()->GetLastActor();
}

void TestMaterials(const std::string& base)
{
  vtkNew<vtkNPRModelImporter> importer;
  vtkNew<vtkRenderer> renderer;
  importer->SetFileName((base + "Material.obj").c_str());
  importer->ImportInto(renderer);
  vtkActor* actor = OnlyActor(renderer);
  Expect(actor && actor->GetTexture(), "the OBJ's texture is there");
  Expect(actor && actor->GetProperty()->GetDiffuseColor()[0] == 1.0 &&
      actor->GetProperty()->GetDiffuseColor()[1] == 0.0 &&
      actor->GetProperty()->GetOpacity() == 0.5 && actor->GetProperty()->GetSpecularPower() == 20.0,
    "the OBJ's material is red, half transparent and shiny");

  std::remove((base + "Texture.png").c_str());
  vtkNew<vtkNPRModelImporter> again;
  again->SetFileName((base + "Material.obj").c_str());
  Expect(again->Read() && std::strstr(again->GetWarnings(), "Texture.png"),
    "a missing texture is a warning that names it");
  std::remove((base + "Material.mtl").c_str());
  vtkNew<vtkNPRModelImporter> bare;
  bare->SetFileName((base + "Material.obj").c_str());
  Expect(bare->Read() && std::strstr(bare->GetWarnings(), "Material.mtl"),
    "a missing MTL is a warning that names it");

  vtkNew<vtkRenderer> second;
  importer->SetFileName((base + "Scene.gltf").c_str());
  importer->ImportInto(second);
  actor = OnlyActor(second);
  // glTF is linear: 0.5 there is 0.735 on the screen.
  Expect(actor && std::abs(actor->GetProperty()->GetDiffuseColor()[2] - 0.7354) < 1e-3 &&
      actor->GetProperty()->GetInterpolation() == VTK_PHONG &&
      actor->GetProperty()->GetAmbient() == 0.0 && actor->GetProperty()->GetDiffuse() == 1.0,
    "glTF's base colour is the diffuse colour of a plain material");

  vtkNew<vtkRenderer> third;
  importer->SetFileName((base + "Ascii.ply").c_str());
  importer->ImportInto(third);
  actor = OnlyActor(third);
  Expect(actor && actor->GetMapper()->GetScalarVisibility() &&
      actor->GetMapper()->GetInputAsDataSet()->GetPointData()->GetScalars()->GetComponent(0, 0) ==
        99.0,
    "PLY's point colours are shown");

  importer->SetIsoValue(3.0);
  Expect(importer->Read() && std::strstr(importer->GetWarnings(), "not used"),
    "an iso value for a mesh is a warning");
}

// What VTK's own OBJ reader can not do: negative indices, continued lines, quads, two materials.
void TestOBJ(const std::string& base)
{
  model_files::WriteText(base + "Odd.obj",
    "# two squares\nv 0 0 0\nv 1 0 0\nv 1 +1 0\nv 0 1e0 0\r\nusemtl a\nf -4 -3 \\\n -2 -1\n"
    "usemtl b\nv 0 0 2\nf 1//  2 5\n");
  vtkNew<vtkNPRModelImporter> importer;
  importer->SetFileName((base + "Odd.obj").c_str());
  vtkNew<vtkPolyData> surface;
  Expect(importer->GetSurface(surface) && importer->GetNumberOfParts() == 2 &&
      surface->GetNumberOfPolys() == 2 && surface->GetNumberOfPoints() == 7,
    "an OBJ of two materials is two parts, its corners shared within each");
  double bounds[6];
  surface->GetBounds(bounds);
  Expect(bounds[1] == 1.0 && bounds[3] == 1.0 && bounds[5] == 2.0, "the odd OBJ has its bounds");
}

// Libraries of materials: several in one line, and ones that can not be used, which the surface
// survives.
void TestLibraries(const std::string& base)
{
  const std::string start = "v 0 0 0\nv 1 0 0\nv 1 1 0\nmtllib ";
  const std::string end = "\nusemtl green\nf 1 2 3\n";
  model_files::WriteText(base + "First.mtl", "newmtl red\nKd 1 0 0\n");
  model_files::WriteText(base + "Second.mtl", "newmtl green\nKd 0 1 0\n");
  model_files::WriteText(base + "With space.mtl", "newmtl green\nKd 0 1 0\n");
  const std::string name = base.substr(base.rfind('/') + 1);
  for (const std::string& libraries :
    { name + "First.mtl " + name + "Second.mtl", name + "With space.mtl" })
  {
    model_files::WriteText(base + "Libraries.obj", start + libraries + end);
    vtkNew<vtkNPRModelImporter> importer;
    importer->SetFileName((base + "Libraries.obj").c_str());
    vtkNew<vtkRenderer> renderer;
    Expect(importer->ImportInto(renderer) && std::strlen(importer->GetWarnings()) == 0 &&
        OnlyActor(renderer)->GetProperty()->GetDiffuseColor()[1] == 1.0 &&
        OnlyActor(renderer)->GetProperty()->GetDiffuseColor()[0] == 0.0,
      "the material of 'mtllib " + libraries + "' is green: " + importer->GetWarnings());
  }
  model_files::WriteGzip(base + "Cut.mtl", std::string(1000, 'x') + "newmtl green\n");
  const std::string bytes = model_files::ReadText(base + "Cut.mtl");
  model_files::WriteText(base + "Cut.mtl", bytes.substr(0, bytes.size() / 2));
  model_files::WriteText(base + "Junk.mtl", std::string("\x01\x80\xff\0junk", 8));
  for (const char* library : { "Cut.mtl", "Junk.mtl", "None.mtl" })
  {
    model_files::WriteText(base + "Libraries.obj", start + name + library + end);
    vtkNew<vtkNPRModelImporter> importer;
    importer->SetFileName((base + "Libraries.obj").c_str());
    Expect(importer->Read() && std::strstr(importer->GetWarnings(), "material"),
      std::string("a warning tells of ") + library + ": " + importer->GetErrorMessage());
  }
}

// What other programs begin an ASCII STL with.
void TestSTL(const std::string& base)
{
  const std::string text =
    "solid part\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
    "vertex 0 1 0\nendloop\nendfacet\nendsolid part\n";
  std::string capitals = text;
  std::transform(capitals.begin(), capitals.end(), capitals.begin(),
    [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  for (const std::string& content :
    { text, capitals, "S" + text.substr(1), "  " + text, "\n\t" + text })
  {
    model_files::WriteText(base + "Solid.stl", content);
    vtkNew<vtkNPRModelImporter> importer;
    importer->SetFileName((base + "Solid.stl").c_str());
    vtkNew<vtkPolyData> surface;
    Expect(importer->GetSurface(surface) && surface->GetNumberOfPolys() == 1,
      "an STL that begins with '" + content.substr(0, 8) +
        "' is read: " + importer->GetErrorMessage());
    model_files::WriteText(base + "Solid.stl", content.substr(0, content.size() - 20));
    vtkNew<vtkNPRModelImporter> cut;
    cut->SetFileName((base + "Solid.stl").c_str());
    Expect(!cut->Read() && std::strstr(cut->GetErrorMessage(), "endsolid"),
      "one that begins with '" + content.substr(0, 8) + "' and is cut off is refused");
  }
}

void TestUpAxes()
{
  vtkNew<vtkNPRModelImporter> importer;
  Expect(importer->GetUpAxis() == 1, "y is up where there is no file");
  for (const char* name : { "a.STL", "a.nii", "a.nii.gz", "a.nrrd", "a.nhdr", "a.mha", "a.mhd" })
  {
    importer->SetFileName(name);
    Expect(importer->GetUpAxis() == 2, std::string("z is up in ") + name);
  }
  for (const char* name : { "a.obj", "a.ply", "a.glb", "a.vti", "a.vtk", "a.vdb", "a.doc" })
  {
    importer->SetFileName(name);
    Expect(importer->GetUpAxis() == 1, std::string("y is up in ") + name);
  }
  Expect(
    vtkNPRModelImporter::GetFormatUpAxis(-1) == -1 && vtkNPRModelImporter::GetFormatUpAxis(0) == 1,
    "the table tells which axis is up");
}

// The axes of a picture point where its header says, here x and z exchanged, which mirrors.
void TestDirections(const std::string& base)
{
  const auto ball = model_files::MakeBall();
  const int* size = ball->GetDimensions();
  const double* spacing = ball->GetSpacing();
  const std::string values(static_cast<const char*>(ball->GetScalarPointer()),
    static_cast<std::size_t>(ball->GetNumberOfPoints()) * sizeof(float));
  std::ostringstream meta;
  meta << "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n"
       << "TransformMatrix = 0 0 1 0 1 0 1 0 0\nOffset = 1 2 3\nElementSpacing = " << spacing[0]
       << " " << spacing[1] << " " << spacing[2] << "\nDimSize = " << size[0] << " " << size[1]
       << " " << size[2] << "\nElementType = MET_FLOAT\nElementDataFile = LOCAL\n"
       << values;
  model_files::WriteText(base + "Turned.mha", meta.str());
  std::ostringstream nrrd;
  nrrd << "NRRD0004\ntype: float\ndimension: 3\nspace: left-posterior-superior\nsizes: " << size[0]
       << " " << size[1] << " " << size[2] << "\nspace directions: (0,0," << spacing[0] << ") (0,"
       << spacing[1] << ",0) (" << spacing[2]
       << ",0,0)\nspace origin: (1,2,3)\nendian: little\nencoding: raw\n\n"
       << values;
  model_files::WriteText(base + "Turned.nrrd", nrrd.str());
  for (const char* name : { "Turned.mha", "Turned.nrrd" })
  {
    vtkNew<vtkNPRModelImporter> importer;
    importer->SetFileName((base + name).c_str());
    importer->SetIsoValue(model_files::IsoValue);
    vtkNew<vtkPolyData> surface;
    Expect(importer->GetSurface(surface), std::string(name) + " is read");
    double bounds[6];
    surface->GetBounds(bounds);
    // The ball's middle is half of the picture along each of its axes.
    const double expected[3] = { 1.0 + 0.5 * (size[2] - 1) * spacing[2],
      2.0 + 0.5 * (size[1] - 1) * spacing[1], 3.0 + 0.5 * (size[0] - 1) * spacing[0] };
    for (int i = 0; i < 3; ++i)
    {
      const double middle = 0.5 * (bounds[2 * i] + bounds[2 * i + 1]);
      Expect(std::abs(middle - expected[i]) < 0.01,
        std::string(name) + " lies at " + std::to_string(middle) + ", not " +
          std::to_string(expected[i]));
    }
    Expect(model_files::SignedVolume(surface) > 3.9, std::string(name) + " faces outwards");
  }
}
}

int TestModelImporter(int argc, char* argv[])
{
  std::string folder = ".";
  for (int i = 1; i + 1 < argc; ++i)
  {
    folder = std::strcmp(argv[i], "-T") == 0 ? argv[i + 1] : folder;
  }
  const auto files = model_files::WriteGoodFiles(folder, "Good");
  for (const model_files::GoodFile& file : files)
  {
    CheckFile(file);
  }
  TestMaterials(folder + "/Good");
  TestOBJ(folder + "/Good");
  TestDirections(folder + "/Good");
  TestLibraries(folder + "/Good");
  TestSTL(folder + "/Good");
  TestUpAxes();
  Expect(vtkNPRModelImporter::GetNumberOfFormats() >= 19 &&
      vtkNPRModelImporter::IsFileNameKnown("/a/b.PLY.GZ") &&
      !vtkNPRModelImporter::IsFileNameKnown("/a/b.doc") &&
      !vtkNPRModelImporter::IsFileNameKnown(".ply"),
    "extensions are known in any case");
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
