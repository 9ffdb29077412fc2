// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosTheme.h"

#include <vtkTextProperty.h>

#include <algorithm>
#include <filesystem>
#include <string>

namespace helios::viewer
{

namespace
{

Theme MakeDark()
{
  Theme theme;
  theme.Name = "dark";
  theme.Background[0] = { 20, 22, 27 };
  theme.Background[1] = { 36, 40, 48 };
  theme.Ink = { 232, 235, 240 };
  theme.FaintInk = { 160, 167, 178 };
  theme.Heading = { 130, 200, 245 };
  theme.Warning = { 255, 214, 102 };
  theme.Panel = { 14, 16, 21 };
  theme.Opacity = 205;
  theme.Border = { 74, 81, 94 };
  theme.Groove = { 104, 114, 130 };
  theme.Handle = { 104, 184, 240 };
  theme.HeldHandle = { 178, 222, 252 };
  theme.Waveform = { 90, 205, 250 };
  theme.Fit = { 250, 128, 150 };
  theme.Mark = { 255, 216, 64 };
  theme.Scene = { { 24, 26, 32 }, 0.45 };
  theme.Ramp = { 0.30, 1.0 };
  return theme;
}

Theme MakeLight()
{
  Theme theme;
  theme.Name = "light";
  theme.Background[0] = { 250, 251, 252 };
  theme.Background[1] = { 232, 236, 241 };
  theme.Ink = { 28, 32, 39 };
  theme.FaintInk = { 96, 103, 115 };
  theme.Heading = { 12, 98, 160 };
  theme.Warning = { 160, 74, 0 };
  theme.Panel = { 255, 255, 255 };
  theme.Opacity = 215;
  theme.Border = { 190, 196, 206 };
  theme.Groove = { 150, 158, 170 };
  theme.Handle = { 30, 120, 190 };
  theme.HeldHandle = { 90, 170, 230 };
  theme.Waveform = { 0, 112, 178 };
  theme.Fit = { 196, 44, 84 };
  theme.Mark = { 214, 90, 0 };
  theme.Scene = { { 255, 255, 255 }, 0.62 };
  theme.Ramp = { 0.0, 0.78 };
  return theme;
}

const std::vector<Theme>& GetThemes()
{
  static const std::vector<Theme> themes{ MakeDark(), MakeLight() };
  return themes;
}

/// Returns a font of the system with clear letters and brackets; empty: none is there.
std::string FindFontFile()
{
  std::error_code ignored;
  for (const char* name : { "dejavu/DejaVuSans.ttf", "liberation/LiberationSans-Regular.ttf",
         "liberation2/LiberationSans-Regular.ttf", "noto/NotoSans-Regular.ttf" })
  {
    const std::string path = std::string("/usr/share/fonts/truetype/") + name;
    if (std::filesystem::exists(path, ignored))
    {
      return path;
    }
  }
  return {};
}

} // namespace

//------------------------------------------------------------------------------
const Theme& FindTheme(const std::string& name)
{
  const auto& themes = GetThemes();
  const auto found = std::find_if(
    themes.begin(), themes.end(), [&name](const Theme& theme) { return theme.Name == name; });
  return found == themes.end() ? themes.front() : *found;
}

//------------------------------------------------------------------------------
std::vector<std::string> GetThemeNames()
{
  std::vector<std::string> names;
  for (const Theme& theme : GetThemes())
  {
    names.push_back(theme.Name);
  }
  return names;
}

//------------------------------------------------------------------------------
int GetTextSize(int width, int height)
{
  return std::clamp(std::min(width / 88, height / 55), 12, 28);
}

//------------------------------------------------------------------------------
void SetUpText(vtkTextProperty* letters, const Rgb& color, int size)
{
  static const std::string file = FindFontFile();
  if (file.empty())
  {
    letters->SetFontFamilyToArial(); // the font of VTK has brackets that look round
  }
  else
  {
    letters->SetFontFamily(VTK_FONT_FILE);
    letters->SetFontFile(file.c_str());
  }
  letters->SetFontSize(size);
  letters->SetColor(Shade(color).Rgb);
  letters->ShadowOff();
  letters->BoldOff();
  letters->ItalicOff();
}

} // namespace helios::viewer
