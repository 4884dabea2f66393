// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRShadingStyles.h"

#include "vtkNPRGoochStyle.h"
#include "vtkNPRPhongStyle.h"
#include "vtkNPRSnippetStyle.h"
#include "vtkNPRToonStyle.h"

#include <vtkObjectFactory.h>

#include <iterator>

vtkStandardNewMacro(vtkNPRShadingStyles);

namespace
{
struct Entry
{
  const char* Name;
  const char* Description;
  vtkNPRShadingStyle* (*Create)();
};

template<typename Style>
vtkNPRShadingStyle* Create()
{
  return Style::New();
}

const Entry Entries[] = {
  { "phong", "Smooth shading with highlights, as VTK draws it", &Create<vtkNPRPhongStyle> },
  { "toon", "Cartoon: a few flat tones", &Create<vtkNPRToonStyle> },
  { "gooch", "Technical illustration: from cool to warm", &Create<vtkNPRGoochStyle> },
  { "snippet", "Your own GLSL function", &Create<vtkNPRSnippetStyle> },
};
}

//------------------------------------------------------------------------------
int vtkNPRShadingStyles::GetNumberOfStyles()
{
  return static_cast<int>(std::size(Entries));
}

//------------------------------------------------------------------------------
const char* vtkNPRShadingStyles::GetStyleName(int index)
{
  return index >= 0 && index < GetNumberOfStyles() ? Entries[index].Name : nullptr;
}

//------------------------------------------------------------------------------
const char* vtkNPRShadingStyles::GetStyleDescription(int index)
{
  return index >= 0 && index < GetNumberOfStyles() ? Entries[index].Description : nullptr;
}

//------------------------------------------------------------------------------
vtkNPRShadingStyle* vtkNPRShadingStyles::CreateStyle(const std::string& name)
{
  for (const Entry& entry : Entries)
  {
    if (name == entry.Name)
    {
      return entry.Create();
    }
  }
  return nullptr;
}
