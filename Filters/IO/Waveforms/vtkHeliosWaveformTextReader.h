// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosWaveformTextReader
 * @brief   read waveforms from HELIOS text columns, piece by piece
 *
 * A line is one pulse, blanks or tabs between the columns: pulse index, origin
 * x y z [m], direction x y z, times of the first and the last sample [ns], GPS
 * time [s], the samples [nW]: the format of vtkHeliosWaveformTextWriter and,
 * with OneWayTimes, of HELIOS++. A word that starts with # starts a comment;
 * lines without words are skipped. Lines may end in CR LF.
 *
 * Output 0: a vtkTable in the layout of vtkHeliosScanner, one row per pulse:
 * PulseIds, Origin, Direction (normalized), GpsTime [s], StartTime [ns],
 * BinSize [ns], Offset, Count; Samples [W] in the field data. Times are two-way.
 *
 * Times have 4 decimals in the file: of the bin sizes consistent with them, the
 * one with the fewest decimals is used. Samples have 9: those above 1 nW are
 * restored bit for bit.
 *
 * Piece i of n (UPDATE_PIECE_NUMBER) is the lines that start in the i-th of n
 * equal byte ranges: the pieces in order are the whole, each with its own Samples.
 *
 * Errors, without output: a line that is too short, a last line without line
 * end (an interrupted run), a word that is not a number, NaN and infinities, a
 * direction that is not a unit vector, times that do not fit the samples, a
 * file that cannot be read or, read in one piece, has no waveforms. Messages
 * start with file:line.
 *
 * @sa
 * vtkHeliosWaveformTextWriter vtkHeliosWaveformXMLReader
 */

#ifndef vtkHeliosWaveformTextReader_h
#define vtkHeliosWaveformTextReader_h

#include "vtkHeliosFiltersIOModule.h" // For export macro
#include "vtkTableAlgorithm.h"

#include <cstdint> // For positions in the file

namespace helios
{
class WaveformParser;
struct TextReport;
}

class VTKHELIOSFILTERSIO_EXPORT vtkHeliosWaveformTextReader : public vtkTableAlgorithm
{
public:
  static vtkHeliosWaveformTextReader* New();
  vtkTypeMacro(vtkHeliosWaveformTextReader, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the file to read. Required.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /**
   * Set/Get whether the times in the file are one-way, as in files of HELIOS++. Default: off.
   */
  vtkSetMacro(OneWayTimes, bool);
  vtkGetMacro(OneWayTimes, bool);
  vtkBooleanMacro(OneWayTimes, bool);
  ///@}

  ///@{
  /**
   * Set/Get the bin of the waveforms [ns], two-way, which the times of a line
   * must fit; 0: derived from the times. Valid range: [0, 1e3]. Default: 0.
   */
  vtkSetClampMacro(BinSize, double, 0.0, 1e3);
  vtkGetMacro(BinSize, double);
  ///@}

protected:
  vtkHeliosWaveformTextReader();
  ~vtkHeliosWaveformTextReader() override;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHeliosWaveformTextReader(const vtkHeliosWaveformTextReader&) = delete;
  void operator=(const vtkHeliosWaveformTextReader&) = delete;

  bool ReadPiece(helios::WaveformParser& parser, helios::TextReport& report, std::int64_t piece,
    std::int64_t count);

  char* FileName = nullptr;
  bool OneWayTimes = false;
  double BinSize = 0.0;
};

#endif
