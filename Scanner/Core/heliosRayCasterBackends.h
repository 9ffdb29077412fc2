// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The only file that knows which backends of the ray caster are built.

#ifndef heliosRayCasterBackends_h
#define heliosRayCasterBackends_h

#include "vtkHeliosScannerCoreModule.h" // For export macro

#include <vtkSmartPointer.h>

class vtkHeliosRayCaster;

namespace helios
{

/// Returns the default ray caster. All backends that are built are then registered.
VTKHELIOSSCANNERCORE_EXPORT vtkSmartPointer<vtkHeliosRayCaster> MakeDefaultRayCaster();

} // namespace helios

#endif
