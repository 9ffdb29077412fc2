// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Optics at the wavelength of a scanner.

#ifndef heliosWater_h
#define heliosWater_h

#include "heliosMaterialTable.h"
#include "vtkHeliosScannerCoreModule.h" // For export macro

namespace helios
{

/**
 * Returns the absorption of pure water [1/m] at a wavelength [nm]: Pope and Fry 1997 (Applied
 * Optics 36, 8710-8723) up to 700 nm, Hale and Querry 1973 (Applied Optics 12, 555-563) and Kou,
 * Labrie and Chylek 1993 (Applied Optics 32, 3531-3540) beyond. Logarithms between a few
 * wavelengths are interpolated: beyond 700 nm, where it only matters that water is dark, to about
 * 30 %.
 */
VTKHELIOSSCANNERCORE_EXPORT double GetPureWaterAbsorption(double wavelength);

/**
 * Returns optics at a wavelength [nm]: the indices of a medium with dispersion, and water as a
 * volume, whose attenuation, which is given at 532 nm, changes like the attenuation of pure water.
 */
VTKHELIOSSCANNERCORE_EXPORT MaterialOptics GetOpticsAt(
  const MaterialOptics& optics, double wavelength);

} // namespace helios

#endif
