// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The names of PCL's fields, and the arrays that they are.

#ifndef heliosPcdNames_h
#define heliosPcdNames_h

#include "vtkHeliosArrayNames.h"

#include <string>

namespace helios
{

struct PcdField;
struct PcdHeader;

/// As in vtkHeliosPCLArrayNames.h, which is above this module.
inline constexpr const char* CurvatureName = "Curvature";

/// What a field of a file is.
enum class PcdMeaning
{
  Array, ///< an array with the name of the field
  Padding,
  Coordinate, ///< one of x y z
  Normal,     ///< a component of Normals
  Color,      ///< blue, green, red and alpha in four bytes, of a float or an integer
  ColorCopy,  ///< the same, beside RGB in full
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

/// The index of a field of PCL, in upper case if there is none in lower case, or -1.
int FindPclField(const PcdHeader& header, const std::string& name);

PcdRole GetPcdRole(const PcdHeader& header, const PcdField& field);

///@{
/// Text as ASCII without backslashes, characters beyond it as \u and four hexadecimal digits (in
/// UTF-16), and back. Text that is not UTF-8 is escaped byte by byte, as Latin-1.
std::string EscapeText(const std::string& text);
std::string UnescapeText(const std::string& text);
///@}

} // namespace helios

#endif
