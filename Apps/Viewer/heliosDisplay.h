// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The display that windows are on: all of the operating system that the viewer sees.

#ifndef heliosDisplay_h
#define heliosDisplay_h

#include <string>

namespace helios
{

/// Says why there is no display to draw on, and the ways out; empty: there is one. VTK would end the
/// program without a word.
std::string CheckDisplay();

/// Where the display goes away later, says so instead of what the window system says.
void ExplainLostDisplay();

} // namespace helios

#endif
