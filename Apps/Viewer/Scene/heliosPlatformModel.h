// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Simple built-in platform models, in metres, in the body frame (x right, y forward, z up).

#ifndef heliosPlatformModel_h
#define heliosPlatformModel_h

#include <vtkSmartPointer.h>

class vtkPolyData;

namespace helios
{
enum class PlatformType;
}

namespace helios::viewer
{

/// Returns a tripod (its feet at z = 0), an aircraft, a car, or a multicopter.
vtkSmartPointer<vtkPolyData> MakePlatformModel(PlatformType type);

/// Returns a scanner: a head on a base, facing y.
vtkSmartPointer<vtkPolyData> MakeScannerModel();

} // namespace helios::viewer

#endif
