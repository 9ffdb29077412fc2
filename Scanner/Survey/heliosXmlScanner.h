// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Scanners from their elements. Errors go to the messages of the document.

#ifndef heliosXmlScanner_h
#define heliosXmlScanner_h

#include "heliosSurveyData.h"
#include "heliosXmlElement.h"

namespace helios
{

ScannerData ReadScanner(const XmlElement& element);

/// What a survey's own <FWFSettings> and <detectorSettings> change in a scanner, all its channels.
void OverrideScanner(const XmlElement& survey, ScannerData& scanner);

/// What only shows once all is read: bins too wide for the pulse, ranges that hold nothing.
void CheckScanner(const ScannerData& scanner, Messages& log);

} // namespace helios

#endif
