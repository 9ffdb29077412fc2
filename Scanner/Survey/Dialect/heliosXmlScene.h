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

/// The parts of a <scene>, with their files found.
SceneData ReadScene(const XmlElement& element, Assets& assets);

/// Adds the parts of a <partTable>; rows: its rows as the text of a CSV file, if there is no file.
void ReadPartTable(
  const XmlElement& element, Assets& assets, const std::string& rows, std::vector<PartData>& parts);

/// Checks that every epoch has a part to scan.
void CheckEpochs(const SceneData& scene, Messages& log);

/// The folders searched for the spectra of materials named in a document.
std::vector<std::string> FindSpectraFolders(const XmlDocument& document, const Assets& assets);

} // namespace helios

#endif
