// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosPCDWriter
 * @brief   write echoes as a PCD file of the Point Cloud Library
 *
 * PCD 0.7, DATA ascii or binary, HEIGHT 1. Fields:
 * - x, y, z; with Precision Float relative to an origin, which the header gives in a comment that
 *   other programs skip: "# vtkHelios origin: x y z". The point types of PCL are float, and UTM
 *   northings in float are off by half a metre;
 * - intensity: Amplitude [W], else Intensity; a comment states which;
 * - rgb: RGB in 8 bits, packed as PCL does; if the first block has finer colours, or with Precision
 *   Double, RGB is a further field;
 * - label: ClassificationIds, 32 bits; normal_x, normal_y, normal_z: Normals; curvature: Curvature;
 * - every other numeric point array, by its name (with _ for blanks) and type, COUNT its
 *   components: PCL ignores them. Bit and string arrays are dropped. With Precision Float, x y z,
 *   intensity, the normals, curvature and EchoWidth are float, as required by the PCL point types
 *   and helios::PointEcho; other arrays keep their type, such as the 64 bits of GpsTime. With
 *   Double all arrays keep their type, x y z are absolute, and vtkHeliosPCDReader restores the same
 *   bits (also from text, which is the shortest that does). PCL reads x y z of 64 bits into custom
 *   types only: pcl::PointXYZ gets zeros, with a warning.
 *
 * Additional comments: "# vtkHelios CRS: ...", "# vtkHelios GpsEpoch: ..." from the field data. The
 * header is ASCII: a character beyond it is \\u and four hexadecimal digits.
 *
 * Blocks: vtkPolyData with double points. Every block has the point arrays of the first; CRS and
 * GpsEpoch come from the first. Points with non-finite coordinates are dropped, with a warning. The
 * header is rewritten after each block: the .part is a valid PCD file.
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
class Status;
struct PcdHeader;
}

class VTKHELIOSFILTERSIO_EXPORT vtkHeliosPCDWriter : public vtkHeliosStreamWriter
{
public:
  static vtkHeliosPCDWriter* New();
  vtkTypeMacro(vtkHeliosPCDWriter, vtkHeliosStreamWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** Storage of numbers. */
  enum Storages
  {
    Ascii = 0,
    Binary = 1
  };

  /** Type of x, y, z and of the other fields that are float in PCL. */
  enum Precisions
  {
    Float = 0,
    Double = 1
  };

  ///@{
  /**
   * Set/Get the storage of numbers. Valid range: Ascii, Binary. Default: Binary.
   */
  vtkSetClampMacro(Storage, int, Ascii, Binary);
  vtkGetMacro(Storage, int);
  ///@}

  ///@{
  /**
   * Set/Get the precision of numbers. Valid range: Float, Double. Default: Float.
   */
  vtkSetClampMacro(Precision, int, Float, Double);
  vtkGetMacro(Precision, int);
  ///@}

  ///@{
  /**
   * Set/Get the origin of Precision Float [m], used if UseOrigin is on; else it is the centre of
   * the first block, rounded to 100 m. The error of a coordinate within 1 km of it is 0.06 mm at
   * most; an error of 1 mm or more causes a warning. Valid range: finite. Default: 0 0 0; off.
   */
  vtkSetVector3Macro(Origin, double);
  vtkGetVector3Macro(Origin, double);
  vtkSetMacro(UseOrigin, bool);
  vtkGetMacro(UseOrigin, bool);
  vtkBooleanMacro(UseOrigin, bool);
  ///@}

  ///@{
  /**
   * Set/Get the resolution that coordinates keep, in their unit: with Precision Float, x y z are of
   * 64 bits and absolute if coordinates of the first block were off by more than half the
   * resolution. 0: they are float. Valid range: [0, infinity). Default: 0.
   */
  vtkSetClampMacro(Resolution, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Resolution, double);
  ///@}

  /**
   * Returns whether x, y, z are float in the file that was opened last.
   */
  bool GetHasFloatPoints() const;

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
  helios::Status SetFirst(vtkPolyData* echoes, helios::PcdBlock& block) const;
  helios::Status SetNext(vtkPolyData* echoes, helios::PcdBlock& block) const;
  void ChooseOrigin(const helios::PcdBlock& block, double origin[3]) const;
  bool WriteHeader();
  bool WritePoints(helios::PcdBlock& block, vtkIdType count, vtkIdType start);
  void Warn(const helios::PcdBlock& block, vtkIdType count);

  int Storage = Binary;
  int Precision = Float;
  double Origin[3] = { 0.0, 0.0, 0.0 };
  bool UseOrigin = false;
  double Resolution = 0.0;
  std::unique_ptr<helios::PcdHeader> Header; // null before the first block
  bool HasWarnedFar = false;
  bool HasWarnedColors = false;
};

#endif
