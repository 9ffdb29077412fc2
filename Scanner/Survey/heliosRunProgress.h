// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// How far a run is, and the same as JSON.

#ifndef heliosRunProgress_h
#define heliosRunProgress_h

#include "heliosPartFile.h"
#include "heliosRunCounts.h"

#include <json/value.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace helios
{

/// How far a file of a leg is.
struct FileProgress
{
  std::string Name;      ///< the final one, without its folder
  vtkIdType Size = 0;    ///< [bytes]; of an index, without its pieces
  vtkIdType Records = 0; ///< in it, or in its pieces
  vtkIdType Bytes = 0;   ///< of the records, wherever they are
  bool IsWhole = false;  ///< it has its final name
  std::string Head;      ///< the checksum of the bytes that every block writes over; empty: none
  std::vector<FileBlock> Blocks; ///< since the line before, in this file and those beside it
};

/// How far a leg is.
struct LegProgress
{
  int Blocks = 0; ///< that are safe
  bool IsDone = false;
  std::vector<FileProgress> Files;
  RunCounts Counts;     ///< of the run, up to here
  double Seconds = 0.0; ///< of computing and writing, over all its attempts
};

/// Whether no number is smaller than before.
bool HasGrown(const RunCounts& before, const RunCounts& after);
bool HasGrown(const FileProgress& before, const FileProgress& after);

///@{
/// JSON in one line, or in lines for people; false where a text is none.
std::string ToLine(const Json::Value& value);
std::string ToText(const Json::Value& value);
bool FromText(const std::string& text, Json::Value& value);
///@}

///@{
/// Counts by their names.
Json::Value ToJson(const RunCounts& counts);
RunCounts CountsFromJson(const Json::Value& value);
///@}

/// A member that is missing, of another type or out of range; the text says which.
class BadJson : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

///@{
/// Strict: throws BadJson.
vtkIdType GetCount(const Json::Value& value, const char* name);
LegProgress ProgressFromJson(const Json::Value& value);
///@}

Json::Value ToJson(const LegProgress& progress);

} // namespace helios

#endif
