// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The names of PCL's fields, and the arrays that they are.

#ifndef heliosPcdNames_h
#define heliosPcdNames_h

#include "vtkHeliosArrayNames.h"

namespace helios
{

struct PcdField;
struct PcdHeader;

/// Names equal to vtkHeliosPCLArrayNames.h, which is above this module.
inline constexpr const char* CurvatureName = "Curvature";

/// Meaning of a field of a file.
enum class PcdMeaning
{
  Array, ///< an array with the name of the field
  Padding,
  Coordinate, ///< one of x y z
  Normal,     ///< a component of Normals
  Color,      ///< blue, green, red and alpha in four bytes, of a float or an integer
  ColorCopy,  ///< colour as well, beside RGB in full
  Label,      ///< ClassificationIds
  Curvature,  ///< Curvature
  Intensity   ///< Intensity, or Amplitude if the header states so
};

/// The meaning of a field, and its axis if it is a coordinate or a component of normals.
struct PcdRole
{
  PcdMeaning Meaning = PcdMeaning::Array;
  int Axis = -1;
};

PcdRole GetPcdRole(const PcdHeader& header, const PcdField& field);

} // namespace helios

#endif
