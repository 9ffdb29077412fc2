// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The colours, font and text size of everything drawn over and behind the data.

#ifndef heliosTheme_h
#define heliosTheme_h

#include "heliosColorMaps.h"

#include <string>
#include <vector>

class vtkTextProperty;

namespace helios::viewer
{

struct Theme
{
  std::string Name;     ///< dark, light
  Rgb Background[2];    ///< behind the data: bottom, top
  Rgb Ink;              ///< text and axes
  Rgb FaintInk;         ///< keys, grid labels
  Rgb Heading;          ///< headings, open menus
  Rgb Warning;          ///< messages
  Rgb Panel;            ///< behind text
  std::uint8_t Opacity; ///< opacity of panels, 255: opaque
  Rgb Border;           ///< border of panels; grid lines
  Rgb Groove;           ///< groove of sliders
  Rgb Handle;           ///< handle of sliders and the time bar
  Rgb HeldHandle;       ///< while dragged
  Rgb Waveform;         ///< measured curve
  Rgb Fit;              ///< fitted curve
  Rgb Mark;             ///< selected echo, measured line
  Veil Scene;           ///< over the mesh of a scene with echoes
  RampPart Ramp;        ///< part of the colour map: without the end close to the background
};

/// Returns the theme of a name; the first of GetThemeNames() for an unknown one.
const Theme& FindTheme(const std::string& name);

/// Returns dark, light.
std::vector<std::string> GetThemeNames();

/// Returns the text height for a window [pixels], in [12, 28].
int GetTextSize(int width, int height);

/// Sets the font of the viewer: proportional, without shadow, with a size [pixels].
void SetUpText(vtkTextProperty* letters, const Rgb& color, int size);

/// Red, green and blue in [0, 1], as VTK's properties take them.
struct Shade
{
  explicit Shade(const Rgb& color)
    : Rgb{ color[0] / 255.0, color[1] / 255.0, color[2] / 255.0 }
  {
  }
  double Rgb[3];
};

} // namespace helios::viewer

#endif
