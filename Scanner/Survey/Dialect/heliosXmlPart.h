// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Reads a part of a scene from its element. Errors go to the messages of the document.

#ifndef heliosXmlPart_h
#define heliosXmlPart_h

#include "heliosAssets.h"
#include "heliosSurveyData.h"

namespace helios
{

/// Returns the filters and motions of a <part> of a <scene>, with their files found; it may have
/// several.
PartData ReadPart(const XmlElement& element, const XmlElement& scene, Assets& assets);

} // namespace helios

#endif
