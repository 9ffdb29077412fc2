// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Pulses through the kernel, on all threads.

#ifndef heliosScanRun_h
#define heliosScanRun_h

#include "heliosScanRecords.h"
#include "vtkHeliosScannerCoreModule.h" // For export macro

#include <vtkType.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace helios
{

struct ScanModel;

/// What was done of all [0, 1]; false ends the run.
using RunWatcher = std::function<bool(double)>;

/// Takes the records of some chunks, in order.
using ChunkSink = std::function<void(const std::vector<ChunkResult>&)>;

/**
 * How many chunks run between two looks at progress and abort: as many as a cache holds, and fewer
 * where they take long or hold much, so that a run of any survey can be stopped.
 */
class VTKHELIOSSCANNERCORE_EXPORT BatchSize
{
public:
  explicit BatchSize(vtkIdType threads)
    : Threads(threads)
  {
  }

  vtkIdType GetChunks() const { return this->Threads * this->ChunksPerThread; }

  /// After a batch.
  void Adapt(double seconds, std::size_t bytes);

private:
  vtkIdType Threads;
  vtkIdType ChunksPerThread = 1;
};

/// Hands on the records of the pulses [first, last), in order, a batch at a time; and counts them.
ScanCounts RunScan(const ScanModel& model, vtkIdType first, vtkIdType last,
  const RunWatcher& goesOn, const ChunkSink& take);

} // namespace helios

#endif
