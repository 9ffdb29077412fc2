// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosWaveformTextWriter
 * @brief   waveforms in HELIOS text columns
 *
 * One pulse a line, blanks between the columns, no header:
 * - fullwave index: the id of the pulse
 * - origin x y z [m], 4 decimals
 * - direction x y z, a unit vector, 9 decimals
 * - time of the first sample and of the last one, t_max = t_min + (n - 1) bin
 *   [ns], two-way, after the emission, 4 decimals
 * - GPS time of the emission [s], 9 decimals
 * - the n samples [nW], 9 decimals
 *
 * HELIOS++ writes times one way and directions with 4 decimals.
 *
 * Blocks: waveforms as vtkHeliosScanner gives them: vtkTable with the columns
 * PulseIds, Origin, Direction, GpsTime [s], StartTime [ns], BinSize [ns], Offset,
 * Count (at least 1), and Samples [W] in its field data. A block without rows
 * needs no columns.
 *
 * @sa
 * vtkHeliosWaveformTextReader vtkHeliosWaveformXMLWriter vtkHeliosScanner
 */

#ifndef vtkHeliosWaveformTextWriter_h
#define vtkHeliosWaveformTextWriter_h

#include "vtkHeliosFiltersIOModule.h" // For export macro
#include "vtkHeliosStreamWriter.h"

class VTKHELIOSFILTERSIO_EXPORT vtkHeliosWaveformTextWriter : public vtkHeliosStreamWriter
{
public:
  static vtkHeliosWaveformTextWriter* New();
  vtkTypeMacro(vtkHeliosWaveformTextWriter, vtkHeliosStreamWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Appends the waveforms of a block.
   */
  bool Write(vtkDataObject* block) override;

protected:
  vtkHeliosWaveformTextWriter() = default;
  ~vtkHeliosWaveformTextWriter() override = default;

  const char* GetBlockSource() const override;

private:
  vtkHeliosWaveformTextWriter(const vtkHeliosWaveformTextWriter&) = delete;
  void operator=(const vtkHeliosWaveformTextWriter&) = delete;
};

#endif
