// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The writers of a leg.

#ifndef heliosLegOutput_h
#define heliosLegOutput_h

#include "vtkHeliosRunFiles.h"
#include "vtkHeliosStreamWriter.h"

#include <vtkDataObject.h>
#include <vtkSmartPointer.h>

#include <functional>
#include <string>
#include <vector>

namespace helios
{

struct FileProgress;
struct RunSettings;

// Output ports of vtkHeliosScanner.
constexpr int EchoPort = vtkHeliosRunFiles::POINTS;
constexpr int WaveformPort = vtkHeliosRunFiles::WAVEFORMS;
constexpr int PulsePort = vtkHeliosRunFiles::PULSES;

/// A writer and its input: a port of the scanner, of all channels together or of one.
struct LegOutput
{
  static constexpr std::size_t AllChannels = static_cast<std::size_t>(-1);

  vtkSmartPointer<vtkHeliosStreamWriter> Writer;
  int Port = 0;
  std::size_t Channel = AllChannels;
};

using LegOutputs = std::vector<LegOutput>;

/// The writer for a port of the scanner.
vtkSmartPointer<vtkHeliosStreamWriter> MakeWriter(int port, const RunSettings& settings);

/// Gets a block: a port of the scanner, of a channel or of AllChannels.
using OutputGetter = std::function<vtkSmartPointer<vtkDataObject>(int port, std::size_t channel)>;

/// Writes a block; false after an error.
bool WriteOutput(const LegOutput& output, const OutputGetter& get);

/// The file name of a writer, without the folder.
std::string GetName(vtkHeliosStreamWriter* writer);

///@{
/// The progress of the files of writers, and what was written since the last call.
FileProgress CollectProgress(vtkHeliosStreamWriter* writer, bool isWhole);
std::vector<FileProgress> CollectProgress(const LegOutputs& outputs, bool isWhole);
///@}

} // namespace helios

#endif
