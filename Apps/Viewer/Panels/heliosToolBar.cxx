// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosToolBar.h"

#include "heliosPainter.h"

namespace helios::viewer
{

//------------------------------------------------------------------------------
Rect ToolBar::GetPlace(const Rect& rect, int button, int textSize) const
{
  int x = rect.X + textSize / 2;
  for (int i = 0; i < button; ++i)
  {
    x += MeasureText(this->Buttons[static_cast<std::size_t>(i)].Text, textSize) + 3 * textSize / 2;
  }
  const Rect place{ x, rect.Y + 3,
    MeasureText(this->Buttons[static_cast<std::size_t>(button)].Text, textSize) + textSize,
    rect.Height - 6 };
  return place.Right() > rect.Right() ? Rect() : place;
}

//------------------------------------------------------------------------------
int ToolBar::Find(const Rect& rect, int x, int y, int textSize) const
{
  for (int i = 0; i < static_cast<int>(this->Buttons.size()); ++i)
  {
    if (this->GetPlace(rect, i, textSize).Contains(x, y))
    {
      return i;
    }
  }
  return -1;
}

//------------------------------------------------------------------------------
PanelSize ToolBar::GetSize(int textSize) const
{
  return this->IsVisible && !this->Buttons.empty()
    ? PanelSize{ 1, GetLineHeight(textSize) + 3 * textSize / 4 }
    : PanelSize{};
}

//------------------------------------------------------------------------------
void ToolBar::Paint(Painter& painter, const Rect& rect) const
{
  const Theme& theme = painter.GetTheme();
  painter.Fill(rect, theme.Panel);
  painter.DrawLine(rect.X, rect.Y, rect.Right(), rect.Y, theme.Border);
  for (int i = 0; i < static_cast<int>(this->Buttons.size()); ++i)
  {
    const ToolButton& button = this->Buttons[static_cast<std::size_t>(i)];
    const Rect place = this->GetPlace(rect, i, painter.GetTextSize());
    if (place.IsEmpty())
    {
      return;
    }
    const bool isOn = button.IsOn && button.IsOn();
    painter.Fill(place, isOn ? theme.Handle : theme.Border,
      isOn                   ? 130
        : i == this->Hovered ? 200
                             : 70);
    painter.DrawText(place.X + place.Width / 2, place.Y + place.Height / 2, button.Text, theme.Ink,
      Painter::Align::Center);
  }
}

} // namespace helios::viewer
