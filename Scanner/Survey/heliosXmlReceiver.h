// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Sampling, waveforms, detection, noise and errors of a scanner from its elements.

#ifndef heliosXmlReceiver_h
#define heliosXmlReceiver_h

#include "heliosSurveyData.h"
#include "heliosXmlElement.h"

namespace helios
{

class Messages;

/// What a <scanner> says about its receiver, its noise and its errors.
void ReadReceiver(const XmlElement& scanner, ScannerData& data);

/// What a survey's own <FWFSettings>, <detectorSettings> and attributes change in its scanner.
void OverrideReceiver(const XmlElement& survey, ScannerData& data);

/// What only shows once all is read: bins too wide for the pulse, waveforms shorter than it.
void CheckReceiver(const ScannerData& data, Messages& log);

} // namespace helios

#endif
