// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPcdNames.h"

#include "heliosPcdHeader.h"

#include <cstddef>

namespace names = vtkHeliosArrayNames;

namespace helios
{

namespace
{

bool IsPacked(const PcdField& field)
{
  return field.Size == 4 && field.Count == 1;
}

bool IsReal(const PcdField& field)
{
  return field.Type == 'F' && field.Count == 1;
}

/// Returns whether the file has all normals, of one type, and no array of them.
bool HasNormals(const PcdHeader& header)
{
  int size = 0;
  for (const char* name : { "normal_x", "normal_y", "normal_z" })
  {
    const int i = header.FindPcl(name);
    const PcdField* field = i < 0 ? nullptr : &header.Fields[static_cast<std::size_t>(i)];
    if (!field || !IsReal(*field) || (size != 0 && field->Size != size))
    {
      return false;
    }
    size = field->Size;
  }
  return header.Find(names::Normals) < 0;
}

bool HasColors(const PcdHeader& header)
{
  const int i = header.Find(names::RGB);
  return i >= 0 && header.Fields[static_cast<std::size_t>(i)].Count == 3;
}

PcdMeaning GetColorMeaning(const PcdHeader& header, const std::string& name)
{
  const int rgb = header.FindPcl("rgb");
  const bool isFirst =
    name == "rgb" || rgb < 0 || !IsPacked(header.Fields[static_cast<std::size_t>(rgb)]);
  return !isFirst        ? PcdMeaning::Array
    : !HasColors(header) ? PcdMeaning::Color
                         : PcdMeaning::ColorCopy;
}

} // namespace

PcdRole GetPcdRole(const PcdHeader& header, const PcdField& field)
{
  const std::string name = ToLowerCase(field.Name);
  const int found = header.FindPcl(name);
  if (field.Name == "_")
  {
    return { PcdMeaning::Padding };
  }
  if (&header.Fields[static_cast<std::size_t>(found)] != &field)
  {
    return {}; // another field has the name in lower case
  }
  if (name == "x" || name == "y" || name == "z")
  {
    return { PcdMeaning::Coordinate, name[0] - 'x' };
  }
  if (name.size() == 8 && name.substr(0, 7) == "normal_" && name[7] >= 'x' && name[7] <= 'z')
  {
    return HasNormals(header) ? PcdRole{ PcdMeaning::Normal, name[7] - 'x' } : PcdRole();
  }
  if ((name == "rgb" || name == "rgba") && IsPacked(field))
  {
    return { GetColorMeaning(header, name) };
  }
  if (name == "label" && field.Type != 'F' && field.Count == 1 && field.Size <= 4 &&
    header.Find(names::ClassificationIds) < 0)
  {
    return { PcdMeaning::Label };
  }
  if (name == "curvature" && IsReal(field) &&
    (header.Find(CurvatureName) < 0 || field.Name == CurvatureName))
  {
    return { PcdMeaning::Curvature };
  }
  const char* own = header.HasAmplitude ? names::Amplitude : names::Intensity;
  if (name == "intensity" && (header.Find(own) < 0 || field.Name == own))
  {
    return { PcdMeaning::Intensity };
  }
  return {};
}

} // namespace helios
