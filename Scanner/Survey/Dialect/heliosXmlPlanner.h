// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Reads a planning task from HELIOS XML or a mesh.

#ifndef heliosXmlPlanner_h
#define heliosXmlPlanner_h

#include "heliosPlannerData.h"
#include "heliosXmlElement.h"

namespace helios
{

class Assets;
class Messages;

/**
 * Returns the first <surveyPlanner> of a file, else its first <survey>, else its first <scene>; or
 * a mesh (.obj, .tif), with all references; without a file, the scene of the caller. Complete only
 * if log has no error then.
 */
PlannerData ReadPlanner(const PlannerRequest& request, Messages& log);

/// Checks a <surveyPlanner> and its references.
void CheckPlanner(const XmlElement& planner, Assets& assets, Messages& log);

/// Returns the reference file.xml#id to an element.
std::string MakeReference(const std::string& file, const std::string& id);

} // namespace helios

#endif
