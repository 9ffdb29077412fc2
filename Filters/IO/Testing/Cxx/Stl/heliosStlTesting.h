// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// STL files made for tests.

#ifndef heliosStlTesting_h
#define heliosStlTesting_h

#include "heliosSceneReading.h"
#include "vtkHeliosSTLSceneReader.h"

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace helios::stl
{

using Reading = SceneReading<vtkHeliosSTLSceneReader>;

/// Two triangles of a unit square.
inline const std::string Square = "solid square\n"
                                  "facet normal 0 0 1\n outer loop\n  vertex 0 0 0\n"
                                  "  vertex 1 0 0\n  vertex 1 1 0\n endloop\nendfacet\n"
                                  "facet normal 0 0 1\n outer loop\n  vertex 0 0 -0\n"
                                  "  vertex 1 1 0\n  vertex 0 1 0\n endloop\nendfacet\n"
                                  "endsolid square\n";

template <typename T>
void Append(std::string& bytes, T value)
{
  char raw[sizeof(value)];
  std::memcpy(raw, &value, sizeof(value));
  bytes.append(raw, sizeof(value));
}

/// A binary file of nine coordinates per triangle.
inline std::string MakeBinary(const std::vector<float>& coordinates, std::string head = "solid")
{
  std::string bytes = head;
  bytes.resize(80);
  Append(bytes, static_cast<std::uint32_t>(coordinates.size() / 9));
  for (std::size_t i = 0; i < coordinates.size(); ++i)
  {
    if (i % 9 == 0)
    {
      bytes.append(12, '\0'); // the normal
    }
    Append(bytes, coordinates[i]);
    if (i % 9 == 8)
    {
      bytes.append(2, '\0');
    }
  }
  return bytes;
}

} // namespace helios::stl

#endif
