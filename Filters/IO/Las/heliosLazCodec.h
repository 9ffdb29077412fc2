// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Compression of points by LASzip. Any thread may use an object of its own.

#ifndef heliosLazCodec_h
#define heliosLazCodec_h

#include "heliosLazForm.h"
#include "heliosStatus.h"
#include "vtkHeliosFiltersIOModule.h" // For export macro

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace helios
{

/// A compressed chunk.
struct LazBytes
{
  std::uint64_t Points = 0;
  std::string Bytes;
};

/// Compresses points as one chunk; any thread may call it.
Status EncodeLazChunk(
  const LazForm& form, const char* records, std::uint64_t count, std::string& bytes);

/// Compresses points in parallel, in chunks as LASzip has them; the last one may be short.
VTKHELIOSFILTERSIO_EXPORT Status EncodeLazChunks(
  const LazForm& form, const char* records, std::uint64_t count, std::vector<LazBytes>& chunks);

/// Decompresses the points of a chunk, one range after the other.
class LazDecoder
{
public:
  /// Errors do not have the name of the file.
  Status Open(const LazForm& form, std::string bytes, std::uint64_t points);

  /// Decompresses the next points.
  Status Read(std::uint64_t count, char* records);

  LazDecoder();
  ~LazDecoder();
  LazDecoder(const LazDecoder&) = delete;
  void operator=(const LazDecoder&) = delete;

private:
  struct Parts;
  std::unique_ptr<Parts> Own;
};

///@{
/// Encodes and decodes the table of chunks; when decoding, ChunkSize gives the points of chunks if
/// it is not variable, and the last chunk has the rest of all points.
VTKHELIOSFILTERSIO_EXPORT std::string EncodeLazTable(const std::vector<LazChunk>& chunks);
Status DecodeLazTable(std::string_view bytes, const LazForm& form, std::uint64_t points,
  std::uint64_t room, std::vector<LazChunk>& chunks);
///@}

} // namespace helios

#endif
