// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The pulse shape of a receiver as text: gaussian, helios, or the name of a file.

#ifndef heliosXmlPulseShape_h
#define heliosXmlPulseShape_h

#include "heliosReceiverData.h"
#include "heliosXmlValue.h"

namespace helios
{

/// A file is searched in the folder of the value, else as given. False after an error.
bool SetPulseShape(ReceiverData& receiver, const XmlValue& value, Messages& log);

std::string GetPulseShape(const ReceiverData& receiver);

} // namespace helios

#endif
