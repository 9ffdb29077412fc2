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

/// Appends the records of the pulses [first, last), in order, and counts them.
ScanCounts RunScan(const ScanModel& model, vtkIdType first, vtkIdType last,
  const RunWatcher& goesOn, std::vector<ChunkResult>& results);

} // namespace helios

#endif
