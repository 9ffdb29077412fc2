// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Pulses through the kernel, on all threads.

#ifndef heliosScanRun_h
#define heliosScanRun_h

#include "heliosScanRecords.h"

#include <vtkType.h>

#include <functional>
#include <vector>

namespace helios
{

struct ScanModel;

/// What was done of all [0, 1]; false ends the run.
using RunWatcher = std::function<bool(double)>;

/// Takes the records of some chunks, in order.
using ChunkSink = std::function<void(const std::vector<ChunkResult>&)>;

/// Hands on the records of the pulses [first, last), in order, a batch at a time; and counts them.
ScanCounts RunScan(const ScanModel& model, vtkIdType first, vtkIdType last,
  const RunWatcher& goesOn, const ChunkSink& take);

} // namespace helios

#endif
