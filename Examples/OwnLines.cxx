// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A kind of line of your own in one page: where the surface is straight across the line of sight.
// Once added by its name, styles draw it as they draw the built-in kinds.
#include <nprViewQuantities.h>
#include <vtkNPRIllustration.h>
#include <vtkNPRIllustrationStyle.h>
#include <vtkNPRLineDefinition.h>
#include <vtkNPROffscreen.h>
#include <vtkNPRSampleSource.h>

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPNGWriter.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <vector>

// The radial curvature kr is that along w, towards the eye. The curvatures along any two tangents
// at right angles have the sum k1 + k2, so the curvature across w is k1 + k2 - kr.
class StraightAcross : public vtkNPRLineDefinition
{
public:
  static StraightAcross* New();
  vtkTypeMacro(StraightAcross, vtkNPRLineDefinition);

  const char* GetName() const override { return "straight-across"; }
  const char* GetDescription() const override { return "where nothing bends across the view"; }
  bool IsViewDependent() const override { return true; }

  // What must be there, and which filter makes it: the arrays behind kr and H.
  std::vector<RequiredArray> GetRequiredArrays() const override
  {
    std::vector<RequiredArray> arrays = npr::FindViewQuantity("kr")->Arrays;
    const auto& more = npr::FindViewQuantity("H")->Arrays;
    arrays.insert(arrays.end(), more.begin(), more.end());
    return arrays;
  }

  // The line is where this is 0 ...
  bool HasField() const override { return true; }
  void EvaluateField(const npr::LineSurface& surface, const npr::LineView& view, vtkIdType begin,
    vtkIdType end, float* field) const override
  {
    std::vector<double> mean(end - begin);
    npr::FindViewQuantity("H")->Evaluate(
      surface, view, npr::PointSpan::Range(begin, end), 0, mean.data());
    npr::EvaluateRadialCurvature(surface, view, begin, end, field + begin);
    for (vtkIdType i = begin; i < end; ++i)
    {
      field[i] = static_cast<float>(2.0 * mean[i - begin]) - field[i];
    }
  }

  // ... and this is above 0: here, where the surface is seen at an angle. Strength rises to 1.
  bool HasTest() const override { return true; }
  void EvaluateTest(const npr::LineSurface& surface, const npr::LineView& view, const Index* points,
    vtkIdType count, const float*, float* test) const override
  {
    std::vector<double> cosine(count);
    std::vector<double> sine(count);
    npr::EvaluateRadialDerivative(
      surface, view, npr::PointSpan::List(points, count), cosine.data(), sine.data(), nullptr);
    for (vtkIdType i = 0; i < count; ++i)
    {
      test[i] = static_cast<float>(std::min(5.0 * cosine[i], (sine[i] - 0.3) / 0.3));
    }
  }
};
vtkStandardNewMacro(StraightAcross);

int main(int argc, char* argv[])
{
  vtkNPROffscreen::Setup();
  vtkNew<vtkNPRSampleSource> sample;
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sample->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(800, 600);
  window->AddRenderer(renderer);
  renderer->ResetCamera();

  vtkNew<StraightAcross> definition;
  vtkNPRLineDefinition::AddKind(definition);

  vtkNew<vtkNPRIllustrationStyle> style;
  style->LoadString(R"({ "shading": { "style": "paper" }, "lines": [
    { "type": "contours", "width": 3 },
    { "type": "straight-across", "width": 2, "color": "#a02020", "spline": "b-spline",
      "smoothing": 6, "taper": true, "minimum_length": 26 } ] })");
  vtkNew<vtkNPRIllustration> illustration;
  illustration->SetRenderer(renderer);
  illustration->SetStyle(style);
  illustration->Apply();
  window->Render();

  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(window);
  grab->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(grab->GetOutputPort());
  writer->SetFileName(argc > 1 ? argv[1] : "OwnLines.png");
  writer->Write();
  return writer->GetErrorCode() == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
