// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Memory estimate of an OBJ file as a scene.

#ifndef heliosObjMemory_h
#define heliosObjMemory_h

#include "heliosStatus.h"
#include "vtkHeliosFiltersIOModule.h" // For export macro

#include <functional>
#include <string>

namespace helios
{

/// Vertices and triangles of a file, counted from the start and the words of its lines.
struct ObjCounts
{
  double Vertices = 0.0;
  double Triangles = 0.0;
};
VTKHELIOSFILTERSIO_EXPORT ObjCounts CountObj(
  const std::string& path, const std::function<bool(double)>& onBlock = {});

/**
 * Returns an error if a file needs more memory than available. Lines are counted only if the file
 * size alone does not decide.
 */
VTKHELIOSFILTERSIO_EXPORT Status CheckObjMemory(
  const std::string& path, const std::function<bool(double)>& onBlock = {});

} // namespace helios

#endif
