// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The optics of a scanner from its element.

#ifndef heliosXmlOptics_h
#define heliosXmlOptics_h

#include "heliosSurveyData.h"
#include "heliosXmlElement.h"

namespace helios
{

class Messages;

/// Reads the optics; values that are not given are unchanged.
void ReadOptics(const XmlElement& element, ScannerData& scanner);

/// Resets everything that ReadOptics() reads, except for the type, to that of a new scanner.
void ForgetOptics(ScannerData& scanner);

/// Checks the complete optics: those that deflect nothing.
void CheckOptics(const ScannerData& scanner, Messages& log);

} // namespace helios

#endif
