// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// glTF documents made for tests.

#ifndef heliosGltfTesting_h
#define heliosGltfTesting_h

#include "heliosSceneReading.h"
#include "vtkHeliosGLTFSceneReader.h"

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace helios::gltf
{

using Reading = SceneReading<vtkHeliosGLTFSceneReader>;

inline std::string EncodeBase64(const std::string& bytes)
{
  const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3)
  {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0);
    }
    for (std::size_t k = 0; k < 4; ++k)
    {
      text += i + k <= bytes.size() ? digits[group >> (18 - 6 * k) & 63] : '=';
    }
  }
  return text;
}

template <typename T>
std::string ToBytes(const std::vector<T>& values)
{
  return std::string(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
}

/// A document with one buffer; each addition has a view and an accessor of its own.
class Maker
{
public:
  /// Adds a view; returns its number.
  int AddView(const std::string& bytes, int stride = 0)
  {
    this->Bytes.resize((this->Bytes.size() + 3) / 4 * 4); // accessors are aligned
    this->Views += (this->Views.empty() ? "" : ",") + std::string("{\"buffer\":0,\"byteOffset\":") +
      std::to_string(this->Bytes.size()) + ",\"byteLength\":" + std::to_string(bytes.size()) +
      (stride > 0 ? ",\"byteStride\":" + std::to_string(stride) : "") + "}";
    this->Bytes += bytes;
    return this->NumberOfViews++;
  }

  int AddAccessor(
    int view, int type, std::size_t count, const std::string& shape, const std::string& more = "")
  {
    this->Accessors += (this->Accessors.empty() ? "" : ",") + std::string("{") +
      (view < 0 ? "" : "\"bufferView\":" + std::to_string(view) + ",") +
      "\"componentType\":" + std::to_string(type) + ",\"count\":" + std::to_string(count) +
      ",\"type\":\"" + shape + "\"" + more + "}";
    return this->NumberOfAccessors++;
  }

  int AddFloats(const std::vector<float>& values, int components = 3)
  {
    return this->AddAccessor(this->AddView(ToBytes(values)), 5126,
      values.size() / static_cast<std::size_t>(components),
      components == 1 ? "SCALAR" : "VEC" + std::to_string(components));
  }

  template <typename T>
  int AddIndices(const std::vector<T>& values)
  {
    return this->AddAccessor(this->AddView(ToBytes(values)),
      sizeof(T) == 1     ? 5121
        : sizeof(T) == 2 ? 5123
                         : 5125,
      values.size(), "SCALAR");
  }

  /// The document with further members, and a buffer of a URI; none: the binary chunk.
  std::string MakeJson(const std::string& members, const std::string& uri = "") const
  {
    return "{\"asset\":{\"version\":\"2.0\"},\n" + members + ",\n\"accessors\":[" +
      this->Accessors + "],\n\"bufferViews\":[" + this->Views +
      "],\n\"buffers\":[{\"byteLength\":" + std::to_string(this->Bytes.size()) +
      (uri.empty() ? "" : ",\"uri\":\"" + uri + "\"") + "}]}";
  }

  /// Makes a document with the buffer in it.
  std::string MakeText(const std::string& members) const
  {
    return this->MakeJson(
      members, "data:application/octet-stream;base64," + EncodeBase64(this->Bytes));
  }

  std::string MakeBinary(const std::string& members) const
  {
    std::string json = this->MakeJson(members);
    json.resize((json.size() + 3) / 4 * 4, ' ');
    const auto chunk = [](std::uint32_t type, const std::string& bytes) {
      return ToBytes<std::uint32_t>({ static_cast<std::uint32_t>(bytes.size()), type }) + bytes;
    };
    const std::string chunks = chunk(0x4E4F534A, json) + chunk(0x004E4942, this->Bytes);
    return "glTF" + ToBytes<std::uint32_t>({ 2, static_cast<std::uint32_t>(chunks.size() + 12) }) +
      chunks;
  }

  std::string Bytes;

private:
  std::string Views;
  std::string Accessors;
  int NumberOfViews = 0;
  int NumberOfAccessors = 0;
};

/// A primitive: its positions, indices (-1: none), and further members.
inline std::string MakePrimitive(int positions, int indices = -1, const std::string& more = "")
{
  return "{\"attributes\":{\"POSITION\":" + std::to_string(positions) + "}" +
    (indices < 0 ? "" : ",\"indices\":" + std::to_string(indices)) + more + "}";
}

/// Meshes of one primitive each, and nodes in a scene of the first node.
inline std::string MakeMembers(const std::string& nodes, const std::vector<std::string>& primitives)
{
  std::string meshes;
  for (const std::string& primitive : primitives)
  {
    meshes += (meshes.empty() ? "" : ",") + ("{\"primitives\":[" + primitive + "]}");
  }
  return "\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\n\"nodes\":[" + nodes + "],\n\"meshes\":[" +
    meshes + "]";
}

/// The corners of a unit tetrahedron, and its faces, seen from outside.
inline const std::vector<float> Corners = { 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1 };
inline const std::vector<std::uint16_t> Faces = { 0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2 };

/// A tetrahedron at some nodes.
inline std::string MakeTetrahedra(const std::string& nodes, const std::string& more = "")
{
  Maker maker;
  const int corners = maker.AddFloats(Corners);
  const int faces = maker.AddIndices(Faces);
  return maker.MakeText(MakeMembers(nodes, { MakePrimitive(corners, faces) }) + more);
}

} // namespace helios::gltf

#endif
