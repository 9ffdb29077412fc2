// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Runs pulses through the kernel, on all threads.
//
// The pulses of a scan are divided at five levels:
//
//   |<--------------------- block ---------------------->|<- ...   flushed to disk, journaled
//   |<-------- piece -------->|<-------- piece --------->|         requested from the pipeline
//   |<- batch ->|<-- batch -->|<- ...                              appended to the output
//   |  |  |  |  |  |  |  |  | chunk                                a task of a thread
//   ||||||||                  group                                rays traced together
//
// - A block is what a run that is killed may lose (--pulses-per-block).
// - A piece is a part in VTK's sense (UPDATE_PIECE_NUMBER), computed by one update of the scanner and
//   written while the next one is computed: 32768 pulses, with 16 and more threads more, or the whole block of VTK XML.
// - A batch is as many chunks as take 0.05 to 0.5 s (BatchSize); then its records are appended to
//   the output, and progress is reported.
// - A chunk is up to 256 pulses, fewer in a small piece or if pulses are slow: PulseKernel::Run(),
//   which fills one ChunkResult.
// - A group is up to 32 pulses (PulseKernel): their rays and hits stay in the cache, one RayBatch. The
//   sub-rays of each of its pulses are a bundle (BeamBundle).
//
// Pulses may become slower within a batch: WorkWatch also reports progress between its groups, and
// ends the run after the pulse that each thread is at.
//
// The output is byte-identical for any of these sizes.

#ifndef heliosScanRun_h
#define heliosScanRun_h

#include "heliosScanCounts.h"
#include "heliosScanRecords.h"
#include "heliosStatus.h"
#include "heliosWorkWatch.h"
#include "vtkHeliosScannerCoreModule.h" // For export macro

#include <vtkType.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace helios
{

struct ScanModel;

/// Receives the records of some chunks, in order.
using ChunkSink = std::function<void(const std::vector<ChunkResult>&)>;

/**
 * The number of chunks of a batch, and the most pulses of a chunk: limited by the cache, and smaller
 * for slow or large chunks, so that progress is reported often.
 */
class VTKHELIOSSCANNERCORE_EXPORT BatchSize
{
public:
  explicit BatchSize(vtkIdType threads = 1)
    : Threads(threads)
  {
  }

  void SetThreads(vtkIdType threads) { this->Threads = threads; }
  vtkIdType GetChunks() const { return this->Threads * this->ChunksPerThread; }
  vtkIdType GetMaximumPulses() const { return this->MaximumPulses; }

  /// Adapts the size after a batch.
  void Adapt(double seconds, std::size_t bytes);

private:
  vtkIdType Threads;
  vtkIdType ChunksPerThread = 1;
  vtkIdType MaximumPulses = 16; // pulses of a chunk; more once pulses are known to be fast
};

/// Passes on the records of the pulses [first, last) of the sample, in order, in batches; and counts
/// them. The first batch is as large as the last one of the scan before. An error of the detector
/// ends the scan.
Status RunScan(const ScanModel& model, vtkIdType first, vtkIdType last, BatchSize& batch,
  const RunWatcher& shouldContinue, const ChunkSink& onChunks, ScanCounts& counts);

} // namespace helios

#endif
