// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// PLY files made for tests.

#ifndef heliosPlyTesting_h
#define heliosPlyTesting_h

#include "heliosSceneReading.h"
#include "vtkHeliosPLYSceneReader.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>

namespace helios::ply
{

using Reading = SceneReading<vtkHeliosPLYSceneReader>;

/// A header with vertices of doubles, and faces of a flag and a list.
inline std::string MakeHead(const std::string& format, int vertices, int faces)
{
  return "ply\nformat " + format + " 1.0\ncomment made\nobj_info for a test\nelement vertex " +
    std::to_string(vertices) +
    "\nproperty double x\nproperty float64 y\nproperty double z\nproperty uchar red\n"
    "element face " +
    std::to_string(faces) + "\nproperty short flag\nproperty list uchar int vertex_indices\n" +
    "element edge 1\nproperty list uint8 uint16 nodes\nend_header\n";
}

/// A unit square of a triangle and, through its middle, a triangle and a quadrilateral.
inline const std::string Square = MakeHead("ascii", 5, 3) +
  "0 0 0 255\n1 0 0 255\n1 1 0 1\n\n0 1 0 2\n447422.9990000001 0.1 1e-3 0\n"
  "7 3 0 1 2\n-7 3 0 2 3\n7 4 0 1 4 3\n2 1 2\n";

template <typename T>
void Append(std::string& bytes, T value, bool isBig)
{
  char raw[sizeof(value)];
  std::memcpy(raw, &value, sizeof(value));
  if (isBig)
  {
    std::reverse(raw, raw + sizeof(value));
  }
  bytes.append(raw, sizeof(value));
}

/// Makes a binary file of Square.
inline std::string MakeBinary(bool isBig)
{
  std::string bytes = MakeHead(isBig ? "binary_big_endian" : "binary_little_endian", 5, 3);
  const double points[5][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 },
    { 447422.9990000001, 0.1, 1e-3 } };
  for (const auto& point : points)
  {
    std::for_each(point, point + 3, [&](double value) { Append(bytes, value, isBig); });
    bytes += '\xff';
  }
  const std::vector<std::vector<std::int32_t>> faces = { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 1, 4, 3 } };
  for (const auto& face : faces)
  {
    Append(bytes, static_cast<std::int16_t>(-7), isBig);
    bytes += static_cast<char>(face.size());
    std::for_each(face.begin(), face.end(), [&](std::int32_t id) { Append(bytes, id, isBig); });
  }
  bytes += '\x02';
  Append(bytes, static_cast<std::uint16_t>(1), isBig);
  Append(bytes, static_cast<std::uint16_t>(2), isBig);
  return bytes;
}

} // namespace helios::ply

#endif
