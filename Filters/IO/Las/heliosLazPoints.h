// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The points of a LAZ file, decompressed chunk by chunk.

#ifndef heliosLazPoints_h
#define heliosLazPoints_h

#include "heliosLazForm.h"
#include "heliosStatus.h"
#include "vtkHeliosFiltersIOModule.h" // For export macro

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace helios
{

class LazDecoder;

class VTKHELIOSFILTERSIO_EXPORT LazPoints
{
public:
  /// Reads bytes of the file: place, number, bytes.
  using ReadBytes = std::function<bool(std::uint64_t, std::uint64_t, char*)>;

  /// Finds the chunks of a file of a size. Errors are "has ...".
  Status Open(const LasHeader& header, const LasRecord* record, std::uint64_t size, ReadBytes read);

  /// Finds the chunks without the table: one after the other up to the end of the file, which is
  /// being written. Only for points with layers.
  Status OpenGrowing(
    const LasHeader& header, const LasRecord* record, std::uint64_t size, ReadBytes read);

  /// Reads the raw points first to first + count, chunks in parallel.
  Status Read(std::uint64_t first, std::uint64_t count, char* bytes);

  /// Returns the number of points of all chunks.
  std::uint64_t GetCount() const { return this->Begins.back().Points; }
  const std::vector<LazChunk>& GetChunks() const { return this->Chunks; }

  LazPoints();
  ~LazPoints();

private:
  /// Points of one chunk.
  struct Part
  {
    std::size_t Chunk = 0;
    std::uint64_t Begin = 0; // in the chunk
    std::uint64_t End = 0;
    char* Bytes = nullptr;
    std::unique_ptr<LazDecoder> Decoder; // at Begin; null: none yet
  };

  Status Start(
    const LasHeader& header, const LasRecord* record, std::uint64_t size, ReadBytes read);
  Status FindTable(std::uint64_t points, std::uint64_t& place);
  Status ReadTable(std::uint64_t points, std::uint64_t place);
  Status FindChunks(std::uint64_t points);
  Status CheckChunks(std::uint64_t points, std::uint64_t end) const;
  void SetBegins();
  Status ReadPart(Part& part);
  std::vector<Part> FindParts(std::uint64_t first, std::uint64_t count, char* bytes);

  LazForm Form;
  ReadBytes ReadFile;
  std::uint64_t Begin = 0; // first byte of the chunks
  std::uint64_t Size = 0;  // size of the file [bytes]
  std::vector<LazChunk> Chunks;
  std::vector<LazChunk> Begins; // first point and byte of each chunk, and the ends of the last one
  std::unique_ptr<LazDecoder> Current; // decoder of the chunk that was read in part
  std::size_t CurrentChunk = 0;
  std::uint64_t CurrentNext = 0;
};

} // namespace helios

#endif
