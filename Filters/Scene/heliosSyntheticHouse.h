// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A house with a gabled roof.

#ifndef heliosSyntheticHouse_h
#define heliosSyntheticHouse_h

namespace helios
{

class MeshBuilder;

/**
 * A house about the z axis that stands on z = 0, its ridge along y at that height; it is 0.65 as wide
 * as long. Closed shapes: the body with its recessed door (at +x) and windows, the two halves of the
 * roof with eaves that reach 0.5 m over the walls, and the chimney, 0.7 m higher than the ridge. A
 * storey of windows is left out where the walls are too low for it.
 */
void AddHouse(MeshBuilder& mesh, double length, double height);

} // namespace helios

#endif
