// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Converts a parsed OBJ file to a scene: resolves materials, drops unused triangles and vertices.

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
 * Extent of a scene [m] beyond which a vertex is an outlier: half the circumference of the Earth is
 * 2e7, and no projected or geocentric scene is wider than half of that.
 */
constexpr double LargestExtent = 1e7;

/// Converts parser output to a scene; call the functions in this order.
class ObjScene
{
public:
  ObjScene(ObjParser& parser, TextReport& report);

  /// Reads the material libraries and resolves the materials used. False after an error.
  bool ReadMaterials();

  /**
   * Drops degenerate triangles: those whose normal is within the rounding error of their
   * coordinates. Warns with their number, and about a scene without triangles.
   */
  void DropFlatTriangles();

  /// Warns about a vertex far from the others.
  void CheckExtent();

  /// Drops vertices that no triangle uses.
  void DropUnusedPoints();

  /// Converts y up to z up.
  void TurnUp();

  /// Moves the arrays to a scene.
  void MoveTo(vtkPolyData* scene);

  vtkIdType GetNumberOfDroppedTriangles() const { return this->DroppedTriangles; }

private:
  bool ReadLibrary(const ObjParser::Statement& library, class MtlFile& reader);
  std::int64_t FindVertexLine(vtkIdType vertex) const;

  ObjParser& Parser;
  TextReport& Report;
  MaterialTable Materials;
  std::vector<int> Rows;             // material row per name used
  std::vector<unsigned char> IsUsed; // per vertex
  vtkIdType UsedPoints = 0;
  vtkIdType DroppedTriangles = 0;
};

} // namespace helios

#endif
