// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The optics of a scanner from its element.

#ifndef heliosXmlOptics_h
#define heliosXmlOptics_h

#include "heliosSurveyData.h"
#include "heliosXmlElement.h"

namespace helios
{

class Assets;
class Messages;

/// Reads the <incidentBeam> of prisms; unchanged without one.
void ReadIncidentBeam(const XmlElement& element, ScannerData& scanner);

/// Reads the <beams> of a spinning head, also from their file; unchanged without them.
void ReadBeams(const XmlElement& element, const Assets& files, ScannerData& scanner);

/// Resets all optics, except for the type, to the values of a new scanner.
void ResetOptics(ScannerData& scanner);

/// Checks the complete optics: those that deflect nothing.
void CheckOptics(const ScannerData& scanner, Messages& log);

} // namespace helios

#endif
