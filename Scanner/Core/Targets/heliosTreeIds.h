// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Tree, species and organ of echoes.

#ifndef heliosTreeIds_h
#define heliosTreeIds_h

class vtkPolyData;

namespace helios
{

/**
 * Adds TreeIds, SpeciesIds and OrganIds to echoes with the field data of a scene with trees
 * (Part.Tree, Part.Species, materials), and the names of the latter two to the field data. An organ
 * is leaf or wood by a word in the name of the material, or by its optics, Leaf. Without trees
 * nothing is added.
 */
void AddTreeIds(vtkPolyData* echoes);

} // namespace helios

#endif
