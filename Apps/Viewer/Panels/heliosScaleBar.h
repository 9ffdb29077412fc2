// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A bar of a round length, and the directions of the axes.

#ifndef heliosScaleBar_h
#define heliosScaleBar_h

#include "heliosPanel.h"

#include <string>

class vtkRenderer;

namespace helios::viewer
{

/// Scale bar. In perspective its length holds at the distance of the focal point, as its label
/// says.
class ScaleBar : public Panel
{
public:
  explicit ScaleBar(vtkRenderer* renderer)
    : Renderer(renderer)
  {
  }

  void SetVisible(bool visible) { this->IsVisible = visible; }

  /// Returns the length that a pixel shows [m].
  double GetMetresPerPixel() const;

  /// Returns the length of the bar [m], at most a fifth of the window's width.
  double GetLength() const;
  std::string GetLabel() const;

  PanelSize GetSize(int textSize) const override;
  void Paint(Painter& painter, const Rect& rect) const override;

private:
  int GetPixels() const;

  vtkRenderer* Renderer;
  bool IsVisible = false;
};

/// The directions of east (x), north (y) and up (z).
class AxesPanel : public Panel
{
public:
  explicit AxesPanel(vtkRenderer* renderer)
    : Renderer(renderer)
  {
  }

  void SetVisible(bool visible) { this->IsVisible = visible; }

  /// Computes the direction of an axis on the screen: right, up, towards the viewer.
  void GetDirection(int axis, double direction[3]) const;

  /// Returns whether the name of an axis is not where that of another one is.
  bool HasName(int axis) const;

  PanelSize GetSize(int textSize) const override;
  void Paint(Painter& painter, const Rect& rect) const override;

private:
  vtkRenderer* Renderer;
  bool IsVisible = false;
};

} // namespace helios::viewer

#endif
