// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosStreamWriter
 * @brief   writes a cloud block by block
 */

#ifndef vtkHeliosStreamWriter_h
#define vtkHeliosStreamWriter_h

#include "vtkHeliosFiltersIOModule.h" // For export macro
#include "vtkObject.h"

class VTKHELIOSFILTERSIO_EXPORT vtkHeliosStreamWriter : public vtkObject
{
public:
  static vtkHeliosStreamWriter* New();
  vtkTypeMacro(vtkHeliosStreamWriter, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;



protected:
  vtkHeliosStreamWriter();
  ~vtkHeliosStreamWriter() override;

private:
  vtkHeliosStreamWriter(const vtkHeliosStreamWriter&) = delete;
  void operator=(const vtkHeliosStreamWriter&) = delete;
};

#endif
