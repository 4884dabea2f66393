// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprImageComparison.h"

#include <vtkErrorCode.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkPNGWriter.h>
#include <vtkRenderWindow.h>
#include <vtkWindowToImageFilter.h>

#include <vtksys/SystemTools.hxx>

#include <cstdlib>
#include <iostream>

namespace npr
{
namespace
{
std::string Argument(const char* flag, int argc, char* argv[])
{
  for (int i = 1; i + 1 < argc; ++i)
  {
    if (std::string(argv[i]) == flag)
    {
      return argv[i + 1];
    }
  }
  return {};
}
}

vtkSmartPointer<vtkImageData> ReadImage(const std::string& fileName)
{
  if (!vtksys::SystemTools::FileExists(fileName, true))
  {
    std::cerr << "There is no file " << fileName << "\n";
    return nullptr;
  }
  vtkNew<vtkPNGReader> reader;
  if (!reader->CanReadFile(fileName.c_str()))
  {
    std::cerr << fileName << " is not a PNG file\n";
    return nullptr;
  }
  reader->SetFileName(fileName.c_str());
  reader->Update();
  if (reader->GetErrorCode() != vtkErrorCode::NoError)
  {
    std::cerr << fileName << " could not be read\n";
    return nullptr;
  }
  return reader->GetOutput();
}

bool WriteImage(vtkImageData* image, const std::string& fileName)
{
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  writer->SetFileName(fileName.c_str());
  writer->Write();
  if (writer->GetErrorCode() != vtkErrorCode::NoError)
  {
    std::cerr << "Could not write " << fileName << ": "
              << vtkErrorCode::GetStringFromErrorCode(writer->GetErrorCode()) << "\n";
    return false;
  }
  return true;
}

int CompareWithBaseline(
  vtkRenderWindow* window, const char* name, int argc, char* argv[], const ImageLimits& limits)
{
  if (window->GetMultiSamples() > 1)
  {
    std::cerr << name << ": the window has " << window->GetMultiSamples()
              << " samples a pixel, which differ from driver to driver. Call SetMultiSamples(0) "
                 "before the first Render().\n";
    return EXIT_FAILURE;
  }
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(window);
  grab->SetInputBufferTypeToRGB();
  grab->ReadFrontBufferOff();
  grab->Update();
  return CompareWithBaseline(grab->GetOutput(), name, argc, argv, limits);
}

int CompareWithBaseline(
  vtkImageData* result, const char* name, int argc, char* argv[], const ImageLimits& limits)
{
  const std::string baselines = Argument("-B", argc, argv);
  const std::string output = Argument("-T", argc, argv);
  if (baselines.empty() || output.empty())
  {
    std::cerr << name << ": give the folder of the baselines by -B and a folder for output by -T\n";
    return EXIT_FAILURE;
  }
  const std::string baselineFile = baselines + "/" + name + ".png";
  const std::string resultFile = output + "/" + name + ".png";
  const std::string pictureFile = output + "/" + name + ".difference.png";
  // What an earlier run left must not be taken for this run's.
  vtksys::SystemTools::RemoveFile(pictureFile);
  vtksys::SystemTools::MakeDirectory(output);
  if (!result || !WriteImage(result, resultFile))
  {
    std::cerr << name << ": there is no result to compare\n";
    return EXIT_FAILURE;
  }
  if (!vtksys::SystemTools::FileExists(baselineFile, true))
  {
    std::cerr << name << ": there is no baseline " << baselineFile
              << "\nLook at the result. If it is right, make it the baseline:\n  cp " << resultFile
              << " " << baselineFile << "\n";
    return EXIT_FAILURE;
  }
  const ImageComparison comparison = CompareImages(ReadImage(baselineFile), result, limits);
  std::cout << name << "\n" << comparison.Report();
  if (comparison.Passes())
  {
    return EXIT_SUCCESS;
  }
  std::cerr << name << ": the picture is not its baseline " << baselineFile << "\n";
  if (comparison.Picture && WriteImage(comparison.Picture, pictureFile))
  {
    std::cerr << "Baseline, result and difference side by side: " << pictureFile
              << "\nLook at it. If the change is wanted, renew the baseline:\n  cp " << resultFile
              << " " << baselineFile << "\n";
  }
  return EXIT_FAILURE;
}
}
