// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Places the panels of a window so that none covers another.

#ifndef heliosLayout_h
#define heliosLayout_h

#include "heliosRect.h"

#include <array>
#include <string>

namespace helios::viewer
{

/// Panels by priority: the later ones give way.
enum class PanelId : int
{
  MenuBar,  ///< the top row
  ToolBar,  ///< the row below it
  TimeBar,  ///< the bottom row
  Dialog,   ///< in the middle, alone
  Help,     ///< everything between, alone
  Menu,     ///< below the menu bar; hides what it would cover
  Tip,      ///< below a button, over others while the mouse is on it
  Editor,   ///< left, below the status
  Chart,    ///< left or right of the editor, above the message
  Legend,   ///< right, below the legs
  Message,  ///< left, above the scale bar
  Status,   ///< left, top
  Axes,     ///< right, bottom
  ScaleBar, ///< left, bottom
  Legs,     ///< right, top
  Cursor    ///< left of the axes
};
constexpr std::size_t NumberOfPanels = 16;

/// Returns the name of a panel in the state file.
std::string GetPanelName(PanelId id);

/**
 * Set the window and the wanted sizes, then Place(). A panel for which there is no room is smaller
 * (texts, chart) or has an empty rectangle: it is not drawn. Only tips cover others.
 */
class Layout
{
public:
  void SetWindow(int width, int height, int textSize);

  /// Sets the wanted size; empty: not shown.
  void SetSize(PanelId id, const PanelSize& size) { this->Sizes[Index(id)] = size; }

  PanelSize GetSize(PanelId id) const { return this->Sizes[Index(id)]; }

  /// Sets the left end of the open menu.
  void SetMenuPosition(int x) { this->MenuX = x; }

  /// Sets the left end of the tip.
  void SetTipPosition(int x) { this->TipX = x; }

  void Place();

  const Rect& Get(PanelId id) const { return this->Rects[Index(id)]; }

  /// Returns the part of the window between menu bar and time bar.
  const Rect& GetView() const { return this->View; }

  /// Returns the gap between panels, and inside them around text [pixels].
  int GetGap() const { return this->Gap; }

  /// Finds the panel at a pixel; false: none.
  bool Find(int x, int y, PanelId& id) const;

private:
  static std::size_t Index(PanelId id) { return static_cast<std::size_t>(id); }
  void PlaceBars();
  void PlaceRight(const Rect& area);
  void PlaceLeft(const Rect& area);
  void PlaceChart(const Rect& area, int bottom);
  void PlaceMenu();
  void PlaceDialog();
  Rect MakeDrop(PanelId id, int x, int top) const;
  void Set(PanelId id, const Rect& rect) { this->Rects[Index(id)] = rect; }
  void HideCovered();

  std::array<PanelSize, NumberOfPanels> Sizes{};
  std::array<Rect, NumberOfPanels> Rects{};
  Rect View;
  int Width = 0;
  int Height = 0;
  int Gap = 8;
  int MenuX = 0;
  int TipX = 0;
  int RightColumn = 0; ///< width
};

} // namespace helios::viewer

#endif
