// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Searches the files of a run for waveforms, in its own thread.

#ifndef heliosWaveformSearch_h
#define heliosWaveformSearch_h

#include "heliosSimulation.h"

#include <vtkType.h>

#include <atomic>
#include <future>
#include <string>
#include <thread>
#include <vector>

namespace helios::viewer
{

/**
 * Returns the files with waveforms of the inputs: the files of a folder and its subfolders, or
 * beside legNNN_points.* the leg's legNNN_fullwave.txt, .pvtt or .las; LAS files whose points refer
 * to packets. Empty: none.
 */
std::vector<std::string> FindWaveformFiles(const std::vector<std::string>& inputs);

class WaveformSearch
{
public:
  ~WaveformSearch(); ///< ends the thread

  /**
   * Returns the waveforms of pulses [first, last) in files, first the files of a leg (-1: unknown).
   * The future throws std::runtime_error with a message if no file has any. Ends an earlier search.
   */
  std::future<PulseRecord> Find(
    const std::vector<std::string>& files, int leg, vtkIdType first, vtkIdType last);

private:
  void Stop();

  std::thread Thread;
  std::atomic<bool> IsEnding{ false };
};

} // namespace helios::viewer

#endif
