// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRToonStyle.h"

#include "vtkNPRToonFS.h"

#include <vtkDoubleArray.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkShaderProgram.h>
#include <vtkTextureObject.h>

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkNPRToonStyle);

namespace
{
constexpr int MaximumTones = vtkNPRShadingStyle::MaximumSize;
constexpr double DarkestTone = 0.3;

std::vector<double> EvenTones(int count)
{
  if (count == 1)
  {
    return { 1.0 };
  }
  if (count == 3)
  {
    return { DarkestTone, 0.7, 1.0 };
  }
  std::vector<double> tones(count);
  for (int i = 0; i < count; ++i)
  {
    tones[i] = DarkestTone + (1.0 - DarkestTone) * i / (count - 1);
  }
  return tones;
}

// The ramp as red, green and blue of each step.
std::vector<float> Colors(vtkDataArray* ramp, const std::vector<double>& fallback)
{
  std::vector<float> colors;
  if (!ramp || ramp->GetNumberOfTuples() == 0) // it may have been emptied after it was given
  {
    for (double tone : fallback)
    {
      colors.insert(colors.end(), 3, static_cast<float>(tone));
    }
    return colors;
  }
  const bool colored = ramp->GetNumberOfComponents() == 3;
  for (vtkIdType i = 0; i < ramp->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      const double tone = ramp->GetComponent(i, colored ? c : 0);
      colors.push_back(std::isfinite(tone) ? static_cast<float>(tone) : 0.0f);
    }
  }
  return colors;
}

void Upload(vtkTextureObject* texture, vtkOpenGLRenderWindow* window, std::vector<float> colors)
{
  texture->SetContext(window);
  texture->SetMinificationFilter(vtkTextureObject::Nearest);
  texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  texture->Create2DFromRaw(
    static_cast<unsigned int>(colors.size() / 3), 1, 3, VTK_FLOAT, colors.data());
}

std::vector<double> Levels(vtkDataArray* ramp, const std::vector<double>& fallback)
{
  if (!ramp)
  {
    return fallback;
  }
  std::vector<double> levels(static_cast<size_t>(ramp->GetNumberOfTuples()));
  for (size_t i = 0; i < levels.size(); ++i)
  {
    levels[i] = ramp->GetComponent(static_cast<vtkIdType>(i), 0);
  }
  return levels;
}

vtkSmartPointer<vtkDataArray> MakeRamp(const std::vector<double>& levels)
{
  auto ramp = vtkSmartPointer<vtkDoubleArray>::New();
  for (double level : levels)
  {
    ramp->InsertNextValue(level);
  }
  return ramp;
}

const std::vector<double> HardHighlight = { 0.0, 1.0 };
}

//------------------------------------------------------------------------------
vtkNPRToonStyle::vtkNPRToonStyle()
{
  using Values = std::vector<double>;
  this->DeclareParameter(
    { "number_of_tones", "Tones of the diffuse part, where no ramp is given", 1, { 1.0, 256.0 },
      [this](const Values& v) { this->SetNumberOfTones(static_cast<int>(std::lround(v[0]))); },
      [this] { return Values{ static_cast<double>(this->NumberOfTones) }; } });
  this->DeclareParameter({ "smoothing_width", "Width of the borders between tones in pixels", 1,
    { 0.0, 64.0 }, [this](const Values& v) { this->SetSmoothingWidth(v[0]); },
    [this] { return Values{ this->SmoothingWidth }; } });
  this->DeclareParameter({ "diffuse_ramp", "Levels from dark to bright", 0, { 0.0, 1.0 },
    [this](const Values& v) { this->SetDiffuseRamp(v.empty() ? nullptr : MakeRamp(v)); },
    [this] { return Levels(this->DiffuseRamp, EvenTones(this->NumberOfTones)); } });
  this->DeclareParameter(
    { "specular_ramp", "Levels of the highlight from dark to bright", 0, { 0.0, 1.0 },
      [this](const Values& v) { this->SetSpecularRamp(v.empty() ? nullptr : MakeRamp(v)); },
      [this] { return Levels(this->SpecularRamp, HardHighlight); } });
}

//------------------------------------------------------------------------------
vtkNPRToonStyle::~vtkNPRToonStyle() = default;

//------------------------------------------------------------------------------
std::string vtkNPRToonStyle::GetCode()
{
  return vtkNPRToonFS;
}

//------------------------------------------------------------------------------
bool vtkNPRToonStyle::AcceptRamp(vtkDataArray* ramp)
{
  if (ramp &&
    ((ramp->GetNumberOfComponents() != 1 && ramp->GetNumberOfComponents() != 3) ||
      ramp->GetNumberOfTuples() < 1 || ramp->GetNumberOfTuples() > MaximumTones))
  {
    vtkErrorMacro("A ramp needs 1 to " << MaximumTones << " tuples of 1 (levels) or 3 (colours) "
                                       << "components, not " << ramp->GetNumberOfTuples()
                                       << " tuples of " << ramp->GetNumberOfComponents()
                                       << "; the ramp stays as it was.");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkNPRToonStyle::SetDiffuseRamp(vtkDataArray* ramp)
{
  if (ramp != this->DiffuseRamp && this->AcceptRamp(ramp))
  {
    this->DiffuseRamp = ramp;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkDataArray* vtkNPRToonStyle::GetDiffuseRamp()
{
  return this->DiffuseRamp;
}

//------------------------------------------------------------------------------
void vtkNPRToonStyle::SetSpecularRamp(vtkDataArray* ramp)
{
  if (ramp != this->SpecularRamp && this->AcceptRamp(ramp))
  {
    this->SpecularRamp = ramp;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkDataArray* vtkNPRToonStyle::GetSpecularRamp()
{
  return this->SpecularRamp;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkNPRToonStyle::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  for (vtkDataArray* ramp : { this->DiffuseRamp.Get(), this->SpecularRamp.Get() })
  {
    time = ramp ? std::max(time, ramp->GetMTime()) : time;
  }
  return time;
}

//------------------------------------------------------------------------------
void vtkNPRToonStyle::Activate(vtkOpenGLRenderWindow* window)
{
  if (this->DiffuseTexture->GetContext() != window || this->DiffuseTexture->GetHandle() == 0 ||
    this->UploadTime < this->GetMTime())
  {
    Upload(this->DiffuseTexture, window, Colors(this->DiffuseRamp, EvenTones(this->NumberOfTones)));
    Upload(this->SpecularTexture, window, Colors(this->SpecularRamp, HardHighlight));
    this->UploadTime.Modified();
  }
  this->DiffuseTexture->Activate();
  this->SpecularTexture->Activate();
}

//------------------------------------------------------------------------------
void vtkNPRToonStyle::Deactivate()
{
  this->DiffuseTexture->Deactivate();
  this->SpecularTexture->Deactivate();
}

//------------------------------------------------------------------------------
void vtkNPRToonStyle::ReleaseGraphicsResources(vtkWindow* window)
{
  this->DiffuseTexture->ReleaseGraphicsResources(window);
  this->SpecularTexture->ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkNPRToonStyle::SetUniforms(vtkShaderProgram* program)
{
  program->SetUniformi("nprToonDiffuseRamp", this->DiffuseTexture->GetTextureUnit());
  program->SetUniformi("nprToonSpecularRamp", this->SpecularTexture->GetTextureUnit());
  program->SetUniformf("nprToonSmoothing", static_cast<float>(this->SmoothingWidth));
}
