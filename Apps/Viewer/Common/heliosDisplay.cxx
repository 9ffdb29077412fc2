// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosDisplay.h"

#include "heliosStatus.h"

#include <X11/XKBlib.h>
#include <X11/Xlib.h>

#include <cstdlib>
#include <iostream>

#undef Status // int, in Xlib.h

namespace helios::viewer
{

namespace
{

const char* const Remedy =
  "; log in to a desktop, use ssh -X, or draw without a window: "
  "xvfb-run -a vtkhelios view ... --offscreen --still picture.png (Debian package xvfb)";

/// Runs when the server of Xlib is lost; Xlib exits when this returns.
int OnLostDisplay(Display*)
{
  std::cerr
    << "error: the connection to the display is lost and the viewer ends; saved files are kept\n";
  return 0;
}

} // namespace

//------------------------------------------------------------------------------
Status CheckDisplay()
{
  const char* name = std::getenv("DISPLAY");
  if (!name || !*name)
  {
    return Status::Error(std::string("there is no display (DISPLAY is not set)") + Remedy);
  }
  Display* display = XOpenDisplay(nullptr);
  if (!display)
  {
    return Status::Error("the display " + std::string(name) + " cannot be opened" + Remedy);
  }
  XCloseDisplay(display);
  return {};
}

//------------------------------------------------------------------------------
void ExplainLostDisplay()
{
  XSetIOErrorHandler(OnLostDisplay);
}

//------------------------------------------------------------------------------
std::string FindShiftedKey(void* display, const std::string& name)
{
  auto* keyboard = static_cast<Display*>(display);
  const KeySym key = XStringToKeysym(name.c_str());
  const KeyCode code = keyboard && key != NoSymbol ? XKeysymToKeycode(keyboard, key) : 0;
  const KeySym shifted = code ? XkbKeycodeToKeysym(keyboard, code, 0, 1) : NoSymbol;
  const char* found = shifted != NoSymbol ? XKeysymToString(shifted) : nullptr;
  return found ? found : name;
}

} // namespace helios::viewer
