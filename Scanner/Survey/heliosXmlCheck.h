// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// What a check of a file looks at beyond what a run reads of it.

#ifndef heliosXmlCheck_h
#define heliosXmlCheck_h

#include "heliosAssets.h"
#include "heliosSurveyData.h"

#include <string>

namespace helios
{

class Messages;

/// The names in a survey that are only looked up when it runs: coordinate systems, its ray caster.
void CheckSurveyNames(const SurveyData& survey, const std::string& where, Messages& log);

/// The scanners, platforms and scenes of a document, used or not; an error where it holds nothing.
void CheckAssets(const XmlElement& root, Assets& assets, Messages& log);

} // namespace helios

#endif
