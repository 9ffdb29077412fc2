// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Materials of a glTF document that are cut, or blended, by their opacity.

#ifndef heliosGltfCutout_h
#define heliosGltfCutout_h

#include "heliosCutouts.h"

#include <cstdint>
#include <string>

namespace helios
{

class GltfDocument;

/**
 * Finds the opacity of a material whose alphaMode is MASK or BLEND: that of the texture of its base
 * colour, which may be embedded, times the factor. Returns the set of texture coordinates that it
 * needs; -1: none.
 */
int FindGltfCutout(
  GltfDocument& document, std::int64_t material, const std::string& name, Cutout& cutout);

} // namespace helios

#endif
