// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Encodes the points of a block in parallel by vtkSMPTools.

#ifndef heliosLasEncoder_h
#define heliosLasEncoder_h

#include "heliosLasBlock.h"

#include <vtkSMPTools.h>

#include <algorithm>
#include <vector>

namespace helios
{

/// Encodes the points of a block in rounds of chunks; one round is in memory at a time.
class LasEncoder
{
public:
  LasEncoder(LasBlock& block, const LasScaling& scaling, vtkIdType count)
    : Block(block)
    , Scaling(scaling)
    , Count(count)
    , Chunks(8 * static_cast<std::size_t>(vtkSMPTools::GetEstimatedNumberOfThreads()))
  {
  }

  bool HasPoints() const { return this->Next < this->Count; }
  vtkIdType GetNext() const { return this->Next; }
  const LasSummary& GetSummary() const { return this->Summary; }

  /// Encodes the next round into bytes; false if one of its points cannot be encoded.
  bool NextRound(std::vector<char>& bytes)
  {
    const vtkIdType length = this->Block.GetPointLength();
    const vtkIdType first = this->Next;
    const vtkIdType count =
      std::min(this->Count - first, PointsPerChunk * static_cast<vtkIdType>(this->Chunks.size()));
    bytes.resize(static_cast<std::size_t>(count * length));
    const vtkIdType chunks = (count + PointsPerChunk - 1) / PointsPerChunk;
    const auto encode = [&](vtkIdType chunk)
    {
      const vtkIdType begin = chunk * PointsPerChunk;
      const vtkIdType end = std::min(count, begin + PointsPerChunk);
      Chunk& result = this->Chunks[static_cast<std::size_t>(chunk)];
      result = Chunk();
      char* records = bytes.data() + begin * length;
      result.IsGood = this->Block.Encode(this->Scaling, first + begin, first + end, records);
      if (result.IsGood)
      {
        result.Summary.Add(records, end - begin, length);
      }
    };
    vtkSMPTools::For(0, chunks, 1,
      [&encode](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType chunk = begin; chunk < end; ++chunk)
        {
          encode(chunk);
        }
      });
    return this->Claim(chunks, count);
  }

private:
  static constexpr vtkIdType PointsPerChunk = 4096;

  struct Chunk
  {
    LasSummary Summary;
    bool IsGood = false;
  };

  bool Claim(vtkIdType chunks, vtkIdType count)
  {
    const bool isGood = std::all_of(this->Chunks.begin(), this->Chunks.begin() + chunks,
      [](const Chunk& chunk) { return chunk.IsGood; });
    for (vtkIdType chunk = 0; isGood && chunk < chunks; ++chunk)
    {
      this->Summary.Add(this->Chunks[static_cast<std::size_t>(chunk)].Summary);
    }
    this->Next += isGood ? count : 0;
    return isGood;
  }

  LasBlock& Block;
  const LasScaling& Scaling;
  vtkIdType Count;
  vtkIdType Next = 0;
  std::vector<Chunk> Chunks;
  LasSummary Summary;
};

} // namespace helios

#endif
