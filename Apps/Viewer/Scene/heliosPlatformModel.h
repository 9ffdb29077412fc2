// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Simple built-in platform models, in metres, in the body frame (x right, y forward, z up).

#ifndef heliosPlatformModel_h
#define heliosPlatformModel_h

#include <vtkSmartPointer.h>

class vtkPolyData;

namespace helios::viewer
{

enum class PlatformKind;

/// Returns what carries a scanner; on the ground with its feet or wheels at z = 0. An unknown kind
/// is a ball.
vtkSmartPointer<vtkPolyData> MakePlatformModel(PlatformKind kind);

/// Returns a scanner: a head on a base, facing y.
vtkSmartPointer<vtkPolyData> MakeScannerModel();

} // namespace helios::viewer

#endif
