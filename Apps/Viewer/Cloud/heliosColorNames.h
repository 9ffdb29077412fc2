// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Names of the coloured quantities, used by options and the state file.

#ifndef heliosColorNames_h
#define heliosColorNames_h

#include "heliosCloudColors.h"

#include <string>
#include <utility>
#include <vector>

namespace helios::viewer
{

/// Returns the colourings in the order of cycling through them.
inline const std::vector<std::pair<std::string, ColorBy>>& GetColorings()
{
  static const std::vector<std::pair<std::string, ColorBy>> colorings{
    { "height", ColorBy::Height }, { "amplitude", ColorBy::Amplitude },
    { "return", ColorBy::ReturnNumber }, { "returns", ColorBy::NumberOfReturns },
    { "class", ColorBy::Class }, { "time", ColorBy::Time }, { "part", ColorBy::Part },
    { "material", ColorBy::Material }, { "leg", ColorBy::Leg }, { "incidence", ColorBy::Incidence },
    { "range", ColorBy::Range }, { "rgb", ColorBy::Own }, { "one", ColorBy::One }
  };
  return colorings;
}

inline std::vector<std::string> GetColorByNames()
{
  std::vector<std::string> names;
  for (const auto& coloring : GetColorings())
  {
    names.push_back(coloring.first);
  }
  return names;
}

inline std::string GetColorByName(ColorBy by)
{
  for (const auto& coloring : GetColorings())
  {
    if (coloring.second == by)
    {
      return coloring.first;
    }
  }
  return {};
}

/// Returns the words of a colouring in the menu.
inline std::string GetColorTitle(ColorBy by)
{
  switch (by)
  {
    case ColorBy::Amplitude:
      return "amplitude or intensity";
    case ColorBy::ReturnNumber:
      return "return number";
    case ColorBy::NumberOfReturns:
      return "number of returns";
    case ColorBy::Incidence:
      return "angle of incidence";
    case ColorBy::Own:
      return "colours of the points";
    case ColorBy::One:
      return "one colour";
    default:
      return GetColorByName(by);
  }
}

} // namespace helios::viewer

#endif
