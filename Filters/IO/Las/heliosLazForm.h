// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// How the points of a LAZ file are compressed: the record of LASzip, and the table of chunks.

#ifndef heliosLazForm_h
#define heliosLazForm_h

#include "heliosLasFormat.h"
#include "heliosStatus.h"
#include "vtkHeliosFiltersIOModule.h" // For export macro

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace helios
{

/// Fields of a point that are compressed together.
struct LazItem
{
  int Type = 0; ///< number in LASitem::Type
  int Size = 0; ///< [bytes]
  int Version = 0;
};

/// Points that are compressed together.
struct LazChunk
{
  std::uint64_t Points = 0;
  std::uint64_t Bytes = 0;
};

/// Points of a chunk that is written, as LASzip has it.
inline constexpr std::uint64_t LazPointsPerChunk = 50000;

/// Number of bytes that locate the table of chunks, before the first chunk.
inline constexpr std::uint64_t LazTablePlaceSize = 8;

struct VTKHELIOSFILTERSIO_EXPORT LazForm
{
  static constexpr const char* User = "laszip encoded";
  static constexpr int RecordId = 22204;
  static constexpr std::uint32_t Variable = 0xFFFFFFFF; ///< a chunk size: the table has the sizes

  bool IsLayered = true; ///< formats 6 to 10
  bool HasChunks = true; ///< false: LASzip 1, one chunk without a table
  std::uint32_t ChunkSize = Variable;
  std::vector<LazItem> Items;
  int PointLength = 0; ///< [bytes]

  /// Makes the form of points that are written.
  static LazForm Make(int format, int pointLength);

  /// Encodes the record of LASzip.
  LasRecord Encode() const;

  /// Decodes its data, and checks them against the point length and format of the header.
  Status Decode(std::string_view data, const LasHeader& header);

  /// Returns the number of layers of a chunk, if it has layers.
  std::uint64_t GetNumberOfLayers() const;

  /// Returns the bytes of a chunk before its layers: a point, its number of points, sizes of layers.
  std::uint64_t GetHeadSize() const;

  /// Reads the head of a chunk with layers; an error if its layers do not fit in a number of bytes.
  Status DecodeHead(std::string_view head, std::uint64_t room, LazChunk& chunk) const;
};

} // namespace helios

#endif
