// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRCallbackLines.h"

#include "nprArrayNames.h"
#include "nprViewQuantities.h"

#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <array>
#include <map>
#include <string>

vtkStandardNewMacro(vtkNPRCallbackLines);

class vtkNPRCallbackLines::Internals
{
public:
  vtkSmartPointer<vtkNPRCallbackLines> Observed; // whose observers are asked; null for its own
  vtkSmartPointer<vtkPolyData> Input;

  // During the event.
  const npr::LineSurface* Surface = nullptr;
  npr::LineView View;
  std::map<std::string, vtkSmartPointer<vtkDataArray>> Quantities;

  bool NeedsDerivatives = false; // what was asked for
  // What came back. No test where it is empty.
  std::vector<float> Field;
  std::vector<float> Test;

  // In the order of the surface, which is not that of the input.
  std::vector<float> GetValues(vtkDataArray* array) const
  {
    std::vector<float> values(array->GetNumberOfTuples());
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      const vtkIdType point = this->Surface->GetPointId(static_cast<Index>(i));
      values[i] = static_cast<float>(array->GetComponent(point, 0));
    }
    return values;
  }
};

//------------------------------------------------------------------------------
vtkNPRCallbackLines::vtkNPRCallbackLines() : Internal(new Internals)
{
  this->AddTextParameter("name", "what the lines are called", this->Name);
}

vtkNPRCallbackLines::~vtkNPRCallbackLines() = default;

//------------------------------------------------------------------------------
void vtkNPRCallbackLines::CopyParameters(vtkNPRLineDefinition* other)
{
  this->Superclass::CopyParameters(other);
  if (auto* lines = vtkNPRCallbackLines::SafeDownCast(other))
  {
    this->SetViewDependent(lines->ViewDependent);
    this->Internal->Observed = lines;
  }
}

//------------------------------------------------------------------------------
std::vector<std::string> vtkNPRCallbackLines::GetQuantityNames()
{
  std::vector<std::string> names;
  for (const npr::ViewQuantity& quantity : npr::GetViewQuantities())
  {
    names.emplace_back(quantity.Name);
  }
  return names;
}

//------------------------------------------------------------------------------
vtkDataArray* vtkNPRCallbackLines::GetQuantity(const char* name)
{
  Internals& internal = *this->Internal;
  if (!internal.Surface || !name)
  {
    vtkErrorMacro("Quantities are there during UpdateDataEvent only.");
    return nullptr;
  }
  vtkSmartPointer<vtkDataArray>& values = internal.Quantities[name];
  if (values)
  {
    return values;
  }
  const npr::ViewQuantity* quantity = npr::FindViewQuantity(name);
  if (!quantity)
  {
    values = internal.Input->GetPointData()->GetArray(name);
    if (!values)
    {
      vtkErrorMacro("The lines \"" << this->Name << "\": there is neither a quantity nor a point "
                                   << "array of the input named \"" << name << "\".");
    }
    return values;
  }
  for (const RequiredArray& array : quantity->Arrays)
  {
    if (!internal.Surface->HasArray(array.Name))
    {
      vtkErrorMacro("The lines \"" << this->Name << "\": " << name << " needs the point array \""
                                   << array.Name << "\", which the input does not have. Put "
                                   << array.Maker << " before this filter.");
      return nullptr;
    }
    internal.NeedsDerivatives =
      internal.NeedsDerivatives || std::string(array.Name) == npr::names::CurvatureDerivatives;
  }
  const int components = quantity->Components;
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(this->GetNumberOfPoints());
  vtkSMPTools::For(0, this->GetNumberOfPoints(),
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<double> column(end - begin);
      for (int c = 0; c < components; ++c)
      {
        quantity->Evaluate(
          *internal.Surface, internal.View, npr::PointSpan::Range(begin, end), c, column.data());
        for (vtkIdType i = begin; i < end; ++i)
        {
          array->SetTypedComponent(
            internal.Surface->GetPointId(static_cast<Index>(i)), c, column[i - begin]);
        }
      }
    });
  values = array;
  return values;
}

//------------------------------------------------------------------------------
int vtkNPRCallbackLines::GetNumberOfPoints() const
{
  return this->Internal->Surface ? this->Internal->Surface->GetMesh().GetNumberOfPoints() : 0;
}

//------------------------------------------------------------------------------
void vtkNPRCallbackLines::GetEye(double eye[3]) const
{
  for (int i = 0; i < 3; ++i)
  {
    const bool isPlace = this->Internal->Surface && !this->IsEyeAtInfinity();
    eye[i] = this->Internal->View.Eye[i] +
      (isPlace ? this->Internal->Surface->GetMesh().GetOrigin()[i] : 0.0);
  }
}

//------------------------------------------------------------------------------
bool vtkNPRCallbackLines::IsEyeAtInfinity() const
{
  return this->Internal->View.Perspective == 0.0f;
}

//------------------------------------------------------------------------------
bool vtkNPRCallbackLines::SetField(vtkDataArray* field)
{
  if (!field || field->GetNumberOfTuples() != this->GetNumberOfPoints() ||
    field->GetNumberOfComponents() != 1)
  {
    vtkErrorMacro("The field of the lines \"" << this->Name << "\" must be one number for each of "
                                              << this->GetNumberOfPoints() << " points.");
    return false;
  }
  this->Internal->Field = this->Internal->GetValues(field);
  return true;
}

//------------------------------------------------------------------------------
bool vtkNPRCallbackLines::SetTest(vtkDataArray* test)
{
  if (!test || test->GetNumberOfTuples() != this->GetNumberOfPoints() ||
    test->GetNumberOfComponents() != 1)
  {
    vtkErrorMacro("The test of the lines \"" << this->Name << "\" must be one number for each of "
                                             << this->GetNumberOfPoints() << " points.");
    return false;
  }
  this->Internal->Test = this->Internal->GetValues(test);
  return true;
}

//------------------------------------------------------------------------------
void vtkNPRCallbackLines::BindInput(vtkPolyData* input)
{
  this->Internal->Input = input;
}

//------------------------------------------------------------------------------
std::vector<vtkNPRLineDefinition::RequiredArray> vtkNPRCallbackLines::GetRequiredArrays() const
{
  // All that the input has: nobody knows what the observer will ask for.
  vtkPointData* given = this->Internal->Input ? this->Internal->Input->GetPointData() : nullptr;
  std::vector<RequiredArray> arrays;
  for (const npr::ViewQuantity& quantity : npr::GetViewQuantities())
  {
    for (const RequiredArray& needed : quantity.Arrays)
    {
      vtkDataArray* array = given ? given->GetArray(needed.Name) : nullptr;
      if (!given || (array && array->GetNumberOfComponents() == needed.Components))
      {
        arrays.push_back(needed);
      }
    }
  }
  return arrays;
}

//------------------------------------------------------------------------------
bool vtkNPRCallbackLines::NeedsDerivatives() const
{
  return this->Internal->NeedsDerivatives;
}

//------------------------------------------------------------------------------
void vtkNPRCallbackLines::BeginView(const npr::LineSurface& surface, const npr::LineView& view)
{
  Internals& internal = *this->Internal;
  internal.Field.clear();
  internal.Test.clear();
  internal.NeedsDerivatives = false;
  if (vtkNPRCallbackLines* observed = internal.Observed)
  {
    observed->BindInput(internal.Input);
    observed->BeginView(surface, view);
    internal.Field = std::move(observed->Internal->Field);
    internal.Test = std::move(observed->Internal->Test);
    internal.NeedsDerivatives = observed->Internal->NeedsDerivatives;
    return;
  }
  internal.Surface = &surface;
  internal.View = view;
  this->InvokeEvent(vtkCommand::UpdateDataEvent);
  internal.Surface = nullptr;
  internal.Quantities.clear();
  if (internal.Field.empty())
  {
    vtkErrorMacro("There are no lines \""
      << this->Name << "\", for no observer of UpdateDataEvent has called SetField.");
    internal.Field.assign(surface.GetMesh().GetNumberOfPoints(), 1.0f);
  }
}

//------------------------------------------------------------------------------
void vtkNPRCallbackLines::EvaluateField(
  const npr::LineSurface&, const npr::LineView&, vtkIdType begin, vtkIdType end, float* field) const
{
  std::copy(
    this->Internal->Field.begin() + begin, this->Internal->Field.begin() + end, field + begin);
}

//------------------------------------------------------------------------------
bool vtkNPRCallbackLines::HasTest() const
{
  return !this->Internal->Test.empty();
}

//------------------------------------------------------------------------------
void vtkNPRCallbackLines::EvaluateTest(const npr::LineSurface&, const npr::LineView&,
  const Index* points, vtkIdType count, const float*, float* test) const
{
  for (vtkIdType i = 0; i < count; ++i)
  {
    test[i] = this->Internal->Test[points[i]];
  }
}

//------------------------------------------------------------------------------
void vtkNPRCallbackLines::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Observed: " << this->Internal->Observed.Get() << "\n";
}
