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

/// The string in the field data CRS; empty if missing.
VTKHELIOSFILTERSCORE_EXPORT std::string GetCRS(vtkDataObject* data);

/// Sets the field data CRS, or removes it if the string is empty.
VTKHELIOSFILTERSCORE_EXPORT void SetCRS(vtkDataObject* data, const std::string& crs);

} // namespace helios

#endif
