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

// Of vtkHeliosScanner.
constexpr int EchoPort = 0;
constexpr int WaveformPort = 1;
constexpr int PulsePort = 2;

/// A writer, and what it writes: a port of the scanner, of all its channels together or of one.
struct LegOutput
{
  static constexpr std::size_t AllChannels = static_cast<std::size_t>(-1);

  vtkSmartPointer<vtkHeliosStreamWriter> Writer;
  int Port = 0;
  std::size_t Channel = AllChannels;
};

using LegOutputs = std::vector<LegOutput>;

/// The writer of a port of the scanner.
vtkSmartPointer<vtkHeliosStreamWriter> MakeWriter(int port, const RunSettings& settings);

/// How the name of its file ends.
std::string GetSuffix(int port, const std::string& format);

/// The name of the file of a writer, without its folder.
std::string GetName(vtkHeliosStreamWriter* writer);

///@{
/// How far the files of writers are, and what was written since this was asked last.
FileProgress TakeProgress(vtkHeliosStreamWriter* writer, bool isWhole);
std::vector<FileProgress> TakeProgress(const LegOutputs& outputs, bool isWhole);
///@}

} // namespace helios

#endif
