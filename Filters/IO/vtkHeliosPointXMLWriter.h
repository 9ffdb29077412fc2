// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosPointXMLWriter
 * @brief   echoes as VTP pieces under a PVTP
 */

#ifndef vtkHeliosPointXMLWriter_h
#define vtkHeliosPointXMLWriter_h

#include "vtkHeliosFiltersIOModule.h" // For export macro
#include "vtkHeliosStreamWriter.h"

class VTKHELIOSFILTERSIO_EXPORT vtkHeliosPointXMLWriter : public vtkHeliosStreamWriter
{
public:
  static vtkHeliosPointXMLWriter* New();
  vtkTypeMacro(vtkHeliosPointXMLWriter, vtkHeliosStreamWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;



protected:
  vtkHeliosPointXMLWriter();
  ~vtkHeliosPointXMLWriter() override;

private:
  vtkHeliosPointXMLWriter(const vtkHeliosPointXMLWriter&) = delete;
  void operator=(const vtkHeliosPointXMLWriter&) = delete;
};

#endif
