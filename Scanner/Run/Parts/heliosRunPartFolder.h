// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The folder of a part of a run: what its journal states, and whether its files are complete.

#ifndef heliosRunPartFolder_h
#define heliosRunPartFolder_h

#include "heliosRunPart.h"
#include "heliosRunProgress.h"
#include "heliosScanCounts.h"
#include "heliosStatus.h"

#include <json/value.h>

#include <map>
#include <string>
#include <vector>

namespace helios
{

struct LegPlan;

/// A block of a part.
struct RunPartBlock
{
  std::size_t Leg = 0;
  std::vector<FileProgress> Files; ///< Records belong to the block
  ScanCounts Counts;               ///< counts of the block
};

class RunPartFolder
{
public:
  explicit RunPartFolder(const std::string& path);

  /// Reads the journal, and the summary if there is one.
  Status Read();

  /// Checks the blocks against the legs of the run, and the sizes of the files.
  Status Check(const std::vector<LegPlan>& plans) const;

  /// Checks the bytes of a block.
  Status CheckBlock(const FileBlock& block) const;

  /// Returns the path of a file.
  std::string FindFile(const std::string& name) const;

  const RunPart& GetPart() const { return this->Part; }
  const Json::Value& GetFingerprint() const { return this->Fingerprint; }
  const std::vector<RunPartBlock>& GetBlocks() const { return this->Blocks; }

  /// Returns how long its blocks took [s].
  double GetSeconds() const;

  /// Returns the folder and the part, for messages.
  std::string Describe() const;

private:
  Status CheckSummary() const;
  void AddBlock(std::size_t leg, const LegProgress& progress);
  std::string GetCure(const char* option) const;

  std::string Path;
  RunPart Part;
  Json::Value Fingerprint;
  std::vector<RunPartBlock> Blocks;
  ScanCounts Counts;                        // counts of the blocks so far
  std::map<std::string, vtkIdType> Records; // records of the files so far
  std::map<std::size_t, double> Seconds;    // seconds of the legs so far
};

} // namespace helios

#endif
