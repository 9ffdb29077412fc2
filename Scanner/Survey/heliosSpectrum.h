// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Reflectances from spectra.

#ifndef heliosSpectrum_h
#define heliosSpectrum_h

#include <string>
#include <vector>

class vtkPolyData;

namespace helios
{

class Messages;

/// A reflectance over the wavelength, read from the text form of the ASTER library: any header, then
/// rows of wavelength [um] and reflectance [percent].
class Spectrum
{
public:
  /// Reads a file; says in words what is wrong with it, or returns an empty text.
  std::string Read(const std::string& path);

  /// The reflectance [0..1] at a wavelength [nm], linear between the rows; before the first and
  /// after the last row theirs holds.
  double GetReflectance(double wavelength) const;

private:
  std::vector<double> Wavelengths; // [um], ascending
  std::vector<double> Values;      // [percent]
};

/**
 * Gives the materials of a scene that have a spectrum and no reflectance the one at the wavelength
 * [nm]. A spectrum is the file <name>.txt of the first folder that has it; one that is missing is
 * warned of once, and its materials keep the default.
 */
void ResolveSpectra(vtkPolyData* scene,
  const std::vector<std::string>& folders,
  double wavelength,
  Messages& log);

} // namespace helios

#endif
