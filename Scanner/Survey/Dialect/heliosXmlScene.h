// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Reads scenes from their elements. Errors go to the messages of the document.

#ifndef heliosXmlScene_h
#define heliosXmlScene_h

#include "heliosAssets.h"
#include "heliosSurveyData.h"

#include <string>
#include <vector>

namespace helios
{

/// The parts of a <scene>, with their files found; elements: that of each part that is not of a table.
SceneData ReadScene(
  const XmlElement& element, Assets& assets, std::vector<XmlElement>* elements = nullptr);

/// Returns the folders searched for the spectra of materials named in a document.
std::vector<std::string> FindSpectraFolders(const XmlDocument& document, const Assets& assets);

} // namespace helios

#endif
