// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Reads surveys from HELIOS XML.

#ifndef heliosXmlSurvey_h
#define heliosXmlSurvey_h

#include "heliosSurveyData.h"
#include "heliosXmlElement.h"

#include <string>
#include <vector>

namespace helios
{

class Assets;
class Messages;

/// The elements that a survey is read from.
struct SurveyElements
{
  ///@{
  /// One for each scanner or platform of the data; an interpolated platform is the <survey>. Those
  /// given before reading are read first, used or not.
  std::vector<XmlElement> Scanners;
  std::vector<XmlElement> Platforms;
  ///@}

  XmlElement Scene;
  std::vector<XmlElement> Parts; ///< one for each part of the scene that is not of a table
};

/// Returns the first survey of a document, which may be null, with all references. Complete only if
/// log has no error then.
SurveyData ReadSurvey(
  const XmlDocument* document, Assets& assets, Messages& log, SurveyElements* elements = nullptr);

/// Reads the survey of an element; without a name it has the name of data.FileName.
void ReadSurvey(const XmlElement& element, Assets& assets, Messages& log, SurveyData& data);

/// Returns a name valid for a folder.
std::string MakeFolderName(std::string name);

} // namespace helios

#endif
