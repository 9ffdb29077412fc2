// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Reads scanners from their elements. Errors go to the messages of the document.

#ifndef heliosXmlScanner_h
#define heliosXmlScanner_h

#include "heliosSurveyData.h"
#include "heliosXmlElement.h"

namespace helios
{

class Assets;

/// Reads a scanner, and the beam tables that it names.
ScannerData ReadScanner(const XmlElement& element, const Assets& files);

/// Overrides all channels of a scanner by a survey's own <FWFSettings> and <detectorSettings>.
void OverrideScanner(const XmlElement& survey, ScannerData& scanner);

/// Reads the axis of the head rotation; unchanged without an element.
void ReadHeadRotateAxis(const XmlElement& element, Vec3& axis);

/// Checks the complete data: bins too wide for the pulse, empty ranges.
void CheckScanner(const ScannerData& scanner, Messages& log);

} // namespace helios

#endif
