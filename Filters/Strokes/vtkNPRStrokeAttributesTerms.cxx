// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// The factors of widths and opacities by arrays.
#include "vtkNPRStrokeAttributes.h"

#include "nprArrayNames.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <cmath>

namespace
{
double GetValue(vtkDataArray* array, vtkIdType point)
{
  const int components = array->GetNumberOfComponents();
  if (components == 1)
  {
    return array->GetComponent(point, 0);
  }
  double sum = 0.0;
  for (int c = 0; c < components; ++c)
  {
    sum += array->GetComponent(point, c) * array->GetComponent(point, c);
  }
  return std::sqrt(sum);
}
}

//------------------------------------------------------------------------------
int vtkNPRStrokeAttributes::AddTerm(int attribute, const char* array)
{
  if ((attribute != WIDTH && attribute != OPACITY) || !array || !*array)
  {
    vtkErrorMacro("a term must be of WIDTH or OPACITY, and by the name of a point array");
    return -1;
  }
  Term term;
  term.Attribute = attribute;
  term.Array = array;
  this->Terms.push_back(term);
  this->Modified();
  return this->GetNumberOfTerms() - 1;
}

//------------------------------------------------------------------------------
vtkNPRStrokeAttributes::Term* vtkNPRStrokeAttributes::FindTerm(int term)
{
  if (term < 0 || term >= this->GetNumberOfTerms())
  {
    vtkErrorMacro("there is no term " << term << "; there are " << this->GetNumberOfTerms()
                                      << ". Take the number that AddTerm() returns.");
    return nullptr;
  }
  this->Modified();
  return &this->Terms[term];
}

//------------------------------------------------------------------------------
void vtkNPRStrokeAttributes::SetTermRange(int term, double from, double to)
{
  if (!std::isfinite(from) || !std::isfinite(to))
  {
    vtkErrorMacro("the range of a term must be two finite numbers");
  }
  else if (Term* found = this->FindTerm(term))
  {
    found->From = from;
    found->To = to;
  }
}

//------------------------------------------------------------------------------
void vtkNPRStrokeAttributes::SetTermFactors(int term, double atFrom, double atTo)
{
  if (Term* found = this->FindTerm(term))
  {
    const double most = found->Attribute == OPACITY ? 1.0 : 1000.0;
    if (!(atFrom >= 0.0 && atFrom <= most && atTo >= 0.0 && atTo <= most))
    {
      vtkErrorMacro("the factors of term " << term << " must be from 0 to " << most);
      return;
    }
    found->AtFrom = atFrom;
    found->AtTo = atTo;
  }
}

//------------------------------------------------------------------------------
void vtkNPRStrokeAttributes::SetTermShape(int term, int shape)
{
  if (Term* found = this->FindTerm(term))
  {
    found->Shape = shape == SMOOTH ? SMOOTH : LINEAR;
  }
}

//------------------------------------------------------------------------------
void vtkNPRStrokeAttributes::SetTermAverage(int term, bool average)
{
  if (Term* found = this->FindTerm(term))
  {
    found->Average = average;
  }
}

//------------------------------------------------------------------------------
void vtkNPRStrokeAttributes::RemoveAllTerms()
{
  this->Terms.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
bool vtkNPRStrokeAttributes::Uses(const char* array) const
{
  return std::any_of(this->Terms.begin(), this->Terms.end(),
    [array](const Term& term) { return term.Array == array; });
}

//------------------------------------------------------------------------------
bool vtkNPRStrokeAttributes::MultiplyTerm(const Term& term, vtkPolyData* output, float* factors)
{
  vtkDataArray* array = output->GetPointData()->GetArray(term.Array.c_str());
  if (!array)
  {
    std::string names;
    for (int i = 0; i < output->GetPointData()->GetNumberOfArrays(); ++i)
    {
      const char* name = output->GetPointData()->GetArrayName(i);
      names += name ? (names.empty() ? "" : ", ") + std::string(name) : "";
    }
    const std::string wanted = term.Array == npr::names::Shade ? npr::names::Normals
      : term.Array == npr::names::IsophoteDistance
      ? std::string(npr::names::Normals) + "' and '" + npr::names::RadialCurvature +
        "' (vtkNPRFeatureLines::AddQuantity()), with the field data '" + npr::names::LengthScale
      : term.Array;
    vtkErrorMacro("the strokes have no point array '"
      << wanted << "' to take their " << (term.Attribute == WIDTH ? "width" : "opacity")
      << " from; they have: " << names << ".");
    return false;
  }
  double range[2] = { term.From, term.To };
  if (term.From == term.To)
  {
    array->GetFiniteRange(range, array->GetNumberOfComponents() == 1 ? 0 : -1);
  }
  vtkSMPTools::For(0, output->GetNumberOfPoints(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const double value = GetValue(array, i);
        double x = range[0] != range[1] && std::isfinite(value)
          ? std::min(std::max((value - range[0]) / (range[1] - range[0]), 0.0), 1.0)
          : 0.0;
        x = term.Shape == SMOOTH ? x * x * (3.0 - 2.0 * x) : x;
        factors[i] *= static_cast<float>(term.AtFrom + x * (term.AtTo - term.AtFrom));
      }
    });
  return true;
}
