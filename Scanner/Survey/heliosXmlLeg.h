// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Legs with their templates from their elements. Errors go to the messages of the document.

#ifndef heliosXmlLeg_h
#define heliosXmlLeg_h

#include "heliosLegSettings.h"
#include "heliosXmlElement.h"

namespace helios
{

class Assets;

/// What a <leg> says; as in the settings given where it says nothing.
LegSettings ReadLeg(const XmlElement& leg, LegSettings settings, Assets& files);

/// What a <scannerSettings> says, that of a leg or one beside legs, with its templates.
LegSettings ReadScannerSettings(const XmlElement& element, Assets& files);

/// Reads the templates of a document, for their errors.
void CheckTemplates(const XmlElement& root, Assets& files);

} // namespace helios

#endif
