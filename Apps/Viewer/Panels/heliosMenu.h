// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Menus of all actions, for the mouse; and the same actions as a page of keys.

#ifndef heliosMenu_h
#define heliosMenu_h

#include "heliosPanel.h"

#include <functional>
#include <string>
#include <vector>

namespace helios::viewer
{

struct MenuItem
{
  std::string Text;
  std::string Key;            ///< key in the form that is shown
  std::function<void()> Do;   ///< null: for information only
  std::function<bool()> IsOn; ///< whether it has a tick; null: it never has
};

struct Menu
{
  std::string Title;
  std::vector<MenuItem> Items;
};

/// The titles of the menus in a row.
class MenuBar : public Panel
{
public:
  explicit MenuBar(const std::vector<Menu>& menus)
    : Menus(menus)
  {
  }

  void SetVisible(bool visible) { this->IsVisible = visible; }

  /// Sets the open menu; -1: none.
  void SetOpen(int menu) { this->Open = menu; }
  int GetOpen() const { return this->Open; }

  /// Returns the left end of a title [pixels from the left end of the bar].
  int GetTitlePosition(int menu, int textSize) const;

  /// Finds the menu at a position; -1: none.
  int FindMenu(int x, int textSize) const;

  PanelSize GetSize(int textSize) const override;
  void Paint(Painter& painter, const Rect& rect) const override;

private:
  const std::vector<Menu>& Menus;
  int Open = -1;
  bool IsVisible = false;
};

/// The items of the open menu, each with its key at the right.
class MenuList : public Panel
{
public:
  void SetMenu(const Menu* menu)
  {
    this->Content = menu;
    this->First = 0;
  }

  /// Scrolls a list that is longer than its rectangle by items.
  void Scroll(int items, const Rect& rect, int textSize);

  /// Returns the item at a height below the top of the list; null: none.
  const MenuItem* FindItem(int fromTop, int textSize) const;

  PanelSize GetSize(int textSize) const override;
  void Paint(Painter& painter, const Rect& rect) const override;

private:
  int GetTickWidth(int textSize) const;

  const Menu* Content = nullptr; ///< null: closed
  int First = 0;                 ///< the first shown
};

/// All menus in columns, in letters that are small enough for the rectangle.
class HelpPage : public Panel
{
public:
  explicit HelpPage(const std::vector<Menu>& menus)
    : Menus(menus)
  {
  }

  void SetVisible(bool visible) { this->IsVisible = visible; }
  bool GetVisible() const { return this->IsVisible; }

  /// Finds the largest text size with which all keys fit a rectangle [pixels]; at least 6.
  int FindTextSize(const Rect& rect, int textSize) const;

  bool Fits(const Rect& rect, int textSize) const;

  PanelSize GetSize(int textSize) const override;
  void Paint(Painter& painter, const Rect& rect) const override;

private:
  struct Line
  {
    std::string Key;
    std::string Text;
    bool IsHeading;
  };

  std::vector<std::vector<Line>> MakeColumns(int lines) const;
  static int MeasureColumn(const std::vector<Line>& column, int textSize, int& keys);

  const std::vector<Menu>& Menus;
  bool IsVisible = false;
};

} // namespace helios::viewer

#endif
