// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosPCLArrayNames
 * @brief   the names of the arrays that only the filters on PCL make
 *
 * All others are in vtkHeliosArrayNames.
 */

#ifndef vtkHeliosPCLArrayNames_h
#define vtkHeliosPCLArrayNames_h

namespace vtkHeliosPCLArrayNames
{

///@{
/** Point data. */
inline constexpr const char* ClusterIds = "ClusterIds"; // from 0, the largest; -1: in none
inline constexpr const char* PlaneIds = "PlaneIds";     // from 0, as they were found; -1: in none
inline constexpr const char* Curvature = "Curvature";   // [0..1/3], see vtkHeliosPCLNormals
inline constexpr const char* NumberOfPoints = "NumberOfPoints"; // that a point stands for
///@}

///@{
/** Field data of planes: a row each. */
inline constexpr const char* PlaneCoefficients = "Plane.Coefficients"; // a b c d, unit normal
inline constexpr const char* PlaneCentre = "Plane.Centre";             // [m]
inline constexpr const char* PlaneDeviation = "Plane.Deviation";       // [m], root mean square
///@}

/** Field data of a cloud that was registered: 16 numbers, row by row. */
inline constexpr const char* RegistrationMatrix = "Registration.Matrix";

} // namespace vtkHeliosPCLArrayNames

#endif
