// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The writers of a leg.

#ifndef heliosLegOutput_h
#define heliosLegOutput_h

#include "heliosPartFile.h"
#include "vtkHeliosRunFiles.h"
#include "vtkHeliosStreamWriter.h"

#include <vtkDataObject.h>
#include <vtkSmartPointer.h>
#include <vtkTable.h>

#include <cstddef>
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
constexpr int HitPort = vtkHeliosRunFiles::HITS;

/// Rows of a text file: bytes of another file, or a text.
struct OutputRows
{
  vtkIdType Count = 0;
  std::string Path; ///< empty: Text
  FileBlock Block;  ///< in that file
  std::string Text;
};

/// Data that a writer writes at a time, or rows that have its format already.
struct OutputPiece
{
  vtkSmartPointer<vtkDataObject> Data; ///< null: rows
  vtkSmartPointer<vtkTable> Waveforms; ///< waveforms of LAS points that have them
  OutputRows Rows;
};

/// A writer and its input: a port of the scanner, of all channels together or of one.
struct LegOutput
{
  static constexpr std::size_t AllChannels = static_cast<std::size_t>(-1);

  /// Writes a piece; false after an error.
  bool Write(const OutputPiece& piece) const;

  /// Returns whether the writer needs the waveforms of points, too.
  bool HasWaveforms() const;

  vtkSmartPointer<vtkHeliosStreamWriter> Writer;
  int Port = 0;
  std::size_t Channel = AllChannels;
};

using LegOutputs = std::vector<LegOutput>;

/// A piece of every output of a leg.
using LegPiece = std::vector<OutputPiece>;

/// Gets a port of the scanner, of a channel or of AllChannels; null: it has no records.
using PortGetter = std::function<vtkSmartPointer<vtkDataObject>(int port, std::size_t channel)>;

/// Collects the data that an output needs from the ports.
OutputPiece CollectPiece(const LegOutput& output, const PortGetter& get);

/// Writes a piece of every output; false after an error.
bool WriteOutputs(const LegOutputs& outputs, const LegPiece& piece);

/// Ends a block that a run can go on after; false after an error.
bool EndBlock(const LegOutputs& outputs);

/// Closes a writer. It asks meanwhile whether it goes on, if that takes long; false stops it.
bool Close(const LegOutput& output, const std::function<bool()>& goesOn);

/// Removes what writers leave beside complete files, once the journal has these.
void RemoveParts(const LegOutputs& outputs);

/// Returns the writer for a port of the scanner.
vtkSmartPointer<vtkHeliosStreamWriter> MakeWriter(int port, const RunSettings& settings);

/// Returns the file name of a writer, without the folder.
std::string GetName(vtkHeliosStreamWriter* writer);

/// @{
/// Returns the progress of the files of writers, and what was written since the last call.
FileProgress CollectProgress(vtkHeliosStreamWriter* writer, bool isWhole);
std::vector<FileProgress> CollectProgress(const LegOutputs& outputs, bool isWhole);
///@}

} // namespace helios

#endif
