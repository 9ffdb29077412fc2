// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPainter.h"

#include <vtkBrush.h>
#include <vtkContext2D.h>
#include <vtkNew.h>
#include <vtkPen.h>
#include <vtkStdString.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>

#include <cmath>
#include <sstream>

namespace helios::viewer
{

namespace
{

constexpr int DotsPerInch = 72; // dots of VTK's windows: a point is a pixel

/// Returns the length of a text without its last UTF-8 character.
std::size_t FindLastCharacter(const std::string& text)
{
  std::size_t at = text.size();
  do
  {
    --at;
  } while (at > 0 && (static_cast<unsigned char>(text[at]) & 0xC0) == 0x80);
  return at;
}

} // namespace

//------------------------------------------------------------------------------
int MeasureText(const std::string& text, int textSize)
{
  vtkTextRenderer* renderer = vtkTextRenderer::GetInstance();
  if (text.empty() || !renderer)
  {
    return 0;
  }
  vtkNew<vtkTextProperty> letters;
  SetUpText(letters, Rgb(), textSize);
  int box[4] = { 0, 0, 0, 0 };
  renderer->GetBoundingBox(letters, text, box, DotsPerInch);
  return box[1] - box[0] + 1;
}

//------------------------------------------------------------------------------
int GetLineHeight(int textSize)
{
  return static_cast<int>(std::lround(1.4 * textSize));
}

//------------------------------------------------------------------------------
std::string Shorten(const std::string& text, int textSize, int width)
{
  if (MeasureText(text, textSize) <= width)
  {
    return text;
  }
  std::string start = text;
  const std::string ellipsis = "\xE2\x80\xA6";
  while (!start.empty() && MeasureText(start + ellipsis, textSize) > width)
  {
    start.resize(FindLastCharacter(start));
  }
  return start.empty() ? "" : start + ellipsis;
}

//------------------------------------------------------------------------------
std::vector<std::string> SplitLines(const std::string& text)
{
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);)
  {
    lines.push_back(line);
  }
  return lines;
}

//------------------------------------------------------------------------------
void Painter::DrawPanel(const Rect& rect)
{
  const Rgb& fill = this->Colors.Panel;
  const Rgb& border = this->Colors.Border;
  this->Context->GetBrush()->SetColor(fill[0], fill[1], fill[2], this->Colors.Opacity);
  this->Context->GetPen()->SetLineType(vtkPen::SOLID_LINE);
  this->Context->GetPen()->SetColor(border[0], border[1], border[2], this->Colors.Opacity);
  this->Context->GetPen()->SetWidth(1.0F);
  this->Context->DrawRect(static_cast<float>(rect.X), static_cast<float>(rect.Y),
    static_cast<float>(rect.Width - 1), static_cast<float>(rect.Height - 1));
}

//------------------------------------------------------------------------------
void Painter::Fill(const Rect& rect, const Rgb& color, std::uint8_t opacity)
{
  this->Context->GetBrush()->SetColor(color[0], color[1], color[2], opacity);
  this->Context->GetPen()->SetLineType(vtkPen::NO_PEN);
  this->Context->DrawRect(static_cast<float>(rect.X), static_cast<float>(rect.Y),
    static_cast<float>(rect.Width), static_cast<float>(rect.Height));
}

//------------------------------------------------------------------------------
void Painter::DrawLine(double x0, double y0, double x1, double y1, const Rgb& color, double width)
{
  this->Context->GetPen()->SetLineType(vtkPen::SOLID_LINE);
  this->Context->GetPen()->SetColor(color[0], color[1], color[2], 255);
  this->Context->GetPen()->SetWidth(static_cast<float>(width));
  this->Context->DrawLine(
    static_cast<float>(x0), static_cast<float>(y0), static_cast<float>(x1), static_cast<float>(y1));
}

//------------------------------------------------------------------------------
void Painter::FillTriangle(const double (&xy)[6], const Rgb& color)
{
  this->Context->GetBrush()->SetColor(color[0], color[1], color[2], 255);
  this->Context->GetPen()->SetLineType(vtkPen::NO_PEN);
  float corners[6];
  std::copy(xy, xy + 6, corners);
  this->Context->DrawPolygon(corners, 3);
}

//------------------------------------------------------------------------------
void Painter::DrawText(int x, int y, const std::string& text, const Rgb& color, Align align)
{
  if (text.empty())
  {
    return;
  }
  vtkNew<vtkTextProperty> letters;
  SetUpText(letters, color, this->TextSize);
  letters->SetVerticalJustificationToCentered();
  align == Align::Left      ? letters->SetJustificationToLeft()
    : align == Align::Right ? letters->SetJustificationToRight()
                            : letters->SetJustificationToCentered();
  this->Context->ApplyTextProp(letters);
  this->Context->DrawString(static_cast<float>(x), static_cast<float>(y), text);
}

} // namespace helios::viewer
