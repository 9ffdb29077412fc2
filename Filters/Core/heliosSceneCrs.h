// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The coordinate system in the field data of a scene.

#ifndef heliosSceneCrs_h
#define heliosSceneCrs_h

#include "vtkHeliosFiltersCoreModule.h"

#include <string>

class vtkDataObject;

namespace helios
{

/// The text in the field data CRS; empty where there is none.
VTKHELIOSFILTERSCORE_EXPORT std::string GetCRS(vtkDataObject* data);

/// Sets the text in the field data CRS, or takes it out where it is empty.
VTKHELIOSFILTERSCORE_EXPORT void SetCRS(vtkDataObject* data, const std::string& crs);

} // namespace helios

#endif
