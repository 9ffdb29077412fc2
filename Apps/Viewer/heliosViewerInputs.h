// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// What the user wants to see: surveys, runs, clouds and scenes, told apart by their files.

#ifndef heliosViewerInputs_h
#define heliosViewerInputs_h

#include <memory>
#include <string>
#include <vector>

namespace helios
{

class Viewer;
class ViewerTool;

/// Shows the inputs of a viewer; says in words what is wrong with them, or returns an empty text.
std::string ShowInputs(Viewer& viewer);

/// The tools of a viewer, in the order that they are asked.
std::vector<std::unique_ptr<ViewerTool>> MakeTools(Viewer& viewer);

} // namespace helios

#endif
