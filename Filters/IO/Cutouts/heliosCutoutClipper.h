// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Triangles that are cut out of a triangle by a texture.

#ifndef heliosCutoutClipper_h
#define heliosCutoutClipper_h

#include "heliosCutoutShape.h"
#include "vtkHeliosFiltersIOModule.h" // For export macro

#include <array>
#include <vector>

namespace helios
{

/// How a texture continues outside [0, 1].
enum class TextureWrap
{
  Repeat,
  Mirror, ///< every second one is mirrored
  Clamp   ///< by the pixels of its border
};

/// A piece of a triangle: barycentric coordinates of the second and third corner, three points per
/// triangle, in the orientation of the triangle.
struct CutoutPieces
{
  std::vector<std::array<double, 2>> Points;
  std::vector<int> Corners;

  void Clear()
  {
    this->Points.clear();
    this->Corners.clear();
  }
};

/// Cuts triangles by a band of a shape.
class VTKHELIOSFILTERSIO_EXPORT CutoutClipper
{
public:
  using Point = std::array<double, 2>;

  CutoutClipper(const CutoutBand& band, std::array<TextureWrap, 2> wrap);

  /**
   * Finds the pieces of a triangle, given by the texture coordinates of its corners. A triangle
   * without area in the texture has none. False if the texture is repeated over it too often, or is
   * clamped and the triangle is beyond its border.
   */
  bool Clip(const std::array<Point, 3>& corners, CutoutPieces& pieces);

private:
  /// A repetition of the texture.
  struct Tile
  {
    Point Origin;
    std::array<bool, 2> IsMirrored;

    Point Place(const Point& point) const;
  };

  bool HasTiles(const Point& low, const Point& high) const;
  Tile MakeTile(double column, double row) const;
  void ClipTile(const Tile& tile, const Point& low, const Point& high, CutoutPieces& pieces);
  void ClipBandTriangle(const Tile& tile, int triangle, CutoutPieces& pieces);
  bool CutSides(std::vector<Point>& polygon) const;
  int AddPoint(const Point& point, CutoutPieces& pieces) const;

  const CutoutBand& Band;
  const CutoutGrid Grid;
  const std::array<TextureWrap, 2> Wrap;
  std::array<Point, 3> Corners{};
  double Area = 0.0; // twice the area of the corners, signed

  std::vector<int> Ids; // pieces' point of each point of the band, in a tile; -1: none yet
  std::vector<int> Used;
  std::vector<int> Found;
  std::vector<Point> Polygon;
};

} // namespace helios

#endif
