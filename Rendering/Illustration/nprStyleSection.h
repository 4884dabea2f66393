// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprStyleSection_h
#define nprStyleSection_h

#include "nprStyleDocument.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace npr
{
/**
 * @class StyleSection
 * @brief One object of a style document.
 *
 * Remembers which keys were asked for, so that Finish() can refuse the others: a misspelt key must
 * not be ignored. Everything throws a StyleError that names the key.
 */
class StyleSection
{
public:
  using Json = nlohmann::json;

  StyleSection(const Json& object, std::string path);

  [[noreturn]] void Fail(const std::string& key, const std::string& what) const;

  /// Null where there is no such key.
  const Json* Find(const std::string& key);

  /// @name Values
  /// Each stays as it is where there is no such key.
  ///@{
  void Read(const std::string& key, std::string& value);
  void Read(const std::string& key, bool& value);
  void Read(const std::string& key, double& value, double low, double high);
  void Read(const std::string& key, int& value, int low, int high);
  void Read(const std::string& key, Color& value);
  /// Two numbers of which each is in the range.
  void Read(const std::string& key, std::array<double, 2>& values, double low, double high);
  /// One of some names; its index.
  void Read(const std::string& key, int& value, const std::vector<std::string>& names);
  ///@}

  Color ToColor(const std::string& key, const Json& json) const;

  /// All keys that nobody asked for, as parameters for the object that the section describes.
  Parameters ReadOthers();
  /// The keys that have been asked for so far, parted by commas.
  std::string DescribeKeys() const;

  /// Refuses keys that nobody asked for.
  void Finish() const;

  /// The sections of the list under a key; empty when there is none.
  std::vector<StyleSection> List(const std::string& key);

private:
  std::vector<double> ToNumbers(const std::string& key, const Json& json) const;

  const Json& Object;
  std::string Path;
  std::set<std::string> Known;
};
}

#endif
