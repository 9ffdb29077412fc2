// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosFlightArrayNames
 * @brief   names of the arrays of flight plans
 *
 * All others are in vtkHeliosArrayNames, such as Speed of waypoints.
 */

#ifndef vtkHeliosFlightArrayNames_h
#define vtkHeliosFlightArrayNames_h

namespace vtkHeliosFlightArrayNames
{

/** Waypoints: point data. 1: the scanner fires from there to the next waypoint. */
inline constexpr const char* Active = "Active";

///@{
/** Cells of the ground: point data of their centres. */
inline constexpr const char* PulseDensity = "PulseDensity";     // [1/m2], of all strips
inline constexpr const char* StripDensity = "StripDensity";     // [1/m2], of the densest strip
inline constexpr const char* NumberOfStrips = "NumberOfStrips"; // strips that reach the cell
inline constexpr const char* FlyingHeight = "FlyingHeight";     // [m], of the nearest line above it
///@}

} // namespace vtkHeliosFlightArrayNames

#endif
