// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosLASWriter
 * @brief   write echoes as LAS 1.4 or LAZ
 *
 * The file, including its .part, is valid after every block: its header counts the points written.
 * With WriteCompressed it is a LAZ file of chunks of 50,000 points, compressed in parallel by
 * LASzip; EndBlock() ends a chunk. Its .part has no table of chunks until Close() or Abandon();
 * vtkHeliosLASReader needs none.
 * The point format is 6, or 7 if the first block has RGB; with waveforms 9 or 10. All blocks have
 * the same arrays and CRS; the field data CRS is written as a WKT record. A resumed file (Reopen)
 * keeps its scale and offset.
 *
 * Point fields:
 * - x, y, z: 32-bit multiples of Scale relative to an offset, the first point of the file in whole
 *   units; rounded to nearest. The header has the bounding box of the rounded points. The file is
 *   byte-identical for any division of the points into blocks, except with Scale 0, and in degrees.
 * - intensity: the array Intensity if present; else from the amplitude A: 1000 log10(A / 1 fW), in
 *   0.01 dB, or 65535 A / FullIntensity.
 * - ReturnNumber, NumberOfReturns; values above 15 become 15, with a warning.
 * - ClassificationIds; values outside 0 to 255 become 1 (unclassified), with a warning.
 * - scan angle: ScanAngle in steps of 0.006 degrees, within -180 and 180.
 * - point source id: LegIds + 1.
 * - scanner channel: the lowest two bits of ChannelIds.
 * - GPS time: GpsTime [s] unchanged; with a field array GpsEpoch (seconds of GPS time since 6
 *   January 1980, not 0) adjusted standard time, GpsEpoch + GpsTime - 1e9, flagged in the header.
 * - ClassificationFlags, ScanDirectionFlag, EdgeOfFlightLine, UserData, RGB, NearInfrared.
 * - Extra Bytes: every other array, exactly, with its own name and type (Amplitude, EchoWidth,
 *   Range, PulseIds ...), including ChannelIds. An array of three components becomes three fields:
 *   TruePointX, TruePointY, TruePointZ. An Intensity that is not of 16 bits is stored there, too.
 * - names of parts, materials, species and organs (field arrays Part.Name ...): in a file beside it,
 *   see vtkHeliosPointNames.
 *
 * With WriteWaveforms, each waveform of a block is one packet of 32-bit samples in a file named
 * .wdp instead of .las; every point of the pulse refers to it. The samples keep 23 bits relative to
 * the largest one and are padded with 0 W to the packet size. Return point location: the time [ps]
 * from the first sample to the point, along the beam. X(t), Y(t), Z(t): metres per picosecond, from
 * the point to the scanner. The anchor, the origin of the first sample, is point + location (X(t),
 * Y(t), Z(t)).
 *
 * Blocks: vtkPolyData, double points; any array may be missing (its value is then 0; for returns
 * and classes 1). Docs/files.md lists the file field by field.
 *
 * Errors, after which the block is not written and the next one is accepted: a coordinate or time
 * that is not finite, a coordinate that does not fit in 32 bits, a LegIds outside -1 to 65534,
 * arrays, CRS or GpsEpoch that differ from earlier blocks, a CRS unknown to PROJ, arrays that Extra
 * Bytes cannot hold.
 *
 * @sa
 * vtkHeliosStreamWriter vtkHeliosLASReader vtkHeliosCOPCWriter
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
class LasNamesFile;
class LasWaves;
class LazSink;
class Status;
struct LasFileHead;
}

class VTKHELIOSFILTERSIO_EXPORT vtkHeliosLASWriter : public vtkHeliosStreamWriter
{
public:
  static vtkHeliosLASWriter* New();
  vtkTypeMacro(vtkHeliosLASWriter, vtkHeliosStreamWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the step of coordinates [units of the points], applied at the first block. 0: the
   * finest power of ten, from 1e-6 up, that can hold eight times the extent of the first block; it
   * depends on the block size. Valid range: 0, [1e-9, 1000]. Default: 0.0001, which stands for 0.1
   * mm or the next finer power of ten in the unit of each axis, and 1e-9 degrees, or as fine as
   * eight times the extent of the first block allows; points that a file stored (field data
   * CoordinateScale) keep its scale and offset, or get no coarser steps.
   */
  vtkSetClampMacro(Scale, double, 0.0, 1000.0);
  vtkGetMacro(Scale, double);
  ///@}

  ///@{
  /**
   * Set/Get the amplitude of intensity 65535 [W], for linear scaling; 0:
   * intensity is 1000 log10(A / 1 fW). Valid range: [0, 1e6]. Default: 0.
   */
  vtkSetClampMacro(FullIntensity, double, 0.0, 1e6);
  vtkGetMacro(FullIntensity, double);
  ///@}

  ///@{
  /**
   * Set/Get whether arrays without a LAS field are written as Extra Bytes.
   * Default: on.
   */
  vtkSetMacro(WriteExtraBytes, bool);
  vtkGetMacro(WriteExtraBytes, bool);
  vtkBooleanMacro(WriteExtraBytes, bool);
  ///@}

  ///@{
  /**
   * Set/Get whether points are compressed (LAZ), applied by Open(). Default: off.
   */
  vtkSetMacro(WriteCompressed, bool);
  vtkGetMacro(WriteCompressed, bool);
  vtkBooleanMacro(WriteCompressed, bool);
  ///@}

  ///@{
  /**
   * Set/Get the date in the header: the day of the year and the year. Valid range: [0, 366], [0,
   * 65535]. Default: 0, none, for reproducible files.
   */
  vtkSetClampMacro(CreationDay, int, 0, 366);
  vtkGetMacro(CreationDay, int);
  vtkSetClampMacro(CreationYear, int, 0, 65535);
  vtkGetMacro(CreationYear, int);
  ///@}

  ///@{
  /**
   * Set/Get the system identifier in the header, truncated to 32 characters. Default: "SIMULATION".
   */
  vtkSetMacro(SystemIdentifier, std::string);
  vtkGetMacro(SystemIdentifier, std::string);
  ///@}

  ///@{
  /**
   * Set/Get whether points have waveforms (formats 9 and 10), applied by Open(). Packets are
   * written to a second file named .wdp instead of .las. SetWaveforms() sets the waveforms of the
   * next block. Default: off.
   */
  vtkSetMacro(WriteWaveforms, bool);
  vtkGetMacro(WriteWaveforms, bool);
  vtkBooleanMacro(WriteWaveforms, bool);
  ///@}

  /**
   * Sets the waveforms (output port 1 of vtkHeliosScanner) of the pulses given by WaveformIds in
   * the next block; null: none.
   */
  void SetWaveforms(vtkTable* waveforms);

  bool Open() override;
  bool Reopen(vtkIdType fileSize, vtkIdType numberOfRecords, vtkIdType numberOfBytes) override;
  bool Write(vtkDataObject* block) override;
  bool EndBlock() override;
  std::string Sync() override;
#ifndef __VTK_WRAP__
  std::vector<helios::FileBlock> CollectBlocks() override;
  std::string GetHeadChecksum() const override;
  bool RestoreHead(const std::string& checksum) override;
#endif
  bool Close() override;
  bool Abandon() override;

protected:
  vtkHeliosLASWriter();
  ~vtkHeliosLASWriter() override;

  const char* GetBlockSource() const override;

  /// Gives the complete file its name; the packets have theirs already.
  virtual bool FinishFile()
  {
    return this->Superclass::Close();
  }

private:
  vtkHeliosLASWriter(const vtkHeliosLASWriter&) = delete;
  void operator=(const vtkHeliosLASWriter&) = delete;

  void Start(bool isResumed);
  std::string GetPacketsName() const;
  bool SetBlock(vtkPolyData* echoes, helios::LasBlock& points, helios::LasWaves& waves);
  bool CheckSpacing(const helios::LasWaves& waves);
  bool WritePacketsHead();
  bool WritePackets(const helios::LasWaves& waves);
  bool WriteEmpty();
  bool RefusePoints(const std::string& problem);
  bool MakeHead(const helios::LasBlock& block, vtkPolyData* echoes);
  bool CheckSame(const helios::LasBlock& block, vtkPolyData* echoes);
  bool DescribeFile(vtkPolyData* echoes, const helios::LasBlock& block, helios::LasFileHead& head);
  bool WriteHead();
  bool WritePoints(helios::LasBlock& block, vtkIdType count);
  bool ResumeCompressed();
  bool RemovePoints(vtkIdType size);
  bool CheckCompressed(const helios::Status& status);
  bool AppendChunk(const std::string& bytes);
  bool WriteTable();
  void Warn(const helios::LasBlock& block);
  bool AddNames(vtkPolyData* echoes);
  bool RefuseNames(const std::string& problem);

  double Scale = 0.0001;
  double FullIntensity = 0.0;
  bool WriteExtraBytes = true;
  bool WriteWaveforms = false;
  bool WriteCompressed = false;
  int CreationDay = 0;
  int CreationYear = 0;
  std::string SystemIdentifier = "SIMULATION";
  std::unique_ptr<helios::LasFileHead> Head;   // layout of the file; null before its first block
  std::unique_ptr<helios::LasNamesFile> Names; // names of parts and materials
  std::unique_ptr<helios::LazSink> Compressed; // null: points are not compressed, or none yet
  std::unique_ptr<helios::PartFile> Packets;   // null: points have no waveforms
  vtkSmartPointer<vtkTable> Waveforms;         // waveforms of the next block
  bool HasWarnedReturns = false;               // since Open()
  bool HasWarnedClasses = false;
};

#endif
