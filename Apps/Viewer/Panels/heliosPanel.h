// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A rectangle over the picture that draws itself.

#ifndef heliosPanel_h
#define heliosPanel_h

#include "heliosRect.h"

namespace helios::viewer
{

class Painter;

class Panel
{
public:
  Panel() = default;
  virtual ~Panel() = default;
  Panel(const Panel&) = delete;
  void operator=(const Panel&) = delete;

  /// Returns the wanted size for a text size [pixels]; empty: not shown.
  virtual PanelSize GetSize(int textSize) const = 0;

  /// Draws into a rectangle, which may be smaller.
  virtual void Paint(Painter& painter, const Rect& rect) const = 0;
};

} // namespace helios::viewer

#endif
