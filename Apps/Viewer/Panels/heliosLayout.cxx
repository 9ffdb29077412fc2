// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosLayout.h"

#include <algorithm>

namespace helios::viewer
{

namespace
{

constexpr int MinimumChart = 140; // height and width of a legible chart [pixels]

/// Returns the part of a length that is free; 0 if it is less than the minimum.
int Fit(int wanted, int room, int minimum)
{
  const int length = std::min(wanted, room);
  return length >= std::min(wanted, minimum) ? length : 0;
}

} // namespace

//------------------------------------------------------------------------------
std::string GetPanelName(PanelId id)
{
  static const char* const names[NumberOfPanels] = { "menuBar", "toolBar", "timeBar", "dialog",
    "help", "menu", "tip", "editor", "chart", "legend", "message", "status", "axes", "scaleBar",
    "legs", "cursor" };
  return names[static_cast<std::size_t>(id)];
}

//------------------------------------------------------------------------------
void Layout::SetWindow(int width, int height, int textSize)
{
  this->Width = width;
  this->Height = height;
  this->Gap = std::max(6, 2 * textSize / 3);
}

//------------------------------------------------------------------------------
void Layout::Place()
{
  this->Rects.fill(Rect());
  this->PlaceBars();
  const Rect area = this->View.Shrunk(this->Gap);
  if (!this->GetSize(PanelId::Dialog).IsEmpty())
  {
    this->PlaceDialog();
    return;
  }
  if (!this->GetSize(PanelId::Help).IsEmpty())
  {
    this->Set(PanelId::Help, area);
    return;
  }
  this->PlaceRight(area);
  this->PlaceLeft(area);
  this->PlaceMenu();
  this->HideCovered();
}

//------------------------------------------------------------------------------
void Layout::PlaceBars()
{
  const int menus = std::min(this->GetSize(PanelId::MenuBar).Height, this->Height);
  const int tools = std::min(this->GetSize(PanelId::ToolBar).Height, this->Height - menus);
  const int top = menus + tools;
  const int bottom = std::min(this->GetSize(PanelId::TimeBar).Height, this->Height - top);
  this->Set(PanelId::MenuBar, { 0, this->Height - menus, this->Width, menus });
  this->Set(PanelId::ToolBar, { 0, this->Height - top, this->Width, tools });
  this->Set(PanelId::TimeBar, { 0, 0, this->Width, bottom });
  this->View = { 0, bottom, this->Width, this->Height - top - bottom };
}

//------------------------------------------------------------------------------
/// Places a column: legs from the top, then the legend; axes at the bottom, the cursor to their
/// left.
void Layout::PlaceRight(const Rect& area)
{
  const PanelSize legs = this->GetSize(PanelId::Legs), legend = this->GetSize(PanelId::Legend),
                  axes = this->GetSize(PanelId::Axes), cursor = this->GetSize(PanelId::Cursor);
  int bottom = area.Y;
  if (!axes.IsEmpty() && axes.Height <= area.Height / 3)
  {
    this->Set(PanelId::Axes, { area.Right() - axes.Width, bottom, axes.Width, axes.Height });
    bottom += axes.Height + this->Gap;
  }
  const Rect& placed = this->Get(PanelId::Axes);
  const int right = placed.IsEmpty() ? area.Right() : placed.X - this->Gap;
  this->Set(PanelId::Cursor, { right - cursor.Width, area.Y, cursor.Width, cursor.Height });
  if (!legend.IsEmpty() && bottom + legend.Height <= area.Top())
  {
    this->Set(
      PanelId::Legend, { area.Right() - legend.Width, bottom, legend.Width, legend.Height });
    bottom += legend.Height + this->Gap;
  }
  const int height = Fit(legs.Height, area.Top() - bottom, legs.Height / 6);
  this->Set(PanelId::Legs, { area.Right() - legs.Width, area.Top() - height, legs.Width, height });
  this->RightColumn = 0;
  for (const PanelId id : { PanelId::Legs, PanelId::Legend, PanelId::Axes })
  {
    this->RightColumn = std::max(this->RightColumn, this->Get(id).Width);
  }
}

//------------------------------------------------------------------------------
/// Places a column: status from the top, then the editor; scale bar, message and chart from the
/// bottom.
void Layout::PlaceLeft(const Rect& area)
{
  const PanelSize status = this->GetSize(PanelId::Status), editor = this->GetSize(PanelId::Editor),
                  message = this->GetSize(PanelId::Message),
                  scale = this->GetSize(PanelId::ScaleBar);
  const int width = std::max(0, area.Width - this->RightColumn - this->Gap);
  int bottom = area.Y;
  this->Set(PanelId::ScaleBar, { area.X, bottom, std::min(scale.Width, width), scale.Height });
  bottom += scale.IsEmpty() ? 0 : scale.Height + this->Gap;
  this->Set(PanelId::Message, { area.X, bottom, std::min(message.Width, width), message.Height });
  bottom += message.IsEmpty() ? 0 : message.Height + this->Gap;
  int top = area.Top();
  const int room = top - bottom - (editor.IsEmpty() ? 0 : editor.Height + this->Gap);
  const int height = Fit(status.Height, room, status.Height);
  this->Set(PanelId::Status, { area.X, top - height, std::min(status.Width, width), height });
  top -= height > 0 ? height + this->Gap : 0;
  if (!editor.IsEmpty())
  {
    const int fitted = Fit(editor.Height, top - bottom, editor.Height / 2);
    this->Set(PanelId::Editor, { area.X, top - fitted, std::min(editor.Width, width), fitted });
  }
  this->PlaceChart(area, bottom);
}

//------------------------------------------------------------------------------
void Layout::PlaceChart(const Rect& area, int bottom)
{
  const PanelSize chart = this->GetSize(PanelId::Chart);
  const Rect& editor = this->Get(PanelId::Editor);
  const Rect& status = this->Get(PanelId::Status);
  const int left = editor.IsEmpty() ? area.X : editor.Right() + this->Gap;
  const int right = area.Right() - (this->RightColumn > 0 ? this->RightColumn + this->Gap : 0);
  const int top = status.IsEmpty() ? area.Top() : status.Y - this->Gap;
  const int width = Fit(chart.Width, right - left, MinimumChart);
  const int height = Fit(chart.Height, top - bottom, MinimumChart);
  this->Set(PanelId::Chart, { left, bottom, width, height });
}

//------------------------------------------------------------------------------
void Layout::PlaceMenu()
{
  // An open menu covers the buttons, which are of no use then.
  const Rect& bar = this->Get(PanelId::MenuBar);
  this->Set(PanelId::Menu, this->MakeDrop(PanelId::Menu, this->MenuX, bar.Y));
  this->Set(PanelId::Tip, this->MakeDrop(PanelId::Tip, this->TipX, this->View.Top()));
  if (this->Get(PanelId::Menu).IsEmpty())
  {
    return;
  }
  this->Set(PanelId::ToolBar, Rect());
  this->Set(PanelId::Tip, Rect());
}

//------------------------------------------------------------------------------
/// Returns a rectangle that hangs down from a height, within the window.
Rect Layout::MakeDrop(PanelId id, int x, int top) const
{
  const PanelSize size = this->GetSize(id);
  const int height = std::min(size.Height, top - this->View.Y);
  return { std::max(0, std::min(x, this->Width - size.Width)), top - height, size.Width, height };
}

//------------------------------------------------------------------------------
void Layout::PlaceDialog()
{
  const Rect area = this->View.Shrunk(this->Gap);
  const PanelSize size = this->GetSize(PanelId::Dialog);
  const int width = std::min(size.Width, area.Width), height = std::min(size.Height, area.Height);
  this->Set(PanelId::Dialog,
    { area.X + (area.Width - width) / 2, area.Y + (area.Height - height) / 2, width, height });
}

//------------------------------------------------------------------------------
/// Hides a panel that would cover one of higher priority, or leave the window.
void Layout::HideCovered()
{
  const Rect window{ 0, 0, this->Width, this->Height };
  for (std::size_t i = 0; i < NumberOfPanels; ++i)
  {
    Rect& rect = this->Rects[i];
    bool isFree =
      rect.X >= 0 && rect.Y >= 0 && rect.Right() <= window.Width && rect.Top() <= window.Height;
    for (std::size_t j = 0; j < i && isFree; ++j)
    {
      isFree = j == Index(PanelId::Tip) || !rect.Intersects(this->Rects[j]);
    }
    rect = isFree && !rect.IsEmpty() ? rect : Rect();
  }
}

//------------------------------------------------------------------------------
bool Layout::Find(int x, int y, PanelId& id) const
{
  for (std::size_t i = 0; i < NumberOfPanels; ++i)
  {
    if (!this->Rects[i].IsEmpty() && this->Rects[i].Contains(x, y))
    {
      id = static_cast<PanelId>(i);
      return true;
    }
  }
  return false;
}

} // namespace helios::viewer
