// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprGLTFDocument.h"

#include "nprFileFormats.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <type_traits>

namespace npr
{
namespace
{
constexpr const char* ExportAgain = "; the file is damaged, export it again";

std::string ReadWhole(const std::string& path)
{
  std::ifstream stream(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(stream), {} };
}

std::uint32_t Word(const std::string& bytes, std::size_t at)
{
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i)
  {
    value |= std::uint32_t(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
  }
  return value;
}

std::size_t TypeSize(std::size_t type)
{
  switch (type)
  {
    case 5120: // byte
    case 5121: // unsigned byte
      return 1;
    case 5122: // short
    case 5123: // unsigned short
      return 2;
    case 5125: // unsigned int
    case 5126: // float
      return 4;
    default:
      return 0;
  }
}

template<typename T, typename Stored>
T DecodeOne(const char* bytes, bool isNormalized)
{
  Stored stored;
  std::memcpy(&stored, bytes, sizeof(Stored));
  if constexpr (std::is_floating_point_v<T> && std::is_integral_v<Stored>)
  {
    if (isNormalized)
    {
      return std::max(
        static_cast<T>(stored) / static_cast<T>(std::numeric_limits<Stored>::max()), T(-1));
    }
  }
  return static_cast<T>(stored);
}

template<typename T>
T DecodeOne(const char* bytes, std::size_t type, bool isNormalized)
{
  switch (type)
  {
    case 5120:
      return DecodeOne<T, std::int8_t>(bytes, isNormalized);
    case 5121:
      return DecodeOne<T, std::uint8_t>(bytes, isNormalized);
    case 5122:
      return DecodeOne<T, std::int16_t>(bytes, isNormalized);
    case 5123:
      return DecodeOne<T, std::uint16_t>(bytes, isNormalized);
    case 5125:
      return DecodeOne<T, std::uint32_t>(bytes, isNormalized);
    default:
      return DecodeOne<T, float>(bytes, isNormalized);
  }
}
}

void GLTFElement::Fail(const char* expected) const
{
  throw ModelError(Printable(this->Path) +
    (this->IsThere() ? " is not " : " is missing; it should be ") + expected + ExportAgain);
}

GLTFElement GLTFElement::operator[](const char* member) const
{
  const std::string path = this->Path + (this->Path.empty() ? "" : ".") + member;
  if (!this->Value)
  {
    return { nullptr, path };
  }
  if (!this->Value->is_object())
  {
    this->Fail("an object");
  }
  const auto found = this->Value->find(member);
  return { found == this->Value->end() ? nullptr : &*found, path };
}

std::size_t GLTFElement::Size() const
{
  if (this->Value && !this->Value->is_array())
  {
    this->Fail("an array");
  }
  return this->Value ? this->Value->size() : 0;
}

GLTFElement GLTFElement::At(std::size_t index) const
{
  return { &(*this->Value)[index], this->Path + "[" + std::to_string(index) + "]" };
}

std::size_t GLTFElement::Whole() const
{
  // Some exporters write 1.0.
  constexpr double most = 9007199254740992.0;
  const double value = this->Value && this->Value->is_number() ? this->Value->get<double>() : -1.0;
  if (!(value >= 0.0 && value < most && value == std::floor(value)))
  {
    this->Fail("a whole number from 0");
  }
  return static_cast<std::size_t>(value);
}

bool GLTFElement::Truth() const
{
  if (!this->Value || !this->Value->is_boolean())
  {
    this->Fail("true or false");
  }
  return this->Value->get<bool>();
}

double GLTFElement::Number() const
{
  if (!this->Value || !this->Value->is_number())
  {
    this->Fail("a number");
  }
  return this->Value->get<double>();
}

std::vector<double> GLTFElement::Numbers(std::size_t count) const
{
  if (this->Size() != count)
  {
    this->Fail(("an array of " + std::to_string(count) + " numbers").c_str());
  }
  std::vector<double> numbers;
  for (std::size_t i = 0; i < count; ++i)
  {
    numbers.push_back(this->At(i).Number());
  }
  return numbers;
}

std::string GLTFElement::Text() const
{
  if (!this->Value || !this->Value->is_string())
  {
    this->Fail("a text");
  }
  return this->Value->get<std::string>();
}

GLTFDocument::GLTFDocument(const std::string& path) : FilePath(path)
{
  std::string text = ReadWhole(path);
  if (text.compare(0, 4, "glTF") == 0)
  {
    const std::string bytes = std::move(text);
    text.clear();
    this->ReadBinary(bytes, text);
  }
  this->Root = nlohmann::json::parse(text, nullptr, false);
  if (!this->Root.is_object())
  {
    throw ModelError("it is no JSON; the file is damaged or no glTF, export it again");
  }
  const std::string version = this->GetRoot()["asset"]["version"].Text();
  if (version != "2" && version.compare(0, 2, "2.") != 0)
  {
    throw ModelError("it is glTF " + Printable(version.substr(0, 20)) +
      ", but only version 2.0 is supported; export it as glTF 2.0");
  }
  this->CheckExtensions();
}

void GLTFDocument::ReadBinary(const std::string& bytes, std::string& text)
{
  if (bytes.size() < 20)
  {
    throw ModelError("it ends inside of its header; copy or export it again");
  }
  if (Word(bytes, 4) != 2)
  {
    throw ModelError("it is binary glTF " + std::to_string(Word(bytes, 4)) +
      ", but only version 2 is supported; export it as glTF 2.0");
  }
  if (Word(bytes, 8) > bytes.size())
  {
    throw ModelError("it ends too early: its header announces " + std::to_string(Word(bytes, 8)) +
      " bytes, there are " + std::to_string(bytes.size()) + "; copy or export it again");
  }
  constexpr std::uint32_t json = 0x4E4F534A;
  constexpr std::uint32_t binary = 0x004E4942;
  for (std::size_t at = 12; at + 8 <= bytes.size();)
  {
    const std::size_t size = Word(bytes, at);
    const std::uint32_t kind = Word(bytes, at + 4);
    at += 8;
    if (size > bytes.size() - at)
    {
      throw ModelError("its chunks end behind its end; copy or export it again");
    }
    if (kind == json && text.empty())
    {
      text = bytes.substr(at, size);
    }
    else if (kind == binary && !this->HasBinaryChunk)
    {
      this->BinaryChunk = bytes.substr(at, size);
      this->HasBinaryChunk = true;
    }
    at += size;
  }
}

// What is not required may be ignored; so may what only changes the look.
void GLTFDocument::CheckExtensions()
{
  static const std::vector<std::string> known = { "KHR_lights_punctual", "KHR_mesh_quantization",
    "KHR_texture_transform", "KHR_materials_pbrSpecularGlossiness", "KHR_materials_unlit" };
  const GLTFElement required = this->GetRoot()["extensionsRequired"];
  for (std::size_t i = 0; i < required.Size(); ++i)
  {
    const std::string name = required.At(i).Text();
    if (std::find(known.begin(), known.end(), name) != known.end())
    {
      continue;
    }
    if (name.compare(0, 14, "KHR_materials_") != 0 && name.compare(0, 13, "KHR_technique") != 0)
    {
      throw ModelError(
        "it uses " + Printable(name.substr(0, 60)) + ", which is not supported; export it without");
    }
    this->IgnoredExtensions.push_back(Printable(name.substr(0, 60)));
  }
}

std::size_t GLTFDocument::FindIndex(const char* array, const GLTFElement& reference) const
{
  const std::size_t index = reference.Whole();
  const std::size_t size = this->GetRoot()[array].Size();
  if (index >= size)
  {
    throw ModelError(reference.GetPath() + " refers to " + array + "[" + std::to_string(index) +
      "], but there are " + std::to_string(size) + ExportAgain);
  }
  return index;
}

GLTFElement GLTFDocument::Find(const char* array, const GLTFElement& reference) const
{
  return this->GetRoot()[array].At(this->FindIndex(array, reference));
}

std::string GLTFDocument::GetPath(const std::string& uri) const
{
  std::string name;
  for (std::size_t i = 0; i < uri.size(); ++i)
  {
    const auto isHex = [&](std::size_t at)
    { return at < uri.size() && std::isxdigit(static_cast<unsigned char>(uri[at])); };
    if (uri[i] == '%' && isHex(i + 1) && isHex(i + 2))
    {
      name += static_cast<char>(std::strtol(uri.substr(i + 1, 2).c_str(), nullptr, 16));
      i += 2;
    }
    else
    {
      name += uri[i];
    }
  }
  const std::filesystem::path folder = std::filesystem::path(this->FilePath).parent_path();
  std::error_code ignored;
  // Some exporters do not encode what they should, such as '%'.
  return std::filesystem::exists(folder / name, ignored) ? (folder / name).string()
                                                         : (folder / uri).string();
}

std::string GLTFDocument::DecodeData(const GLTFElement& uri)
{
  const std::string text = uri.Text();
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos || text.rfind(";base64", comma) == std::string::npos)
  {
    throw ModelError(uri.GetPath() + " is no data in base64" + ExportAgain);
  }
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (std::size_t i = comma + 1; i < text.size() && text[i] != '='; ++i)
  {
    static const std::string digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const std::size_t digit = digits.find(text[i]);
    if (digit == std::string::npos)
    {
      throw ModelError(uri.GetPath() + " is no data in base64" + ExportAgain);
    }
    bits = bits << 6 | static_cast<std::uint32_t>(digit);
    count += 6;
    if (count >= 8)
    {
      count -= 8;
      bytes += static_cast<char>(bits >> count & 255u);
    }
  }
  return bytes;
}

const std::string& GLTFDocument::GetBuffer(std::size_t index)
{
  const auto [entry, isNew] = this->Buffers.try_emplace(index);
  if (!isNew)
  {
    return entry->second;
  }
  const GLTFElement buffer = this->GetRoot()["buffers"].At(index);
  const std::size_t length = buffer["byteLength"].Whole();
  std::string source = buffer.GetPath();
  if (!buffer.Has("uri"))
  {
    if (index != 0 || !this->HasBinaryChunk)
    {
      throw ModelError(source + " has no data" + ExportAgain);
    }
    entry->second = std::move(this->BinaryChunk);
  }
  else if (IsData(buffer["uri"].Text()))
  {
    entry->second = DecodeData(buffer["uri"]);
  }
  else
  {
    const std::string path = this->GetPath(buffer["uri"].Text());
    source = "'" + Printable(path) + "'";
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored))
    {
      throw ModelError(source + " is missing, which " + buffer.GetPath() +
        " refers to; put it there, or export the model as .glb, which is one file");
    }
    entry->second = ReadWhole(path);
  }
  if (entry->second.size() < length)
  {
    throw ModelError(source + " has " + std::to_string(entry->second.size()) + " of " +
      std::to_string(length) + " bytes; copy or export it again");
  }
  entry->second.resize(length);
  return entry->second;
}

GLTFDocument::Span GLTFDocument::GetView(const GLTFElement& view)
{
  const std::string& buffer = this->GetBuffer(this->FindIndex("buffers", view["buffer"]));
  const std::size_t offset = view.Has("byteOffset") ? view["byteOffset"].Whole() : 0;
  const std::size_t length = view["byteLength"].Whole();
  if (offset > buffer.size() || length > buffer.size() - offset)
  {
    throw ModelError(view.GetPath() + " ends behind the end of its buffer (" +
      std::to_string(buffer.size()) + " bytes)" + ExportAgain);
  }
  return { buffer.data() + offset, length };
}

std::string GLTFDocument::ReadView(const GLTFElement& view)
{
  const Span span = this->GetView(view);
  return { span.Begin, span.Size };
}

template<typename T>
void GLTFDocument::Decode(const GLTFElement& owner, const GLTFElement& view, std::size_t offset,
  std::size_t type, bool isNormalized, std::size_t components, std::size_t count,
  std::vector<T>& values)
{
  const Span span = this->GetView(view);
  const std::size_t size = TypeSize(type);
  const std::size_t tuple = size * components;
  const std::size_t given = view.Has("byteStride") ? view["byteStride"].Whole() : 0;
  const std::size_t stride = given > 0 ? given : tuple;
  if (stride < tuple || count == 0 || offset > span.Size || tuple > span.Size - offset ||
    count - 1 > (span.Size - offset - tuple) / stride)
  {
    throw ModelError(owner.GetPath() + " (" + std::to_string(count) + " x " +
      std::to_string(tuple) + " bytes) does not fit into " + view.GetPath() + " (" +
      std::to_string(span.Size) + " bytes)" + ExportAgain);
  }
  values.reserve(values.size() + count * components);
  for (std::size_t i = 0; i < count; ++i)
  {
    for (std::size_t j = 0; j < components; ++j)
    {
      values.push_back(
        DecodeOne<T>(span.Begin + offset + i * stride + j * size, type, isNormalized));
    }
  }
}

template<typename T>
GLTFValues<T> GLTFDocument::ReadAccessor(const GLTFElement& accessor)
{
  static const std::map<std::string, int> kinds = { { "SCALAR", 1 }, { "VEC2", 2 }, { "VEC3", 3 },
    { "VEC4", 4 } };
  const auto kind = kinds.find(accessor["type"].Text());
  const std::size_t type = accessor["componentType"].Whole();
  // Points of floats, indices of whole numbers.
  if (kind == kinds.end() || TypeSize(type) == 0 ||
    (std::is_integral_v<T> && (kind->second != 1 || type == 5126)))
  {
    throw ModelError(accessor.GetPath() + " has the wrong type for its use" + ExportAgain);
  }
  const bool isNormalized = accessor.Has("normalized") && accessor["normalized"].Truth();
  const std::size_t count = accessor["count"].Whole();
  const auto components = static_cast<std::size_t>(kind->second);
  GLTFValues<T> result;
  result.Components = kind->second;
  if (accessor.Has("bufferView"))
  {
    const std::size_t offset = accessor.Has("byteOffset") ? accessor["byteOffset"].Whole() : 0;
    this->Decode(accessor, this->Find("bufferViews", accessor["bufferView"]), offset, type,
      isNormalized, components, count, result.Values);
  }
  else
  {
    // Zeros need no bytes in the file, so a damaged count could ask for any memory.
    constexpr std::size_t most = 100000000;
    if (count == 0 || count > most)
    {
      throw ModelError(accessor.GetPath() + " has no bufferView for its " + std::to_string(count) +
        " elements" + ExportAgain);
    }
    result.Values.assign(count * components, T(0));
  }
  if (!accessor.Has("sparse"))
  {
    return result;
  }

  const GLTFElement sparse = accessor["sparse"];
  const std::size_t changes = sparse["count"].Whole();
  const auto decode = [&](
                        const GLTFElement& part, std::size_t partType, std::size_t width, auto& out)
  {
    const std::size_t offset = part.Has("byteOffset") ? part["byteOffset"].Whole() : 0;
    this->Decode(part, this->Find("bufferViews", part["bufferView"]), offset, partType,
      isNormalized, width, changes, out);
  };
  const std::size_t indexType = sparse["indices"]["componentType"].Whole();
  if (TypeSize(indexType) == 0 || indexType == 5126)
  {
    throw ModelError(sparse.GetPath() + ".indices has the wrong type" + ExportAgain);
  }
  std::vector<std::int64_t> indices;
  std::vector<T> values;
  decode(sparse["indices"], indexType, 1, indices);
  decode(sparse["values"], type, components, values);
  for (std::size_t i = 0; i < indices.size(); ++i)
  {
    if (indices[i] < 0 || indices[i] >= static_cast<std::int64_t>(count))
    {
      throw ModelError(sparse.GetPath() + " changes element " + std::to_string(indices[i]) +
        " of " + std::to_string(count) + ExportAgain);
    }
    std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(i * components), components,
      result.Values.begin() + static_cast<std::ptrdiff_t>(indices[i]) * kind->second);
  }
  return result;
}

template GLTFValues<float> GLTFDocument::ReadAccessor<float>(const GLTFElement&);
template GLTFValues<std::int64_t> GLTFDocument::ReadAccessor<std::int64_t>(const GLTFElement&);
}
