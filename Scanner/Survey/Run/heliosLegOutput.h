// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The writers of a leg.

#ifndef heliosLegOutput_h
#define heliosLegOutput_h

#include "vtkHeliosStreamWriter.h"

#include <vtkSmartPointer.h>

#include <string>
#include <vector>

namespace helios
{

struct FileProgress;
struct RunSettings;

// Output ports of vtkHeliosScanner.
constexpr int EchoPort = 0;
constexpr int WaveformPort = 1;
constexpr int PulsePort = 2;

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

/// The suffix of its file name.
std::string GetSuffix(int port, const std::string& format);

/// The file name of a writer, without the folder.
std::string GetName(vtkHeliosStreamWriter* writer);

///@{
/// The progress of the files of writers, and what was written since the last call.
FileProgress TakeProgress(vtkHeliosStreamWriter* writer, bool isWhole);
std::vector<FileProgress> TakeProgress(const LegOutputs& outputs, bool isWhole);
///@}

} // namespace helios

#endif
