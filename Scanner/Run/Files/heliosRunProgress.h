// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The progress of a run, and its JSON form.

#ifndef heliosRunProgress_h
#define heliosRunProgress_h

#include "heliosPartFile.h"
#include "heliosScanCounts.h"

#include <json/value.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace helios
{

/// The progress of a file of a leg.
struct FileProgress
{
  std::string Name;              ///< the final one, without its folder
  vtkIdType Size = 0;            ///< [bytes]; of an index, without its pieces
  vtkIdType Records = 0;         ///< in it, or in its pieces
  vtkIdType Bytes = 0;           ///< bytes of the records, in all files
  bool IsWhole = false;          ///< it has its final name
  std::string Head;              ///< checksum of the bytes that every block overwrites; empty: none
  std::vector<FileBlock> Blocks; ///< since the last line, in this file and those beside it
};

/// The progress of a leg.
struct LegProgress
{
  int Blocks = 0; ///< safe blocks
  int Pieces = 0; ///< safe pieces of the next block: the run was stopped within it
  bool IsDone = false;
  std::vector<FileProgress> Files;
  ScanCounts Counts;    ///< counts of the run so far
  double Seconds = 0.0; ///< computing and writing time, over all attempts
};

/// Returns whether one can be journaled after the other, of the same leg.
bool Follows(const LegProgress& before, const LegProgress& after);

/// Returns whether a file was written anew when it became complete, with all its bytes in one block.
bool IsRewritten(const FileProgress& file);

/// Returns whether no count has decreased; a file that was written anew may be smaller.
bool HasGrown(const ScanCounts& before, const ScanCounts& after);
bool HasGrown(const FileProgress& before, const FileProgress& after);

/// @{
/// Write JSON in one line, or indented, and read it; false if a text is not valid.
std::string ToLine(const Json::Value& value);
std::string ToText(const Json::Value& value);
bool FromText(const std::string& text, Json::Value& value);
///@}

///@{
/// Counts with their names.
Json::Value ToJson(const ScanCounts& counts);
ScanCounts CountsFromJson(const Json::Value& value);
///@}

/// A member is missing, of another type or out of range; the text names it.
class BadJson : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// @{
/// Read values strictly: throw BadJson.
vtkIdType GetCount(const Json::Value& value, const char* name);
LegProgress ProgressFromJson(const Json::Value& value);
///@}

Json::Value ToJson(const LegProgress& progress);

} // namespace helios

#endif
