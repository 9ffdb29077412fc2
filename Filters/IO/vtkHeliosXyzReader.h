// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosXyzReader
 * @brief   points from a text file, piece by piece
 */

#ifndef vtkHeliosXyzReader_h
#define vtkHeliosXyzReader_h

#include "vtkPolyDataAlgorithm.h"
#include "vtkHeliosFiltersIOModule.h" // For export macro

class VTKHELIOSFILTERSIO_EXPORT vtkHeliosXyzReader : public vtkPolyDataAlgorithm
{
public:
  static vtkHeliosXyzReader* New();
  vtkTypeMacro(vtkHeliosXyzReader, vtkPolyDataAlgorithm);

protected:
  vtkHeliosXyzReader() = default;
  ~vtkHeliosXyzReader() override = default;

private:
  vtkHeliosXyzReader(const vtkHeliosXyzReader&) = delete;
  void operator=(const vtkHeliosXyzReader&) = delete;
};

#endif
