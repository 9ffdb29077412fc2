// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Buttons of the main actions, in a row below the menus.

#ifndef heliosToolBar_h
#define heliosToolBar_h

#include "heliosPanel.h"

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace helios::viewer
{

struct ToolButton
{
  std::string Text;
  std::string Tip; ///< its effect, and its key
  std::function<void()> Do;
  std::function<bool()> IsOn; ///< whether it is pressed in; null: never
};

class ToolBar : public Panel
{
public:
  void SetButtons(std::vector<ToolButton> buttons) { this->Buttons = std::move(buttons); }
  const std::vector<ToolButton>& GetButtons() const { return this->Buttons; }

  void SetVisible(bool visible) { this->IsVisible = visible; }

  /// Sets the button below the mouse; -1: none.
  void SetHovered(int button) { this->Hovered = button; }
  int GetHovered() const { return this->Hovered; }

  /// Returns the place of a button in the rectangle of the bar [pixels]; empty: there is no room.
  Rect GetPlace(const Rect& rect, int button, int textSize) const;

  /// Finds the button at a position; -1: none.
  int Find(const Rect& rect, int x, int y, int textSize) const;

  PanelSize GetSize(int textSize) const override;
  void Paint(Painter& painter, const Rect& rect) const override;

private:
  std::vector<ToolButton> Buttons;
  int Hovered = -1;
  bool IsVisible = false;
};

} // namespace helios::viewer

#endif
