// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Display of the windows: the only use of the operating system in the viewer.

#ifndef heliosDisplay_h
#define heliosDisplay_h

#include <string>

namespace helios::viewer
{

/// Returns why there is no display to draw on, with remedies; empty: there is one. VTK would exit
/// without a message.
std::string CheckDisplay();

/// Reports a display lost later, instead of the window system's message.
void ExplainLostDisplay();

} // namespace helios::viewer

#endif
