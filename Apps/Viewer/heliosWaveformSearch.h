// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Looks for waveforms in the files of a run, in a thread of its own.

#ifndef heliosWaveformSearch_h
#define heliosWaveformSearch_h

#include "heliosSimulation.h"

#include <vtkType.h>

#include <atomic>
#include <future>
#include <string>
#include <thread>
#include <vector>

namespace helios
{

/**
 * The files with waveforms that belong to inputs: those of a folder and of the folders below it, or
 * beside legNNN_points.* the leg's legNNN_fullwave.txt or .pvtt; LAS files whose points name packets.
 * Without any: none.
 */
std::vector<std::string> FindWaveformFiles(const std::vector<std::string>& inputs);

class WaveformSearch
{
public:
  ~WaveformSearch(); ///< ends the thread soon

  /**
   * The waveforms of pulses [first, last) in files, those of a leg (-1: not known) first. The
   * future throws std::runtime_error with words where no file has any. Ends a search before.
   */
  std::future<PulseRecord> Find(
    const std::vector<std::string>& files, int leg, vtkIdType first, vtkIdType last);

private:
  void Stop();

  std::thread Thread;
  std::atomic<bool> IsEnding{ false };
};

} // namespace helios

#endif
