// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Materials of synthetic scenes. Classification by ASPRS LAS codes.
//
// Reflectance is one number for all wavelengths. Values marked ASTER are the mean of those at 1064
// and 1550 nm, in brackets, of the ASTER spectral library (Baldridge et al. 2009, Remote Sensing of
// Environment 113, 711; today ECOSTRESS); leaves are darker at 1550 nm due to water. The others are
// marked as assumed. For a survey at one wavelength spectra are more accurate.

#ifndef heliosSyntheticMaterials_h
#define heliosSyntheticMaterials_h

#include "heliosMaterialTable.h"

namespace helios
{
namespace synthetic
{

enum LasClass
{
  Unclassified = 1,
  GroundClass = 2,
  LowVegetation = 3,
  HighVegetation = 5,
  Building = 6
};

inline Material MakeMaterial(const char* name, double reflectance, int classification)
{
  Material material;
  material.Name = name;
  material.Reflectance = reflectance;
  material.Classification = classification;
  material.IsGround = classification == GroundClass;
  return material;
}

/// Returns a test panel: neither ground nor building.
inline Material Target()
{
  return MakeMaterial("target", 0.5, Unclassified);
}
/// Returns bare ground for the plane, step and blocks: assumed.
inline Material Ground()
{
  return MakeMaterial("ground", 0.3, GroundClass);
}
/// Returns grass: ASTER, green grass (0.52, 0.23).
inline Material Grass()
{
  return MakeMaterial("grass", 0.38, GroundClass);
}
/// Returns bark: assumed.
inline Material Bark()
{
  return MakeMaterial("bark", 0.3, HighVegetation);
}
/// Returns leaves: ASTER, deciduous trees (0.57, 0.24).
inline Material Leaf()
{
  return MakeMaterial("leaf", 0.4, HighVegetation);
}
/// Returns needles: ASTER, coniferous trees (0.52, 0.18).
inline Material Needle()
{
  return MakeMaterial("needle", 0.35, HighVegetation);
}
/// Returns shrubs: stems equal bark, leaves equal leaves of trees.
inline Material Stem()
{
  return MakeMaterial("stem", 0.3, LowVegetation);
}
inline Material ShrubLeaf()
{
  return MakeMaterial("shrub_leaf", 0.4, LowVegetation);
}
/// Returns dry tilled soil: assumed.
inline Material Soil()
{
  return MakeMaterial("soil", 0.3, GroundClass);
}
/// Returns crops: stems and leaves equal shrubs; ears are ripe straw: assumed.
inline Material CropStem()
{
  return MakeMaterial("crop_stem", 0.3, LowVegetation);
}
inline Material CropLeaf()
{
  return MakeMaterial("crop_leaf", 0.4, LowVegetation);
}
inline Material CropEar()
{
  return MakeMaterial("crop_ear", 0.45, LowVegetation);
}
/// Returns light plaster: assumed.
inline Material Plaster()
{
  return MakeMaterial("plaster", 0.7, Building);
}
/// Returns roofs: ASTER, slate shingle (0.19, 0.17).
inline Material Roof()
{
  return MakeMaterial("roof", 0.18, Building);
}
/// Returns wood: ASTER, pine wood (0.90, 0.56).
inline Material Wood()
{
  return MakeMaterial("wood", 0.73, Building);
}
/// Returns the mean of a window's frame and the curtain behind: assumed.
inline Material Window()
{
  return MakeMaterial("window", 0.1, Building);
}
/// Returns the red brick of chimneys: assumed.
inline Material Brick()
{
  return MakeMaterial("brick", 0.35, Building);
}
/// Returns the concrete of the blocks: assumed.
inline Material Concrete()
{
  return MakeMaterial("concrete", 0.35, Building);
}

} // namespace synthetic
} // namespace helios

#endif
