// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosScaleBar.h"

#include "heliosPainter.h"
#include "heliosTextPanel.h"
#include "heliosTicks.h"

#include <vtkCamera.h>
#include <vtkMath.h>
#include <vtkMatrix4x4.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace helios::viewer
{

namespace
{

constexpr double LargestShare = 0.2; // share of the window's width

// Red, green and blue for x, y and z, bright enough for both themes.
constexpr Rgb AxisColors[3] = { { 230, 85, 80 }, { 60, 170, 80 }, { 80, 140, 235 } };
const char* const AxisNames[3] = { "E", "N", "Up" };

} // namespace

//------------------------------------------------------------------------------
double ScaleBar::GetMetresPerPixel() const
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  const double half = camera->GetParallelProjection()
    ? camera->GetParallelScale()
    : camera->GetDistance() * std::tan(0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle()));
  return 2.0 * half / std::max(1, this->Renderer->GetSize()[1]);
}

//------------------------------------------------------------------------------
double ScaleBar::GetLength() const
{
  return RoundDown(LargestShare * std::max(1, this->Renderer->GetSize()[0]) *
    std::max(1e-12, this->GetMetresPerPixel()));
}

//------------------------------------------------------------------------------
int ScaleBar::GetPixels() const
{
  return std::max(1, static_cast<int>(std::lround(this->GetLength() / this->GetMetresPerPixel())));
}

//------------------------------------------------------------------------------
std::string ScaleBar::GetLabel() const
{
  const bool isExact = this->Renderer->GetActiveCamera()->GetParallelProjection() != 0;
  return DescribeLength(this->GetLength()) + (isExact ? "" : " at the centre");
}

//------------------------------------------------------------------------------
PanelSize ScaleBar::GetSize(int textSize) const
{
  if (!this->IsVisible)
  {
    return {};
  }
  const int margin = GetTextMargin(textSize);
  const int width = std::max(this->GetPixels(), MeasureText(this->GetLabel(), textSize));
  return { width + 2 * margin + 1, GetLineHeight(textSize) + textSize / 2 + 2 * margin };
}

//------------------------------------------------------------------------------
void ScaleBar::Paint(Painter& painter, const Rect& rect) const
{
  painter.DrawPanel(rect);
  const Rgb& ink = painter.GetTheme().Ink;
  const Rect inside = rect.Shrunk(GetTextMargin(painter.GetTextSize()));
  painter.DrawText(inside.X, inside.Top() - painter.GetLineHeight() / 2, this->GetLabel(), ink);
  const int height = painter.GetTextSize() / 2;
  const int x1 = inside.X + this->GetPixels() - 1;
  painter.DrawLine(inside.X, inside.Y + 1, x1, inside.Y + 1, ink, 2.0);
  painter.DrawLine(inside.X, inside.Y, inside.X, inside.Y + height, ink);
  painter.DrawLine(x1, inside.Y, x1, inside.Y + height, ink);
}

//------------------------------------------------------------------------------
void AxesPanel::GetDirection(int axis, double direction[3]) const
{
  vtkMatrix4x4* view = this->Renderer->GetActiveCamera()->GetViewTransformMatrix();
  for (int row = 0; row < 3; ++row)
  {
    direction[row] = view->GetElement(row, axis);
  }
}

//------------------------------------------------------------------------------
PanelSize AxesPanel::GetSize(int textSize) const
{
  return this->IsVisible ? PanelSize{ 6 * textSize, 6 * textSize } : PanelSize{};
}

//------------------------------------------------------------------------------
/// A longer arrow in the same direction has its name there.
bool AxesPanel::HasName(int axis) const
{
  double d[3], other[3];
  this->GetDirection(axis, d);
  bool hasName = true;
  for (int i = 0; i < 3; ++i)
  {
    this->GetDirection(i, other);
    const double share = std::hypot(d[0], d[1]), length = std::hypot(other[0], other[1]);
    const bool isSame = d[0] * other[0] + d[1] * other[1] > 0.85 * share * length;
    hasName = hasName && (i == axis || !isSame || length <= share);
  }
  return hasName;
}

//------------------------------------------------------------------------------
void AxesPanel::Paint(Painter& painter, const Rect& rect) const
{
  const double centerX = rect.X + 0.5 * rect.Width, centerY = rect.Y + 0.5 * rect.Height;
  const double length = 0.5 * std::min(rect.Width, rect.Height) - 1.1 * painter.GetTextSize();
  std::array<int, 3> order{ 0, 1, 2 }; // the farthest first
  std::sort(order.begin(), order.end(),
    [this](int a, int b)
    {
      double first[3], second[3];
      this->GetDirection(a, first);
      this->GetDirection(b, second);
      return first[2] < second[2];
    });
  for (const int axis : order)
  {
    double d[3];
    this->GetDirection(axis, d);
    const Rgb& color = AxisColors[axis];
    const double x = centerX + length * d[0], y = centerY + length * d[1];
    painter.DrawLine(centerX, centerY, x, y, color, 2.0);
    const double share = std::hypot(d[0], d[1]);
    if (share > 0.25) // an arrow; else it points at the viewer
    {
      const double ux = d[0] / share, uy = d[1] / share, size = 0.45 * painter.GetTextSize();
      const double bx = x - 1.4 * size * ux, by = y - 1.4 * size * uy;
      painter.FillTriangle({ x, y, bx - 0.5 * size * uy, by + 0.5 * size * ux, bx + 0.5 * size * uy,
                             by - 0.5 * size * ux },
        color);
      painter.DrawText(static_cast<int>(x + 0.75 * painter.GetTextSize() * ux),
        static_cast<int>(y + 0.75 * painter.GetTextSize() * uy),
        this->HasName(axis) ? AxisNames[axis] : "", painter.GetTheme().Ink, Painter::Align::Center);
    }
  }
}

} // namespace helios::viewer
