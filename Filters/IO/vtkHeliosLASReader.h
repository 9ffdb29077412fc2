// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosLASReader
 * @brief   points from a LAS file, piece by piece
 *
 * LAS 1.0 to 1.4, uncompressed, point formats 0 to 10. Output 0 is a vtkPolyData
 * without cells: points of doubles, and the point arrays
 * - GpsTime [s] (double), where the format has it;
 * - Intensity (unsigned short), ReturnNumber, NumberOfReturns, ScanDirection,
 *   EdgeOfFlightLine, UserData, ClassificationFlags (unsigned char);
 * - ClassificationIds (int), ScanAngle (double) [deg];
 * - LegIds (int), the point source id less 1: -1 where it is 0;
 * - ChannelIds (int), the scanner channel, formats 6 to 10;
 * - RGB (float, 3, each in [0..1]), NearInfrared (unsigned short), where the
 *   format has them;
 * - each field of the Extra Bytes by its name and type, or of doubles where it is
 *   scaled. Three fields of one type whose names end in X, Y, Z are one array of
 *   three numbers. A field with the name of another array replaces it.
 *
 * Field arrays: CRS (WKT, or EPSG:n from GeoTIFF keys) where the file has one;
 * GpsEpoch, 1e9 where its times are adjusted standard time: GpsEpoch + GpsTime
 * are seconds of GPS time. So a file of vtkHeliosLASWriter comes back as it was.
 *
 * Piece i of n is the i-th of n equal stretches of the points.
 *
 * Errors, which name the file, end the reading without output: no LAS, a
 * version, format or size that cannot be, a file that is cut off or whose counts
 * do not fit, LAZ (the message says how to convert it); of waveforms: no file of
 * packets, a descriptor that is not there, empty or not known, a packet beyond the
 * end, packets that overlap to more than there is.
 *
 * Output 1 is a vtkTable, with ReadWaveforms: the waveforms that the points of the
 * piece name, as vtkHeliosScanner gives them (PulseIds, Origin, Direction, GpsTime,
 * StartTime, BinSize, Offset, Count; Samples in the field data), from the file
 * itself or a .wdp beside it. PulseIds are the WaveformIds of the points, or where
 * they have none the number of the first one. X(t), Y(t), Z(t) of a point lead
 * to the scanner: Direction is their opposite. The origin is Range away from the
 * first point; without that array it is the anchor, where the first sample came
 * from: point + location (X(t), Y(t), Z(t)). Samples of exactly 0 at the end are
 * left out: packets are filled up with them. Files of earlier versions of
 * vtkHeliosLASWriter, whose vectors lead away from the scanner, are known by their
 * descriptor records, and read right with a warning.
 *
 * @sa
 * vtkHeliosLASWriter
 */

#ifndef vtkHeliosLASReader_h
#define vtkHeliosLASReader_h

#include "vtkHeliosFiltersIOModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <cstdint> // For numbers of points
#include <string>  // For names and messages

class vtkTable;

namespace helios
{
class LasFile;
}

class VTKHELIOSFILTERSIO_EXPORT vtkHeliosLASReader : public vtkPolyDataAlgorithm
{
public:
  static vtkHeliosLASReader* New();
  vtkTypeMacro(vtkHeliosLASReader, vtkPolyDataAlgorithm);
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
   * Set/Get whether waveforms are read to output 1. Default: off.
   */
  vtkSetMacro(ReadWaveforms, bool);
  vtkGetMacro(ReadWaveforms, bool);
  vtkBooleanMacro(ReadWaveforms, bool);
  ///@}

protected:
  vtkHeliosLASReader();
  ~vtkHeliosLASReader() override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkHeliosLASReader(const vtkHeliosLASReader&) = delete;
  void operator=(const vtkHeliosLASReader&) = delete;

  void WarnOfValues(const std::string& path, vtkPolyData* cloud);
  std::string ReadPoints(helios::LasFile& file, std::uint64_t begin, std::uint64_t end,
    vtkPolyData* output, vtkTable* waveforms);

  char* FileName = nullptr;
  bool ReadWaveforms = false;
  std::string WarnedName;   // the file whose waveforms were warned of
  std::string WarnedValues; // the file whose values were warned of
};

#endif
