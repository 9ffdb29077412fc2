// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosFoliageArrayNames
 * @brief   names of the arrays of trees and of measured plant area density
 *
 * All others are in vtkHeliosArrayNames, such as PAD and LeafProjection.
 */

#ifndef vtkHeliosFoliageArrayNames_h
#define vtkHeliosFoliageArrayNames_h

namespace vtkHeliosFoliageArrayNames
{

///@{
/** Trees of a scene: field data, a value per part by PartIds, also of turbid voxels. */
inline constexpr const char* PartTree = "Part.Tree";       // number of the tree, -1: none
inline constexpr const char* PartSpecies = "Part.Species"; // empty: not known
///@}

///@{
/** Echoes of a scene with trees: point data, and field data with the names by number. */
inline constexpr const char* TreeIds = "TreeIds";       // number of the tree, -1: none
inline constexpr const char* SpeciesIds = "SpeciesIds"; // row of Species.Name, -1: none
inline constexpr const char* SpeciesName = "Species.Name";
inline constexpr const char* OrganIds = "OrganIds";    // 0 none, 1 leaf, 2 wood of a tree
inline constexpr const char* OrganName = "Organ.Name"; // none, leaf, wood
///@}

///@{
/** Cells of vtkHeliosPlantAreaDensity: cell data of an image. */
inline constexpr const char* DensityError = "DensityError"; // [m2/m3], NaN: unknown
inline constexpr const char* CellState = "CellState"; // 0 no beam, 1 seen, 2 shadowed, 3 saturated
inline constexpr const char* NumberOfBeams = "NumberOfBeams"; // int64, that enter with some energy
inline constexpr const char* NumberOfShadowedBeams = "NumberOfShadowedBeams"; // int64, without any
inline constexpr const char* GroundDistance = "GroundDistance"; // [m], of the centre, NaN: unknown
inline constexpr const char* PathLength = "PathLength";         // [m], free, of all energy
///@}

///@{
/** Sums over the beams of a cell, to which further scans are added; energies are in pulses, paths
 * times G. */
inline constexpr const char* EnteringEnergy = "EnteringEnergy";
inline constexpr const char* InterceptedEnergy = "InterceptedEnergy";
inline constexpr const char* InterceptedSquare = "InterceptedSquare"; // sum of squares, a beam each
inline constexpr const char* FreePath = "FreePath";                   // [m]
inline constexpr const char* HitPath = "HitPath";             // [m], of squared intercepted energy
inline constexpr const char* PotentialPath = "PotentialPath"; // [m], without plants
inline constexpr const char* PotentialPathSquare = "PotentialPathSquare"; // [m2]
///@}

} // namespace vtkHeliosFoliageArrayNames

#endif
