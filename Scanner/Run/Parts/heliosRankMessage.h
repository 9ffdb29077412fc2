// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Messages between the ranks of a run.

#ifndef heliosRankMessage_h
#define heliosRankMessage_h

#include "heliosScanCounts.h"
#include "vtkHeliosScannerRunModule.h" // For export macro

#include <string>
#include <vector>

namespace helios
{

/// Records of a block for one output: rows of text, or a piece of VTK XML.
struct RankRecords
{
  vtkIdType Count = 0;
  std::string Bytes;
};

/// A message as text: a line of JSON, and the bytes of the records.
struct VTKHELIOSSCANNERRUN_EXPORT RankMessage
{
  static constexpr const char* Begin = "begin"; ///< to all: load the epoch Run of a survey
  static constexpr const char* Ready = "ready"; ///< from all: loaded, with the fingerprint
  static constexpr const char* Job = "job";     ///< to one: compute a block
  static constexpr const char* Block = "block"; ///< from one: the block
  static constexpr const char* Fault = "fault"; ///< from one: it has failed, with an error
  static constexpr const char* End = "end";     ///< to all and from all: end the service

  RankMessage() = default;
  explicit RankMessage(const std::string& kind)
    : Kind(kind)
  {
  }

  std::string Encode() const;

  /// Decodes a text; false if it is no message.
  bool Decode(const std::string& text);

  std::string Kind;
  int Run = 0;   ///< number of the run; messages of earlier ones are ignored
  int Epoch = 0; ///< epoch of the survey
  int Leg = 0;
  vtkIdType Index = 0;     ///< index of the block in the leg
  ScanCounts Counts;       ///< counts of the block
  std::string Fingerprint; ///< JSON
  std::string Error;
  std::vector<RankRecords> Records; ///< by output of the leg
};

} // namespace helios

#endif
