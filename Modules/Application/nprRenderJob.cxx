// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprRenderJob.h"

#include "nprImageFile.h"
#include "nprReporter.h"
#include "vtkNPRDrawingStyle.h"
#include "vtkNPRDrawingWriter.h"
#include "vtkNPRIllustration.h"
#include "vtkNPRIllustrationStyle.h"
#include "vtkNPROffscreen.h"

#include <vtkErrorCode.h>
#include <vtkImageData.h>
#include <vtkPolyData.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>

namespace npr
{
namespace
{
// Of the picture's shorter side, a tenth of a line's width: what is smaller is the mesh's shape.
// Drawings to scale are as exact as the writer's default.
constexpr double ToleranceOfPen = 0.0003;
constexpr int FinenessOfTones = 2;        // times as many pixels each way
constexpr int LargestSideOfTones = 16384; // that graphics have
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkRenderWindow> MakeWindow(Reporter& reporter, const std::array<int, 2>& size)
{
  // Which class New() gives is settled by Setup().
  const bool good = vtkNPROffscreen::Setup();
  reporter.DropVTKErrors();
  if (!good)
  {
    throw CommandError(RenderError, vtkNPROffscreen::GetErrorMessage());
  }
  auto window = vtkSmartPointer<vtkRenderWindow>::New();
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(4);
  window->SetSize(size[0], size[1]);
  return window;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> GrabImage(vtkRenderWindow* window, Reporter& reporter)
{
  window->Render();
  reporter.ThrowOnVTKError(RenderError);
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(window);
  grab->SetInputBufferTypeToRGB();
  grab->ReadFrontBufferOff();
  grab->ShouldRerenderOff();
  grab->Update();
  reporter.ThrowOnVTKError(RenderError);
  return grab->GetOutput();
}

//------------------------------------------------------------------------------
RenderJob::RenderJob(Reporter& reporter, const std::array<int, 2>& size, bool withPixels)
  : Output(reporter),
    Window(withPixels ? MakeWindow(reporter, size) : vtkSmartPointer<vtkRenderWindow>::New())
{
  this->Window->SetOffScreenRendering(1);
  this->Window->SetSize(size[0], size[1]);
  this->Window->AddRenderer(this->Renderer);
  this->Illustration->SetRenderer(this->Renderer);
  reporter.Watch(this->Illustration, "preparing");
}

RenderJob::~RenderJob() = default;

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> RenderJob::DrawWithoutPaper()
{
  // What a pixel shows of the paper is the difference between black and white paper. This holds
  // for whatever draws there, blended in whichever way.
  this->Renderer->GradientBackgroundOff();
  this->Renderer->SetBackground(0.0, 0.0, 0.0);
  const vtkSmartPointer<vtkImageData> onBlack = GrabImage(this->Window, this->Output);
  this->Renderer->SetBackground(1.0, 1.0, 1.0);
  const vtkSmartPointer<vtkImageData> onWhite = GrabImage(this->Window, this->Output);

  vtkNew<vtkImageData> image;
  image->SetDimensions(onBlack->GetDimensions());
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  const auto* black = static_cast<const unsigned char*>(onBlack->GetScalarPointer());
  const auto* white = static_cast<const unsigned char*>(onWhite->GetScalarPointer());
  auto* pixel = static_cast<unsigned char*>(image->GetScalarPointer());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i, black += 3, white += 3, pixel += 4)
  {
    const int paper =
      std::max({ white[0] - black[0], white[1] - black[1], white[2] - black[2], 0 });
    const int opacity = 255 - paper;
    for (int c = 0; c < 3; ++c)
    {
      pixel[c] = static_cast<unsigned char>(
        opacity > 0 ? std::min(255, (black[c] * 255 + opacity / 2) / opacity) : 0);
    }
    pixel[3] = static_cast<unsigned char>(opacity);
  }
  return image;
}

//------------------------------------------------------------------------------
void RenderJob::Apply(vtkNPRIllustrationStyle* style)
{
  this->Illustration->SetStyle(style);
  this->Illustration->Apply();
  // Lines that do not fit the model are no fault of the drawing: they are found before it begins.
  if (this->Illustration->GetNumberOfLineTypes() > 0)
  {
    vtkNew<vtkPolyData> lines;
    this->Illustration->GetLines(lines);
  }
  this->Output.ThrowOnVTKError(InputError);
  this->Output.StartClock();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> RenderJob::Draw()
{
  return GrabImage(this->Window, this->Output);
}

//------------------------------------------------------------------------------
void RenderJob::AddIllustrationStages()
{
  for (const char* stage : { "prepare", "curvature", "lines", "visibility", "strokes" })
  {
    this->Output.AddStage(stage, this->Illustration->GetStageSeconds(stage));
  }
}

//------------------------------------------------------------------------------
void RenderJob::AddStages(double seconds)
{
  this->AddIllustrationStages();
  // The lines are extracted while the first image is drawn.
  for (const char* stage : { "lines", "visibility", "strokes" })
  {
    seconds -= this->Illustration->GetStageSeconds(stage);
  }
  this->Output.AddStage("draw", seconds);
}

//------------------------------------------------------------------------------
void RenderJob::Run(vtkNPRIllustrationStyle* style, const std::string& file, bool transparent)
{
  this->Apply(style);
  const vtkSmartPointer<vtkImageData> image = transparent ? this->DrawWithoutPaper() : this->Draw();
  this->AddStages(this->Output.StopClock());
  this->Output.BeginStage("write");
  WriteImage(image, file);
  this->Output.EndStage();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> RenderJob::DrawShading(bool transparent)
{
  const auto setLines = [this](bool visible)
  {
    for (int type = 0; type < this->Illustration->GetNumberOfLineTypes(); ++type)
    {
      this->Illustration->SetLineVisibility(type, visible);
    }
  };
  setLines(false);
  const vtkSmartPointer<vtkImageData> image = transparent ? this->DrawWithoutPaper() : this->Draw();
  setLines(true);
  return image;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> RenderJob::DrawTones()
{
  const int* const known = this->Window->GetSize();
  const std::array<int, 2> size = { known[0], known[1] };
  // Not antialiased: where one thing hides another, their mean is neither's tone.
  this->Window->SetMultiSamples(0);
  const int factor =
    std::max(size[0], size[1]) <= LargestSideOfTones / FinenessOfTones ? FinenessOfTones : 1;
  this->Window->SetSize(factor * size[0], factor * size[1]);
  const vtkSmartPointer<vtkImageData> image = this->DrawShading(true);
  this->Window->SetSize(size[0], size[1]);
  return image;
}

//------------------------------------------------------------------------------
void RenderJob::RunDrawing(vtkNPRIllustrationStyle* style, vtkNPRDrawingWriter* writer,
  const std::string& file, DrawingShading shading, bool transparent)
{
  if (shading == DrawingShading::Tones)
  {
    style->SetOutline(vtkNPRIllustrationStyle::NoOutline); // it is no tone
  }
  this->Apply(style);
  if (shading != DrawingShading::None)
  {
    shading == DrawingShading::Image ? writer->SetImage(this->DrawShading(transparent))
                                     : writer->SetTones(this->DrawTones());
    this->Output.AddStage("shade", this->Output.StopClock());
    this->Window->Finalize(); // no more pixels: what the graphics hold is free for what follows
  }
  vtkNew<vtkPolyData> strokes;
  this->Illustration->GetStrokes(strokes);
  this->Output.ThrowOnVTKError(RenderError);
  this->AddIllustrationStages();

  this->Output.BeginStage("write");
  vtkNew<vtkNPRDrawingStyle> inks;
  style->GetDrawingStyle(inks, writer->GetShorterSide());
  writer->SetStyle(inks);
  if (writer->GetFit() != vtkNPRDrawingWriter::TRUE_SCALE)
  {
    writer->SetTolerance(ToleranceOfPen * writer->GetShorterSide());
  }
  writer->SetCamera(this->Renderer->GetActiveCamera());
  writer->SetInputData(strokes);
  WriteWhole(file,
    [&](const std::string& partial)
    {
      writer->SetFileName(partial.c_str());
      writer->Write();
      if (writer->GetErrorCode() == vtkErrorCode::UserError)
      {
        // The page has been checked; a picture that is not flat has not.
        this->Output.ThrowOnVTKError(shading == DrawingShading::Tones ? UsageError : OtherError);
      }
      this->Output.DropVTKErrors(); // who writes whole files says it
      return writer->GetErrorCode() == vtkErrorCode::NoError;
    });
  this->Output.EndStage();
}
}
