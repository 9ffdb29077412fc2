// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosScenePolygons.h"

namespace helios
{

//------------------------------------------------------------------------------
/// Adds the triangles of a polygon; false if its sides cross.
bool ScenePolygons::AddTriangles(const PolygonRings& rings, int material)
{
  const bool isSimple = this->Triangulator.Triangulate(this->Mesh.Points.GetValues(), rings);
  const std::vector<vtkTypeInt32>& corners = this->Triangulator.GetCorners();
  for (std::size_t i = 0; i < corners.size(); i += 3)
  {
    this->Mesh.AddTriangle(corners[i], corners[i + 1], corners[i + 2], material);
  }
  return isSimple;
}

//------------------------------------------------------------------------------
void ScenePolygons::Warn(TextReport& report) const
{
  if (this->NumberOfCrossed > 0)
  {
    report.Warn(this->FirstPlace +
      "the sides of the polygon cross, so its triangles may be wrong (" +
      std::to_string(this->NumberOfCrossed) + " such polygons in this file); correct it");
  }
}

} // namespace helios
