// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Attributes whose text has a grammar of its own: the pulse shape of a receiver, gaussian, helios, or the
// name of a file; the start time of a survey.

#ifndef heliosXmlPulseShape_h
#define heliosXmlPulseShape_h

#include "heliosReceiverData.h"
#include "heliosXmlValue.h"

namespace helios
{

/// Sets the pulse shape; a file is searched in the folder of the value, else by its given path.
/// False after an error.
bool SetPulseShape(ReceiverData& receiver, const XmlValue& value, Messages& log);

std::string GetPulseShape(const ReceiverData& receiver);

/// Sets the start; false after an error.
bool SetGpsStart(std::string& start, const XmlValue& value, Messages& log);

std::string GetGpsStart(const std::string& start);

} // namespace helios

#endif
