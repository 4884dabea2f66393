// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
//
// glTF 2.0: nodes, meshes and materials. VTK's own importer is not taken: it trusts indices, nodes
// and buffers whatever they say, leaves out what it can not read so that indices shift, wants all
// images, and shows neither vertex colours nor mirrored textures.
// Source: Khronos glTF 2.0 specification, 2021.
#include "nprFileFormats.h"
#include "nprGLTFDocument.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkTransform.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace npr
{
namespace
{
double ToSRGB(double linear)
{
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

struct Material
{
  std::array<double, 4> Colour = { 1.0, 1.0, 1.0, 1.0 }; // linear
  bool IsBlended = false;
  GLTFElement TextureInfo;

  vtkSmartPointer<vtkProperty> MakeProperty() const
  {
    double diffuse[3];
    std::transform(this->Colour.begin(), this->Colour.begin() + 3, diffuse,
      [](double linear) { return ToSRGB(std::clamp(linear, 0.0, 1.0)); });
    return MakePlainProperty(
      diffuse, this->IsBlended ? std::clamp(this->Colour[3], 0.0, 1.0) : 1.0);
  }
};

class GLTFParser
{
public:
  explicit GLTFParser(ModelFile& file) : File(file), Document(file.Path) {}
  void Parse();

private:
  void AddNode(const GLTFElement& node, vtkMatrix4x4* matrix);
  const std::vector<ModelPart>& GetMesh(const GLTFElement& mesh, std::size_t index);
  void AddPrimitive(const GLTFElement& primitive, std::vector<ModelPart>& parts);
  vtkSmartPointer<vtkCellArray> ReadTriangles(const GLTFElement& primitive, vtkIdType points);
  vtkSmartPointer<vtkDataArray> ReadAttribute(
    const GLTFElement& accessor, int components, vtkIdType points, const char* name);
  Material ReadMaterial(const GLTFElement& element);
  void AddColours(vtkPolyData* surface, const GLTFElement& accessor, const Material& material);
  void AddTexture(ModelPart& part, const GLTFElement& primitive, const GLTFElement& info);
  vtkSmartPointer<vtkTexture> ReadImage(const GLTFElement& image);
  void Warn(const std::string& text);

  ModelFile& File;
  GLTFDocument Document;
  std::map<std::size_t, std::vector<ModelPart>> Meshes;
};

void GLTFParser::Warn(const std::string& text)
{
  if (std::find(this->File.Warnings.begin(), this->File.Warnings.end(), text) ==
    this->File.Warnings.end())
  {
    this->File.Warnings.push_back(text);
  }
}

vtkSmartPointer<vtkMatrix4x4> ReadMatrix(const GLTFElement& node)
{
  auto result = vtkSmartPointer<vtkMatrix4x4>::New();
  if (node.Has("matrix"))
  {
    const auto values = node["matrix"].Numbers(16);
    result->DeepCopy(values.data());
    result->Transpose(); // columns come first
    return result;
  }
  vtkNew<vtkTransform> transform;
  if (node.Has("translation"))
  {
    transform->Translate(node["translation"].Numbers(3).data());
  }
  if (node.Has("rotation"))
  {
    const auto q = node["rotation"].Numbers(4); // x, y, z, w
    const double sine = std::hypot(q[0], q[1], q[2]);
    if (sine > 0.0)
    {
      transform->RotateWXYZ(
        vtkMath::DegreesFromRadians(2.0 * std::atan2(sine, q[3])), q[0], q[1], q[2]);
    }
  }
  if (node.Has("scale"))
  {
    // vtkTransform refuses a scale of zero, which hides a part.
    const auto scale = node["scale"].Numbers(3);
    vtkNew<vtkMatrix4x4> diagonal;
    for (int i = 0; i < 3; ++i)
    {
      diagonal->SetElement(i, i, scale[static_cast<std::size_t>(i)]);
    }
    vtkMatrix4x4::Multiply4x4(transform->GetMatrix(), diagonal, result);
    return result;
  }
  result->DeepCopy(transform->GetMatrix());
  return result;
}

void GLTFParser::Parse()
{
  for (const std::string& name : this->Document.GetIgnoredExtensions())
  {
    this->Warn("It uses " + name + ", which is not supported; its look may differ.");
  }
  const GLTFElement root = this->Document.GetRoot();
  const GLTFElement nodes = root["nodes"];
  std::vector<std::size_t> roots;
  if (root.Has("scene") || root["scenes"].Size() > 0)
  {
    const GLTFElement scene =
      root.Has("scene") ? this->Document.Find("scenes", root["scene"]) : root["scenes"].At(0);
    for (std::size_t i = 0; i < scene["nodes"].Size(); ++i)
    {
      roots.push_back(this->Document.FindIndex("nodes", scene["nodes"].At(i)));
    }
  }
  else
  {
    std::vector<bool> isChild(nodes.Size(), false);
    for (std::size_t n = 0; n < nodes.Size(); ++n)
    {
      const GLTFElement children = nodes.At(n)["children"];
      for (std::size_t i = 0; i < children.Size(); ++i)
      {
        isChild[this->Document.FindIndex("nodes", children.At(i))] = true;
      }
    }
    for (std::size_t n = 0; n < nodes.Size(); ++n)
    {
      if (!isChild[n])
      {
        roots.push_back(n);
      }
    }
  }

  struct Visit
  {
    std::size_t Node;
    vtkSmartPointer<vtkMatrix4x4> Parent;
  };
  std::vector<Visit> visits;
  for (auto node = roots.rbegin(); node != roots.rend(); ++node)
  {
    visits.push_back({ *node, vtkSmartPointer<vtkMatrix4x4>::New() });
  }
  std::vector<bool> isVisited(nodes.Size(), false);
  while (!visits.empty())
  {
    const Visit visit = visits.back();
    visits.pop_back();
    const GLTFElement node = nodes.At(visit.Node);
    if (isVisited[visit.Node])
    {
      throw ModelError(node.GetPath() +
        " has two parents or is its own descendant, but nodes must be a tree; the file is "
        "damaged, export it again");
    }
    isVisited[visit.Node] = true;
    auto matrix = ReadMatrix(node);
    vtkMatrix4x4::Multiply4x4(visit.Parent, matrix, matrix);
    if (node.Has("mesh"))
    {
      this->AddNode(node, matrix);
    }
    const GLTFElement children = node["children"];
    for (std::size_t i = children.Size(); i-- > 0;)
    {
      visits.push_back({ this->Document.FindIndex("nodes", children.At(i)), matrix });
    }
  }
}

void GLTFParser::AddNode(const GLTFElement& node, vtkMatrix4x4* matrix)
{
  if (node.Has("skin"))
  {
    this->Warn("Skins are not supported: the model is shown as it was before it got its bones.");
  }
  const std::size_t index = this->Document.FindIndex("meshes", node["mesh"]);
  const GLTFElement mesh = this->Document.GetRoot()["meshes"].At(index);
  const GLTFElement weights = node.Has("weights") ? node["weights"] : mesh["weights"];
  for (std::size_t i = 0; i < weights.Size(); ++i)
  {
    if (weights.At(i).Number() != 0.0)
    {
      this->Warn("Morph targets are not supported: the model is shown without them.");
    }
  }
  for (const ModelPart& part : this->GetMesh(mesh, index))
  {
    this->File.AddPart(part.Surface);
    ModelPart& added = this->File.Parts.back();
    added.Matrix = matrix;
    added.Property = part.Property;
    added.Texture = part.Texture;
  }
}

const std::vector<ModelPart>& GLTFParser::GetMesh(const GLTFElement& mesh, std::size_t index)
{
  const auto [entry, isNew] = this->Meshes.try_emplace(index);
  if (isNew)
  {
    const GLTFElement primitives = mesh["primitives"];
    for (std::size_t i = 0; i < primitives.Size(); ++i)
    {
      this->AddPrimitive(primitives.At(i), entry->second);
    }
  }
  return entry->second;
}

vtkSmartPointer<vtkDataArray> GLTFParser::ReadAttribute(
  const GLTFElement& accessor, int components, vtkIdType points, const char* name)
{
  const GLTFValues<float> values = this->Document.ReadAccessor<float>(accessor);
  if (values.Components != components ||
    (points >= 0 && values.Values.size() / components != static_cast<std::size_t>(points)))
  {
    throw ModelError(accessor.GetPath() + ", the " + name + ", has " +
      std::to_string(values.Values.size() / values.Components) + " x " +
      std::to_string(values.Components) + " numbers instead of " +
      (points >= 0 ? std::to_string(points) : std::string("any")) + " x " +
      std::to_string(components) + "; the file is damaged, export it again");
  }
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.Values.size()) / components);
  std::copy(values.Values.begin(), values.Values.end(), array->GetPointer(0));
  return array;
}

vtkSmartPointer<vtkCellArray> GLTFParser::ReadTriangles(
  const GLTFElement& primitive, vtkIdType points)
{
  std::vector<std::int64_t> corners;
  if (primitive.Has("indices"))
  {
    const GLTFElement accessor = this->Document.Find("accessors", primitive["indices"]);
    corners = this->Document.ReadAccessor<std::int64_t>(accessor).Values;
    for (const std::int64_t corner : corners)
    {
      if (corner < 0 || corner >= points)
      {
        throw ModelError(primitive.GetPath() + " refers to point " + std::to_string(corner) +
          ", but there are " + std::to_string(points) +
          " points; the file is damaged, export it again");
      }
    }
  }
  else
  {
    corners.resize(static_cast<std::size_t>(points));
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
      corners[i] = static_cast<std::int64_t>(i);
    }
  }
  const std::size_t mode = primitive.Has("mode") ? primitive["mode"].Whole() : 4;
  auto triangles = vtkSmartPointer<vtkCellArray>::New();
  const std::size_t step = mode == 4 ? 3 : 1;
  for (std::size_t i = 0; i + 2 < corners.size(); i += step)
  {
    // Every second triangle of a strip is turned; all of a fan share their first corner.
    const std::size_t turned = mode == 5 ? i % 2 : 0;
    triangles->InsertNextCell(
      { corners[mode == 6 ? 0 : i], corners[i + 1 + turned], corners[i + 2 - turned] });
  }
  return triangles;
}

void GLTFParser::AddPrimitive(const GLTFElement& primitive, std::vector<ModelPart>& parts)
{
  const std::size_t mode = primitive.Has("mode") ? primitive["mode"].Whole() : 4;
  const GLTFElement attributes = primitive["attributes"];
  if (mode < 4 || mode > 6 || !attributes.Has("POSITION"))
  {
    this->Warn("Points, lines and meshes without positions are left out.");
    return;
  }
  ModelPart part;
  part.Surface = vtkSmartPointer<vtkPolyData>::New();
  const auto find = [&](const char* name) -> GLTFElement
  { return this->Document.Find("accessors", attributes[name]); };
  vtkNew<vtkPoints> points;
  points->SetData(this->ReadAttribute(find("POSITION"), 3, -1, "Points"));
  const vtkIdType count = points->GetNumberOfPoints();
  part.Surface->SetPoints(points);
  part.Surface->SetPolys(this->ReadTriangles(primitive, count));
  if (attributes.Has("NORMAL"))
  {
    part.Surface->GetPointData()->SetNormals(
      this->ReadAttribute(find("NORMAL"), 3, count, "Normals"));
  }
  Material material;
  if (primitive.Has("material"))
  {
    material = this->ReadMaterial(this->Document.Find("materials", primitive["material"]));
    part.Property = material.MakeProperty();
  }
  if (attributes.Has("COLOR_0"))
  {
    this->AddColours(part.Surface, find("COLOR_0"), material);
  }
  if (material.TextureInfo.IsThere())
  {
    this->AddTexture(part, primitive, material.TextureInfo);
  }
  parts.push_back(part);
}

Material GLTFParser::ReadMaterial(const GLTFElement& element)
{
  Material material;
  material.IsBlended = element.Has("alphaMode") && element["alphaMode"].Text() == "BLEND";
  const GLTFElement glossy = element["extensions"]["KHR_materials_pbrSpecularGlossiness"];
  const bool isGlossy = glossy.IsThere() && !element.Has("pbrMetallicRoughness");
  const GLTFElement source = isGlossy ? glossy : element["pbrMetallicRoughness"];
  const char* factor = isGlossy ? "diffuseFactor" : "baseColorFactor";
  if (source.Has(factor))
  {
    const auto values = source[factor].Numbers(4);
    std::copy(values.begin(), values.end(), material.Colour.begin());
  }
  material.TextureInfo = source[isGlossy ? "diffuseTexture" : "baseColorTexture"];
  return material;
}

// They are linear, and multiply the material's.
void GLTFParser::AddColours(
  vtkPolyData* surface, const GLTFElement& accessor, const Material& material)
{
  const GLTFValues<float> values = this->Document.ReadAccessor<float>(accessor);
  const auto points = static_cast<std::size_t>(surface->GetNumberOfPoints());
  const auto components = static_cast<std::size_t>(values.Components);
  if ((components != 3 && components != 4) || values.Values.size() != components * points)
  {
    this->Warn(accessor.GetPath() + " does not have one colour for each point; it is not used.");
    return;
  }
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetName("Colors");
  colours->SetNumberOfComponents(3);
  colours->SetNumberOfTuples(static_cast<vtkIdType>(points));
  for (std::size_t i = 0; i < 3 * points; ++i)
  {
    const double linear =
      material.Colour[i % 3] * static_cast<double>(values.Values[i / 3 * components + i % 3]);
    colours->SetValue(static_cast<vtkIdType>(i),
      static_cast<unsigned char>(
        255.0 * ToSRGB(linear > 0.0 ? std::min(linear, 1.0) : 0.0) + 0.5)); // 0 for NaN
  }
  surface->GetPointData()->SetScalars(colours);
}

void GLTFParser::AddTexture(ModelPart& part, const GLTFElement& primitive, const GLTFElement& info)
{
  const GLTFElement transform = info["extensions"]["KHR_texture_transform"];
  const GLTFElement set = transform.Has("texCoord") ? transform["texCoord"] : info["texCoord"];
  const std::string name = "TEXCOORD_" + std::to_string(set.IsThere() ? set.Whole() : 0);
  const GLTFElement texture = this->Document.Find("textures", info["index"]);
  if (!primitive["attributes"].Has(name.c_str()) || !texture.Has("source"))
  {
    this->Warn(texture.GetPath() + " has no " +
      (texture.Has("source") ? "texture coordinates" : "image that can be read") +
      "; the plain colour is used.");
    return;
  }
  auto coordinates =
    this->ReadAttribute(this->Document.Find("accessors", primitive["attributes"][name.c_str()]), 2,
      part.Surface->GetNumberOfPoints(), "TextureCoordinates");
  const auto two = [&](const char* key, double value) {
    return transform.Has(key) ? transform[key].Numbers(2) : std::vector<double>{ value, value };
  };
  const auto offset = two("offset", 0.0);
  const auto scale = two("scale", 1.0);
  const double angle = transform.Has("rotation") ? transform["rotation"].Number() : 0.0;
  for (vtkIdType i = 0; i < coordinates->GetNumberOfTuples(); ++i)
  {
    const double u = scale[0] * coordinates->GetComponent(i, 0);
    const double v = scale[1] * coordinates->GetComponent(i, 1);
    // They run downwards, VTK's upwards.
    coordinates->SetTuple2(i, offset[0] + std::cos(angle) * u + std::sin(angle) * v,
      1.0 - (offset[1] - std::sin(angle) * u + std::cos(angle) * v));
  }
  part.Surface->GetPointData()->SetTCoords(coordinates);
  part.Texture = this->ReadImage(this->Document.Find("images", texture["source"]));
  if (!part.Texture)
  {
    return;
  }
  // VTK wraps both directions alike, so the one that leaves the image decides.
  constexpr std::size_t clamp = 33071;
  constexpr std::size_t mirror = 33648;
  constexpr std::size_t repeat = 10497;
  std::size_t wrap[2] = { repeat, repeat };
  if (texture.Has("sampler"))
  {
    const GLTFElement sampler = this->Document.Find("samplers", texture["sampler"]);
    wrap[0] = sampler.Has("wrapS") ? sampler["wrapS"].Whole() : repeat;
    wrap[1] = sampler.Has("wrapT") ? sampler["wrapT"].Whole() : repeat;
  }
  double range[2];
  coordinates->GetRange(range, 0);
  constexpr double tolerance = 1e-3;
  const std::size_t chosen = wrap[range[0] < -tolerance || range[1] > 1.0 + tolerance ? 0 : 1];
  part.Texture->SetWrap(chosen == clamp ? vtkTexture::ClampToEdge
      : chosen == mirror                ? vtkTexture::MirroredRepeat
                                        : vtkTexture::Repeat);
}

vtkSmartPointer<vtkTexture> GLTFParser::ReadImage(const GLTFElement& image)
{
  if (image.Has("uri") && !GLTFDocument::IsData(image["uri"].Text()))
  {
    return ReadTexture(this->File, this->Document.GetPath(image["uri"].Text()));
  }
  const std::string bytes = image.Has("uri")
    ? GLTFDocument::DecodeData(image["uri"])
    : this->Document.ReadView(this->Document.Find("bufferViews", image["bufferView"]));
  return ReadTextureBytes(this->File, bytes, image.GetPath());
}
}

void ReadGLTF(ModelFile& file)
{
  GLTFParser(file).Parse();
}
}
