// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosScanRun.h"

#include "heliosPulseKernel.h"

#include <vtkSMPThreadLocal.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <memory>

namespace helios
{
namespace
{

// Pulses handed to a thread at a time, and between two looks at progress and abort.
constexpr vtkIdType PulsesPerChunk = 1024;
constexpr vtkIdType ChunksPerBatch = 256;

/// Runs chunks of pulses, each thread with its own kernel.
struct ChunkFunctor
{
  const ScanModel& Model;
  vtkIdType First;
  vtkIdType Last;
  std::vector<ChunkResult>& Results;
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
      const vtkIdType from = this->First + c * PulsesPerChunk;
      kernel->Run(from, std::min(this->Last, from + PulsesPerChunk),
        this->Results[static_cast<std::size_t>(c)]);
    }
  }
};

} // namespace

//------------------------------------------------------------------------------
ScanCounts RunScan(const ScanModel& model, vtkIdType first, vtkIdType last,
  const RunWatcher& goesOn, std::vector<ChunkResult>& results)
{
  const vtkIdType chunks = (last - first + PulsesPerChunk - 1) / PulsesPerChunk;
  results.resize(static_cast<std::size_t>(chunks));
  ChunkFunctor functor{ model, first, last, results, {} };
  vtkIdType done = 0;
  while (done < chunks && goesOn(static_cast<double>(done) / static_cast<double>(chunks)))
  {
    const vtkIdType next = std::min(chunks, done + ChunksPerBatch);
    vtkSMPTools::For(done, next, 1, functor);
    done = next;
  }
  ScanCounts sum;
  for (auto& kernel : functor.Kernels)
  {
    sum.Add(kernel->GetCounts());
  }
  return sum;
}

} // namespace helios
