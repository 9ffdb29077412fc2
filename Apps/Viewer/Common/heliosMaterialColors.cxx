// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosMaterialColors.h"

#include <algorithm>
#include <cctype>

namespace helios::viewer
{

namespace
{

struct WordColor
{
  const char* Word;
  Rgb Color;
};

constexpr WordColor Words[] = {
  { "ground", { 168, 143, 110 } },
  { "terrain", { 168, 143, 110 } },
  { "soil", { 150, 120, 88 } },
  { "grass", { 142, 172, 92 } },
  { "meadow", { 142, 172, 92 } },
  { "leaf", { 84, 150, 76 } },
  { "leaves", { 84, 150, 76 } },
  { "canopy", { 84, 150, 76 } },
  { "needle", { 62, 122, 78 } },
  { "tree", { 84, 150, 76 } },
  { "veg", { 122, 165, 82 } },
  { "crop", { 170, 178, 84 } },
  { "trunk", { 120, 92, 66 } },
  { "bark", { 120, 92, 66 } },
  { "wood", { 140, 106, 74 } },
  { "branch", { 120, 92, 66 } },
  { "roof", { 176, 88, 70 } },
  { "brick", { 184, 106, 84 } },
  { "wall", { 206, 190, 168 } },
  { "house", { 206, 190, 168 } },
  { "building", { 206, 190, 168 } },
  { "concrete", { 178, 178, 174 } },
  { "asphalt", { 104, 106, 112 } },
  { "road", { 104, 106, 112 } },
  { "street", { 104, 106, 112 } },
  { "window", { 128, 164, 188 } },
  { "glass", { 128, 164, 188 } },
  { "water", { 77, 140, 217 } },
  { "metal", { 150, 156, 164 } },
};

std::string ToLower(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

} // namespace

//------------------------------------------------------------------------------
Rgb GetMaterialColor(const Material& material, std::size_t row)
{
  if (material.Classification > 1)
  {
    return GetClassColor(material.Classification);
  }
  const std::string name = ToLower(material.Name);
  for (const WordColor& word : Words)
  {
    if (name.find(word.Word) != std::string::npos)
    {
      return word.Color;
    }
  }
  return material.IsGround ? GetClassColor(2) : GetDistinctColor(static_cast<std::int64_t>(row));
}

} // namespace helios::viewer
