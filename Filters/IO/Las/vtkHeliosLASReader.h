// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosLASReader
 * @brief   read points from a LAS file, piece by piece
 *
 * LAS 1.0 to 1.5, point formats 0 to 10, and LAZ of all of them, whose chunks are decompressed in
 * parallel. Output 0 is a vtkPolyData without
 * cells: double points, and the point arrays
 * - GpsTime [s] (double), if the format has it;
 * - Intensity (unsigned short), ReturnNumber, NumberOfReturns, ScanDirectionFlag, EdgeOfFlightLine,
 *   UserData, ClassificationFlags (unsigned char);
 * - ClassificationIds (int), ScanAngle (double) [deg];
 * - LegIds (int), the point source id minus 1: -1 if it is 0;
 * - ChannelIds (int), the scanner channel, formats 6 to 10;
 * - RGB (float, 3, each in [0..1]), NearInfrared (unsigned short), if the format has them. Colours
 *   of 8 bits, none of the whole file above 255, are scaled by 257, with a warning; files of
 *   vtkHeliosLASWriter always have 16 bits;
 * - each field of the Extra Bytes by its name and type, as double if it is scaled. Where it has its
 *   no_data value, it is NaN (integers become double; integers of 64 bits stay, with a warning).
 *   Bytes that are not described are not read, with a warning. Three fields of one type whose names
 *   end in X, Y, Z become one array of three components. A field with the name of another array
 *   replaces it.
 *
 * Field arrays: CRS (WKT, or EPSG:n from GeoTIFF keys) if the file has one; GpsEpoch, 1e9 if the
 * times are adjusted standard time, the offset of LAS 1.5 if they have one: GpsEpoch + GpsTime are
 * seconds of GPS time. Part.Name and Material.Name, if vtkHeliosPointNames finds a file of them; a
 * warning if it cannot be read. Data written by vtkHeliosLASWriter are read back unchanged.
 *
 * With Classes, only points of these classes are read; with SkipWithheld, only points that are not
 * withheld.
 *
 * Piece i of n is the i-th of n equal ranges of the points.
 *
 * Errors, which name the file, without output: not a LAS file; an invalid version, format or size;
 * a truncated file; inconsistent counts; damaged chunks of LAZ. For waveforms: no
 * packet file; a descriptor that is missing, empty or unknown; a packet beyond the end; packets
 * that overlap to more than the file size.
 *
 * Output 1 is a vtkTable, with ReadWaveforms: the waveforms of the points of the piece, in the
 * layout of vtkHeliosScanner (PulseIds, Origin, Direction, GpsTime, StartTime, BinSize, Offset,
 * Count; Samples in the field data), read from the file itself or a .wdp beside it. PulseIds are
 * the WaveformIds of the points or, if missing, the index of the first point. X(t), Y(t), Z(t) of a
 * point lead to the scanner: Direction is their opposite. The origin is at distance Range from the
 * first point; without that array it is the anchor, the origin of the first sample: point +
 * location (X(t), Y(t), Z(t)). Trailing samples of exactly 0 are dropped: packets are padded with
 * them. Files of earlier versions of vtkHeliosLASWriter, whose vectors lead away from the scanner,
 * are recognized by their descriptor records and read correctly, with a warning.
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
#include <vector>  // For classes

class vtkTable;

namespace helios
{
class LasArrays;
class LasFile;
struct LasColorBits;
class Status;
}

class VTKHELIOSFILTERSIO_EXPORT vtkHeliosLASReader : public vtkPolyDataAlgorithm
{
public:
  static vtkHeliosLASReader* New();
  vtkTypeMacro(vtkHeliosLASReader, vtkPolyDataAlgorithm);
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
   * Set/Get whether waveforms are read to output 1. Default: off.
   */
  vtkSetMacro(ReadWaveforms, bool);
  vtkGetMacro(ReadWaveforms, bool);
  vtkBooleanMacro(ReadWaveforms, bool);
  ///@}

  ///@{
  /**
   * Set/Get the classes whose points are read, such as "2 6". Waveforms are not read then. Valid
   * range of a class: [0, 255]. Default: empty, all.
   */
  vtkSetMacro(Classes, std::string);
  vtkGetMacro(Classes, std::string);
  ///@}

  ///@{
  /**
   * Set/Get whether withheld points (bit 4 of ClassificationFlags) are left out; a warning counts
   * them. Waveforms are not read then. Default: off.
   */
  vtkSetMacro(SkipWithheld, bool);
  vtkGetMacro(SkipWithheld, bool);
  vtkBooleanMacro(SkipWithheld, bool);
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

  helios::Status FindColors(helios::LasFile& file, helios::LasColorBits& colors);
  void SelectPoints(const std::vector<char>& isWanted, vtkPolyData* cloud);
  void ReadNames(vtkIdType points, vtkPolyData* cloud);
  void WarnOfNotes(const std::string& path, const helios::LasArrays& arrays);
  void WarnOfValues(const std::string& path, vtkPolyData* cloud);
  std::string FindCrs(const helios::LasFile& file);
  helios::Status ReadPoints(helios::LasFile& file, std::uint64_t begin, std::uint64_t end,
    vtkPolyData* output, vtkTable* waveforms);

  char* FileName = nullptr;
  bool ReadWaveforms = false;
  std::string Classes;
  bool SkipWithheld = false;
  std::string WarnedName;   // file whose waveforms caused a warning
  std::string WarnedValues; // file whose values caused a warning
  std::string WarnedCrs;    // file whose system caused a warning
  std::string KnownCrs;     // by PROJ
  std::string WarnedNames;  // the warning about names
  std::string WarnedNotes;  // file whose notes were warnings
  std::string ColorsFile;   // file whose colours are known, with its state
  bool AreColors8 = false;  // colours of the file have 8 bits
  bool IsInfrared8 = false; // infrared of the file has 8 bits
};

#endif
