// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Reads the blocks of a run from its parts.

#ifndef heliosRunPartReader_h
#define heliosRunPartReader_h

#include "heliosBlockSource.h"
#include "heliosLegFiles.h"
#include "heliosRunPartFolder.h"
#include "heliosStatus.h"

#include <vtkDataObject.h>
#include <vtkSmartPointer.h>

#include <json/value.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace helios
{

class Messages;

class RunPartReader : public BlockSource
{
public:
  RunPartReader(const SurveyData& survey, const RunSettings& settings, Messages& log);
  ~RunPartReader() override;

  /// Reads the journals of all parts, in any order: they must belong to one run.
  Status Open(const std::vector<std::string>& folders);

  /// Checks that the parts are of a run with this fingerprint. A scene not known yet is ignored.
  Status CheckFingerprints(const Json::Value& fingerprint) const;

  /// Checks that the parts have all blocks of the legs, and finds them.
  Status FindBlocks(const std::vector<LegPlan>& plans);

  /// Returns how long the blocks of all parts took [s].
  double GetSeconds() const;

  bool Compute(const LegPlan& plan, vtkIdType block, vtkIdType count) override;
  LegPiece Collect(const LegOutputs& outputs) override;
  void Count(ScanCounts& counts) override;

private:
  using Place = std::pair<int, std::size_t>; // port and channel

  struct Block
  {
    const RunPartFolder* Part;
    const RunPartBlock* Data;
  };

  Status Sort();
  Status FindMissing() const;
  bool Check(const Status& status);
  FileProgress FindFile(const LegOutput& file) const;
  bool ReadPiece(const LegOutput& file);
  OutputPiece CollectOne(const LegOutput& output);

  LegFiles Files;
  Messages& Log;
  std::vector<RunPartFolder> Parts;
  std::vector<Block> Blocks;                     // blocks of the run
  std::map<std::size_t, std::size_t> FirstBlock; // first block of each leg
  const Block* Current = nullptr;
  LegOutputs CurrentFiles; // files of its part
  std::map<Place, vtkSmartPointer<vtkDataObject>> Pieces;
};

} // namespace helios

#endif
