// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Mirrors and glass in material files (MTL).

#ifndef heliosMtlOptics_h
#define heliosMtlOptics_h

#include "heliosMaterialTable.h"
#include "heliosTextFile.h"

#include <map>
#include <string>
#include <string_view>

namespace helios
{

/**
 * The optics of the material that a file defines. helios_optics is mirror, pane, volume, water,
 * leaf, retroreflector, or illum: what the standard keys illum and d mean. helios_water is a type
 * of water with its numbers. helios_mirrorReflectance, helios_thickness [m], helios_attenuation
 * [1/m], helios_backscatter [1/(m sr)], helios_transmittance, helios_retroreflection [1/sr],
 * helios_meanSquareSlope and the standard Ni are their numbers; helios_dispersion is a medium whose
 * index follows the wavelength. Without helios_optics and helios_water a material is opaque, and the
 * standard keys are ignored.
 */
class MtlOptics
{
public:
  /// Returns whether a key is one of these.
  static bool Has(std::string_view key);

  /// Returns whether it is not of standard MTL.
  static bool IsOwn(std::string_view key) { return key.substr(0, 7) == "helios_"; }

  /// Forgets the previous material.
  void Start() { this->Lines.clear(); }

  /// Keeps the line of a key.
  void Read(TextFile& file, std::string_view key, TextWords& words);

  /// Computes the optics after the last line; specular is the mean of Ks. False after an error.
  bool Finish(double specular, MaterialOptics& optics, TextReport& report) const;

private:
  struct Line
  {
    std::string Place;
    std::string Value;
  };

  bool SetKind(const Line& line, double specular, MaterialOptics& optics, TextReport& report) const;
  bool SetWater(const Line& line, MaterialOptics& optics, TextReport& report) const;
  bool SetDispersion(MaterialOptics& optics, TextReport& report) const;
  bool SetStandardKind(
    const Line& line, double specular, MaterialOptics& optics, TextReport& report) const;
  bool SetNumber(
    const char* key, double minimum, double maximum, double& value, TextReport& report) const;

  std::map<std::string, Line, std::less<>> Lines; // by their key
};

/// Returns the lines from which MtlOptics reads the same optics; none if opaque.
std::string FormatMtlOptics(const MaterialOptics& optics);

} // namespace helios

#endif
