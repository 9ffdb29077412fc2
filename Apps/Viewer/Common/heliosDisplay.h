// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Display of the windows: the only use of the operating system in the viewer.

#ifndef heliosDisplay_h
#define heliosDisplay_h

#include "heliosStatus.h"

#include <string>

namespace helios::viewer
{

/// Returns an error with remedies if there is no display to draw on. VTK would exit without a
/// message.
Status CheckDisplay();

/// Reports a display lost later, instead of the window system's message.
void ExplainLostDisplay();

/// Returns the name of a key with Shift, "K" for "k" and "less" for "comma", by the keyboard of a
/// display (an X Display); other names stay as they are. VTK 9.3 names keys without Shift.
std::string FindShiftedKey(void* display, const std::string& name);

} // namespace helios::viewer

#endif
