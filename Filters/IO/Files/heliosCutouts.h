// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Materials whose textures cut shapes out of triangles, which is not read.

#ifndef heliosCutouts_h
#define heliosCutouts_h

#include "heliosSceneMesh.h"

#include <string>
#include <vector>

namespace helios
{

/// The row of a material, where it says so ("path:line: "), and what: `map_d of material "leaf"`.
struct Cutout
{
  int Row = 0;
  std::string Place;
  std::string What;
};

/// Warns once of the triangles that are scanned as opaque, if there are any.
VTKHELIOSFILTERSIO_EXPORT void WarnOfCutouts(
  SceneMesh& mesh, const std::vector<Cutout>& cutouts, TextReport& report);

} // namespace helios

#endif
