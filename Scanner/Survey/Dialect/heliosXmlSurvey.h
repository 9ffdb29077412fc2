// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Reads surveys from HELIOS XML.

#ifndef heliosXmlSurvey_h
#define heliosXmlSurvey_h

#include "heliosSurveyData.h"

#include <string>

namespace helios
{

class Assets;
class Messages;
class XmlDocument;
class XmlElement;

/// The first survey of a document, which may be null, with all references. Complete only if log has
/// no error then.
SurveyData ReadSurvey(const XmlDocument* document, Assets& assets, Messages& log);

/// The survey of an element; its name without a name is that of data.FileName.
void ReadSurvey(const XmlElement& element, Assets& assets, Messages& log, SurveyData& data);

/// A name valid for a folder.
std::string MakeFolderName(std::string name);

} // namespace helios

#endif
