// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprStyleSection.h"

#include <algorithm>
#include <cmath>

namespace npr
{
namespace
{
std::string Text(double value)
{
  std::string text = std::to_string(value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.')
  {
    text.pop_back();
  }
  return text;
}
}

//------------------------------------------------------------------------------
StyleSection::StyleSection(const Json& object, std::string path)
  : Object(object), Path(std::move(path))
{
  if (!object.is_object())
  {
    throw StyleError((this->Path.empty() ? "the style" : this->Path) + " must be an object { }");
  }
}

//------------------------------------------------------------------------------
void StyleSection::Fail(const std::string& key, const std::string& what) const
{
  throw StyleError(this->Path + "/" + key + " " + what);
}

//------------------------------------------------------------------------------
const StyleSection::Json* StyleSection::Find(const std::string& key)
{
  this->Known.insert(key);
  const auto found = this->Object.find(key);
  return found == this->Object.end() ? nullptr : &*found;
}

//------------------------------------------------------------------------------
void StyleSection::Read(const std::string& key, std::string& value)
{
  if (const Json* json = this->Find(key))
  {
    if (!json->is_string())
    {
      this->Fail(key, "must be a string");
    }
    value = json->get<std::string>();
  }
}

//------------------------------------------------------------------------------
void StyleSection::Read(const std::string& key, bool& value)
{
  if (const Json* json = this->Find(key))
  {
    if (!json->is_boolean())
    {
      this->Fail(key, "must be true or false");
    }
    value = json->get<bool>();
  }
}

//------------------------------------------------------------------------------
void StyleSection::Read(const std::string& key, double& value, double low, double high)
{
  if (const Json* json = this->Find(key))
  {
    const double number = json->is_number() ? json->get<double>() : std::nan("");
    if (!(number >= low && number <= high))
    {
      this->Fail(key, "must be a number from " + Text(low) + " to " + Text(high));
    }
    value = number;
  }
}

//------------------------------------------------------------------------------
void StyleSection::Read(const std::string& key, int& value, int low, int high)
{
  double number = value;
  this->Read(key, number, double(low), double(high));
  if (number != std::floor(number))
  {
    this->Fail(key, "must be a whole number");
  }
  value = static_cast<int>(number);
}

//------------------------------------------------------------------------------
void StyleSection::Read(const std::string& key, Color& value)
{
  if (const Json* json = this->Find(key))
  {
    value = this->ToColor(key, *json);
  }
}

//------------------------------------------------------------------------------
Color StyleSection::ToColor(const std::string& key, const Json& json) const
{
  if (json.is_string())
  {
    try
    {
      return ParseColor(json.get<std::string>());
    }
    catch (const StyleError& error)
    {
      this->Fail(key, std::string("is not a colour: ") + error.what());
    }
  }
  const std::vector<double> numbers = this->ToNumbers(key, json);
  if (numbers.size() != 3 ||
    std::any_of(numbers.begin(), numbers.end(), [](double v) { return v < 0.0 || v > 1.0; }))
  {
    this->Fail(key, "must be a colour: \"#rrggbb\", a name, or three numbers from 0 to 1");
  }
  return { numbers[0], numbers[1], numbers[2] };
}

//------------------------------------------------------------------------------
Parameters StyleSection::ReadOthers()
{
  Parameters others;
  for (const auto& [key, json] : this->Object.items())
  {
    if (this->Known.count(key) == 0)
    {
      if (json.is_string())
      {
        others[key] = json.get<std::string>();
      }
      else
      {
        others[key] = this->ToNumbers(key, json);
      }
    }
  }
  return others;
}

//------------------------------------------------------------------------------
std::string StyleSection::DescribeKeys() const
{
  std::string keys;
  for (const std::string& name : this->Known)
  {
    keys += (keys.empty() ? "" : ", ") + name;
  }
  return keys;
}

//------------------------------------------------------------------------------
void StyleSection::Finish() const
{
  for (const auto& item : this->Object.items())
  {
    if (this->Known.count(item.key()) == 0)
    {
      this->Fail(item.key(), "is not known; the keys here are: " + this->DescribeKeys());
    }
  }
}

//------------------------------------------------------------------------------
std::vector<StyleSection> StyleSection::List(const std::string& key)
{
  std::vector<StyleSection> sections;
  if (const Json* list = this->Find(key))
  {
    if (!list->is_array())
    {
      this->Fail(key, "must be a list [ ]");
    }
    for (std::size_t i = 0; i < list->size(); ++i)
    {
      sections.emplace_back((*list)[i], this->Path + "/" + key + "/" + std::to_string(i));
    }
  }
  return sections;
}

//------------------------------------------------------------------------------
std::vector<double> StyleSection::ToNumbers(const std::string& key, const Json& json) const
{
  std::vector<double> numbers;
  const auto add = [&](const Json& item)
  {
    if (!item.is_number() && !item.is_boolean())
    {
      this->Fail(key, "must be a number, true or false, a text, or a list of numbers");
    }
    numbers.push_back(item.is_boolean() ? double(item.get<bool>()) : item.get<double>());
  };
  if (json.is_array())
  {
    std::for_each(json.begin(), json.end(), add);
  }
  else
  {
    add(json);
  }
  return numbers;
}

//------------------------------------------------------------------------------
void StyleSection::Read(
  const std::string& key, std::array<double, 2>& values, double low, double high)
{
  if (const Json* json = this->Find(key))
  {
    const std::vector<double> numbers =
      json->is_array() ? this->ToNumbers(key, *json) : std::vector<double>();
    if (numbers.size() != 2 ||
      !std::all_of(numbers.begin(), numbers.end(), [&](double v) { return v >= low && v <= high; }))
    {
      this->Fail(key, "must be a list of two numbers from " + Text(low) + " to " + Text(high));
    }
    values = { numbers[0], numbers[1] };
  }
}

//------------------------------------------------------------------------------
void StyleSection::Read(const std::string& key, int& value, const std::vector<std::string>& names)
{
  std::string name;
  this->Read(key, name);
  if (!this->Find(key))
  {
    return;
  }
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
  {
    std::string known;
    for (std::size_t i = 0; i < names.size(); ++i)
    {
      known += (i == 0 ? "\"" : i + 1 < names.size() ? ", \"" : " or \"") + names[i] + "\"";
    }
    this->Fail(key, "must be " + known);
  }
  value = static_cast<int>(found - names.begin());
}
}
