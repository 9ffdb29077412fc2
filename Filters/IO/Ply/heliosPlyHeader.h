// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The header of a polygon file (PLY): its elements and their properties.

#ifndef heliosPlyHeader_h
#define heliosPlyHeader_h

#include "heliosStatus.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace helios
{

enum class PlyType
{
  Int8,
  UInt8,
  Int16,
  UInt16,
  Int32,
  UInt32,
  Float32,
  Float64
};

enum class PlyStorage
{
  Text,
  LittleEndian,
  BigEndian
};

struct PlyProperty
{
  std::string Name;
  PlyType Type = PlyType::Float32;
  bool IsList = false;
  PlyType CountType = PlyType::UInt8; ///< type of the count of a list
};

struct PlyElement
{
  std::string Name;
  std::int64_t Count = 0;
  std::vector<PlyProperty> Properties;

  /// Returns the index of a property, -1 if missing.
  int Find(const std::string& name) const;
};

/// Contents that a file is read as: the vertices and faces of a mesh, or vertices as points.
enum class PlyContent
{
  Mesh,
  Points
};

struct PlyHeader
{
  PlyStorage Storage = PlyStorage::Text;
  std::vector<PlyElement> Elements;
  int Axes[3] = { -1, -1, -1 };             ///< the properties x, y and z of a vertex
  std::map<std::string, std::string> Marks; ///< marks in comments: comment vtkhelios KEY VALUE
  std::int64_t DataBegin = 0;               ///< [bytes]
  std::int64_t DataLine = 0;                ///< number of the first line of data

  /// Reads the header of a file and compares its counts with the size of the file; errors have file:line.
  Status Read(const std::string& path, PlyContent content);

  const PlyElement* Find(const std::string& name) const;

private:
  /// Fewest bytes of the data, with empty lists.
  double GetSmallestSize() const;
};

/// Returns the size of a number in binary files [bytes].
inline std::size_t GetSize(PlyType type)
{
  constexpr std::size_t sizes[] = { 1, 1, 2, 2, 4, 4, 4, 8 };
  return sizes[static_cast<std::size_t>(type)];
}

/// @{
/// Returns the name in headers.
const char* GetName(PlyType type);
const char* GetName(PlyStorage storage);
///@}

} // namespace helios

#endif
