// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The air in fog, rain, snow, smoke and dust.

#ifndef heliosWeather_h
#define heliosWeather_h

#include "heliosStatus.h"
#include "vtkHeliosScannerCoreModule.h" // For export macro

#include <string>

namespace helios
{

struct Air
{
  double Extinction = 0.0; ///< alpha [1/m]
  double LidarRatio = 0.0; ///< alpha over the backscatter [sr]; 0: no backscatter
  /// diameter of single drops [m]; 0: so many that they are not single
  double DropletDiameter = 0.0;
};

/**
 * Parses the air of a kind of weather and its amount, such as "fog 0.2" or "rain 10", at a
 * wavelength [nm]:
 * - fog, smoke, dust: visibility V [km]: 3.912 / V (lambda / 550 nm)^-q per km, with q of Kim,
 *   McArthur and Korevaar 2001 (SPIE 4214): V - 0.5 from 0.5 km on, 0.16 V + 0.34 from 1 km, 1.3
 *   from 6 km, 1.6 from 50 km; below 0.5 km 0;
 * - rain [mm/h]: 1.076 R^0.67 dB/km (Carbonneau and Wisely 1998, SPIE 3232);
 * - snow (dry), sleet (wet snow) [mm/h of water]: (5.42e-5 lambda + 5.496) S^1.38 and (1.02e-4
 *   lambda + 3.786) S^0.72 dB/km (ITU-R P.1814);
 * - lidar ratios: 18.8 sr of droplets (O'Connor, Illingworth and Hogan 2004, J. Atmos. Oceanic
 *   Technol. 21, 777-786), 25 sr of snow, 70 sr of smoke, 45 sr of dust.
 *
 * "rain 10 drops" has single drops of the median diameter by volume of Marshall and Palmer (1948,
 * J. Meteorology 5, 165-166): 0.895 mm R^0.21.
 *
 * clear, or no text, is no weather. An error status tells what to give instead.
 */
VTKHELIOSSCANNERCORE_EXPORT Status ParseWeather(
  const std::string& text, double wavelength, Air& air);

/// Finds the fault of a text, whatever the wavelength.
VTKHELIOSSCANNERCORE_EXPORT Status FindWeatherFault(const std::string& text);

} // namespace helios

#endif
