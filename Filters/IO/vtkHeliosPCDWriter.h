// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosPCDWriter
 * @brief   echoes as a PCD file of the Point Cloud Library
 *
 * PCD 0.7, DATA ascii or binary, HEIGHT 1. Fields:
 * - x, y, z; with Precision Float relative to an origin, which the header says in a comment that other
 *   programs skip: "# vtkHelios origin: x y z". PCL's own point types are float, and UTM's northings
 *   in float are half a metre off;
 * - intensity: Amplitude [W]; a comment says so;
 * - normal_x, normal_y, normal_z: Normals;
 * - each other point array that holds numbers, by its name (with _ for blanks) and type, COUNT its
 *   components. Bits and texts are left out.
 * With Precision Float, x y z, intensity, the normals and EchoWidth are float, so that PCL's point
 * types and helios::PointEcho take them; all else stays as it is, GpsTime with its 64 bits. With
 * Double all stays as it is, x y z are absolute, and vtkHeliosPCDReader gives back the same bits (text is
 * the shortest that does, too); PCL then reads x y z into own types only.
 *
 * Further comments: "# vtkHelios CRS: ...", "# vtkHelios GpsEpoch: ..." from the field data.
 *
 * Blocks: vtkPolyData with points of doubles. Every block has the point arrays of the first; CRS and
 * GpsEpoch are the first's. Points whose coordinates are not finite are left out, with a warning.
 * The header is written again after each block: the .part is a valid PCD file.
 *
 * @sa
 * vtkHeliosStreamWriter vtkHeliosPCDReader
 */

#ifndef vtkHeliosPCDWriter_h
#define vtkHeliosPCDWriter_h

#include "vtkHeliosFiltersIOModule.h" // For export macro
#include "vtkHeliosStreamWriter.h"

#include <memory> // For the header
#include <string> // For messages

namespace helios
{
class PcdBlock;
struct PcdHeader;
}

class VTKHELIOSFILTERSIO_EXPORT vtkHeliosPCDWriter : public vtkHeliosStreamWriter
{
public:
  static vtkHeliosPCDWriter* New();
  vtkTypeMacro(vtkHeliosPCDWriter, vtkHeliosStreamWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** How numbers are stored. */
  enum Storages
  {
    Ascii = 0,
    Binary = 1
  };

  /** What x, y, z and those fields are that PCL has as float. */
  enum Precisions
  {
    Float = 0,
    Double = 1
  };

  ///@{
  /**
   * Set/Get how numbers are stored. Valid range: Ascii, Binary. Default: Binary.
   */
  vtkSetClampMacro(Storage, int, Ascii, Binary);
  vtkGetMacro(Storage, int);
  ///@}

  ///@{
  /**
   * Set/Get what numbers are. Valid range: Float, Double. Default: Float.
   */
  vtkSetClampMacro(Precision, int, Float, Double);
  vtkGetMacro(Precision, int);
  ///@}

  ///@{
  /**
   * Set/Get the origin of Precision Float [m], taken where UseOrigin is on; else it is the middle of
   * the first block, to whole 100 m. A coordinate within 1 km of it is 0.06 mm off at most; one of
   * 1 mm or more gets a warning. Valid range: finite. Default: 0 0 0; off.
   */
  vtkSetVector3Macro(Origin, double);
  vtkGetVector3Macro(Origin, double);
  vtkSetMacro(UseOrigin, bool);
  vtkGetMacro(UseOrigin, bool);
  vtkBooleanMacro(UseOrigin, bool);
  ///@}

  bool Open() override;
  bool Reopen(vtkIdType fileSize, vtkIdType numberOfRecords, vtkIdType numberOfBytes) override;

  /**
   * Appends the echoes of a block.
   */
  bool Write(vtkDataObject* block) override;

  bool Close() override;

protected:
  vtkHeliosPCDWriter();
  ~vtkHeliosPCDWriter() override;

  const char* GetBlockSource() const override;

private:
  vtkHeliosPCDWriter(const vtkHeliosPCDWriter&) = delete;
  void operator=(const vtkHeliosPCDWriter&) = delete;

  bool Refuse(const std::string& problem);
  bool MakeHeader(vtkPolyData* echoes, const helios::PcdBlock& block);
  bool WriteHeader();
  bool WritePoints(helios::PcdBlock& block, vtkIdType count, vtkIdType start);
  void Warn(const helios::PcdBlock& block, vtkIdType count);

  int Storage = Binary;
  int Precision = Float;
  double Origin[3] = { 0.0, 0.0, 0.0 };
  bool UseOrigin = false;
  std::unique_ptr<helios::PcdHeader> Header; // once there is a block
  bool HasWarnedFar = false;
};

#endif
