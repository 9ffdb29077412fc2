// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The blocks of a run that other ranks compute.

#ifndef heliosRankBlocks_h
#define heliosRankBlocks_h

#include "heliosBlockSource.h"
#include "heliosLegFiles.h"
#include "heliosLegPlan.h"
#include "heliosRankMessage.h"

#include <vtkDataObject.h>
#include <vtkSmartPointer.h>

#include <json/value.h>

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

class vtkHeliosRanks;

namespace helios
{

class Messages;

/**
 * Rank 0 gives every other rank two blocks at a time, in order, and a new one for each that it
 * receives: fast ranks compute more of them. No block is given far ahead of the one that is written
 * next, so that memory has a limit.
 */
class RankBlocks : public BlockSource
{
public:
  /// Called while nothing has arrived; false ends the run.
  using WaitCallback = std::function<bool()>;

  RankBlocks(vtkHeliosRanks* ranks, const LegFiles& files, Messages& log, WaitCallback onWait);
  ~RankBlocks() override;

  /// Makes the other ranks load an epoch.
  bool Begin(int epoch);

  /// Sets the legs with blocks, and the fingerprint that all ranks must have.
  void SetRun(const std::vector<LegPlan>& plans, const Json::Value& fingerprint);

  bool Compute(const LegPlan& plan, vtkIdType block, vtkIdType count) override;
  LegPiece Collect(const LegOutputs& outputs) override;
  void Count(ScanCounts& counts) override;

private:
  using Job = std::pair<std::size_t, vtkIdType>; // leg and block

  bool Send(int rank, const RankMessage& message);
  void AddJobs(const Job& first);
  bool AssignJobs();
  bool Wait();
  bool Accept(int rank, RankMessage& message);
  bool CheckFingerprint(int rank, const std::string& text);
  bool Fail(int rank, const std::string& problem);
  std::size_t FindFile(int port, std::size_t channel) const;
  vtkSmartPointer<vtkDataObject> GetData(int port, std::size_t channel);

  vtkHeliosRanks* Ranks;
  LegFiles Files;
  Messages& Log;
  WaitCallback OnWait;
  int Run; // number
  std::vector<LegPlan> Plans;
  Json::Value Fingerprint;
  std::vector<Job> Jobs;
  std::size_t Next = 0;     // job to give
  std::size_t Current = 0;  // job to write
  std::map<int, int> Given; // by rank that is ready: its jobs
  std::map<Job, RankMessage> Received;
  RankMessage Block;       // current
  LegOutputs CurrentFiles; // its outputs
  std::map<std::size_t, vtkSmartPointer<vtkDataObject>> Pieces;
};

} // namespace helios

#endif
