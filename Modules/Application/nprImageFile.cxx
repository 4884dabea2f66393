// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprImageFile.h"

#include "nprReporter.h"

#include <vtkBMPWriter.h>
#include <vtkImageData.h>
#include <vtkImageWriter.h>
#include <vtkJPEGWriter.h>
#include <vtkPNGWriter.h>
#include <vtkPNMWriter.h>
#include <vtkSmartPointer.h>
#include <vtkTIFFWriter.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <string>
#include <system_error>
#include <unistd.h>

namespace npr
{
namespace
{
namespace fs = std::filesystem;

vtkSmartPointer<vtkImageWriter> MakeWriter(const std::string& file)
{
  const std::string extension = ExtensionOf(file);
  if (extension == ".png")
  {
    return vtkSmartPointer<vtkPNGWriter>::New();
  }
  if (extension == ".jpg" || extension == ".jpeg")
  {
    auto writer = vtkSmartPointer<vtkJPEGWriter>::New();
    writer->SetQuality(95);
    return writer;
  }
  if (extension == ".tif" || extension == ".tiff")
  {
    return vtkSmartPointer<vtkTIFFWriter>::New();
  }
  if (extension == ".bmp")
  {
    return vtkSmartPointer<vtkBMPWriter>::New();
  }
  if (extension == ".ppm")
  {
    return vtkSmartPointer<vtkPNMWriter>::New();
  }
  return nullptr;
}

/// While it lives, a signal that ends the program removes the unfinished file first.
class PartialFileGuard
{
public:
  explicit PartialFileGuard(const std::string& path)
  {
    std::strncpy(Path, path.c_str(), sizeof(Path) - 1);
    for (std::size_t i = 0; i < Signals.size(); ++i)
    {
      this->Previous[i] = std::signal(Signals[i], &PartialFileGuard::OnSignal);
    }
  }
  ~PartialFileGuard()
  {
    for (std::size_t i = 0; i < Signals.size(); ++i)
    {
      std::signal(Signals[i], this->Previous[i]);
    }
  }
  PartialFileGuard(const PartialFileGuard&) = delete;
  void operator=(const PartialFileGuard&) = delete;

private:
  static void OnSignal(int number)
  {
    unlink(Path);
    std::signal(number, SIG_DFL);
    std::raise(number);
  }

  static constexpr std::array<int, 3> Signals = { SIGINT, SIGTERM, SIGXFSZ };
  static char Path[4096]; // a signal handler must not touch a std::string
  std::array<void (*)(int), 3> Previous{};
};
char PartialFileGuard::Path[4096];

//------------------------------------------------------------------------------
// The file that links lead to, so that it is written and they stay.
fs::path FollowLinks(fs::path file)
{
  constexpr int mostLinks = 40;
  std::error_code error;
  for (int i = 0; i < mostLinks && fs::is_symlink(file, error); ++i)
  {
    file = file.parent_path() / fs::read_symlink(file, error);
  }
  return file;
}
}

//------------------------------------------------------------------------------
std::string ExtensionOf(const std::string& file)
{
  std::string extension = fs::path(file).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
    [](unsigned char c) { return std::tolower(c); });
  return extension;
}

//------------------------------------------------------------------------------
void CheckWritable(const std::string& file)
{
  std::error_code error;
  const fs::path folder = fs::absolute(fs::path(file), error).parent_path();
  if (error)
  {
    throw CommandError(OutputError,
      file + ": its folder can not be told (" + error.message() + "); name it in full");
  }
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored))
  {
    throw CommandError(OutputError,
      file + ": the folder " + folder.string() + " does not exist; make it first (mkdir -p)");
  }
  if (fs::is_directory(file, ignored))
  {
    throw CommandError(OutputError, file + " is a folder; name a file in it");
  }
  // Drawings are written whole and then moved to their place: that would take a device away.
  if (fs::exists(file, ignored) && !fs::is_regular_file(file, ignored))
  {
    throw CommandError(OutputError, file + " is a device or a pipe; name a file");
  }
  if (access(folder.c_str(), W_OK) != 0 ||
    (fs::exists(file, ignored) && access(file.c_str(), W_OK) != 0))
  {
    throw CommandError(OutputError,
      file + ": cannot be written (" + std::strerror(errno) + "); choose another place");
  }
}

//------------------------------------------------------------------------------
void CheckImageFile(const std::string& file, const std::vector<std::string>& others)
{
  if (!MakeWriter(file))
  {
    std::string known = ".png, .jpg, .tif, .bmp";
    for (const std::string& other : others)
    {
      known += ", " + other;
    }
    throw CommandError(UsageError,
      file + ": unknown kind of image '" + ExtensionOf(file) + "'; write " + known + " or .ppm");
  }
  CheckWritable(file);
}

//------------------------------------------------------------------------------
void CheckTransparency(const std::string& file)
{
  const std::string extension = ExtensionOf(file);
  if (extension != ".png" && extension != ".tif" && extension != ".tiff")
  {
    throw CommandError(UsageError,
      "--background transparent: " + extension +
        " images have no transparency; write .png or .tif, or give the paper a colour");
  }
}

//------------------------------------------------------------------------------
void WriteWhole(const std::string& file, const std::function<bool(const std::string&)>& write)
{
  const fs::path target = FollowLinks(file);
  const fs::path partial = target.parent_path() /
    (".part-" + std::to_string(getpid()) + "-" + fs::path(file).filename().string());
  std::error_code error;
  const PartialFileGuard guard(partial.string());
  const bool good = write(partial.string()) && fs::exists(partial, error);
  if (good)
  {
    fs::rename(partial, target, error);
  }
  if (!good || error)
  {
    const std::string why = error ? error.message() : "no space left, or no permission?";
    fs::remove(partial, error);
    throw CommandError(OutputError, file + ": could not be written (" + why + ")");
  }
}

//------------------------------------------------------------------------------
void WriteImage(vtkImageData* image, const std::string& file)
{
  const vtkSmartPointer<vtkImageWriter> writer = MakeWriter(file);
  writer->SetInputData(image);
  WriteWhole(file,
    [&](const std::string& partial)
    {
      writer->SetFileName(partial.c_str());
      writer->Write();
      return writer->GetErrorCode() == 0;
    });
}
}
