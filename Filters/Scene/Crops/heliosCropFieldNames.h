// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Names of the ground truth arrays in the field data of vtkHeliosCropFieldSource.

#ifndef heliosCropFieldNames_h
#define heliosCropFieldNames_h

namespace helios
{
namespace cropFieldNames
{

inline constexpr const char* LeafArea = "Field.LeafArea";           // [m2], one side
inline constexpr const char* LeafAreaIndex = "Field.LeafAreaIndex"; // [m2/m2]
inline constexpr const char* GroundArea = "Field.GroundArea";       // [m2], reference of the index
inline constexpr const char* PlantPosition = "Plant.Position";      // base of the stem at the soil
inline constexpr const char* PlantHeight = "Plant.Height";          // [m] above the base
inline constexpr const char* PlantLeafArea = "Plant.LeafArea";      // [m2], one side

} // namespace cropFieldNames
} // namespace helios

#endif
