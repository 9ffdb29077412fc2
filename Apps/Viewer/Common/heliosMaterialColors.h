// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Colours of materials: scenes have reflectances, no colours.

#ifndef heliosMaterialColors_h
#define heliosMaterialColors_h

#include "heliosColorMaps.h"
#include "heliosMaterialTable.h"

namespace helios::viewer
{

/**
 * Returns the colour of its class, if set; else of a word in its name (ground, leaf, bark, roof,
 * wall ...); else the ground colour if it is ground; else the distinct colour of its table row.
 */
Rgb GetMaterialColor(const Material& material, std::size_t row);

} // namespace helios::viewer

#endif
