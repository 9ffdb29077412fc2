// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A rank that serves rank 0.

#ifndef heliosRankServer_h
#define heliosRankServer_h

#include "heliosRankMessage.h"
#include "heliosStatus.h"

#include <atomic>
#include <functional>
#include <string>

class vtkHeliosRanks;

namespace helios
{

class RankWorker;

class RankServer
{
public:
  /// Objects that compute the blocks of an epoch.
  struct Service
  {
    RankWorker* Worker = nullptr; ///< null: see the error
    std::string Fingerprint;      ///< JSON
    std::string Error;
  };
  using LoadCallback = std::function<Service(int epoch)>;

  explicit RankServer(vtkHeliosRanks* ranks);

  /// Loads and computes what rank 0 requests, until it ends the service or stop is true.
  Status Serve(const LoadCallback& load, const std::atomic<bool>& stop);

private:
  bool Receive(const std::atomic<bool>& stop, RankMessage& message) const;
  RankMessage RespondTo(const RankMessage& message, const LoadCallback& load);

  vtkHeliosRanks* Ranks;
  Service Current;
  int Run = 0; // number of the run
};

} // namespace helios

#endif
