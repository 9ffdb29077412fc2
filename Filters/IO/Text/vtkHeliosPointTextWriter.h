// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosPointTextWriter
 * @brief   write echoes in HELIOS text columns
 *
 * One echo per line, columns separated by blanks, no header:
 * - x y z [m], 4 decimals; 9 of degrees, and of points that a file stored with finer steps
 * - intensity: the amplitude [nW], 4 decimals
 * - echo width: full width at half maximum, two-way [ns], 4 decimals
 * - return number, from 1
 * - number of returns of the pulse
 * - fullwave index: the pulse id
 * - hit object: the name of the scene part, with _ for blanks; its number if it has no name
 * - classification
 * - GPS time [s], 9 decimals
 * - with WriteScanFlags: the scan direction flag and the edge of flight line, 0 or 1
 * - with WriteDecibels, after these flags: relative amplitude and reflectance [dB], 4 decimals
 *
 * Numbers are correctly rounded, halves to even; zero has no sign.
 *
 * Blocks: echoes in the layout of vtkHeliosScanner: vtkPolyData, double points,
 * point arrays Amplitude [W], EchoWidth [ns], GpsTime [s] and the integer
 * arrays ReturnNumber, NumberOfReturns, PulseIds, PartIds, ClassificationIds;
 * the field array Part.Name, indexed by PartIds, is optional. A block without
 * points needs no arrays.
 *
 * @sa
 * vtkHeliosStreamWriter
 */

#ifndef vtkHeliosPointTextWriter_h
#define vtkHeliosPointTextWriter_h

#include "vtkHeliosFiltersIOModule.h" // For export macro
#include "vtkHeliosStreamWriter.h"

class VTKHELIOSFILTERSIO_EXPORT vtkHeliosPointTextWriter : public vtkHeliosStreamWriter
{
public:
  static vtkHeliosPointTextWriter* New();
  vtkTypeMacro(vtkHeliosPointTextWriter, vtkHeliosStreamWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get whether arrays that a block lacks are filled in: amplitude, width and time 0, return 1
   * of 1, pulse and part -1, class 0. Default: off, they are errors.
   */
  vtkSetMacro(FillMissing, bool);
  vtkGetMacro(FillMissing, bool);
  vtkBooleanMacro(FillMissing, bool);
  ///@}

  ///@{
  /**
   * Set/Get whether there are two more columns, the arrays ScanDirectionFlag and EdgeOfFlightLine.
   * Default: off.
   */
  vtkSetMacro(WriteScanFlags, bool);
  vtkGetMacro(WriteScanFlags, bool);
  vtkBooleanMacro(WriteScanFlags, bool);
  ///@}

  ///@{
  /**
   * Set/Get whether there are four more columns: the columns of WriteScanFlags, and the arrays
   * RelativeAmplitude and Reflectance. Default: off.
   */
  vtkSetMacro(WriteDecibels, bool);
  vtkGetMacro(WriteDecibels, bool);
  vtkBooleanMacro(WriteDecibels, bool);
  ///@}

  ///@{
  /**
   * Returns the names of the arrays that have a column, in the order of the columns after x y z,
   * without the columns of WriteScanFlags and WriteDecibels.
   */
  static int GetNumberOfArrays();
  static const char* GetArrayName(int index);
  ///@}

  /**
   * Appends the echoes of a block.
   */
  bool Write(vtkDataObject* block) override;

protected:
  vtkHeliosPointTextWriter() = default;
  ~vtkHeliosPointTextWriter() override = default;

  const char* GetBlockSource() const override;

private:
  vtkHeliosPointTextWriter(const vtkHeliosPointTextWriter&) = delete;
  void operator=(const vtkHeliosPointTextWriter&) = delete;

  bool FillMissing = false;
  bool WriteScanFlags = false;
  bool WriteDecibels = false;
};

#endif
