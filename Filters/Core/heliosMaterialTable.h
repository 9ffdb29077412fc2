// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The materials of a scene, stored in its field data.

#ifndef heliosMaterialTable_h
#define heliosMaterialTable_h

#include "vtkHeliosFiltersCoreModule.h"

#include <array>
#include <limits>
#include <string>
#include <vector>

class vtkDataObject;

namespace helios
{

/// Reflectance of a surface without reflectance and spectrum.
constexpr double DefaultReflectance = 0.5;

/// Refractive index of water of none: of sea water and fresh water to 0.5 %, from 500 to 1100 nm.
constexpr double WaterIndex = 1.34;

/// Kind of a surface by the light that it does not scatter.
enum class OpticsKind
{
  Opaque, ///< absorbs it
  Mirror, ///< reflects a share of the light
  Pane,   ///< a plate with two faces: reflects and transmits; the surface is the first face met
  Volume, ///< the boundary of a transparent body: reflects and refracts
  Water,  ///< transmits like a volume; its attenuation is given at 532 nm
  Leaf,   ///< scatters light, and transmits a share straight on
  Retroreflector ///< returns light to where it comes from
};

/// Media whose refractive index is known by wavelength.
enum class DispersionKind
{
  None, ///< the index is a number
  Water,
  SodaLime, ///< window glass
  Bk7,
  Silica
};

struct VTKHELIOSFILTERSCORE_EXPORT MaterialOptics
{
  OpticsKind Kind = OpticsKind::Opaque;
  double MirrorReflectance = 1.0; ///< [0..1]
  double RefractiveIndex = 1.5;   ///< pane, volume and water only, [1..4]
  double Thickness = 0.004;       ///< pane only [m]
  double Attenuation = 0.0;       ///< within them [1/m]
  double Backscatter = 0.0;       ///< within volumes and water [1/(m sr)]
  double Transmittance = 0.0;     ///< leaf only, [0..1]
  double Retroreflection = 250.0; ///< coefficient of retroreflectors [cd/(lx m2) = 1/sr]
  double MeanSquareSlope = 0.0;   ///< rough surface; 0: smooth
  DispersionKind Dispersion = DispersionKind::None;
  double GroupIndex = 0.0; ///< by which pulses are slower, at a wavelength; 0: RefractiveIndex

  bool operator==(const MaterialOptics& other) const;
};

/// The colour of a surface, for echoes that are coloured.
struct VTKHELIOSFILTERSCORE_EXPORT MaterialColor
{
  /// Red, green, blue, [0..1]; NaN: not set.
  std::array<double, 3> Base{ std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN() };
  std::string Texture; ///< path of an image that Base is multiplied by; empty: none

  bool IsSet() const { return this->Base[0] == this->Base[0]; }
  bool operator==(const MaterialColor& other) const;
};

struct VTKHELIOSFILTERSCORE_EXPORT Material
{
  std::string Name = "default";
  double Reflectance = std::numeric_limits<double>::quiet_NaN(); ///< [0..1]; NaN: not set
  double Specularity = 0.0;                                      ///< [0..1]
  double SpecularExponent = 10.0;
  int Classification = 0;
  bool IsGround = false;
  std::string Spectrum; ///< name of a spectrum; empty: none
  MaterialOptics Optics;
  MaterialColor Color;

  bool operator==(const Material& other) const;
};

using MaterialTable = std::vector<Material>;

/// Returns the material columns of a scene's field data; a scene without them has one default
/// material.
VTKHELIOSFILTERSCORE_EXPORT MaterialTable GetMaterials(vtkDataObject* scene);

/// Replaces the material columns of a scene; columns of optics and of colours exist only if a
/// material has any.
VTKHELIOSFILTERSCORE_EXPORT void SetMaterials(vtkDataObject* scene, const MaterialTable& materials);

} // namespace helios

#endif
