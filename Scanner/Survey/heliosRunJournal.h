// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// What a run has finished, on the disk while it goes on: run.journal, one JSON object a line. The first
// line is the fingerprint of the run, the others say after every block and every leg what is safe.

#ifndef heliosRunJournal_h
#define heliosRunJournal_h

#include "heliosPartFile.h"
#include "heliosRunCounts.h"

#include <json/value.h>

#include <map>
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
};

/// How far a leg is.
struct LegProgress
{
  int Blocks = 0; ///< that are safe
  bool IsDone = false;
  std::vector<FileProgress> Files;
  RunCounts Counts;     ///< of the run, up to here
  double Seconds = 0.0; ///< of computing and writing, over all its attempts

  /// The file of a name; null: none.
  const FileProgress* FindFile(const std::string& name) const;
};

class RunJournal
{
public:
  explicit RunJournal(const std::string& folder);

  const std::string& GetPath() const { return this->Path; }
  bool Exists() const;

  ///@{
  /// Each says in words what is wrong, or returns an empty text. A last line that is torn is ignored.
  std::string Create(const Json::Value& fingerprint); ///< anew
  std::string Read();                                 ///< what an earlier run wrote
  std::string Continue();                             ///< after Read()
  std::string Append(std::size_t leg, const LegProgress& progress);
  ///@}

  /// That of the run that wrote what was read.
  const Json::Value& GetFingerprint() const { return this->Fingerprint; }

  const LegProgress& GetLeg(std::size_t leg) const;
  const std::map<std::size_t, LegProgress>& GetLegs() const { return this->Legs; }

  /// After the run is whole.
  void Remove();

  static const char* GetName() { return "run.journal"; }

private:
  bool Take(const std::string& line);

  std::string Path;
  LogFile File;
  Json::Value Fingerprint;
  std::map<std::size_t, LegProgress> Legs;
  std::uint64_t Size = 0; // of the lines that were read
};

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

/// Writes a text to a file: whole under its name, or not at all. Says what went wrong.
std::string WriteWhole(const std::string& path, const std::string& text);

} // namespace helios

#endif
