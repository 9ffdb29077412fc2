// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosWaveformTextWriter
 * @brief   write waveforms in HELIOS text columns
 *
 * One pulse per line, columns separated by blanks, no header:
 * - fullwave index: the pulse id
 * - origin x y z [m], 4 decimals
 * - direction x y z, a unit vector, 9 decimals
 * - times of the first and the last sample, t_max = t_min + (n - 1) bin [ns],
 *   two-way, after the emission, 4 decimals
 * - GPS time of the emission [s], 9 decimals
 * - the n samples [nW], 9 decimals
 *
 * HELIOS++ writes one-way times and directions with 4 decimals.
 *
 * Blocks: waveforms in the layout of vtkHeliosScanner: vtkTable with the columns PulseIds, Origin,
 * Direction, GpsTime [s], StartTime [ns], BinSize [ns], Offset, Count (at least 1), and Samples [W]
 * in its field data. A block without rows needs no columns.
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
