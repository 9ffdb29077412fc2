// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Reflectances from spectra.

#ifndef heliosSpectrum_h
#define heliosSpectrum_h

#include "heliosStatus.h"

#include <vtkSmartPointer.h>

#include <map>
#include <string>
#include <vector>

class vtkDataObject;

namespace helios
{

class Messages;
struct Material;

/// A reflectance over wavelength, read from the text format of the ASTER library: any header, then
/// rows of wavelength [um] and reflectance [percent].
class Spectrum
{
public:
  /// Reads a file.
  Status Read(const std::string& path);

  /// Returns the reflectance [0..1] at a wavelength [nm], linear between rows, constant before the
  /// first and after the last row.
  double GetReflectance(double wavelength) const;

private:
  std::vector<double> Wavelengths; // [um], ascending
  std::vector<double> Values;      // [percent]
};

/// Returns the file of a spectrum, <name>.txt in the first folder that has it; empty: none.
std::string FindSpectrum(const std::string& name, const std::vector<std::string>& folders);

/// Returns whether a material takes its reflectance from a spectrum.
bool NeedsSpectrum(const Material& material);

/**
 * A scene at several wavelengths: materials that have a spectrum and no reflectance get its value
 * at the wavelength. A spectrum is the file <name>.txt in the first folder that has it; a missing
 * one causes one warning, and its materials keep the default. All scenes have the same points and
 * triangles.
 */
class SpectralScenes
{
public:
  SpectralScenes(vtkDataObject* scene, std::vector<std::string> folders, Messages& log);

  /// Returns the scene at a wavelength [nm].
  vtkDataObject* Get(double wavelength);

  /// Returns the scene without its spectra.
  vtkDataObject* GetPlain() const { return this->Scene; }

private:
  vtkSmartPointer<vtkDataObject> Scene;
  std::vector<std::string> Folders;
  Messages& Log;
  std::map<double, vtkSmartPointer<vtkDataObject>> Scenes;
};

} // namespace helios

#endif
