// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
//
// glTF files of one triangle: a good one, and what happens when each of its parts is wrong. Also
// coordinates that are too large for floats.
#include "TestModelFiles.h"

#include <vtkNPRModelImporter.h>

#include <vtkActorCollection.h>
#include <vtkStringOutputWindow.h>
#include <vtkTexture.h>

#include <cstdint>
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

// A triangle in z = 0, moved to z = 5 by its node, with an image beside it, mirrored along u.
const char* const Good = R"({"asset":{"version":"2.0"},"extensionsRequired":[],"scene":0,
"scenes":[{"nodes":[0]}],
"nodes":[{"children":[1],"translation":[0,0,5]},{"mesh":0,"scale":[2,1,1]}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":2},"indices":1,"mode":4,
"material":0}]}],
"materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0},
"baseColorFactor":[1,1,0.5,1]}}],
"textures":[{"source":0,"sampler":0}],"images":[{"uri":"Triangle%20Image.png"}],
"samplers":[{"wrapS":33648,"wrapT":33071}],
"accessors":[
{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},
{"bufferView":1,"componentType":5123,"count":3,"type":"SCALAR"},
{"bufferView":0,"byteOffset":36,"componentType":5126,"count":3,"type":"VEC2"}],
"bufferViews":[{"buffer":0,"byteLength":60},{"buffer":0,"byteOffset":60,"byteLength":6}],
"buffers":[{"byteLength":66,"uri":"Triangle.bin"}]})";

std::string With(std::string text, const std::string& from, const std::string& to)
{
  const std::size_t at = text.find(from);
  Expect(at != std::string::npos, "the good file has " + from);
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

std::string MakeBytes(std::uint16_t lastCorner)
{
  const float numbers[15] = { 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 3, 0, 0, 1 };
  const std::uint16_t corners[3] = { 0, 1, lastCorner };
  std::string bytes(66, '\0');
  std::memcpy(bytes.data(), numbers, 60);
  std::memcpy(bytes.data() + 60, corners, 6);
  return bytes;
}

void TestGood(const std::string& folder)
{
  const std::string path = folder + "/Triangle.gltf";
  model_files::WriteText(path, Good);
  vtkNew<vtkNPRModelImporter> importer;
  importer->SetFileName(path.c_str());
  vtkNew<vtkPolyData> surface;
  Expect(importer->GetSurface(surface) && std::strlen(importer->GetWarnings()) == 0,
    std::string("the triangle is read: ") + importer->GetErrorMessage() + importer->GetWarnings());
  double bounds[6];
  surface->GetBounds(bounds);
  Expect(surface->GetNumberOfPolys() == 1 && bounds[1] == 2.0 && bounds[3] == 1.0 &&
      bounds[4] == 5.0 && bounds[5] == 5.0,
    "the triangle is moved and scaled");
  vtkNew<vtkRenderer> renderer;
  importer->ImportInto(renderer);
  vtkActor* actor = renderer->GetActors()->GetLastActor();
  Expect(
    actor && actor->GetTexture() && actor->GetTexture()->GetWrap() == vtkTexture::MirroredRepeat,
    "its image is mirrored along u, which leaves the image");
  vtkDataArray* coordinates = surface->GetPointData()->GetTCoords();
  Expect(coordinates && coordinates->GetComponent(1, 0) == 3.0 &&
      coordinates->GetComponent(0, 1) == 1.0 && coordinates->GetComponent(2, 1) == 0.0,
    "its texture coordinates run upwards");

  // The same in one file, in base64.
  std::string coded;
  const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const std::string bytes = MakeBytes(2);
  for (std::size_t i = 0; i < bytes.size(); i += 3) // 66 bytes need no padding
  {
    const auto byte = [&](std::size_t j) { return std::uint32_t(std::uint8_t(bytes[i + j])); };
    const std::uint32_t bits = byte(0) << 16 | byte(1) << 8 | byte(2);
    for (int shift = 18; shift >= 0; shift -= 6)
    {
      coded += digits[bits >> shift & 63u];
    }
  }
  const std::string inside = folder + "/TriangleInside.gltf";
  model_files::WriteText(
    inside, With(Good, "Triangle.bin", "data:application/octet-stream;base64," + coded));
  vtkNew<vtkPolyData> same;
  importer->SetFileName(inside.c_str());
  Expect(importer->GetSurface(same), "data inside of the file are read");
  same->GetBounds(bounds);
  Expect(bounds[1] == 2.0 && bounds[3] == 1.0 && bounds[5] == 5.0, "they are the same");
}

void TestWrong(const std::string& folder)
{
  struct Case
  {
    const char* From;
    const char* To;
    const char* Word;
  };
  const Case cases[] = {
    { "\"2.0\"", "\"1.0\"", "glTF 1.0" },
    { "Triangle.bin", "Not there.bin", "Not there.bin' is missing" },
    { "\"byteLength\":66", "\"byteLength\":6600", "66 of 6600" },
    { "\"buffer\":0,\"byteOffset\":60", "\"buffer\":0,\"byteOffset\":66", "bufferViews[1]" },
    { "\"count\":3", "\"count\":30", "accessors[0]" },
    { "\"count\":3", "\"count\":9007199254740991", "accessors[0]" },
    { "\"scene\":0", "\"scene\":\"hello\"", "scene is not a whole number" },
    { "\"scene\":0", "\"scene\":4", "scenes[4]" },
    { "{\"mesh\":0", "{\"children\":[0],\"mesh\":0", "tree" },
    { "{\"mesh\":0", "{\"mesh\":7", "meshes[7]" },
    { "{\"mesh\":0", "{\"mesh\":-1", "nodes[1].mesh" },
    { "[0,0,5]", "[0,0]", "3 numbers" },
    { "\"POSITION\":0", "\"POSITION\":9", "accessors[9]" },
    { "\"POSITION\":0", "\"POSITION\":2", "instead of" },
    { "\"indices\":1", "\"indices\":0", "wrong type" },
    { "\"nodes\":[0]", "\"nodes\":{}", "array" },
    { "\"extensionsRequired\":[]", "\"extensionsRequired\":[\"KHR_draco_mesh_compression\"]",
      "uses KHR_draco_mesh_compression" },
    { "\"asset\"", "asset", "JSON" },
  };
  const std::string path = folder + "/TriangleWrong.gltf";
  const auto expectError = [&](const std::string& word)
  {
    vtkNew<vtkNPRModelImporter> importer;
    importer->SetFileName(path.c_str());
    const bool isRead = importer->Read();
    const std::string message = importer->GetErrorMessage();
    Expect(!isRead && message.find(word) != std::string::npos,
      "the message should say '" + word + "', but says '" + message + "'");
  };
  for (const Case& wrong : cases)
  {
    model_files::WriteText(path, With(Good, wrong.From, wrong.To));
    expectError(wrong.Word);
  }
  model_files::WriteText(folder + "/TriangleWrong.bin", MakeBytes(77));
  model_files::WriteText(path, With(Good, "Triangle.bin", "TriangleWrong.bin"));
  expectError("point 77");
}

void TestImages(const std::string& folder)
{
  const std::string path = folder + "/TriangleImage.gltf";
  model_files::WriteText(folder + "/Broken.png", "\x89PNG and no more");
  for (const char* image : { "None.png", "Broken.png" })
  {
    model_files::WriteText(path, With(Good, "Triangle%20Image.png", image));
    vtkNew<vtkNPRModelImporter> importer;
    importer->SetFileName(path.c_str());
    vtkNew<vtkRenderer> renderer;
    Expect(importer->ImportInto(renderer), std::string("read without ") + image);
    Expect(std::strstr(importer->GetWarnings(), image), std::string("a warning names ") + image);
    vtkActor* actor = renderer->GetActors()->GetLastActor();
    Expect(actor && !actor->GetTexture(), std::string("no texture from ") + image);
  }
}

// Extensions that only change the look, and shapes that move, are read as far as possible.
void TestLeftOut(const std::string& folder)
{
  const std::string path = folder + "/TriangleLeftOut.gltf";
  const std::pair<std::string, const char*> cases[] = {
    { With(Good, "\"extensionsRequired\":[]", "\"extensionsRequired\":[\"KHR_materials_sheen\"]"),
      "KHR_materials_sheen" },
    { With(Good, "{\"mesh\":0", "{\"mesh\":0,\"skin\":0"), "Skins" },
    { With(Good, "{\"mesh\":0", "{\"mesh\":0,\"weights\":[0,1]"), "Morph" },
  };
  for (const auto& [text, word] : cases)
  {
    model_files::WriteText(path, text);
    vtkNew<vtkNPRModelImporter> importer;
    importer->SetFileName(path.c_str());
    Expect(importer->Read() && std::strstr(importer->GetWarnings(), word),
      std::string(word) + " is a warning, but it is: " + importer->GetWarnings());
  }
}

// Beside 1e8 a float has steps of 8.
void TestFarAway(const std::string& folder)
{
  const std::string points = "100000000.25 0 0\n100000001.5 0 0\n100000000.25 1 0\n";
  const std::string header = "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\n"
                             "property double y\nproperty double z\nelement face 1\n"
                             "property list uchar int vertex_indices\nend_header\n";
  model_files::WriteText(folder + "/Far.ply", header + points + "3 0 1 2\n");
  model_files::WriteText(
    folder + "/Far.obj", "v 100000000.25 0 0\nv 100000001.5 0 0\nv 100000000.25 1 0\nf 1 2 3\n");
  for (const char* name : { "/Far.ply", "/Far.obj" })
  {
    vtkNew<vtkNPRModelImporter> importer;
    importer->SetFileName((folder + name).c_str());
    vtkNew<vtkPolyData> surface;
    Expect(importer->GetSurface(surface), std::string(name) + " is read");
    double bounds[6];
    surface->GetBounds(bounds);
    Expect(bounds[0] == 100000000.25 && bounds[1] == 100000001.5,
      std::string(name) + " keeps its digits: " + std::to_string(bounds[0]) + " " +
        std::to_string(bounds[1]));
  }
}
}

int TestGLTFModels(int argc, char* argv[])
{
  std::string folder = ".";
  for (int i = 1; i + 1 < argc; ++i)
  {
    folder = std::strcmp(argv[i], "-T") == 0 ? argv[i + 1] : folder;
  }
  vtkNew<vtkStringOutputWindow> window;
  vtkOutputWindow::SetInstance(window);
  model_files::WriteText(folder + "/Triangle.bin", MakeBytes(2));
  vtkNew<vtkImageData> image;
  image->SetDimensions(4, 4, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  image->GetPointData()->GetScalars()->Fill(200);
  model_files::WriteWith<vtkPNGWriter>(folder + "/Triangle Image.png", image);
  TestGood(folder);
  TestWrong(folder);
  TestImages(folder);
  TestLeftOut(folder);
  TestFarAway(folder);
  vtkOutputWindow::SetInstance(nullptr);
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
