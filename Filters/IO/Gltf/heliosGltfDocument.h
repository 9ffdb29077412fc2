// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A glTF 2.0 document, as JSON or in the binary container, and its buffers.

#ifndef heliosGltfDocument_h
#define heliosGltfDocument_h

#include "heliosJsonFile.h"
#include "heliosStatus.h"

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace helios
{

/// Returns "meshes[3]".
std::string ElementPath(const char* list, std::int64_t index);

/// Bytes of a buffer, and the distance of elements in them [bytes]; 0: they follow each other.
struct GltfBytes
{
  std::string_view Bytes;
  std::int64_t Stride = 0;
};

/// Errors name the file and the value by its JSON path: "a.glb: meshes[0].primitives[1].indices: ".
class GltfDocument
{
public:
  /// Reads a .gltf or a .glb, whichever its first bytes are, and checks version and extensions.
  Status Read(const std::string& path);

  const Json::Value& GetRoot() const { return this->File.GetRoot(); }
  const std::string& GetPath() const { return this->File.GetPath(); }

  /// Returns an error at a JSON path.
  Status Fail(const std::string& where, const std::string& message) const;

  /// @{
  /// Finds the index of an element of a list of the root, given by a value at a JSON path.
  Status FindIndex(const char* list, const Json::Value& value, const std::string& where,
    std::int64_t& index) const;
  const Json::Value& GetElement(const char* list, std::int64_t index) const;
  std::int64_t GetCount(const char* list) const;
  ///@}

  /// Reads a whole number of at least 0 in a member of an object; the default if it is missing.
  Status ReadWhole(const Json::Value& object, const char* name, const std::string& where,
    std::int64_t missing, std::int64_t& number) const;

  /// Reads the bytes of a buffer view; loads its buffer.
  Status ReadView(const Json::Value& value, const std::string& where, GltfBytes& bytes);

private:
  Status ParseContainer(const std::string& path);
  Status CheckVersion() const;
  Status CheckExtensions() const;
  Status ReadBuffer(std::int64_t index, std::string_view& bytes);
  Status LoadBuffer(const Json::Value& buffer, const std::string& where, std::string& bytes) const;

  JsonFile File;
  std::string Container;                       // the bytes of a .glb
  std::string_view Chunk;                      // its binary chunk
  std::map<std::int64_t, std::string> Buffers; // loaded ones, but for the chunk
};

} // namespace helios

#endif
