// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A house with a gabled roof.

#ifndef heliosSyntheticHouse_h
#define heliosSyntheticHouse_h

namespace helios
{

class MeshBuilder;

/**
 * Adds a house about the z axis on z = 0, its ridge along y at the given height; the width is 0.65
 * of the length. Closed shapes: the body with its recessed door (at +x) and windows, the two halves
 * of the roof with eaves that extend 0.5 m beyond the walls, and the chimney, 0.7 m above the
 * ridge. A storey of windows is left out if the walls are too low for it.
 */
void AddHouse(MeshBuilder& mesh, double length, double height);

} // namespace helios

#endif
