// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Sorts points along a curve. Those that do not fit in memory are in a scratch file meanwhile.

#ifndef heliosPointSort_h
#define heliosPointSort_h

#include "heliosStatus.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace helios
{

/// A point of a file.
struct SortedPoint
{
  std::uint64_t Code = 0;  ///< its place on the curve
  std::uint64_t Index = 0; ///< its place in the file
  const char* Record = nullptr;
};

class PointSort
{
public:
  /// Sorts records of a length [bytes] in a memory [bytes]; the scratch file is in a folder.
  PointSort(std::string folder, std::size_t length, std::uint64_t memory);
  ~PointSort();
  PointSort(const PointSort&) = delete;
  void operator=(const PointSort&) = delete;

  /// Adds the next points of the file, with their codes.
  Status Add(const std::vector<std::uint64_t>& codes, const char* records);

  /// Calls an action with all points, sorted by code, then by index.
  Status Visit(const std::function<Status(const SortedPoint&)>& use);

private:
  struct Key
  {
    std::uint64_t Code;
    std::uint64_t Row;
  };

  /// Points in the scratch file that are sorted.
  struct Run
  {
    std::uint64_t Place; ///< first byte that is not read
    std::uint64_t Count; ///< points that are not read
    std::vector<char> Bytes;
    std::size_t At = 0; ///< first byte of the current point in Bytes
  };

  SortedPoint GetPoint(const Run& run) const;
  void Sort();
  Status StoreRun();
  Status Load(Run& run);
  Status Append(const std::vector<char>& bytes);
  Status VisitMemory(const std::function<Status(const SortedPoint&)>& use);
  Status Merge(const std::function<Status(const SortedPoint&)>& use);
  Status Fail(const char* what, int error) const;

  std::string Folder;
  std::size_t Length;
  std::size_t EntrySize; ///< size of a point in the scratch file: code, index, record
  std::uint64_t Memory;
  std::uint64_t RowsPerRun;
  std::vector<Key> Keys;
  std::vector<char> Records;
  std::uint64_t First = 0; ///< index of the first point in memory
  std::vector<Run> Runs;
  int Scratch = -1; ///< descriptor; -1: none
  std::uint64_t ScratchSize = 0;
};

} // namespace helios

#endif
