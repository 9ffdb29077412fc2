// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosMenu.h"

#include "heliosPainter.h"
#include "heliosTextPanel.h"

#include <algorithm>
#include <cmath>

namespace helios::viewer
{

//------------------------------------------------------------------------------
int MenuBar::GetTitlePosition(int menu, int textSize) const
{
  int x = 0;
  for (int i = 0; i < menu; ++i)
  {
    x += MeasureText(this->Menus[static_cast<std::size_t>(i)].Title, textSize) + 2 * textSize;
  }
  return x;
}

//------------------------------------------------------------------------------
int MenuBar::FindMenu(int x, int textSize) const
{
  const auto count = static_cast<int>(this->Menus.size());
  for (int i = 0; i < count; ++i)
  {
    if (x >= this->GetTitlePosition(i, textSize) && x < this->GetTitlePosition(i + 1, textSize))
    {
      return i;
    }
  }
  return -1;
}

//------------------------------------------------------------------------------
PanelSize MenuBar::GetSize(int textSize) const
{
  return this->IsVisible && !this->Menus.empty()
    ? PanelSize{ 1, GetLineHeight(textSize) + textSize / 2 }
    : PanelSize{};
}

//------------------------------------------------------------------------------
void MenuBar::Paint(Painter& painter, const Rect& rect) const
{
  const Theme& theme = painter.GetTheme();
  const int size = painter.GetTextSize();
  painter.Fill(rect, theme.Panel);
  painter.DrawLine(rect.X, rect.Y, rect.Right(), rect.Y, theme.Border);
  for (std::size_t i = 0; i < this->Menus.size(); ++i)
  {
    const int x = rect.X + this->GetTitlePosition(static_cast<int>(i), size) + size;
    painter.DrawText(x, rect.Y + rect.Height / 2, this->Menus[i].Title,
      static_cast<int>(i) == this->Open ? theme.Heading : theme.Ink);
  }
}

//------------------------------------------------------------------------------
const MenuItem* MenuList::FindItem(int fromTop, int textSize) const
{
  const int row = this->First + (fromTop - GetTextMargin(textSize)) / GetLineHeight(textSize);
  const bool isInside = this->Content && fromTop >= GetTextMargin(textSize) &&
    row < static_cast<int>(this->Content->Items.size());
  return isInside ? &this->Content->Items[static_cast<std::size_t>(row)] : nullptr;
}

//------------------------------------------------------------------------------
PanelSize MenuList::GetSize(int textSize) const
{
  if (!this->Content)
  {
    return {};
  }
  int texts = 0, keys = 0;
  for (const MenuItem& item : this->Content->Items)
  {
    texts = std::max(texts, MeasureText(item.Text, textSize));
    keys = std::max(keys, MeasureText(item.Key, textSize));
  }
  const int margin = 2 * GetTextMargin(textSize);
  return { this->GetTickWidth(textSize) + texts + keys + 4 * textSize,
    static_cast<int>(this->Content->Items.size()) * GetLineHeight(textSize) + margin };
}

//------------------------------------------------------------------------------
void MenuList::Paint(Painter& painter, const Rect& rect) const
{
  const Theme& theme = painter.GetTheme();
  const int size = painter.GetTextSize();
  painter.Fill(rect, theme.Panel);
  painter.DrawPanel(rect);
  const int step = painter.GetLineHeight();
  const int ticks = this->GetTickWidth(size);
  const auto count = static_cast<int>(this->Content->Items.size());
  int y = rect.Top() - GetTextMargin(size) - step / 2;
  for (int i = this->First; i < count && y - step / 2 >= rect.Y; ++i)
  {
    const MenuItem& item = this->Content->Items[static_cast<std::size_t>(i)];
    if (item.IsOn && item.IsOn())
    {
      const int x = rect.X + size;
      painter.DrawLine(x, y, x + size / 4, y - size / 3, theme.Heading, 2.0);
      painter.DrawLine(
        x + size / 4, y - size / 3, x + 2 * size / 3, y + size / 3, theme.Heading, 2.0);
    }
    painter.DrawText(rect.X + size + ticks, y, item.Text, item.Do ? theme.Ink : theme.FaintInk);
    painter.DrawText(rect.Right() - size, y, item.Key, theme.FaintInk, Painter::Align::Right);
    y -= step;
  }
  const int whole = this->GetSize(size).Height;
  if (whole > rect.Height)
  {
    const int height = rect.Height * rect.Height / whole;
    const int top = rect.Top() - rect.Height * this->First * step / whole;
    painter.Fill({ rect.Right() - 4, std::max(rect.Y, top - height), 3, height }, theme.Groove);
  }
}

//------------------------------------------------------------------------------
/// Returns the width of the column of ticks; 0: no item may have one.
int MenuList::GetTickWidth(int textSize) const
{
  const auto& items = this->Content->Items;
  const bool hasTicks = std::any_of(
    items.begin(), items.end(), [](const MenuItem& item) { return item.IsOn != nullptr; });
  return hasTicks ? 5 * textSize / 4 : 0;
}

//------------------------------------------------------------------------------
void MenuList::Scroll(int items, const Rect& rect, int textSize)
{
  const int rows = (rect.Height - GetTextMargin(textSize)) / GetLineHeight(textSize);
  const int count = this->Content ? static_cast<int>(this->Content->Items.size()) : 0;
  this->First = std::clamp(this->First + items, 0, std::max(0, count - rows));
}

//------------------------------------------------------------------------------
/// Columns of at most a number of lines; a heading stays with its first key.
std::vector<std::vector<HelpPage::Line>> HelpPage::MakeColumns(int lines) const
{
  std::vector<std::vector<Line>> columns(1);
  const auto maximum = static_cast<std::size_t>(std::max(3, lines));
  for (const Menu& menu : this->Menus)
  {
    bool isFirst = true;
    for (const MenuItem& item : menu.Items)
    {
      if (columns.back().size() + (isFirst ? 3 : 1) > maximum)
      {
        columns.emplace_back();
      }
      if (isFirst)
      {
        if (!columns.back().empty())
        {
          columns.back().push_back({ "", "", false });
        }
        columns.back().push_back({ "", menu.Title, true });
      }
      columns.back().push_back({ item.Key, item.Text, false });
      isFirst = false;
    }
  }
  return columns;
}

//------------------------------------------------------------------------------
/// Returns the width of a column, and of its keys [pixels].
int HelpPage::MeasureColumn(const std::vector<Line>& column, int textSize, int& keys)
{
  int texts = 0;
  keys = 0;
  for (const Line& line : column)
  {
    keys = std::max(keys, MeasureText(line.Key, textSize));
    texts = std::max(texts, MeasureText(line.Text, textSize));
  }
  keys += textSize;
  return keys + texts;
}

//------------------------------------------------------------------------------
bool HelpPage::Fits(const Rect& rect, int textSize) const
{
  const int lines = (rect.Height - 2 * textSize) / GetLineHeight(textSize);
  int width = 2 * textSize;
  int keys = 0;
  for (const auto& column : this->MakeColumns(lines))
  {
    width += MeasureColumn(column, textSize, keys) + 2 * textSize;
  }
  return lines >= 3 && width - 2 * textSize <= rect.Width;
}

//------------------------------------------------------------------------------
int HelpPage::FindTextSize(const Rect& rect, int textSize) const
{
  constexpr int minimum = 6;
  while (textSize > minimum && !this->Fits(rect, textSize))
  {
    --textSize;
  }
  return textSize;
}

//------------------------------------------------------------------------------
PanelSize HelpPage::GetSize(int) const
{
  return this->IsVisible ? PanelSize{ 1, 1 } : PanelSize{}; // all there is
}

//------------------------------------------------------------------------------
void HelpPage::Paint(Painter& painter, const Rect& rect) const
{
  const Theme& theme = painter.GetTheme();
  const int size = this->FindTextSize(rect, painter.GetTextSize());
  Painter letters = painter.WithTextSize(size);
  painter.Fill(rect, theme.Panel, theme.Opacity); // twice: the picture is faint
  painter.DrawPanel(rect);
  const int step = GetLineHeight(size);
  int x = rect.X + size;
  for (const auto& column : this->MakeColumns((rect.Height - 2 * size) / step))
  {
    int keys = 0;
    const int width = MeasureColumn(column, size, keys);
    int y = rect.Top() - size - step / 2;
    for (const Line& line : column)
    {
      letters.DrawText(x, y, line.Key, theme.FaintInk);
      letters.DrawText(
        x + (line.IsHeading ? 0 : keys), y, line.Text, line.IsHeading ? theme.Heading : theme.Ink);
      y -= step;
    }
    x += width + 2 * size;
  }
}

} // namespace helios::viewer
