// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosGltfDocument.h"

#include "heliosFileBytes.h"
#include "heliosGltfUri.h"
#include "heliosTextFile.h"

#include <json/json.h>

#include <algorithm>
#include <cstring>
#include <iterator>
#include <utility>

namespace helios
{

namespace
{

constexpr double BytesPerByte = 2.0; // memory per byte of a container
constexpr std::size_t HeadSize = 12; // head of a container [bytes]
constexpr std::size_t ChunkHeadSize = 8;
constexpr std::uint32_t JsonChunk = 0x4E4F534A;
constexpr std::uint32_t BinaryChunk = 0x004E4942;
constexpr std::int64_t LargestNumber = std::int64_t(1) << 53;

/// Extensions that are read.
constexpr const char* ReadExtensions[] = { "EXT_mesh_gpu_instancing", "KHR_mesh_quantization",
  "KHR_node_visibility" };

/// Words of extensions that change nothing of the default scene's triangles, of any vendor: looks,
/// data about objects, behaviour.
constexpr const char* HarmlessWords[] = { "_material", "_texture", "_light", "_xmp", "metadata",
  "feature", "_audio", "animation", "interactivity", "physics", "rigid", "collider", "_shapes",
  "outline", "_lod", "packing", "image", "environment", "_sky", "annotation", "selectab", "hover",
  "license", "blend", "technique", "ngon", "manifold", "_bim", "VRM", "camera", "articulation" };

std::uint32_t ReadUnsigned(std::string_view bytes, std::size_t at)
{
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(bytes[at + i]); };
  return byte(0) | byte(1) << 8 | byte(2) << 16 | static_cast<std::uint32_t>(byte(3)) << 24;
}

/// Returns whether an extension is supported. Compression changes how data are read, whatever it
/// compresses.
bool IsSupported(const std::string& extension)
{
  const auto has = [&extension](const char* word)
  { return extension.find(word) != std::string::npos; };
  return std::find(std::begin(ReadExtensions), std::end(ReadExtensions), extension) !=
    std::end(ReadExtensions) ||
    (!has("compression") && std::any_of(std::begin(HarmlessWords), std::end(HarmlessWords), has));
}

} // namespace

//------------------------------------------------------------------------------
std::string ElementPath(const char* list, std::int64_t index)
{
  return std::string(list) + '[' + std::to_string(index) + ']';
}

//------------------------------------------------------------------------------
Status GltfDocument::Read(const std::string& path)
{
  Status status = ReadBytes(path, BytesPerByte, this->Container);
  if (!status.IsOk())
  {
    return status;
  }
  const bool isBinary = this->Container.rfind("glTF", 0) == 0;
  status =
    isBinary ? this->ParseContainer(path) : this->File.Parse(path, std::move(this->Container));
  status = status.IsOk() ? this->CheckVersion() : status;
  return status.IsOk() ? this->CheckExtensions() : status;
}

//------------------------------------------------------------------------------
/// Parses a header of 12 bytes, then chunks: length, type, bytes.
Status GltfDocument::ParseContainer(const std::string& path)
{
  const std::string_view all = this->Container;
  std::string_view json;
  if (all.size() < HeadSize || ReadUnsigned(all, 4) != 2)
  {
    return Status::Error(path + ": its container is not of version 2; export glTF 2.0");
  }
  for (std::size_t at = HeadSize; at + ChunkHeadSize <= all.size();)
  {
    const std::size_t size = ReadUnsigned(all, at);
    const std::uint32_t type = ReadUnsigned(all, at + 4);
    at += ChunkHeadSize;
    if (size > all.size() - at)
    {
      return Status::Error(path + ": a chunk of " + std::to_string(size) +
        " bytes starts at byte " + std::to_string(at) + ", and " + std::to_string(all.size() - at) +
        " follow, so the file is cut off; copy or write it again");
    }
    std::string_view& chunk = type == JsonChunk ? json : this->Chunk;
    if ((type == JsonChunk || type == BinaryChunk) && chunk.empty())
    {
      chunk = all.substr(at, size);
    }
    at += size;
  }
  return json.empty() ? Status::Error(path + ": has no chunk of JSON; write it again")
                      : this->File.Parse(path, std::string(json));
}

//------------------------------------------------------------------------------
Status GltfDocument::CheckVersion() const
{
  const std::string version = GetText(GetMember(this->GetRoot(), "asset"), "version");
  return version.rfind("2.", 0) == 0
    ? Status()
    : this->Fail("asset.version",
        "is " + Quote(version) + ", not 2.0; give a file of glTF 2.0, or export it again");
}

//------------------------------------------------------------------------------
Status GltfDocument::CheckExtensions() const
{
  const Json::Value& required = GetMember(this->GetRoot(), "extensionsRequired");
  for (Json::ArrayIndex i = 0; required.isArray() && i < required.size(); ++i)
  {
    if (!required[i].isString() || !IsSupported(required[i].asString()))
    {
      return this->Fail(ElementPath("extensionsRequired", i),
        Describe(required[i]) +
          " is not supported, and may change the geometry; export without it (without "
          "compression)");
    }
  }
  return {};
}

//------------------------------------------------------------------------------
Status GltfDocument::Fail(const std::string& where, const std::string& message) const
{
  return Status::Error(this->GetPath() + ": " + where + ": " + message);
}

//------------------------------------------------------------------------------
std::int64_t GltfDocument::GetCount(const char* list) const
{
  const Json::Value& all = GetMember(this->GetRoot(), list);
  return all.isArray() ? all.size() : 0;
}

//------------------------------------------------------------------------------
const Json::Value& GltfDocument::GetElement(const char* list, std::int64_t index) const
{
  return GetMember(this->GetRoot(), list)[static_cast<Json::ArrayIndex>(index)];
}

//------------------------------------------------------------------------------
Status GltfDocument::FindIndex(
  const char* list, const Json::Value& value, const std::string& where, std::int64_t& index) const
{
  index = ReadIndex(value, this->GetCount(list));
  return index >= 0
    ? Status()
    : this->Fail(where,
        "is " + Describe(value) + ", and " + list + " has " + std::to_string(this->GetCount(list)) +
          " elements, counted from 0; correct the index");
}

//------------------------------------------------------------------------------
Status GltfDocument::ReadWhole(const Json::Value& object, const char* name,
  const std::string& where, std::int64_t missing, std::int64_t& number) const
{
  const Json::Value& value = GetMember(object, name);
  number = value.isNull() ? missing : ReadIndex(value, LargestNumber);
  return number >= 0 ? Status()
                     : this->Fail(where + '.' + name,
                         "is " + Describe(value) + ", not a whole number of 0 or more; correct it");
}

//------------------------------------------------------------------------------
Status GltfDocument::ReadView(const Json::Value& value, const std::string& where, GltfBytes& bytes)
{
  std::int64_t index = 0;
  Status status = this->FindIndex("bufferViews", value, where, index);
  if (!status.IsOk())
  {
    return status;
  }
  const Json::Value& view = this->GetElement("bufferViews", index);
  const std::string path = ElementPath("bufferViews", index);
  std::int64_t buffer = 0;
  std::int64_t begin = 0;
  std::int64_t size = 0;
  status = this->FindIndex("buffers", GetMember(view, "buffer"), path + ".buffer", buffer);
  status = status.IsOk() ? this->ReadWhole(view, "byteOffset", path, 0, begin) : status;
  status = status.IsOk() ? this->ReadWhole(view, "byteLength", path, 0, size) : status;
  status = status.IsOk() ? this->ReadWhole(view, "byteStride", path, 0, bytes.Stride) : status;
  std::string_view all;
  status = status.IsOk() ? this->ReadBuffer(buffer, all) : status;
  const auto present = static_cast<std::int64_t>(all.size());
  if (status.IsOk() && (begin > present || size > present - begin))
  {
    return this->Fail(path,
      "ends at byte " + std::to_string(begin + size) + ", and buffers[" + std::to_string(buffer) +
        "] has " + std::to_string(present) + "; correct byteOffset and byteLength");
  }
  bytes.Bytes = status.IsOk()
    ? all.substr(static_cast<std::size_t>(begin), static_cast<std::size_t>(size))
    : std::string_view();
  return status;
}

//------------------------------------------------------------------------------
/// Reads a buffer. The first buffer of a container is its binary chunk, unless it has a URI.
Status GltfDocument::ReadBuffer(std::int64_t index, std::string_view& bytes)
{
  const Json::Value& buffer = this->GetElement("buffers", index);
  const std::string where = ElementPath("buffers", index);
  std::int64_t size = 0;
  Status status = this->ReadWhole(buffer, "byteLength", where, 0, size);
  if (!status.IsOk())
  {
    return status;
  }
  if (index == 0 && GetMember(buffer, "uri").isNull() && !this->Chunk.empty())
  {
    bytes = this->Chunk;
  }
  else
  {
    const auto [found, isNew] = this->Buffers.emplace(index, "");
    status = isNew ? this->LoadBuffer(buffer, where, found->second) : status;
    bytes = found->second;
  }
  if (status.IsOk() && static_cast<std::int64_t>(bytes.size()) < size)
  {
    return this->Fail(where,
      "has " + std::to_string(bytes.size()) + " bytes in place of byteLength " +
        std::to_string(size) + ", so it is cut off; copy or write it again");
  }
  bytes = bytes.substr(0, static_cast<std::size_t>(size));
  return status;
}

//------------------------------------------------------------------------------
Status GltfDocument::LoadBuffer(
  const Json::Value& buffer, const std::string& where, std::string& bytes) const
{
  const Json::Value& uri = GetMember(buffer, "uri");
  if (!uri.isString())
  {
    return this->Fail(where + ".uri",
      uri.isNull() ? "is missing, and the file has no binary chunk; write it again"
                   : "is " + Describe(uri) + ", not a text; correct it");
  }
  const Status status = ReadUri(uri.asString(), this->GetPath(), bytes);
  return status.IsOk() ? status : this->Fail(where + ".uri", status.Message());
}

} // namespace helios
