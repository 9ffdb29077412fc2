// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Reads pieces of VTK XML by vtkHelios's writers from memory, without validation.

#ifndef heliosVtkXmlText_h
#define heliosVtkXmlText_h

#include "vtkHeliosFiltersIOModule.h" // For export macro

#include <vtkDataObject.h>
#include <vtkSmartPointer.h>

#include <string>

namespace helios
{

/// Returns the points, or the table of waveforms, of a piece
/// (vtkHeliosStreamWriter::SetBlockText()).
VTKHELIOSFILTERSIO_EXPORT vtkSmartPointer<vtkDataObject> ReadVtkXmlText(
  const std::string& text, bool isTable);

} // namespace helios

#endif
