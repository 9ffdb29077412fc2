// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Refractive indices by wavelength.

#ifndef heliosDispersion_h
#define heliosDispersion_h

#include "heliosMaterialTable.h"
#include "vtkHeliosScannerCoreModule.h" // For export macro

namespace helios
{

struct Indices
{
  double Phase; ///< n, of refraction
  double Group; ///< n - l dn/dl, by which pulses are slower
};

/**
 * Returns the indices of a medium at a vacuum wavelength [nm], within 300 to 2300 nm (water: 400 to
 * 1100): water at 20 degrees C of Daimon and Masumura 2007 (Applied Optics 46, 3811-3820),
 * soda-lime glass of Rubin 1985 (Solar Energy Materials 12, 275-288), BK7 of its maker Schott,
 * fused silica of Malitson 1965 (J. Opt. Soc. Am. 55, 1205-1209). Wavelengths beyond are taken as
 * the limits.
 */
VTKHELIOSSCANNERCORE_EXPORT Indices GetIndices(DispersionKind medium, double wavelength);

} // namespace helios

#endif
