// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosLegend.h"

#include "heliosPainter.h"
#include "heliosTextPanel.h"

#include <algorithm>
#include <cmath>

namespace helios::viewer
{

namespace
{

constexpr int ScaleLines = 12; // height of a scale, in lines of text

} // namespace

//------------------------------------------------------------------------------
PanelSize LegendPanel::GetSize(int textSize) const
{
  if (this->Content.Colors.empty())
  {
    return {};
  }
  int labels = 0;
  for (const Legend::Mark& mark : this->Content.Marks)
  {
    labels = std::max(labels, MeasureText(mark.Text, textSize));
  }
  for (const auto& other : this->Content.Others)
  {
    labels = std::max(labels, MeasureText(other.second, textSize));
  }
  const int margin = GetTextMargin(textSize);
  const int width =
    std::max(MeasureText(this->Content.Title, textSize), 2 * textSize + margin + labels);
  const auto lines =
    (this->Content.IsCategory ? static_cast<int>(this->Content.Marks.size()) : ScaleLines) +
    static_cast<int>(this->Content.Others.size());
  return { width + 2 * margin + 1, (lines + 1) * GetLineHeight(textSize) + 3 * margin };
}

//------------------------------------------------------------------------------
void LegendPanel::Paint(Painter& painter, const Rect& rect) const
{
  painter.DrawPanel(rect);
  const int margin = GetTextMargin(painter.GetTextSize());
  Rect inside = rect.Shrunk(margin);
  painter.DrawText(inside.X, inside.Top() - painter.GetLineHeight() / 2, this->Content.Title,
    painter.GetTheme().Ink);
  inside.Height -= painter.GetLineHeight() + margin;
  this->PaintOthers(painter, inside);
  this->Content.IsCategory ? this->PaintCategories(painter, inside)
                           : this->PaintScale(painter, inside);
}

//------------------------------------------------------------------------------
/// Draws a line for each, from below, and leaves the rest of the rectangle.
void LegendPanel::PaintOthers(Painter& painter, Rect& inside) const
{
  const int step = painter.GetLineHeight();
  const int side = painter.GetTextSize();
  for (const auto& other : this->Content.Others)
  {
    painter.Fill({ inside.X, inside.Y + (step - side) / 2, side, side }, other.first);
    painter.DrawText(
      inside.X + 3 * side / 2, inside.Y + step / 2, other.second, painter.GetTheme().Ink);
    inside.Y += step;
    inside.Height -= step;
  }
}

//------------------------------------------------------------------------------
void LegendPanel::PaintScale(Painter& painter, const Rect& inside) const
{
  const int half = painter.GetLineHeight() / 2; // the labels at the ends
  const Rect bar{ inside.X, inside.Y + half / 2, painter.GetTextSize() + 2, inside.Height - half };
  const auto count = static_cast<int>(this->Content.Colors.size());
  for (int row = 0; row < bar.Height; ++row)
  {
    const int at = std::min(count - 1, count * row / bar.Height);
    painter.Fill(
      { bar.X, bar.Y + row, bar.Width, 1 }, this->Content.Colors[static_cast<std::size_t>(at)]);
  }
  const int tick = painter.GetTextSize() / 3;
  for (const Legend::Mark& mark : this->Content.Marks)
  {
    const int y = bar.Y + static_cast<int>(std::lround(mark.Position * (bar.Height - 1)));
    painter.DrawLine(bar.Right(), y, bar.Right() + tick, y, painter.GetTheme().Ink);
    painter.DrawText(bar.Right() + 2 * tick, y, mark.Text, painter.GetTheme().Ink);
  }
}

//------------------------------------------------------------------------------
void LegendPanel::PaintCategories(Painter& painter, const Rect& inside) const
{
  const int step = painter.GetLineHeight();
  const int side = painter.GetTextSize();
  int y = inside.Top() - step / 2;
  for (const Legend::Mark& mark : this->Content.Marks)
  {
    const Rgb& color = this->Content.Colors[static_cast<std::size_t>(mark.Position)];
    painter.Fill({ inside.X, y - side / 2, side, side }, color);
    painter.DrawText(inside.X + 3 * side / 2, y, mark.Text, painter.GetTheme().Ink);
    y -= step;
  }
}

} // namespace helios::viewer
