// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Closed-form shapes about the z axis, on z = 0.

#ifndef heliosSyntheticShapes_h
#define heliosSyntheticShapes_h

#include <vtkType.h>

namespace helios
{

class MeshBuilder;

/// Adds a square of the given side on z = 0, parts x parts squares.
void AddPlane(MeshBuilder& mesh, double side, int parts);

/**
 * Adds two half planes of the square: z = 0 for x < 0, z = height for x > 0; the riser at x = 0
 * faces -x. Each half and the riser are parts x parts rectangles.
 */
void AddStep(MeshBuilder& mesh, double side, double height, int parts);

/// Adds an icosahedron with edges divided into parts, projected onto the sphere about the origin.
void AddSphere(MeshBuilder& mesh, double diameter, int parts);

/// Adds a pyramid on a square base, with edges divided into parts.
void AddPyramid(MeshBuilder& mesh, double side, double height, int parts);

/**
 * Adds the square ground with one box in each of cells x cells squares. Sides are 30 to 60 % of the
 * square's, tops 20 to 100 % of the height, headings random; the boxes extend 5 % of the height
 * into the ground. Squares that touch the centre stay empty.
 */
void AddBlocks(MeshBuilder& mesh, double side, double height, int cells, vtkIdType seed);

} // namespace helios

#endif
