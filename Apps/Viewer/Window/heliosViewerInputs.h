// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Opens the inputs: surveys, runs, clouds and scenes, identified by their files.

#ifndef heliosViewerInputs_h
#define heliosViewerInputs_h

#include "heliosStatus.h"

#include <memory>
#include <string>
#include <vector>

namespace helios::viewer
{

class Viewer;
class ViewerTool;

/// Shows the inputs of a viewer.
Status ShowInputs(Viewer& viewer);

/// Returns what a file or folder holds that can be shown: "survey", "scene", "points", "run",
/// "plan"; empty: nothing.
std::string FindInputKind(const std::string& path);

/// Returns the tools of a viewer, in order of precedence.
std::vector<std::unique_ptr<ViewerTool>> MakeTools(Viewer& viewer);

} // namespace helios::viewer

#endif
