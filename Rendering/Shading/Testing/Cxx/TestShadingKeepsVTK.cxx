// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Everything but the shading comes through: scenes drawn by VTK alone and by the pass with Phong's
// illumination, which is VTK's own, look the same; with toon shading their hues stay.

#include "nprShadingTest.h"

#include "vtkNPRPhongStyle.h"
#include "vtkNPRShadingPass.h"
#include "vtkNPRToonStyle.h"

#include <vtkCellData.h>
#include <vtkCompositePolyDataMapper2.h>
#include <vtkDoubleArray.h>
#include <vtkElevationFilter.h>
#include <vtkFloatArray.h>
#include <vtkGlyph3DMapper.h>
#include <vtkImageData.h>
#include <vtkLookupTable.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataNormals.h>
#include <vtkTexture.h>
#include <vtkTextureMapToSphere.h>

#include <functional>

using namespace npr::testing;

namespace
{
void FourLights(Stage& stage)
{
  vtkLight* scene = stage.AddLight(-3, 2, 4);
  scene->SetDiffuseColor(0.5, 0.4, 0.4);

  vtkLight* camera = stage.AddLight(0.8, 0.2, 1.0);
  camera->SetLightTypeToCameraLight();
  camera->SetIntensity(0.3);

  vtkLight* point = stage.AddLight(2, 2, 2);
  point->SetPositional(1);
  point->SetConeAngle(90.0);
  point->SetAttenuationValues(1.0, 0.1, 0.05);
  point->SetDiffuseColor(0.2, 0.9, 0.3);

  vtkLight* spot = stage.AddLight(-1, -2, 3);
  spot->SetPositional(1);
  spot->SetConeAngle(12.0);
  spot->SetExponent(3.0);
  spot->SetDiffuseColor(0.3, 0.3, 1.0);

  vtkLight* off = stage.AddLight(0, 0, 4);
  off->SwitchOff();
}

void Shine(vtkActor* actor)
{
  actor->GetProperty()->SetAmbient(0.1);
  actor->GetProperty()->SetDiffuse(0.7);
  actor->GetProperty()->SetSpecular(0.4);
  actor->GetProperty()->SetSpecularPower(15.0);
}

vtkNew<vtkElevationFilter> Elevation()
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(1.0);
  sphere->SetThetaResolution(40);
  sphere->SetPhiResolution(40);
  vtkNew<vtkElevationFilter> elevation;
  elevation->SetInputConnection(sphere->GetOutputPort());
  elevation->SetLowPoint(0, -1, 0);
  elevation->SetHighPoint(0, 1, 0);
  return elevation;
}

vtkNew<vtkTexture> Checks()
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(8, 8, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int i = 0; i < 64; ++i)
  {
    auto* p = static_cast<unsigned char*>(image->GetScalarPointer(i % 8, i / 8, 0));
    const bool odd = (i % 8 + i / 8) % 2 != 0;
    p[0] = odd ? 255 : 30;
    p[1] = 120;
    p[2] = odd ? 40 : 250;
  }
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  return texture;
}

struct Scene
{
  std::string Name;
  std::function<void(Stage&)> Build;
};

const std::vector<Scene> Scenes = {
  { "Lights",
    [](Stage& stage)
    {
      Shine(stage.AddSphere());
      FourLights(stage);
    } },
  { "Moved",
    [](Stage& stage)
    {
      vtkActor* actor = stage.AddSphere();
      Shine(actor);
      actor->SetScale(0.5, 0.9, 0.7);
      actor->SetOrientation(20, 30, 40);
      actor->SetPosition(0.2, -0.1, 0.3);
      stage.Renderer->GetActiveCamera()->SetPosition(2, 1, 3);
      FourLights(stage);
    } },
  { "DirectionalLights",
    [](Stage& stage)
    {
      Shine(stage.AddSphere());
      stage.AddLight(1, 1, 1)->SetDiffuseColor(0.8, 0.3, 0.2);
      stage.AddLight(-1, 1, 1)->SetDiffuseColor(0.1, 0.3, 0.6);
    } },
  { "Headlight",
    [](Stage& stage)
    {
      vtkActor* actor = stage.AddSphere();
      actor->GetProperty()->SetColor(0.8, 0.5, 0.3);
    } },
  { "Flat",
    [](Stage& stage)
    {
      vtkActor* actor = stage.AddSphere(16);
      Shine(actor);
      actor->GetProperty()->SetInterpolationToFlat();
      FourLights(stage);
    } },
  { "CellNormals",
    [](Stage& stage)
    {
      vtkNew<vtkSphereSource> sphere;
      sphere->SetRadius(1.0);
      vtkNew<vtkPolyDataNormals> normals;
      normals->SetInputConnection(sphere->GetOutputPort());
      normals->ComputePointNormalsOff();
      normals->ComputeCellNormalsOn();
      Shine(stage.Add(normals->GetOutputPort()));
      FourLights(stage);
    } },
  { "LookupTable",
    [](Stage& stage)
    {
      auto elevation = Elevation();
      vtkActor* actor = stage.Add(elevation->GetOutputPort());
      actor->GetMapper()->SetScalarRange(0, 1);
      FourLights(stage);
    } },
  { "InterpolatedScalars",
    [](Stage& stage)
    {
      auto elevation = Elevation();
      vtkActor* actor = stage.Add(elevation->GetOutputPort());
      actor->GetMapper()->SetScalarRange(0, 1);
      actor->GetMapper()->InterpolateScalarsBeforeMappingOn();
      FourLights(stage);
    } },
  { "VertexColors",
    [](Stage& stage)
    {
      auto elevation = Elevation();
      elevation->Update();
      vtkNew<vtkPolyData> surface;
      surface->ShallowCopy(elevation->GetOutput());
      vtkNew<vtkUnsignedCharArray> colors;
      colors->SetNumberOfComponents(3);
      colors->SetName("Colors");
      for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
      {
        const bool left = surface->GetPoint(i)[0] < 0.0;
        colors->InsertNextTuple3(left ? 250 : 20, 60, left ? 20 : 250);
      }
      surface->GetPointData()->SetScalars(colors);
      vtkNew<vtkPolyDataMapper> mapper;
      mapper->SetInputData(surface);
      vtkNew<vtkActor> actor;
      actor->SetMapper(mapper);
      stage.Renderer->AddActor(actor);
      FourLights(stage);
    } },
  { "CellColors",
    [](Stage& stage)
    {
      auto elevation = Elevation();
      elevation->Update();
      vtkNew<vtkPolyData> surface;
      surface->ShallowCopy(elevation->GetOutput());
      vtkNew<vtkFloatArray> values;
      for (vtkIdType i = 0; i < surface->GetNumberOfCells(); ++i)
      {
        values->InsertNextValue(static_cast<float>(i % 7));
      }
      surface->GetPointData()->SetScalars(nullptr);
      surface->GetCellData()->SetScalars(values);
      vtkNew<vtkPolyDataMapper> mapper;
      mapper->SetInputData(surface);
      mapper->SetScalarRange(0, 6);
      vtkNew<vtkActor> actor;
      actor->SetMapper(mapper);
      stage.Renderer->AddActor(actor);
      FourLights(stage);
    } },
  { "Texture",
    [](Stage& stage)
    {
      vtkNew<vtkPlaneSource> plane;
      plane->SetOrigin(-0.8, -0.8, 0);
      plane->SetPoint1(0.8, -0.8, 0.3);
      plane->SetPoint2(-0.8, 0.8, 0.2);
      vtkActor* actor = stage.Add(plane->GetOutputPort());
      auto texture = Checks();
      actor->SetTexture(texture);
      FourLights(stage);
    } },
  { "Opacity",
    [](Stage& stage)
    {
      stage.Renderer->SetBackground(0.9, 0.9, 0.5);
      vtkActor* front = stage.AddSphere();
      front->SetPosition(0.2, 0, 0.5);
      front->SetScale(0.6);
      front->GetProperty()->SetOpacity(0.4);
      front->GetProperty()->SetColor(1, 0, 0);
      vtkActor* back = stage.AddSphere();
      back->SetScale(0.7);
      back->SetPosition(-0.2, 0, -0.5);
      back->GetProperty()->SetColor(0, 0.4, 1);
      FourLights(stage);
    } },
  { "DepthPeeling",
    [](Stage& stage)
    {
      stage.Renderer->SetUseDepthPeeling(1);
      stage.Renderer->SetMaximumNumberOfPeels(8);
      for (int i = 0; i < 3; ++i)
      {
        vtkActor* actor = stage.AddSphere(60);
        actor->SetScale(0.6);
        actor->SetPosition(0.3 * (i - 1), 0, 0.3 * i);
        actor->GetProperty()->SetOpacity(0.4);
        actor->GetProperty()->SetColor(i == 0, i == 1, i == 2);
      }
      FourLights(stage);
    } },
  { "BackFaces",
    [](Stage& stage)
    {
      vtkNew<vtkSphereSource> bowl;
      bowl->SetRadius(1.0);
      bowl->SetThetaResolution(80);
      bowl->SetPhiResolution(80);
      bowl->SetEndTheta(180);
      vtkActor* actor = stage.Add(bowl->GetOutputPort());
      actor->RotateX(-70);
      Shine(actor);
      vtkNew<vtkProperty> inside;
      inside->SetColor(1.0, 0.6, 0.1);
      actor->SetBackfaceProperty(inside);
      FourLights(stage);
    } },
  { "Unlit",
    [](Stage& stage)
    {
      vtkActor* actor = stage.AddSphere();
      actor->GetProperty()->LightingOff();
      actor->GetProperty()->SetColor(0.2, 0.7, 0.4);
      FourLights(stage);
    } },
  { "Wireframe",
    [](Stage& stage)
    {
      stage.AddSphere(12)->GetProperty()->SetRepresentationToWireframe();
      FourLights(stage);
    } },
  { "Edges",
    [](Stage& stage)
    {
      vtkActor* actor = stage.AddSphere(12);
      actor->GetProperty()->EdgeVisibilityOn();
      actor->GetProperty()->SetEdgeColor(0.9, 0.2, 0.1);
      FourLights(stage);
    } },
  { "Composite",
    [](Stage& stage)
    {
      vtkNew<vtkMultiBlockDataSet> blocks;
      for (int i = 0; i < 3; ++i)
      {
        vtkNew<vtkSphereSource> sphere;
        sphere->SetRadius(0.4);
        sphere->SetCenter(0.6 * (i - 1), 0.2 * i, 0);
        sphere->SetThetaResolution(30);
        sphere->SetPhiResolution(30);
        sphere->Update();
        blocks->SetBlock(static_cast<unsigned int>(i), sphere->GetOutput());
      }
      vtkNew<vtkCompositePolyDataMapper2> mapper;
      mapper->SetInputDataObject(blocks);
      vtkNew<vtkActor> actor;
      actor->SetMapper(mapper);
      Shine(actor);
      stage.Renderer->AddActor(actor);
      FourLights(stage);
    } },
  { "Glyphs",
    [](Stage& stage)
    {
      vtkNew<vtkSphereSource> points;
      points->SetRadius(0.8);
      vtkNew<vtkSphereSource> sphere;
      sphere->SetRadius(0.2);
      vtkNew<vtkGlyph3DMapper> mapper;
      mapper->SetInputConnection(points->GetOutputPort());
      mapper->SetSourceConnection(sphere->GetOutputPort());
      vtkNew<vtkActor> actor;
      actor->SetMapper(mapper);
      Shine(actor);
      stage.Renderer->AddActor(actor);
      FourLights(stage);
    } },
};

// Scenes in which the pass leaves every pixel to VTK.
const std::set<std::string> Untouched = { "Unlit", "Wireframe" };

// Pixels of one hue class: where one of the channels clearly leads.
int Leading(const std::array<int, 3>& color)
{
  for (int c = 0; c < 3; ++c)
  {
    if (color[c] > 1.3 * color[(c + 1) % 3] && color[c] > 1.3 * color[(c + 2) % 3])
    {
      return c;
    }
  }
  return -1;
}
}

int TestShadingKeepsVTK(int argc, char* argv[])
{
  Checker check(argc, argv);
  Stage stage;
  for (const Scene& scene : Scenes)
  {
    stage.Clear();
    scene.Build(stage);
    const Image plain = stage.Render(check.Folder + "/ShadingVTK" + scene.Name + ".png");

    vtkNew<vtkNPRShadingPass> pass;
    stage.Renderer->SetPass(pass);
    const Image phong = stage.Render(check.Folder + "/ShadingPhong" + scene.Name + ".png");
    const double difference = MeanDifference(plain, phong);
    std::cout << scene.Name << ": mean difference " << difference << "\n";
    check(plain.Colors().size() > 1, scene.Name + ": VTK's image is blank");
    check(difference < 1.0, scene.Name + ": Phong differs from VTK's image");

    // Toon shading: another image, unless nothing is shaded; hues stay.
    vtkNew<vtkNPRToonStyle> toon;
    pass->SetStyle(toon);
    const Image toonImage = stage.Render(check.Folder + "/ShadingToon" + scene.Name + ".png");
    const bool untouched = Untouched.count(scene.Name) > 0;
    check((MeanDifference(plain, toonImage) > 1.0) != untouched,
      scene.Name + (untouched ? ": was shaded" : ": was not shaded"));
    int both = 0;
    int same = 0;
    for (int y = 0; y < plain.Height; ++y)
    {
      for (int x = 0; x < plain.Width; ++x)
      {
        const int before = Leading(plain.At(x, y));
        const int after = Leading(toonImage.At(x, y));
        both += before >= 0 && after >= 0;
        same += before >= 0 && before == after;
      }
    }
    check(same >= 0.9 * both, scene.Name + ": hues are lost");

    // Without the pass VTK's image is back.
    stage.Renderer->SetPass(nullptr);
    check(MeanDifference(plain, stage.Render()) == 0.0, scene.Name + ": VTK's image is not back");

    // An excluded prop is VTK's, as soon as the flag changes.
    stage.Renderer->SetPass(pass);
    vtkCollectionSimpleIterator cookie;
    vtkPropCollection* props = stage.Renderer->GetViewProps();
    for (bool excluded : { true, false })
    {
      props->InitTraversal(cookie);
      while (vtkProp* prop = props->GetNextProp(cookie))
      {
        vtkNPRShadingPass::SetExcluded(prop, excluded);
      }
      const double changed = MeanDifference(excluded ? plain : toonImage, stage.Render());
      check(changed < 0.05, scene.Name + ": the EXCLUDED key is not obeyed");
    }
  }

  // Surface and lines in one mapper: lines stay VTK's.
  {
    stage.Clear();
    vtkNew<vtkPolyData> lines;
    vtkNew<vtkPoints> points;
    points->InsertNextPoint(-0.9, -0.9, 0);
    points->InsertNextPoint(0.9, -0.8, 0);
    vtkNew<vtkCellArray> cells;
    cells->InsertNextCell({ 0, 1 });
    lines->SetPoints(points);
    lines->SetLines(cells);
    vtkNew<vtkFloatArray> normals;
    normals->SetNumberOfComponents(3);
    normals->InsertNextTuple3(0, 0.6, 0.8);
    normals->InsertNextTuple3(0, 0.6, 0.8);
    lines->GetPointData()->SetNormals(normals);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(lines);
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetLineWidth(5);
    stage.Renderer->AddActor(actor);
    stage.AddLight(0, 1, 1);
    const Image plain = stage.Render();
    check(plain.Colors().size() > 1, "Lines: VTK's image is blank");
    vtkNew<vtkNPRShadingPass> pass;
    vtkNew<vtkNPRToonStyle> toon;
    pass->SetStyle(toon);
    stage.Renderer->SetPass(pass);
    check(MeanDifference(plain, stage.Render()) == 0.0, "Lines: were shaded");
  }
  return check.Result();
}
