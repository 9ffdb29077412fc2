// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosDisplay.h"

#include "heliosStatus.h"

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

/// Called by Xlib when its server is lost; Xlib exits when this returns.
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

} // namespace helios::viewer
