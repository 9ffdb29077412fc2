// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Reads legs with their templates from their elements. Errors go to the messages of the document.

#ifndef heliosXmlLeg_h
#define heliosXmlLeg_h

#include "heliosLegSettings.h"
#include "heliosXmlElement.h"

namespace helios
{

class Assets;

/// The maximum depth of nested templates: deeper ones are cyclic.
constexpr int DeepestTemplate = 32;

/// Reads a <leg>; values that it does not give are kept from settings.
LegSettings ReadLeg(const XmlElement& leg, LegSettings settings, Assets& files);

/// Reads a <scannerSettings> of a leg or beside legs, with its templates.
LegSettings ReadScannerSettings(const XmlElement& element, Assets& files);

/// Checks the templates of a document for errors.
void CheckTemplates(const XmlElement& root, Assets& files);

} // namespace helios

#endif
