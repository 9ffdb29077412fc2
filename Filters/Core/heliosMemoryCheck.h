// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Rejects requests that exceed the available memory before they are allocated.

#ifndef heliosMemoryCheck_h
#define heliosMemoryCheck_h

#include "heliosStatus.h"
#include "vtkHeliosFiltersCoreModule.h" // For export macro

#include <string>

namespace helios
{

/// Peak memory per triangle while loading a scene, including half a vertex, its share of the ray
/// caster tree and of temporary copies [bytes]; measured: 58 to 72 (Docs/performance.md).
constexpr double BytesPerTriangle = 75.0;

/// Memory of a vertex [bytes].
constexpr double BytesPerVertex = 24.0;

/**
 * Returns an error if this many items of a size exceed vtkHeliosMemoryLimit: "10000000000 cells with
 * heights need about 2.3 TB of memory, and 24.3 GB are available; " and how to raise the limit.
 */
VTKHELIOSFILTERSCORE_EXPORT Status CheckMemory(
  const std::string& things, double count, double bytesEach);

} // namespace helios

#endif
