// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The header of a polygon file (PLY): its elements and their properties.

#ifndef heliosPlyHeader_h
#define heliosPlyHeader_h

#include "heliosStatus.h"

#include <cstdint>
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
  PlyType CountType = PlyType::UInt8; ///< of a list
};

struct PlyElement
{
  std::string Name;
  std::int64_t Count = 0;
  std::vector<PlyProperty> Properties;

  /// The index of a property, -1 if missing.
  int Find(const std::string& name) const;
};

struct PlyHeader
{
  PlyStorage Storage = PlyStorage::Text;
  std::vector<PlyElement> Elements;
  std::int64_t DataBegin = 0; ///< [bytes]
  std::int64_t DataLine = 0;  ///< number of the first line of data

  /// Reads the header of a file; errors have file:line.
  Status Read(const std::string& path);

  const PlyElement* Find(const std::string& name) const;

  /// Fewest bytes of the data, with empty lists.
  double GetSmallestSize() const;
};

/// The size of a number in binary files [bytes].
std::size_t GetSize(PlyType type);

} // namespace helios

#endif
