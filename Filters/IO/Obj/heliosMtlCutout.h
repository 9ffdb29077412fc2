// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Images of a material file that cut shapes out of triangles.

#ifndef heliosMtlCutout_h
#define heliosMtlCutout_h

#include "heliosCutouts.h"
#include "heliosTextFile.h"

#include <string_view>

namespace helios
{

/**
 * Finds the image of map_d, or the image of map_Kd if its header states transparency; map_d has
 * precedence. A file that cannot be read has none here.
 */
void FindMtlCutout(const TextFile& file, std::string_view key, TextWords words, Cutout& cutout);

} // namespace helios

#endif
