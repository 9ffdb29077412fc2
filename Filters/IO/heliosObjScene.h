// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A parsed OBJ file made into a scene: materials found, useless triangles and vertices left out.

#ifndef heliosObjScene_h
#define heliosObjScene_h

#include "heliosMaterialTable.h"
#include "heliosObjParser.h"

#include <cstdint>
#include <string>
#include <vector>

class vtkPolyData;

namespace helios
{

/**
 * Extent of a scene [m] beyond which a vertex is taken for a stray one: half the circumference of
 * the Earth is 2e7, and no projected or geocentric scene is wider than half of that.
 */
constexpr double LargestExtent = 1e7;

/// Takes what a parser has read through the steps to a scene, in this order.
class ObjScene
{
public:
  ObjScene(ObjParser& parser, TextReport& report);

  /// Reads the material libraries and finds the materials used. False after an error.
  bool ReadMaterials();

  /**
   * Drops triangles without area: those whose normal is within the rounding error of their
   * coordinates. Warns with their number, and of a scene without triangles.
   */
  void DropFlatTriangles();

  /// Warns of a vertex far from the others.
  void CheckExtent();

  /// Drops vertices of no triangle.
  void DropUnusedPoints();

  /// Turns y up into z up.
  void TurnUp();

  /// Hands the arrays over.
  void MoveTo(vtkPolyData* scene);

  vtkIdType GetNumberOfDroppedTriangles() const { return this->DroppedTriangles; }

private:
  bool ReadLibrary(const ObjParser::Statement& library, class MtlFile& reader);
  std::int64_t FindVertexLine(vtkIdType vertex) const;

  ObjParser& Parser;
  TextReport& Report;
  MaterialTable Materials;
  std::vector<int> Rows;             // a material's row, for each name used
  std::vector<unsigned char> IsUsed; // for each vertex
  vtkIdType UsedPoints = 0;
  vtkIdType DroppedTriangles = 0;
};

} // namespace helios

#endif
