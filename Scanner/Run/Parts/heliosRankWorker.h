// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Computes blocks for another rank.

#ifndef heliosRankWorker_h
#define heliosRankWorker_h

#include "heliosLegFiles.h"
#include "heliosRankMessage.h"

#include <string>
#include <vector>

namespace helios
{

class LegRunner;
class Messages;
struct LegPlan;

class RankWorker
{
public:
  /// Sets the files of parts, and the runner of the whole run.
  RankWorker(const LegFiles& files, LegRunner& runner, Messages& log);
  ~RankWorker();

  /// Computes the block of a job; a message with the block, or with an error.
  RankMessage Compute(const RankMessage& job);

private:
  bool Open(const LegPlan& plan);
  void Close();
  bool Fill(const LegPlan& plan, RankMessage& block);

  LegFiles Files;
  LegRunner& Runner;
  Messages& Log;
  const LegPlan* Plan = nullptr; // plan of the open outputs
  LegOutputs Outputs;
  std::vector<std::string> Texts; // texts of the outputs
};

} // namespace helios

#endif
