// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What changes between renders takes effect; GLSL with an error is reported and harmless.

#include "nprShadingTest.h"

#include "vtkNPRGoochStyle.h"
#include "vtkNPRPhongStyle.h"
#include "vtkNPRShadingPass.h"
#include "vtkNPRSnippetStyle.h"
#include "vtkNPRToonStyle.h"

#include <vtkDoubleArray.h>
#include <vtkRenderStepsPass.h>

using namespace npr::testing;

namespace
{
bool Near(const std::array<int, 3>& color, int r, int g, int b)
{
  return std::abs(color[0] - r) <= 1 && std::abs(color[1] - g) <= 1 && std::abs(color[2] - b) <= 1;
}

void TestParameters(Checker& check)
{
  Stage stage;
  stage.AddSphere();
  stage.AddLight(0.3, 0.4, 1.0);
  vtkNew<vtkNPRShadingPass> pass;
  vtkNew<vtkNPRToonStyle> toon;
  pass->SetStyle(toon);
  toon->SetSmoothingWidth(0.0);
  stage.Renderer->SetPass(pass);
  stage.Render();
  const vtkMTimeType code = pass->GetShaderStageMTime();
  toon->SetNumberOfTones(5);
  check(stage.Render().Colors().size() == 6, "NumberOfTones takes no effect");
  vtkNew<vtkDoubleArray> ramp;
  ramp->InsertNextValue(0.1);
  ramp->InsertNextValue(0.8);
  toon->SetDiffuseRamp(ramp);
  check(stage.Render().Colors().size() == 3, "DiffuseRamp takes no effect");
  ramp->InsertNextValue(0.9);
  ramp->Modified();
  check(stage.Render().Colors().size() == 4, "a changed DiffuseRamp takes no effect");
  ramp->Reset();
  ramp->Modified();
  check(stage.Render().Colors().size() == 6, "an emptied ramp does not give way to the tones");
  check(pass->GetShaderStageMTime() == code, "a parameter makes shaders be built anew");

  vtkNew<vtkNPRGoochStyle> gooch;
  pass->SetStyle(gooch);
  check(pass->GetShaderStageMTime() > code, "another style does not make shaders be built anew");
  const Image first = stage.Render();
  gooch->SetBeta(0.0);
  check(MeanDifference(first, stage.Render()) > 1.0, "Beta takes no effect");
  gooch->SetBeta(0.5);
  check(MeanDifference(first, stage.Render()) == 0.0, "Beta does not come back");
  pass->SetStyle(toon);
  check(stage.Render().Colors().size() == 6, "the first style does not come back");
  pass->SetStyle(nullptr);
  const Image none = stage.Render();
  stage.Renderer->SetPass(nullptr);
  check(MeanDifference(none, stage.Render()) == 0.0, "without a style it is not VTK's image");
}

void TestDelegates(Checker& check)
{
  Stage stage;
  stage.AddSphere();
  stage.AddLight(0, 0, 1);
  vtkNew<vtkNPRShadingPass> pass;
  stage.Renderer->SetPass(pass);
  const Image image = stage.Render();
  check(image.At(100, 100)[0] > 200, "the default delegate gives a dark image");
  pass->SetDelegatePass(nullptr);
  check(MeanDifference(image, stage.Render()) == 0.0, "no delegate is not the default one");
  vtkNew<vtkRenderStepsPass> steps;
  pass->SetDelegatePass(steps);
  check(MeanDifference(image, stage.Render()) == 0.0, "another delegate gives another image");
}

// One style in two windows, and one actor in two renderers.
void TestWindows(Checker& check)
{
  Stage one;
  Stage two;
  vtkActor* actor = one.AddSphere();
  one.AddLight(0.3, 0.4, 1.0);
  two.AddSphere();
  two.AddLight(0.3, 0.4, 1.0);
  vtkNew<vtkNPRToonStyle> toon;
  vtkNew<vtkNPRShadingPass> first;
  vtkNew<vtkNPRShadingPass> second;
  first->SetStyle(toon);
  second->SetStyle(toon);
  one.Renderer->SetPass(first);
  two.Renderer->SetPass(second);
  const Image a = one.Render();
  const Image b = two.Render();
  check(MeanDifference(a, b) == 0.0, "the second window differs");
  check(a.Colors().size() > 3, "nothing is drawn");
  check(MeanDifference(a, one.Render()) == 0.0, "the first window differs after the second");
  two.Renderer->SetPass(first);
  check(MeanDifference(b, two.Render()) == 0.0, "one pass does not serve two windows");

  // The same actor with another style at the right.
  vtkNew<vtkRenderer> right;
  right->AddActor(actor);
  right->SetActiveCamera(one.Renderer->GetActiveCamera());
  right->SetViewport(0.5, 0, 1, 1);
  one.Renderer->SetViewport(0, 0, 0.5, 1);
  vtkNew<vtkNPRShadingPass> goochPass;
  vtkNew<vtkNPRGoochStyle> gooch;
  goochPass->SetStyle(gooch);
  right->SetPass(goochPass);
  one.Window->AddRenderer(right);
  for (int i = 0; i < 2; ++i)
  {
    const Image both = one.Render(check.Folder + "/ShadingTwoRenderers.png");
    check(both.At(50, 100)[2] == both.At(50, 100)[0], "the left renderer is not toon shaded");
    check(both.At(150, 100)[2] != both.At(150, 100)[0], "the right renderer is not Gooch's");
  }
}

void TestSnippets(Checker& check)
{
  Stage stage;
  vtkActor* actor = stage.AddSphere();
  actor->GetProperty()->SetColor(0.2, 0.4, 0.6);
  stage.AddLight(0, 0, 1);
  const Image plain = stage.Render();
  vtkNew<vtkNPRShadingPass> pass;
  vtkNew<vtkNPRSnippetStyle> snippet;
  vtkNew<MessageCatcher> messages;
  messages->Watch(pass);
  messages->Watch(snippet);
  pass->SetStyle(snippet);
  stage.Renderer->SetPass(pass);
  check(Near(stage.Render().At(100, 100), 51, 102, 153), "the default snippet is not the colour");

  snippet->SetUniform("tint", 1.0, 0.5, 0.0);
  snippet->SetCode("vec3 nprShade(NprSurface s)\n{\n  return tint;\n}\n");
  check(Near(stage.Render().At(100, 100), 255, 128, 0), "a snippet takes no effect");
  const vtkMTimeType code = snippet->GetCodeMTime();
  snippet->SetUniform("tint", 0.0, 0.5, 1.0);
  check(snippet->GetCodeMTime() == code, "a uniform makes shaders be built anew");
  check(Near(stage.Render().At(100, 100), 0, 128, 255), "a uniform takes no effect");
  snippet->SetCode(
    "vec3 nprShade(NprSurface s)\n{\n  return vec3(scale * amount.y, amount.w, 0.0);\n}\n");
  snippet->SetUniform("scale", 0.5);
  snippet->SetUniform("amount", 0.0, 0.8, 0.0, 0.2);
  check(Near(stage.Render().At(100, 100), 102, 51, 0), "uniforms of other sizes take no effect");
  check(messages->Errors.empty() && messages->Warnings.empty(), "good code is complained about");

  // Syntax, an unknown name, nothing at all: said once, with the line, and VTK's image instead.
  const std::vector<std::string> faulty = { "vec3 nprShade(NprSurface s)\n{\n  return vec3(1.0;\n}",
    "vec3 nprShade(NprSurface s)\n{\n  return nothingOfThisName;\n}", "" };
  for (const std::string& bad : faulty)
  {
    messages->Errors.clear();
    snippet->SetCode(bad);
    const Image fallback = stage.Render();
    stage.Render();
    check(messages->Errors.size() == 1, "an error is not said exactly once");
    check(MeanDifference(plain, fallback) == 0.0, "with an error it is not VTK's image");
    if (messages->Errors.size() == 1)
    {
      const std::string& text = messages->Errors[0];
      std::cout << text << "\n";
      check(text.find("vtkNPRSnippetStyle") != std::string::npos, "the error names no style");
      check(bad.empty() || text.find(":3(") != std::string::npos, "the error names no line");
    }
  }
  snippet->SetCode("vec3 nprShade(NprSurface s) { return vec3(1.0, 0.0, 1.0); }");
  messages->Errors.clear();
  check(Near(stage.Render().At(100, 100), 255, 0, 255), "mended code takes no effect");
  check(messages->Errors.empty(), "mended code is complained about");

  // Good alone, but a name of VTK's shader: reported, not a crash. VTK prints the whole shader,
  // too.
  snippet->SetCode("float specularPowerUniform() { return 1.0; }\n"
                   "vec3 nprShade(NprSurface s) { return vec3(specularPowerUniform()); }");
  const Image clash = stage.Render();
  check(MeanDifference(plain, clash) == 0.0, "with a clash of names it is not VTK's image");
  check(messages->Errors.size() == 1, "a clash of names is not said exactly once");

  // A physically based material has a linear colour: 255 times 0.2, 0.4 and 0.6 to 1/2.2.
  snippet->SetCode("vec3 nprShade(NprSurface s) { return s.diffuse; }");
  actor->GetProperty()->SetInterpolationToPBR();
  check(Near(stage.Render().At(100, 100), 123, 168, 202), "a physically based colour is wrong");
  actor->GetProperty()->SetInterpolationToPhong();

  // Uniforms that can not be.
  messages->Errors.clear();
  snippet->SetUniform("1st", 1.0);
  snippet->SetUniform("gl_x", 1.0);
  snippet->SetUniform("a b", 1.0);
  snippet->SetUniform("", 1.0);
  snippet->SetUniform("x", std::nan(""));
  snippet->SetUniform("x", std::vector<double>(5));
  check(messages->Errors.size() == 6, "impossible uniforms are taken");
}

// The shader leaves out what a material does not have.
void TestMaterials(Checker& check)
{
  Stage stage;
  vtkActor* const actor = stage.AddSphere();
  stage.AddLight(0.3, 0.4, 1.0);
  vtkNew<vtkNPRShadingPass> pass;
  stage.Renderer->SetPass(pass);
  vtkProperty* const property = actor->GetProperty();
  property->SetSpecular(0.0);
  const Image dull = stage.Render();
  property->SetSpecular(0.8);
  const Image shiny = stage.Render();
  check(MeanDifference(dull, shiny) > 1.0, "a highlight does not come");
  property->SetSpecularColor(0.0, 0.0, 0.0);
  check(MeanDifference(dull, stage.Render()) == 0.0, "a black highlight is seen");
  property->SetSpecularColor(1.0, 1.0, 1.0);
  check(MeanDifference(shiny, stage.Render()) == 0.0, "a highlight does not come back");
  property->SetSpecular(0.0);
  check(MeanDifference(dull, stage.Render()) == 0.0, "a highlight does not go");

  vtkNew<vtkProperty> inside;
  inside->SetSpecular(0.8);
  inside->SetSpecularPower(property->GetSpecularPower());
  inside->SetDiffuse(property->GetDiffuse());
  inside->SetAmbient(property->GetAmbient());
  inside->SetColor(property->GetColor());
  actor->SetBackfaceProperty(inside);
  property->FrontfaceCullingOn();
  const Image inner = stage.Render();
  inside->SetSpecular(0.0);
  check(MeanDifference(inner, stage.Render()) > 0.0, "back faces have no highlight of their own");
}

void TestManyLights(Checker& check)
{
  Stage stage;
  stage.AddSphere();
  for (int i = 0; i < 12; ++i)
  {
    stage.AddLight(std::cos(i), std::sin(i), 1.0)->SetIntensity(0.15);
  }
  vtkNew<vtkNPRShadingPass> pass;
  vtkNew<MessageCatcher> messages;
  messages->Watch(pass);
  stage.Renderer->SetPass(pass);
  stage.Render();
  const Image image = stage.Render();
  check(messages->Warnings.size() == 1, "too many lights are not said exactly once");
  check(image.At(100, 100)[0] > 50, "with many lights it is dark");

  // All off, and no light made by itself: VTK's unlit image.
  stage.Renderer->AutomaticLightCreationOff();
  stage.Renderer->RemoveAllLights();
  const Image dark = stage.Render();
  stage.Renderer->SetPass(nullptr);
  check(MeanDifference(dark, stage.Render()) == 0.0, "without lights it is not VTK's image");
}
}

int TestShadingChanges(int argc, char* argv[])
{
  Checker check(argc, argv);
  TestParameters(check);
  TestDelegates(check);
  TestWindows(check);
  TestSnippets(check);
  TestMaterials(check);
  TestManyLights(check);
  return check.Result();
}
