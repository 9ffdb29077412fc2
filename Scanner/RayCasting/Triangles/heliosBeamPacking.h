// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Packs the boxes of nodes and the corners of leaves.

#ifndef heliosBeamPacking_h
#define heliosBeamPacking_h

#include "heliosBeamNode.h"
#include "vtkHeliosScannerRayCastingModule.h" // For export macro

namespace helios
{

/// A box of floats in the frame of a tree.
struct PlainBox
{
  float Low[3];
  float High[3];
};

/// Packs the boxes of children, rounded outwards by the margin.
VTKHELIOSSCANNERRAYCASTING_EXPORT void PackBoxes(
  const PlainBox* boxes, int count, PackedNode& node);

/// Packs corners of triangles (triangle, corner, axis), each rounded to the nearest number: words
/// by corners, then triangles.
VTKHELIOSSCANNERRAYCASTING_EXPORT void PackCorners(
  const double (*corners)[3][3], int count, PackedFrame& frame, vtkTypeUInt32* words);

} // namespace helios

#endif
