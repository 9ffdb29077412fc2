// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosTextPanel.h"

#include "heliosPainter.h"

#include <algorithm>

namespace helios::viewer
{

//------------------------------------------------------------------------------
int GetTextMargin(int textSize)
{
  return textSize / 2;
}

//------------------------------------------------------------------------------
void TextPanel::SetText(const std::string& text)
{
  if (text != this->Text)
  {
    this->Text = text;
    this->Lines = SplitLines(text);
  }
}

//------------------------------------------------------------------------------
PanelSize TextPanel::GetSize(int textSize) const
{
  int width = 0;
  for (const std::string& line : this->Lines)
  {
    width = std::max(width, MeasureText(line, textSize));
  }
  const int margin = 2 * GetTextMargin(textSize);
  const int height = static_cast<int>(this->Lines.size()) * GetLineHeight(textSize);
  return width > 0 ? PanelSize{ width + margin + 1, height + margin } : PanelSize{};
}

//------------------------------------------------------------------------------
void TextPanel::Paint(Painter& painter, const Rect& rect) const
{
  painter.DrawPanel(rect);
  const Rect inside = rect.Shrunk(GetTextMargin(painter.GetTextSize()));
  const int step = painter.GetLineHeight();
  const Theme& theme = painter.GetTheme();
  int y = inside.Top() - step / 2;
  for (const std::string& line : this->Lines)
  {
    if (y - step / 2 < inside.Y)
    {
      return;
    }
    painter.DrawText(inside.X, y, Shorten(line, painter.GetTextSize(), inside.Width),
      this->IsWarning ? theme.Warning : theme.Ink);
    y -= step;
  }
}

} // namespace helios::viewer
