// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// What would take more memory than there is, is refused before it is tried.

#ifndef heliosMemoryCheck_h
#define heliosMemoryCheck_h

#include "vtkHeliosFiltersCoreModule.h" // For export macro

#include <string>

namespace helios
{

/// What a triangle takes at the peak of loading a scene, its share of the ray caster's tree and of
/// copies on the way among it [bytes]; measured: 162.
constexpr double BytesPerTriangle = 165.0;

/**
 * "10000000000 cells with heights take about 2.3 TB of memory, and 24.3 GB are available; " and how
 * to allow more, where so many things of a size go beyond vtkHeliosMemoryLimit; an empty text where
 * they do not.
 */
VTKHELIOSFILTERSCORE_EXPORT std::string CheckMemory(
  const std::string& things, double count, double bytesEach);

} // namespace helios

#endif
