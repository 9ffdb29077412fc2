// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosScanRun.h"

#include "heliosPulseKernel.h"

#include <vtkSMPThreadLocal.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <chrono>
#include <memory>

namespace helios
{
namespace
{

// Limits of a chunk.
constexpr vtkIdType LargestChunk = 256;
constexpr vtkIdType MinimumPulses = 32; // a group; fewer if they are slow
constexpr vtkIdType MinimumChunks = 16; // chunks of a thread: the last ones wait for each other

constexpr vtkIdType MaximumChunksPerThread =
  64; // per batch, so that their records stay in the cache

// Limits of a batch.
constexpr double ShortSeconds = 0.05;
constexpr double LongSeconds = 0.5;
constexpr std::size_t ManyBytes = std::size_t(1) << 28;
constexpr vtkIdType Growth = 4; // growth of fast batches

std::size_t CountBytes(const std::vector<ChunkResult>& results)
{
  std::size_t samples = 0;
  for (const ChunkResult& result : results)
  {
    samples += result.Samples.size();
  }
  return samples * sizeof(float);
}

/// Returns the pulses of a chunk: few enough that every thread has some of all pulses.
vtkIdType ChooseChunkSize(vtkIdType pulses, vtkIdType threads, vtkIdType maximum)
{
  return std::min(
    maximum, std::clamp(pulses / (MinimumChunks * threads), MinimumPulses, LargestChunk));
}

/// Runs chunks of the pulses [First, Last), each thread with its own kernel.
struct ChunkFunctor
{
  const ScanModel& Model;
  WorkWatch& Watch;
  vtkIdType PulsesPerChunk;
  vtkIdType First;
  vtkIdType Last;
  std::vector<ChunkResult> Results;
  vtkSMPThreadLocal<std::shared_ptr<PulseKernel>> Kernels;

  void operator()(vtkIdType begin, vtkIdType end)
  {
    auto& kernel = this->Kernels.Local();
    if (!kernel)
    {
      kernel = std::make_shared<PulseKernel>(this->Model);
    }
    for (vtkIdType c = begin; c < end; ++c)
    {
      const vtkIdType from = this->First + c * this->PulsesPerChunk;
      ChunkResult& result = this->Results[static_cast<std::size_t>(c)];
      result.Clear();
      kernel->Run(from, std::min(this->Last, from + this->PulsesPerChunk), this->Watch, result);
    }
  }
};

} // namespace

//------------------------------------------------------------------------------
void BatchSize::Adapt(double seconds, std::size_t bytes)
{
  if (seconds > LongSeconds || bytes > ManyBytes)
  {
    vtkIdType& size = this->ChunksPerThread > 1 ? this->ChunksPerThread : this->MaximumPulses;
    size = std::max<vtkIdType>(1, size / 2);
  }
  else if (seconds < ShortSeconds && bytes < ManyBytes / 4)
  {
    const bool isSmall = this->MaximumPulses < LargestChunk;
    vtkIdType& size = isSmall ? this->MaximumPulses : this->ChunksPerThread;
    size = std::min(isSmall ? LargestChunk : MaximumChunksPerThread, Growth * size);
  }
}

//------------------------------------------------------------------------------
Status RunScan(const ScanModel& model, vtkIdType first, vtkIdType last, BatchSize& batch,
  const RunWatcher& shouldContinue, const ChunkSink& onChunks, ScanCounts& counts)
{
  const vtkIdType threads = vtkSMPTools::GetEstimatedNumberOfThreads();
  WorkWatch watch(shouldContinue, last - first);
  ChunkFunctor functor{ model, watch, 0, first, first, {}, {} };
  batch.SetThreads(threads);
  while (functor.Last < last && watch.Report())
  {
    const vtkIdType largest = ChooseChunkSize(last - first, threads, batch.GetMaximumPulses());
    functor.First = functor.Last;
    functor.Last = std::min(last, functor.First + largest * batch.GetChunks());
    const vtkIdType size = ChooseChunkSize(functor.Last - functor.First, threads, largest);
    functor.PulsesPerChunk = size;
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    const vtkIdType chunks = (functor.Last - functor.First + size - 1) / size;
    functor.Results.resize(static_cast<std::size_t>(chunks));
    vtkSMPTools::For(0, chunks, 1, functor);
    if (watch.IsStopped())
    {
      break; // its records are incomplete
    }
    onChunks(functor.Results);
    batch.Adapt(
      std::chrono::duration<double>(Clock::now() - start).count(), CountBytes(functor.Results));
  }
  counts = {};
  Status status;
  for (auto& kernel : functor.Kernels)
  {
    counts.Add(kernel->GetCounts());
    status = kernel->GetFault().IsOk() ? status : kernel->GetFault();
  }
  return status;
}

} // namespace helios
