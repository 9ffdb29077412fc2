// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosPointTextWriter
 * @brief   echoes in HELIOS text columns
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



protected:
  vtkHeliosPointTextWriter();
  ~vtkHeliosPointTextWriter() override;

private:
  vtkHeliosPointTextWriter(const vtkHeliosPointTextWriter&) = delete;
  void operator=(const vtkHeliosPointTextWriter&) = delete;
};

#endif
