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

/// What an element does not say stays.
void ReadOptics(const XmlElement& element, ScannerData& scanner);

/// Everything that ReadOptics() reads as it is in a new scanner, but for the type.
void ForgetOptics(ScannerData& scanner);

/// What only shows once all is read: optics that deflect nothing.
void CheckOptics(const ScannerData& scanner, Messages& log);

} // namespace helios

#endif
