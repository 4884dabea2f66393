// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprVisibilityOptions.h"

#include "nprReporter.h"
#include "vtkNPRIllustration.h"
#include "vtkNPRStrokeVisibility.h"

#include <CLI/CLI.hpp>

namespace npr
{
//------------------------------------------------------------------------------
VisibilityOptions::VisibilityOptions()
  : Visibility(vtkNPRStrokeVisibility::IsAvailable() ? "exact" : "depth")
{
}

//------------------------------------------------------------------------------
void VisibilityOptions::AddTo(CLI::App& command)
{
  this->Given = command
                  .add_option("--visibility", this->Visibility,
                    "How it is found which lines surfaces hide: exact (by the surfaces) or depth "
                    "(by the depth buffer: faster, but lines may break)")
                  ->check(CLI::IsMember({ "exact", "depth" }))
                  ->capture_default_str();
}

//------------------------------------------------------------------------------
void VisibilityOptions::Check() const
{
  if (this->Visibility == "exact" && !vtkNPRStrokeVisibility::IsAvailable())
  {
    throw CommandError(UsageError,
      "--visibility exact: this build has no Embree; take depth, or configure it with "
      "-DNPR_USE_EMBREE=ON");
  }
}

//------------------------------------------------------------------------------
void VisibilityOptions::RefuseFor(const std::string& file) const
{
  if (this->Given && this->Given->count() > 0)
  {
    throw CommandError(UsageError,
      "--visibility is for images; in drawings such as " + file + " it is always exact");
  }
}

//------------------------------------------------------------------------------
void VisibilityOptions::ApplyTo(vtkNPRIllustration* illustration) const
{
  illustration->SetStrokeVisibility(
    this->Visibility == "exact" ? vtkNPRIllustration::EXACT : vtkNPRIllustration::DEPTH_BUFFER);
}
}
