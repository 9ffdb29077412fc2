// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosPCLArrayNames
 * @brief   names of the arrays of the PCL filters
 *
 * All others are in vtkHeliosArrayNames.
 */

#ifndef vtkHeliosPCLArrayNames_h
#define vtkHeliosPCLArrayNames_h

namespace vtkHeliosPCLArrayNames
{

///@{
/** Clouds of the PCL filters: point data. */
inline constexpr const char* ClusterIds = "ClusterIds"; // from 0, the largest; -1: no cluster
inline constexpr const char* PlaneIds = "PlaneIds";     // from 0, in the order found; -1: no plane
inline constexpr const char* Curvature = "Curvature";   // [0..1/3], see vtkHeliosPCLNormals
inline constexpr const char* NumberOfPoints = "NumberOfPoints"; // represented by a point
///@}

///@{
/** Field data of planes: one row each. */
inline constexpr const char* PlaneCoefficients = "Plane.Coefficients"; // a b c d, unit normal
inline constexpr const char* PlaneCentre = "Plane.Centre";             // [m]
inline constexpr const char* PlaneDeviation = "Plane.Deviation";       // [m], root mean square
///@}

/** Field data of a registered cloud: 16 numbers, row by row. */
inline constexpr const char* RegistrationMatrix = "Registration.Matrix";

} // namespace vtkHeliosPCLArrayNames

#endif
