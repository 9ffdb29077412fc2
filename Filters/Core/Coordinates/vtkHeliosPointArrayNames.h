// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosPointArrayNames
 * @brief   names of the arrays of points from files
 *
 * All others are in vtkHeliosArrayNames, such as CRS and GpsEpoch.
 */

#ifndef vtkHeliosPointArrayNames_h
#define vtkHeliosPointArrayNames_h

namespace vtkHeliosPointArrayNames
{

/**
 * Field data: the steps of the three coordinates in the file, in their units, and, if the
 * coordinates are unchanged, the three offsets of the file.
 */
inline constexpr const char* CoordinateScale = "CoordinateScale";

} // namespace vtkHeliosPointArrayNames

#endif
