// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosWaveformTextWriter
 * @brief   waveforms in HELIOS text columns
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



protected:
  vtkHeliosWaveformTextWriter();
  ~vtkHeliosWaveformTextWriter() override;

private:
  vtkHeliosWaveformTextWriter(const vtkHeliosWaveformTextWriter&) = delete;
  void operator=(const vtkHeliosWaveformTextWriter&) = delete;
};

#endif
