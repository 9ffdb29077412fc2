// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Reads sampling, waveforms, detection, noise and errors of a scanner from its elements.

#ifndef heliosXmlReceiver_h
#define heliosXmlReceiver_h

#include "heliosSurveyData.h"
#include "heliosXmlElement.h"

namespace helios
{

class Messages;

/// Reads receiver, noise and errors of a <scanner>.
void ReadReceiver(const XmlElement& scanner, ScannerData& data);

/// Overrides the scanner by a survey's own <FWFSettings>, <detectorSettings> and attributes.
void OverrideReceiver(const XmlElement& survey, ScannerData& data);

/// Checks the complete data: bins too wide for the pulse, waveforms shorter than it.
void CheckReceiver(const ScannerData& data, Messages& log);

} // namespace helios

#endif
