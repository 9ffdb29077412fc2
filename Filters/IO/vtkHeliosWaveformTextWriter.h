// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosWaveformTextWriter
 * @brief   waveforms in HELIOS text columns
 *
 * One pulse a line, blanks between the columns, no header: fullwave index (the
 * id of the pulse); origin x y z [m], 4 decimals; direction x y z, 9 decimals;
 * time of the first and of the last sample [ns], two-way, 4 decimals; GPS time
 * [s], 9 decimals; the samples [nW], 9 decimals.
 *
 * Blocks: waveforms as vtkHeliosScanner gives them (vtkTable).
 *
 * @sa
 * vtkHeliosStreamWriter
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

  bool Write(vtkDataObject* block) override;

protected:
  vtkHeliosWaveformTextWriter() = default;
  ~vtkHeliosWaveformTextWriter() override = default;

private:
  vtkHeliosWaveformTextWriter(const vtkHeliosWaveformTextWriter&) = delete;
  void operator=(const vtkHeliosWaveformTextWriter&) = delete;
};

#endif
