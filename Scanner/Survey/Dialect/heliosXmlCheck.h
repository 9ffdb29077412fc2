// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Checks of a file beyond what a run reads.

#ifndef heliosXmlCheck_h
#define heliosXmlCheck_h

#include "heliosAssets.h"
#include "heliosSurveyData.h"

#include <string>

namespace helios
{

class Messages;

/// Checks names in a survey that are only resolved when it runs: coordinate systems, its ray
/// caster.
void CheckSurveyNames(const SurveyData& survey, const std::string& where, Messages& log);

/// Checks the scanners, platforms and scenes of a document, used or not; an error if it is empty.
void CheckAssets(const XmlElement& root, Assets& assets, Messages& log);

} // namespace helios

#endif
