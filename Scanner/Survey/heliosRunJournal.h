// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// What a run has finished, on the disk while it goes on: run.journal, one JSON object a line. The first
// line is the fingerprint of the run, the others say after every block and every leg what is safe. The
// last member of every line, "check", is a checksum of the line and of all lines before it.

#ifndef heliosRunJournal_h
#define heliosRunJournal_h

#include "heliosRunProgress.h"

#include <map>
#include <string>
#include <vector>

namespace helios
{

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

  /// How far a file is that some leg has written to; null: it has nothing that is safe.
  const FileProgress* FindFile(const std::string& name) const;

  /// How far all files are, by their names.
  const std::map<std::string, FileProgress>& GetFiles() const { return this->Files; }

  /// What was read of the bytes of files, in the order in which they were written.
  const std::vector<FileBlock>& GetBlocks() const { return this->Blocks; }

  /// Whether the file is still there, while it is written; else an error in words.
  std::string Check();

  /// After the run is whole.
  void Remove();

  static const char* GetName() { return "run.journal"; }

private:
  void Forget();
  bool IsWithoutChecksums() const;
  std::string Seal(const Json::Value& value);
  bool Unseal(const std::string& line, std::string& body);
  std::string Take(const std::string& body);
  std::string CheckFollows(std::size_t leg, const LegProgress& progress) const;
  void Take(std::size_t leg, const LegProgress& progress);

  std::string Path;
  LogFile File;
  Json::Value Fingerprint;
  std::map<std::size_t, LegProgress> Legs;
  std::map<std::string, FileProgress> Files;
  std::vector<FileBlock> Blocks;
  std::size_t Leg = 0;    // of the last line
  RunCounts Counts;       // of the last line
  std::string LastSeal;   // the checksum of the last line
  std::uint64_t Size = 0; // of the lines that were read
};

/// Writes a text to a file: whole under its name, or not at all. Says what went wrong.
std::string WriteWhole(const std::string& path, const std::string& text);

} // namespace helios

#endif
