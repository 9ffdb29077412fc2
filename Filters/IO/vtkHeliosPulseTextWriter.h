// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosPulseTextWriter
 * @brief   pulses in HELIOS text columns
 *
 * One pulse a line, hit or not, blanks between the columns, no header:
 * - origin x y z [m], 4 decimals
 * - direction x y z, a unit vector, 9 decimals
 * - time [ns], 4 decimals: of this file alone HELIOS counts it so
 * - pulse index: the id of the pulse
 * - device index: the channel
 *
 * Blocks: pulses as vtkHeliosScanner gives them: vtkPolyData, points of doubles,
 * point arrays Direction, GpsTime [s] and of integers PulseIds, ChannelIds. A
 * block without points needs no arrays.
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
