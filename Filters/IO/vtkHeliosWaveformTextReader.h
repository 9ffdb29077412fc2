// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosWaveformTextReader
 * @brief   waveforms from HELIOS text columns, piece by piece
 *
 * A line is one pulse, blanks or tabs between the columns: pulse index, origin
 * x y z [m], direction x y z, times of the first and the last sample [ns], GPS
 * time [s], the samples [nW]; what vtkHeliosWaveformTextWriter writes, and with
 * OneWayTimes what HELIOS++ writes. A word that starts with # ends a line;
 * lines without words are left out. Lines may end in CR LF.
 *
 * Output 0: a vtkTable as vtkHeliosScanner gives it, one row a pulse: PulseIds,
 * Origin, Direction (made a unit vector), GpsTime [s], StartTime [ns], BinSize
 * [ns], Offset, Count; Samples [W] in the field data. Times are two-way.
 *
 * Times have 4 decimals in the file: of the bin sizes that they leave open, the
 * one with the fewest decimals is taken. Samples have 9: those above 1 nW come
 * back bit for bit.
 *
 * Piece i of n (UPDATE_PIECE_NUMBER) is the lines that start in the i-th of n
 * equal stretches of the bytes: the pieces in order are the whole, each with its
 * own Samples.
 *
 * Errors end the reading without output: a line too short, a last line without
 * its end (a run that was cut off), a word that is no number, NaN and
 * infinities, a direction that is no unit vector, times that do not fit the
 * samples, a file that cannot be read or, read in one piece, has no waveforms.
 * Messages start with file:line.
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
   * Set/Get the file to read. No default: an error without.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /**
   * Set/Get whether the times of the file are those of the way out alone, as in
   * files of HELIOS++. Default: off.
   */
  vtkSetMacro(OneWayTimes, bool);
  vtkGetMacro(OneWayTimes, bool);
  vtkBooleanMacro(OneWayTimes, bool);
  ///@}

  ///@{
  /**
   * Set/Get the bin of the waveforms [ns], two-way, which the times of a line
   * must fit; 0: that of the times. Valid range: [0, 1e3]. Default: 0.
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
