// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprSVGPathText.h"

#include <charconv>
#include <cmath>

namespace npr
{
//------------------------------------------------------------------------------
SVGPathText::SVGPathText(int decimals, std::string& text)
  : Decimals(decimals), Unit(std::llround(std::pow(10.0, decimals))), Text(text)
{
}

//------------------------------------------------------------------------------
void SVGPathText::Add(
  const PagePath& path, std::size_t command, std::size_t commandEnd, std::size_t point)
{
  this->Last.setZero();
  this->LastCommand = 0;
  this->AfterNumber = false;
  Place start = this->Last;
  for (bool isFirst = true; command < commandEnd; ++command)
  {
    const PagePath::Command kind = path.Commands[command];
    const PagePoint* const points = path.Points.data() + point;
    switch (kind)
    {
      case PagePath::MOVE:
        start = this->Round(points[0]);
        this->AddCommand(isFirst ? 'M' : 'm');
        this->AddPlace(start - this->Last);
        this->Last = start;
        break;
      case PagePath::LINE:
      {
        const Place end = this->Round(points[0]);
        // A line without length is drawn only where it is all there is: as a dot.
        const bool isAll = command == 1 && commandEnd == 2;
        if (end != this->Last || isAll || path.Commands[command - 1] == PagePath::MOVE)
        {
          this->AddCommand('l');
          this->AddPlace(end - this->Last);
          this->Last = end;
        }
        break;
      }
      case PagePath::CURVE:
      {
        const Place control1 = this->Round(points[0]);
        const Place control2 = this->Round(points[1]);
        const Place end = this->Round(points[2]);
        this->AddCommand('c');
        this->AddPlace(control1 - this->Last);
        this->AddPlace(control2 - this->Last);
        this->AddPlace(end - this->Last);
        this->Last = end;
        break;
      }
      case PagePath::CLOSE:
        this->AddCommand('z');
        this->Last = start;
        break;
    }
    point += PagePath::GetNumberOfPoints(kind);
    isFirst = false;
  }
}

//------------------------------------------------------------------------------
SVGPathText::Place SVGPathText::Round(const PagePoint& point) const
{
  return { std::llround(point.x() * this->Unit), std::llround(point.y() * this->Unit) };
}

//------------------------------------------------------------------------------
void SVGPathText::AddCommand(char command)
{
  // A letter holds for what follows, too.
  if (command != this->LastCommand || command == 'm' || command == 'z')
  {
    this->Text += command;
    this->AfterNumber = false;
  }
  this->LastCommand = command;
}

void SVGPathText::AddPlace(const Place& place)
{
  this->AddNumber(place.x());
  this->AddNumber(place.y());
}

//------------------------------------------------------------------------------
void SVGPathText::AddNumber(long long number)
{
  // Trailing zeros behind the point say nothing.
  long long value = std::llabs(number);
  int decimals = value == 0 ? 0 : this->Decimals;
  while (decimals > 0 && value % 10 == 0)
  {
    value /= 10;
    --decimals;
  }
  char digits[24];
  const char* const end = std::to_chars(digits, digits + sizeof(digits), value).ptr;
  const int whole = static_cast<int>(end - digits) - decimals; // digits before the point

  // A sign parts numbers, and so does a second point.
  if (number < 0)
  {
    this->Text += '-';
  }
  else if (this->AfterNumber && !(this->AfterPoint && whole <= 0))
  {
    this->Text += ' ';
  }
  this->Text.append(digits, whole > 0 ? whole : 0);
  if (decimals > 0)
  {
    this->Text += '.';
    this->Text.append(whole < 0 ? -whole : 0, '0');
    this->Text.append(static_cast<const char*>(digits) + (whole > 0 ? whole : 0), end);
  }
  this->AfterNumber = true;
  this->AfterPoint = decimals > 0;
}
}
