// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The coordinate system in the field data of a scene or of points.

#ifndef heliosSceneCrs_h
#define heliosSceneCrs_h

#include "vtkHeliosFiltersCoreModule.h"

#include <array>
#include <limits>
#include <string>

class vtkDataObject;

namespace helios
{

/// Returns the string in the field data CRS; empty if missing.
VTKHELIOSFILTERSCORE_EXPORT std::string GetCRS(vtkDataObject* data);

/// How a file stores coordinates: whole steps from an offset.
struct CoordinateSteps
{
  std::array<double, 3> Scale; ///< infinite: not known
  std::array<double, 3> Offset{ 0.0, 0.0, 0.0 };
  bool HasOffset = false; ///< false: coordinates were computed from the coordinates in the file

  CoordinateSteps() { this->Scale.fill(std::numeric_limits<double>::infinity()); }
};

/// Returns the steps in the field data CoordinateScale.
VTKHELIOSFILTERSCORE_EXPORT CoordinateSteps GetCoordinateSteps(vtkDataObject* data);

/// Sets the field data CoordinateScale, or removes it if no step is known.
VTKHELIOSFILTERSCORE_EXPORT void SetCoordinateSteps(
  vtkDataObject* data, const CoordinateSteps& steps);

/// Sets the field data CRS, or removes it if the string is empty.
VTKHELIOSFILTERSCORE_EXPORT void SetCRS(vtkDataObject* data, const std::string& crs);

} // namespace helios

#endif
