// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosLASWriter
 * @brief   echoes as LAS 1.4
 *
 * The file is valid after every block, as .part too: its header counts the
 * points that are there. Points are of format 6, or 7 where the first block has
 * RGB; with waveforms 9 or 10. All blocks have the same arrays and CRS; the field data CRS goes to a WKT
 * record. A file that goes on (Reopen) keeps its scale and offset.
 *
 * Of a point:
 * - x, y, z in 32-bit multiples of Scale about an offset, the first point of the
 *   file in whole units; rounded to the nearest. The box in the header is that
 *   of the rounded points. The bytes of the file do not depend on how its points
 *   are divided into blocks, but for Scale 0.
 * - intensity: the array Intensity where there is one; else of the amplitude A
 *   1000 log10(A / 1 fW), hundredths of a decibel, or 65535 A / FullIntensity.
 * - ReturnNumber, NumberOfReturns; beyond 15 they are 15, with a warning.
 * - ClassificationIds; beyond 0 to 255 it is 1 (unclassified), with a warning.
 * - scan angle: ScanAngle to 0.006 degrees, within -180 and 180.
 * - point source id: LegIds + 1.
 * - scanner channel: the lowest two bits of ChannelIds.
 * - GPS time: GpsTime [s] as it is, or with a field array GpsEpoch (seconds of
 *   GPS time since 6 January 1980, not 0) adjusted standard time, GpsEpoch +
 *   GpsTime - 1e9, and the header says so.
 * - ClassificationFlags, ScanDirection, EdgeOfFlightLine, UserData, RGB.
 * - Extra Bytes: every other array, exactly, with its own name and type
 *   (Amplitude, EchoWidth, Range, PulseIds ...), ChannelIds too. An array of
 *   three numbers is three fields: TruePointX, TruePointY, TruePointZ.
 *
 * Waveforms of a block (WriteWaveforms) are a packet each in a file named .wdp
 * instead of .las, as 32-bit samples; every point of the pulse names it. The
 * samples keep 23 bits of the largest one, and 0 W after their last up to the size
 * of a packet. Return point location: the time [ps] from the first sample to the
 * point, along the beam; X(t), Y(t), Z(t): metres a picosecond, from the point to
 * the scanner. The anchor, where the first sample came from, is
 * point + location (X(t), Y(t), Z(t)).
 *
 * Blocks: vtkPolyData, points of doubles; any array may be missing (then it is 0;
 * returns and classes 1). Docs/files.md lists the file field by field.
 *
 * Errors, after which nothing of the block is in the file and the next may
 * follow: a coordinate or a time that is not finite, a coordinate that 32 bits
 * do not hold, a LegIds beyond -1 to 65534, other arrays, CRS or GpsEpoch than
 * before, a CRS that PROJ does not know, arrays that Extra Bytes cannot hold.
 *
 * @sa
 * vtkHeliosStreamWriter vtkHeliosLASReader
 */

#ifndef vtkHeliosLASWriter_h
#define vtkHeliosLASWriter_h

#include "vtkHeliosFiltersIOModule.h" // For export macro
#include "vtkHeliosStreamWriter.h"
#include "vtkSmartPointer.h" // For the waveforms

class vtkTable;

namespace helios
{
class LasBlock;
class LasWaves;
struct LasSheet;
}

class VTKHELIOSFILTERSIO_EXPORT vtkHeliosLASWriter : public vtkHeliosStreamWriter
{
public:
  static vtkHeliosLASWriter* New();
  vtkTypeMacro(vtkHeliosLASWriter, vtkHeliosStreamWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the step of coordinates [units of the points], as the first block
   * takes it. 0: the finest power of ten, from 1e-6 on, that has room for eight
   * times the first block, and so depends on its size. For degrees take 1e-8. Valid
   * range: 0, [1e-9, 1000]. Default: 0.0001.
   */
  vtkSetClampMacro(Scale, double, 0.0, 1000.0);
  vtkGetMacro(Scale, double);
  ///@}

  ///@{
  /**
   * Set/Get the amplitude of intensity 65535 [W], with intensity in proportion;
   * 0: intensity is 1000 log10(A / 1 fW). Valid range: [0, 1e6]. Default: 0.
   */
  vtkSetClampMacro(FullIntensity, double, 0.0, 1e6);
  vtkGetMacro(FullIntensity, double);
  ///@}

  ///@{
  /**
   * Set/Get whether arrays that LAS has no field for are written as Extra Bytes.
   * Default: on.
   */
  vtkSetMacro(WriteExtraBytes, bool);
  vtkGetMacro(WriteExtraBytes, bool);
  vtkBooleanMacro(WriteExtraBytes, bool);
  ///@}

  ///@{
  /**
   * Set/Get the date in the header: the day of the year and the year. Valid range:
   * [0, 366], [0, 65535]. Default: 0, none: the same run gives the same bytes.
   */
  vtkSetClampMacro(CreationDay, int, 0, 366);
  vtkGetMacro(CreationDay, int);
  vtkSetClampMacro(CreationYear, int, 0, 65535);
  vtkGetMacro(CreationYear, int);
  ///@}

  ///@{
  /**
   * Set/Get the system identifier in the header, of which 32 characters are kept.
   * Default: "SIMULATION".
   */
  vtkSetMacro(SystemIdentifier, std::string);
  vtkGetMacro(SystemIdentifier, std::string);
  ///@}

  ///@{
  /**
   * Set/Get whether points have their waveforms (formats 9 and 10), as Open()
   * takes it: packets go to a file beside, named .wdp instead of .las.
   * SetWaveforms() gives those of the next block. Default: off.
   */
  vtkSetMacro(WriteWaveforms, bool);
  vtkGetMacro(WriteWaveforms, bool);
  vtkBooleanMacro(WriteWaveforms, bool);
  ///@}

  /**
   * Set the waveforms (output port 1 of vtkHeliosScanner) of the pulses that the
   * WaveformIds of the next block name; null: none.
   */
  void SetWaveforms(vtkTable* waveforms);

  bool Open() override;
  bool Reopen(vtkIdType fileSize, vtkIdType numberOfRecords, vtkIdType numberOfBytes) override;
  bool Write(vtkDataObject* block) override;
  std::string Sync() override;
#ifndef __VTK_WRAP__
  std::vector<helios::FileBlock> TakeBlocks() override;
  std::string GetHeadChecksum() const override;
  bool RestoreHead(const std::string& checksum) override;
#endif
  bool Close() override;
  bool Abandon() override;

protected:
  vtkHeliosLASWriter();
  ~vtkHeliosLASWriter() override;

  const char* GetBlockSource() const override;

private:
  vtkHeliosLASWriter(const vtkHeliosLASWriter&) = delete;
  void operator=(const vtkHeliosLASWriter&) = delete;

  void Start();
  std::string GetPacketsName() const;
  bool TakeBlock(vtkPolyData* echoes, helios::LasBlock& points, helios::LasWaves& waves);
  bool CheckSpacing(const helios::LasWaves& waves);
  bool WritePacketsHead();
  bool WritePackets(const helios::LasWaves& waves);
  bool WriteEmpty();
  bool RefusePoints(const std::string& problem);
  bool MakeHead(const helios::LasBlock& block, vtkPolyData* echoes);
  bool CheckSame(const helios::LasBlock& block, vtkPolyData* echoes);
  bool MakeSheet(vtkPolyData* echoes, const helios::LasBlock& block, helios::LasSheet& sheet);
  bool WriteHead();
  bool WritePoints(helios::LasBlock& block, vtkIdType count);
  void Warn(const helios::LasBlock& block);

  double Scale = 0.0001;
  double FullIntensity = 0.0;
  bool WriteExtraBytes = true;
  bool WriteWaveforms = false;
  int CreationDay = 0;
  int CreationYear = 0;
  std::string SystemIdentifier = "SIMULATION";
  std::unique_ptr<helios::LasSheet> Sheet;   // of the file; null before its first block
  std::unique_ptr<helios::PartFile> Packets; // null: points have no waveforms
  vtkSmartPointer<vtkTable> Waveforms;       // of the next block
  bool HasWarnedReturns = false;             // since Open()
  bool HasWarnedClasses = false;
};

#endif
