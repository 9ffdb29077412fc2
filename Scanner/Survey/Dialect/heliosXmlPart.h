// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Reads a part of a scene from its element. Errors go to the messages of the document.

#ifndef heliosXmlPart_h
#define heliosXmlPart_h

#include "heliosAssets.h"
#include "heliosSurveyData.h"

#include <functional>

namespace helios
{

/// The filters and motions of a <part> of a <scene>, with their files found; it may have several.
PartData ReadPart(const XmlElement& element, const XmlElement& scene, Assets& assets);

/// Reads the filters crs and repair, the swaps and the motions of a part made by methods, each if
/// its name was set; a name without an element gives the default.
void ReadMadePart(const XmlElement& element, const XmlElement& scene,
  const std::function<bool(const char* name)>& hasSet, Assets& assets, PartData& part);

} // namespace helios

#endif
