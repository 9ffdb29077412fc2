// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Echoes of light that was scattered more than once.

#ifndef heliosScatteredEchoes_h
#define heliosScatteredEchoes_h

#include "heliosPulseShape.h"
#include "heliosReceiver.h"
#include "heliosScatteredProfile.h"
#include "vtkHeliosScannerCoreModule.h" // For export macro

#include <vector>

namespace helios
{

/// Returns the power of scattered light in the received signal at a range; isSum: of all of it.
VTKHELIOSSCANNERCORE_EXPORT ScatteredPower GetScatteredPower(
  const ScatteredProfile& profile, const PulseShape& shape, bool isSum, double range);

/**
 * Drops echoes that are maxima of the sampling only: those of mostly scattered light, whose rise
 * above the signal between them and the echoes beside them is less than three standard errors. The
 * least certain one is dropped first, so that of a broad maximum one echo is left.
 */
VTKHELIOSSCANNERCORE_EXPORT void DropUncertainEchoes(
  const ScatteredProfile& profile, const PulseShape& shape, std::vector<Echo>& echoes);

} // namespace helios

#endif
