// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// What colour a material of a scene is drawn in: scenes carry reflectances, no colours.

#ifndef heliosMaterialColors_h
#define heliosMaterialColors_h

#include "heliosColorMaps.h"
#include "heliosMaterialTable.h"

namespace helios
{

/**
 * That of its class, where it has one; else that of a word in its name (ground, leaf, bark, roof,
 * wall ...); else ground where it is; else the distinct colour of its row in the table.
 */
Rgb GetMaterialColor(const Material& material, std::size_t row);

} // namespace helios

#endif
