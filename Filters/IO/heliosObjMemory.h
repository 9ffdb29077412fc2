// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// What an OBJ file takes as a scene.

#ifndef heliosObjMemory_h
#define heliosObjMemory_h

#include "vtkHeliosFiltersIOModule.h" // For export macro

#include <functional>
#include <string>

namespace helios
{

/// Vertices and triangles of a file, counted by the beginnings and words of its lines.
struct ObjCounts
{
  double Vertices = 0.0;
  double Triangles = 0.0;
};
VTKHELIOSFILTERSIO_EXPORT ObjCounts CountObj(
  const std::string& path, const std::function<bool(double)>& onBlock = {});

/**
 * Why a file would take more memory than there is, in words; empty where it does not. Lines are
 * counted only where its size leaves that open.
 */
VTKHELIOSFILTERSIO_EXPORT std::string CheckObjMemory(
  const std::string& path, const std::function<bool(double)>& onBlock = {});

} // namespace helios

#endif
