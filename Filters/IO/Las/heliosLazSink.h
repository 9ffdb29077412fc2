// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Points on their way to a LAZ file: collected to chunks, which are compressed in parallel.

#ifndef heliosLazSink_h
#define heliosLazSink_h

#include "heliosLazForm.h"
#include "heliosStatus.h"

#include <vtkType.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace helios
{

class LazSink
{
public:
  /// Message of an error of the file, which AppendBytes has reported.
  static constexpr const char* NotAppended = "not appended";

  /// Appends bytes to the file; false after an error.
  using AppendBytes = std::function<bool(const std::string&)>;

  /// Starts a file of points of this form, or goes on after chunks.
  LazSink(LazForm form, std::vector<LazChunk> chunks);

  /// Marks the state to which Restore() returns: before a block.
  void Mark();

  /// Removes the points since Mark(); the caller truncates the file.
  void Restore();

  /// Adds points, and appends chunks once there is one for each thread.
  Status Add(const std::vector<char>& records, const AppendBytes& append);

  /// Appends all points: the last chunk may be short.
  Status Finish(const AppendBytes& append);

  /// Returns the number of points in the file.
  vtkIdType GetNumberOfPoints() const;

  /// Encodes the table of the chunks.
  std::string EncodeTable() const;

private:
  Status AppendChunks(std::uint64_t points, const AppendBytes& append);

  LazForm Form;
  std::vector<LazChunk> Chunks; // in the file
  std::vector<char> Pending;    // points after them
  std::vector<char> Marked;     // points before Mark(), if some of them are in chunks since
  std::size_t MarkedSize = 0;
  std::size_t MarkedChunks = 0;
  bool HasAppended = false; // since Mark()
};

} // namespace helios

#endif
