// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosGltfMesh.h"

#include "heliosGltfAccessor.h"
#include "heliosGltfDocument.h"
#include "heliosMemoryCheck.h"
#include "heliosSceneMesh.h"

#include <json/json.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace helios
{

namespace
{

constexpr double BytesPerItem = 24.0; // memory per vertex or triangle

enum Mode : std::int64_t
{
  Triangles = 4,
  Strip = 5,
  Fan = 6
};

/// Adds the triangles of one primitive after the other.
class PrimitiveReader
{
public:
  PrimitiveReader(GltfDocument& document, const std::vector<double>& weights, bool hasSkin,
    const std::vector<int>& textureSets, GltfMesh& mesh)
    : Document(document)
    , Weights(weights)
    , HasSkin(hasSkin)
    , TextureSets(textureSets)
    , Mesh(mesh)
  {
  }

  Status Read(const Json::Value& primitive, const std::string& path)
  {
    std::int64_t mode = Triangles;
    Status status = this->Document.ReadWhole(primitive, "mode", path, Triangles, mode);
    if (status.IsOk() && (mode < Triangles || mode > Fan))
    {
      return mode < Triangles
        ? Status()
        : this->Document.Fail(path + ".mode",
            "is " + std::to_string(mode) + ", not one of 0 to 6; write the file again");
    }
    status = status.IsOk() ? this->ReadMaterial(primitive, path) : status;
    status = status.IsOk() ? this->ReadPoints(primitive, path) : status;
    if (status.IsOk() && this->HasSkin)
    {
      status =
        ReadGltfWeights(this->Document, primitive, path, this->NumberOfPoints, this->Mesh.Weights);
    }
    status = status.IsOk() ? this->ReadTextures(primitive, path) : status;
    status = status.IsOk() ? this->ReadIndices(primitive, path) : status;
    return status.IsOk() ? this->AddTriangles(mode, path) : status;
  }

private:
  Status ReadMaterial(const Json::Value& primitive, const std::string& path)
  {
    const Json::Value& value = GetMember(primitive, "material");
    std::int64_t index = -1;
    const Status status = value.isNull()
      ? Status()
      : this->Document.FindIndex("materials", value, path + ".material", index);
    this->Material = static_cast<int>(index);
    return status;
  }

  Status ReadPoints(const Json::Value& primitive, const std::string& path)
  {
    const std::string where = path + ".attributes.POSITION";
    const Json::Value& value = GetMember(GetMember(primitive, "attributes"), "POSITION");
    if (value.isNull())
    {
      return this->Document.Fail(where, "is missing; write the file again");
    }
    GltfNumbers points;
    Status status = ReadAccessor(this->Document, value, where, "VEC3", points);
    status = status.IsOk() ? this->AddTargets(primitive, path, points) : status;
    if (!status.IsOk())
    {
      return status;
    }
    const auto bad = std::find_if_not(
      points.Values.begin(), points.Values.end(), [](double x) { return std::isfinite(x); });
    if (bad != points.Values.end())
    {
      return this->Document.Fail(where,
        "vertex " + std::to_string((bad - points.Values.begin()) / 3) +
          " is NaN or infinite; correct the vertex, or remove it");
    }
    this->FirstPoint = static_cast<std::int64_t>(this->Mesh.Points.size()) / 3;
    this->NumberOfPoints = points.GetCount();
    this->Mesh.Points.insert(this->Mesh.Points.end(), points.Values.begin(), points.Values.end());
    return this->FirstPoint + this->NumberOfPoints <= MaximumCorners
      ? Status()
      : this->Document.Fail(where,
          "the mesh has more than " + std::to_string(MaximumCorners) + " vertices; split it");
  }

  /// Reads the texture coordinates of vertices, if the material has a set of them.
  Status ReadTextures(const Json::Value& primitive, const std::string& path)
  {
    this->Textures = GltfNumbers();
    const int set =
      this->Material < 0 ? -1 : this->TextureSets[static_cast<std::size_t>(this->Material)];
    const std::string name = "TEXCOORD_" + std::to_string(set);
    const Json::Value& value = GetMember(GetMember(primitive, "attributes"), name.c_str());
    if (set < 0 || value.isNull())
    {
      return {};
    }
    const std::string where = path + ".attributes." + name;
    const Status status = ReadAccessor(this->Document, value, where, "VEC2", this->Textures);
    return !status.IsOk() || this->Textures.GetCount() == this->NumberOfPoints
      ? status
      : this->Document.Fail(where,
          "has " + std::to_string(this->Textures.GetCount()) + " elements, and the primitive has " +
            std::to_string(this->NumberOfPoints) + " vertices; write the file again");
  }

  /// Moves vertices by weight times displacement of each morph target.
  Status AddTargets(const Json::Value& primitive, const std::string& path, GltfNumbers& points)
  {
    const Json::Value& targets = GetMember(primitive, "targets");
    const std::size_t count = targets.isArray() ? targets.size() : 0;
    if (!this->Weights.empty() && this->Weights.size() != count)
    {
      return this->Document.Fail(path + ".targets",
        "has " + std::to_string(count) + " morph targets, and the mesh is placed with " +
          std::to_string(this->Weights.size()) + " weights; correct weights, or add targets");
    }
    for (std::size_t i = 0; i < this->Weights.size(); ++i)
    {
      const std::string where =
        ElementPath((path + ".targets").c_str(), static_cast<std::int64_t>(i)) + ".POSITION";
      const Json::Value& value = GetMember(targets[static_cast<Json::ArrayIndex>(i)], "POSITION");
      if (this->Weights[i] == 0.0 || value.isNull())
      {
        continue;
      }
      GltfNumbers moves;
      const Status status = ReadAccessor(this->Document, value, where, "VEC3", moves);
      if (!status.IsOk())
      {
        return status;
      }
      if (moves.GetCount() != points.GetCount())
      {
        return this->Document.Fail(where,
          "has " + std::to_string(moves.GetCount()) + " elements, and the primitive has " +
            std::to_string(points.GetCount()) + " vertices; write the file again");
      }
      std::transform(points.Values.begin(), points.Values.end(), moves.Values.begin(),
        points.Values.begin(),
        [weight = this->Weights[i]](double x, double move) { return x + weight * move; });
    }
    return {};
  }

  Status ReadIndices(const Json::Value& primitive, const std::string& path)
  {
    const Json::Value& value = GetMember(primitive, "indices");
    if (value.isNull())
    {
      this->Indices.resize(static_cast<std::size_t>(this->NumberOfPoints));
      std::iota(this->Indices.begin(), this->Indices.end(), 0.0);
      return {};
    }
    GltfNumbers numbers;
    const Status status = ReadAccessor(this->Document, value, path + ".indices", "SCALAR", numbers);
    this->Indices = std::move(numbers.Values);
    const auto limit = static_cast<double>(this->NumberOfPoints);
    const auto bad = std::find_if_not(this->Indices.begin(), this->Indices.end(),
      [limit](double i) { return i >= 0.0 && i < limit; });
    return !status.IsOk() || bad == this->Indices.end()
      ? status
      : this->Document.Fail(path + ".indices",
          "element " + std::to_string(bad - this->Indices.begin()) + " is " + FormatIndex(*bad) +
            ", and the primitive has " + std::to_string(this->NumberOfPoints) +
            " vertices, counted from 0; correct the index");
  }

  static std::string FormatIndex(double index)
  {
    return std::isfinite(index) && std::abs(index) < 1e15
      ? std::to_string(static_cast<std::int64_t>(index))
      : "no index";
  }

  Status AddTriangles(std::int64_t mode, const std::string& path)
  {
    const std::size_t count = this->Indices.size();
    if (mode == Triangles && count % 3 != 0)
    {
      return this->Document.Fail(path,
        "has " + std::to_string(count) + " corners, not a multiple of three; write the file again");
    }
    const std::size_t step = mode == Triangles ? 3 : 1;
    for (std::size_t i = 0; i + 2 < count; i += step)
    {
      const bool isOdd = mode == Strip && i % 2 != 0; // every second one is turned
      this->AddTriangle(mode == Fan ? 0 : i + isOdd, mode == Fan ? i + 1 : i + !isOdd, i + 2);
    }
    return {};
  }

  void AddTriangle(std::size_t a, std::size_t b, std::size_t c)
  {
    for (const std::size_t corner : { a, b, c })
    {
      this->Mesh.Corners.push_back(static_cast<vtkTypeInt32>(
        this->FirstPoint + static_cast<std::int64_t>(this->Indices[corner])));
    }
    this->Mesh.Materials.push_back(this->Material);
    this->AddTexture({ a, b, c });
  }

  /// Adds the texture coordinates of a triangle; all triangles have them once one has.
  void AddTexture(const std::array<std::size_t, 3>& corners)
  {
    std::vector<float>& all = this->Mesh.Textures;
    if (this->Textures.Values.empty() && all.empty())
    {
      return;
    }
    all.resize(6 * this->Mesh.Materials.size(), std::numeric_limits<float>::quiet_NaN());
    for (std::size_t i = 0; i < 6 && !this->Textures.Values.empty(); ++i)
    {
      const auto vertex = static_cast<std::size_t>(this->Indices[corners[i / 2]]);
      all[all.size() - 6 + i] = static_cast<float>(this->Textures.Values[2 * vertex + i % 2]);
    }
  }

  GltfDocument& Document;
  const std::vector<double>& Weights;
  const bool HasSkin;
  const std::vector<int>& TextureSets; // by material
  GltfMesh& Mesh;
  int Material = -1; // material of the current primitive
  std::int64_t FirstPoint = 0;
  std::int64_t NumberOfPoints = 0;
  std::vector<double> Indices;
  GltfNumbers Textures; // coordinates per vertex; empty: none
};

} // namespace

//------------------------------------------------------------------------------
Status ReadGltfMesh(GltfDocument& document, std::int64_t index, const std::vector<double>& weights,
  bool hasSkin, const std::vector<int>& textureSets, GltfMesh& mesh)
{
  const Json::Value& primitives = GetMember(document.GetElement("meshes", index), "primitives");
  const std::string path = ElementPath("meshes", index) + ".primitives";
  if (!primitives.isArray())
  {
    return document.Fail(
      path, "is " + Describe(primitives) + ", not a list of primitives; write the file again");
  }
  PrimitiveReader reader(document, weights, hasSkin, textureSets, mesh);
  for (Json::ArrayIndex i = 0; i < primitives.size(); ++i)
  {
    const std::string where = ElementPath(path.c_str(), i);
    Status status = reader.Read(primitives[i], where);
    if (!status.IsOk())
    {
      return status;
    }
    status = CheckMemory("vertices and triangles of a mesh",
      static_cast<double>(mesh.Points.size() / 3 + mesh.Materials.size()), BytesPerItem);
    if (!status.IsOk())
    {
      return document.Fail(where, status.Message());
    }
  }
  return {};
}

} // namespace helios
