// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosPulseTextWriter
 * @brief   write pulses in HELIOS text columns
 *
 * One pulse per line, hit or not, columns separated by blanks, no header:
 * - origin x y z [m], 4 decimals
 * - direction x y z, a unit vector, 9 decimals
 * - time [ns], 4 decimals: HELIOS uses this unit in this file only
 * - pulse index: the pulse id
 * - device index: the channel
 *
 * Blocks: pulses in the layout of vtkHeliosScanner: vtkPolyData, double points,
 * point arrays Direction, GpsTime [s] and the integer arrays PulseIds,
 * ChannelIds. A block without points needs no arrays.
 *
 * @sa
 * vtkHeliosStreamWriter
 */

#ifndef vtkHeliosPulseTextWriter_h
#define vtkHeliosPulseTextWriter_h

#include "vtkHeliosFiltersIOModule.h" // For export macro
#include "vtkHeliosStreamWriter.h"

class VTKHELIOSFILTERSIO_EXPORT vtkHeliosPulseTextWriter : public vtkHeliosStreamWriter
{
public:
  static vtkHeliosPulseTextWriter* New();
  vtkTypeMacro(vtkHeliosPulseTextWriter, vtkHeliosStreamWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Appends the pulses of a block.
   */
  bool Write(vtkDataObject* block) override;

protected:
  vtkHeliosPulseTextWriter() = default;
  ~vtkHeliosPulseTextWriter() override = default;

  const char* GetBlockSource() const override;

private:
  vtkHeliosPulseTextWriter(const vtkHeliosPulseTextWriter&) = delete;
  void operator=(const vtkHeliosPulseTextWriter&) = delete;
};

#endif
