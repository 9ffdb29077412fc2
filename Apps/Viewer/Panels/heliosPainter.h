// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Draws boxes, text and lines in window pixels, in the colours of a theme.

#ifndef heliosPainter_h
#define heliosPainter_h

#include "heliosRect.h"
#include "heliosTheme.h"

#include <string>
#include <vector>

class vtkContext2D;

namespace helios::viewer
{

/// Returns the width of a line of text [pixels].
int MeasureText(const std::string& text, int textSize);

/// Returns the distance of two lines of text [pixels].
int GetLineHeight(int textSize);

/// Returns the text, shortened to a width [pixels] by an ellipsis at its end.
std::string Shorten(const std::string& text, int textSize, int width);

std::vector<std::string> SplitLines(const std::string& text);

class Painter
{
public:
  enum class Align
  {
    Left,
    Center,
    Right
  };

  Painter(vtkContext2D* context, const Theme& theme, int textSize)
    : Context(context)
    , Colors(theme)
    , TextSize(textSize)
  {
  }

  /// Returns a painter with another text size [pixels].
  Painter WithTextSize(int textSize) const { return { this->Context, this->Colors, textSize }; }

  const Theme& GetTheme() const { return this->Colors; }
  int GetTextSize() const { return this->TextSize; }
  int GetLineHeight() const { return viewer::GetLineHeight(this->TextSize); }

  /// Draws the background of a panel, with a border.
  void DrawPanel(const Rect& rect);

  void Fill(const Rect& rect, const Rgb& color, std::uint8_t opacity = 255);
  void DrawLine(double x0, double y0, double x1, double y1, const Rgb& color, double width = 1.0);
  void FillTriangle(const double (&xy)[6], const Rgb& color);

  /// Draws a line of text; y is its vertical centre.
  void DrawText(int x, int y, const std::string& text, const Rgb& color, Align align = Align::Left);

private:
  vtkContext2D* Context;
  const Theme& Colors;
  int TextSize;
};

} // namespace helios::viewer

#endif
