// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What is wrong with a file is said once, in one line that names the file; and no damage to a file
// brings the program down.
#include "TestModelFiles.h"

#include <vtkNPRModelImporter.h>

#include <vtkCallbackCommand.h>
#include <vtkOutputWindow.h>
#include <vtkStringOutputWindow.h>

#include <sys/stat.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <limits>

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

// Reads a file; returns its error message, empty if it was read. Checks that errors come singly.
std::string ErrorOf(const std::string& path, const double* iso = nullptr)
{
  vtkNew<vtkNPRModelImporter> importer;
  int errors = 0;
  vtkNew<vtkCallbackCommand> count;
  count->SetClientData(&errors);
  count->SetCallback(
    [](vtkObject*, unsigned long, void* data, void*) { ++*static_cast<int*>(data); });
  importer->AddObserver(vtkCommand::ErrorEvent, count);
  importer->SetFileName(path.c_str());
  if (iso)
  {
    importer->SetIsoValue(*iso);
  }
  vtkNew<vtkPolyData> surface;
  const bool isRead = importer->GetSurface(surface);
  const std::string message = importer->GetErrorMessage();
  Expect(errors == (isRead ? 0 : 1), path + " raises " + std::to_string(errors) + " errors");
  Expect(isRead == message.empty(), path + " has a message if and only if it fails");
  Expect(
    isRead || message.find("'" + path + "'") != std::string::npos, path + " is named: " + message);
  Expect(message.find('\n') == std::string::npos, path + " has one line: " + message);
  Expect(message.size() < 700 + path.size(), path + " has a short message: " + message);
  Expect(!isRead || surface->GetNumberOfPolys() + surface->GetNumberOfStrips() > 0,
    path + " has triangles if it is read");
  return message;
}

void ExpectError(const std::string& path, const std::string& word, const double* iso = nullptr)
{
  const std::string message = ErrorOf(path, iso);
  Expect(message.find(word) != std::string::npos,
    path + " should say '" + word + "', but says '" + message + "'");
}

void TestPaths(const std::string& folder)
{
  ExpectError("", "SetFileName");
  ExpectError(folder + "/not there.obj", "no such file");
  ExpectError(folder, "directory");
  model_files::WriteText(folder + "/Bad.doc", "text");
  ExpectError(folder + "/Bad.doc", ".ply.gz");
  std::filesystem::remove(folder + "/BadClosed.obj");
  model_files::WriteText(folder + "/BadClosed.obj", "v 0 0 0\n");
  ::chmod((folder + "/BadClosed.obj").c_str(), 0);
  if (!std::ifstream(folder + "/BadClosed.obj")) // the superuser may read it all the same
  {
    ExpectError(folder + "/BadClosed.obj", "permissions");
  }
  for (int i = 0; i < vtkNPRModelImporter::GetNumberOfFormats(); ++i)
  {
    const std::string path = folder + "/BadEmpty" + vtkNPRModelImporter::GetFormatExtension(i);
    model_files::WriteText(path, "");
    ExpectError(path, "empty");
    model_files::WriteText(path, "this is not what its name says\n");
    const double iso = 1.0;
    Expect(!ErrorOf(path, &iso).empty(), path + " of nonsense fails");
  }
}

void TestMeshes(const std::string& folder)
{
  const std::string obj = folder + "/Bad.obj";
  model_files::WriteText(obj, "v 0 0 0\nv 1 0 0\nv 1 1 0\n");
  ExpectError(obj, "no triangles");
  model_files::WriteText(obj, "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 9\n");
  ExpectError(obj, "line 4");
  model_files::WriteText(obj, "v 0 0 0\nv 1 x 0\n");
  ExpectError(obj, "line 2");
  model_files::WriteText(obj, "v nan nan nan\nv nan 0 0\nv nan 1 0\nf 1 2 3\n");
  ExpectError(obj, "finite");
  model_files::WriteText(obj, "v 2 2 2\nv 2 2 2\nv 2 2 2\nf 1 2 3\n");
  ExpectError(obj, "one place");

  const std::string ply = folder + "/Bad.ply";
  const std::string header = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
                             "property float y\nproperty float z\nelement face 1\n"
                             "property list uchar int vertex_indices\nend_header\n";
  model_files::WriteText(ply, header + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  Expect(ErrorOf(ply).empty(), "the smallest PLY is read");
  model_files::WriteText(ply, header + "0 0 0\n1 0 0\n0 1 0\n");
  ExpectError(ply, "face 0 of 1");
  model_files::WriteText(ply, header + "0 0 0\n1 0\n0 1 0\n3 0 1 2\n");
  ExpectError(ply, "vertex 1 of 3");
  model_files::WriteText(ply, header + "0 0 0\n1 0 0\n0 1 0\n3 0 1 77\n");
  ExpectError(ply, "77");
}

void TestVolumes(const std::string& folder)
{
  const std::string path = folder + "/BadBall.vti";
  const auto ball = model_files::MakeBall();
  model_files::WriteWith<vtkXMLImageDataWriter>(path, ball);
  ExpectError(path, "needs an iso value");
  double iso = 50.0;
  ExpectError(path, "range", &iso);
  iso = std::numeric_limits<double>::quiet_NaN();
  ExpectError(path, "range", &iso);
  ball->GetPointData()->GetScalars()->Fill(3.0);
  model_files::WriteWith<vtkXMLImageDataWriter>(path, ball);
  iso = 3.0;
  ExpectError(path, "the same", &iso);
  vtkNew<vtkImageData> flat;
  flat->SetDimensions(9, 9, 1);
  flat->AllocateScalars(VTK_FLOAT, 1);
  model_files::WriteWith<vtkXMLImageDataWriter>(path, flat);
  ExpectError(path, "9 x 9 x 1", &iso);
}

// Files cut off, and with bytes changed, the same ones each time. Any outcome but a crash is right,
// apart from a file cut off in formats whose readers know how much is to come.
void TestDamage(const std::string& folder)
{
  for (const model_files::GoodFile& file : model_files::WriteGoodFiles(folder, "Damaged"))
  {
    const double* iso = file.IsVolume ? &model_files::IsoValue : nullptr;
    const std::string bytes = model_files::ReadText(file.Path);
    const auto write = [&](const std::string& text)
    {
      model_files::WriteText(file.Path, text);
      return ErrorOf(file.Path, iso);
    };
    int silent = 0;
    for (std::size_t i = 0; i < 20; ++i)
    {
      silent += write(bytes.substr(0, 1 + i * (bytes.size() - 1) / 20)).empty() ? 1 : 0;
    }
    // OBJ is lines without an end, and VTK does not count the numbers in its legacy ASCII files.
    const bool isOpenEnded =
      file.Path.find(".obj") != std::string::npos || file.Path.find(".vtk") != std::string::npos;
    Expect(silent == 0 || isOpenEnded,
      file.Path + " is read " + std::to_string(silent) + " times of 20 although it is cut off");
    std::uint32_t random = 12345;
    const auto next = [&random]() { return (random = random * 1664525u + 1013904223u) >> 8; };
    // OpenVDB takes up to four gigabytes for a damaged text, which is too much for a test.
    const int changes = file.Path.find(".vdb") == std::string::npos ? 60 : 0;
    for (int i = 0; i < changes; ++i)
    {
      std::string changed = bytes;
      // Half of the changes are where the headers are.
      const std::size_t range = i % 2 ? changed.size() : std::min<std::size_t>(changed.size(), 400);
      for (int flips = 1 + i % 4; flips > 0; --flips)
      {
        changed[next() % range] = static_cast<char>(next());
      }
      write(changed);
    }
    model_files::WriteText(file.Path, bytes);
    Expect(ErrorOf(file.Path, iso).empty(), file.Path + " is read again after all");
  }
}
}

int TestModelImporterErrors(int argc, char* argv[])
{
  std::string folder = ".";
  for (int i = 1; i + 1 < argc; ++i)
  {
    folder = std::strcmp(argv[i], "-T") == 0 ? argv[i + 1] : folder;
  }
  vtkNew<vtkStringOutputWindow> window;
  vtkOutputWindow::SetInstance(window);
  TestPaths(folder);
  TestMeshes(folder);
  TestVolumes(folder);
  TestDamage(folder);
  const std::string spilt = window->GetOutput();
  Expect(spilt.empty(), "nothing is printed past the importer: " + spilt);
  vtkOutputWindow::SetInstance(nullptr);
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
