// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprGLTFDocument.h
 * @brief The JSON and the buffers of a glTF file, each access checked.
 *
 * Whatever is not as the specification wants it throws a ModelError that names the element.
 */
#ifndef nprGLTFDocument_h
#define nprGLTFDocument_h

#include <nlohmann/json.hpp>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace npr
{
/// A value in the JSON with its path, such as nodes[3].mesh; perhaps one that is not there.
class GLTFElement
{
public:
  GLTFElement() = default;
  GLTFElement(const nlohmann::json* value, std::string path) : Value(value), Path(std::move(path))
  {
  }
  const std::string& GetPath() const { return this->Path; }
  bool IsThere() const { return this->Value != nullptr; }
  bool Has(const char* member) const { return (*this)[member].IsThere(); }
  /// A member; not there if it, or this, is not there.
  GLTFElement operator[](const char* member) const;
  /// @name Arrays
  /// Those that are not there are empty.
  ///@{
  std::size_t Size() const;
  GLTFElement At(std::size_t index) const;
  ///@}
  std::size_t Whole() const;
  bool Truth() const;
  double Number() const;
  std::vector<double> Numbers(std::size_t count) const;
  std::string Text() const;

private:
  [[noreturn]] void Fail(const char* expected) const;

  const nlohmann::json* Value = nullptr;
  std::string Path;
};

/// What an accessor leads to.
template<typename T>
struct GLTFValues
{
  int Components = 1;
  std::vector<T> Values;
};

class GLTFDocument
{
public:
  /// Reads the JSON; throws where it is none, not glTF 2, or requires an unknown extension.
  explicit GLTFDocument(const std::string& path);

  /// Those that it requires and that change its look alone.
  const std::vector<std::string>& GetIgnoredExtensions() const { return this->IgnoredExtensions; }
  GLTFElement GetRoot() const { return GLTFElement(&this->Root, ""); }
  /// The element of an array of the root that reference, an index, names.
  std::size_t FindIndex(const char* array, const GLTFElement& reference) const;
  GLTFElement Find(const char* array, const GLTFElement& reference) const;

  /// Whole numbers that are normalized become 0 .. 1 (or -1 .. 1) if T is float.
  template<typename T>
  GLTFValues<T> ReadAccessor(const GLTFElement& accessor);
  std::string ReadView(const GLTFElement& view);

  /// @name Uniform resource identifiers
  ///@{
  static bool IsData(const std::string& uri) { return uri.compare(0, 5, "data:") == 0; }
  static std::string DecodeData(const GLTFElement& uri);
  /// The path of the file that a relative one means.
  std::string GetPath(const std::string& uri) const;
  ///@}

private:
  struct Span
  {
    const char* Begin = nullptr;
    std::size_t Size = 0;
  };
  void ReadBinary(const std::string& bytes, std::string& text);
  void CheckExtensions();
  Span GetView(const GLTFElement& view);
  const std::string& GetBuffer(std::size_t index);
  // Adds count tuples, each of so many components, from a view.
  template<typename T>
  void Decode(const GLTFElement& owner, const GLTFElement& view, std::size_t offset,
    std::size_t type, bool isNormalized, std::size_t components, std::size_t count,
    std::vector<T>& values);

  std::string FilePath;
  nlohmann::json Root;
  std::vector<std::string> IgnoredExtensions;
  std::string BinaryChunk;
  bool HasBinaryChunk = false;
  std::map<std::size_t, std::string> Buffers;
};
}

#endif
