// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The state of a run on disk: run.journal, one JSON object per line. The first line is the
// fingerprint of the run; after every block and every leg a line records what is safe. The last
// member of every line, "check", is a checksum of all lines up to and including it.

#ifndef heliosRunJournal_h
#define heliosRunJournal_h

#include "heliosRunProgress.h"
#include "heliosStatus.h"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace helios
{

/// The version of summaries and fingerprints: 2 has epochs, which 1 called plays.
inline constexpr int SummaryVersion = 2;

/// Converts a summary or fingerprint of version 1, which states none.
void ConvertToCurrent(Json::Value& summary);

class RunJournal
{
public:
  explicit RunJournal(const std::string& folder);

  const std::string& GetPath() const { return this->Path; }
  bool Exists() const;

  /// @{
  /// Create or read a journal; an incomplete last line is ignored.
  Status Create(const Json::Value& fingerprint); ///< a new one
  Status Read();                                 ///< journal of an earlier run
  Status Continue();                             ///< after Read()
  Status Append(std::size_t leg, const LegProgress& progress);
  ///@}

  /// Returns the fingerprint of the run whose journal was read.
  const Json::Value& GetFingerprint() const { return this->Fingerprint; }

  const LegProgress& GetLeg(std::size_t leg) const;

  /// Finds the progress of a file of some leg; null: no block of the file is safe.
  const FileProgress* FindFile(const std::string& name) const;

  /// Returns the progress of all files, by name.
  const std::map<std::string, FileProgress>& GetFiles() const { return this->Files; }

  /// @{
  /// Return the lines that Read() has read: the leg, and its progress. Remembered on request only.
  void RememberLines() { this->RemembersLines = true; }
  const std::vector<std::pair<std::size_t, LegProgress>>& GetLines() const { return this->Lines; }
  ///@}

  /// Returns the file blocks that were read, in the order of writing.
  const std::vector<FileBlock>& GetBlocks() const { return this->Blocks; }

  /// Checks that the file still exists while it is written.
  Status Check();

  /// For a complete run.
  void Remove();

private:
  void Forget();
  bool IsWithoutChecksums() const;
  std::string Seal(const Json::Value& value);
  bool Unseal(const std::string& line, std::string& body);
  Status ReadLine(const std::string& body);
  Status CheckFollows(std::size_t leg, const LegProgress& progress) const;
  void Accept(std::size_t leg, const LegProgress& progress);

  std::string Path;
  LogFile File;
  Json::Value Fingerprint;
  std::map<std::size_t, LegProgress> Legs;
  std::map<std::string, FileProgress> Files;
  std::vector<FileBlock> Blocks;
  std::vector<std::pair<std::size_t, LegProgress>> Lines;
  bool RemembersLines = false;
  std::size_t Leg = 0;    // leg of the last line
  ScanCounts Counts;      // counts of the last line
  std::string LastSeal;   // the checksum of the last line
  std::uint64_t Size = 0; // size of the lines that were read
};

} // namespace helios

#endif
