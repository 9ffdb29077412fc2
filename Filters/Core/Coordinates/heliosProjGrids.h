// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Grids that operations of PROJ need. Internal to this folder.

#ifndef heliosProjGrids_h
#define heliosProjGrids_h

#include "heliosProj.h"

#include <string>

namespace helios
{

struct Grids
{
  std::string Missing;    // names, separated by commas
  double Accuracy = -1.0; // accuracy of the operation [m]; -1: unknown
};

/// Finds the most accurate operation with grids that are not installed, at a longitude and latitude
/// [deg] if given.
Grids FindMissingGrids(
  const ProjContext& context, const PJ* source, const PJ* target, const double* place);

} // namespace helios

#endif
