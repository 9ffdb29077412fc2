// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Builds a scene triangle by triangle: double points, 32-bit cells, one material per triangle.

#ifndef heliosMeshBuilder_h
#define heliosMeshBuilder_h

#include "heliosMaterialTable.h"
#include "heliosPose.h"

#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkTypeInt32Array.h>

#include <vector>

class vtkPolyData;

namespace helios
{

class MeshBuilder
{
public:
  MeshBuilder();

  /// Reserves memory for this many points and triangles in total.
  void Reserve(vtkIdType points, vtkIdType triangles);

  /// Sets the frame of the scene for the points that follow.
  void SetFrame(const Pose& frame);

  /// Sets the material for the triangles that follow; equal materials share one row of the table.
  void SetMaterial(const Material& material);

  vtkTypeInt32 AddPoint(const Vec3& point);

  ///@{
  /// Corners counter-clockwise as seen from outside.
  void AddTriangle(vtkTypeInt32 a, vtkTypeInt32 b, vtkTypeInt32 c);
  void AddQuad(vtkTypeInt32 a, vtkTypeInt32 b, vtkTypeInt32 c, vtkTypeInt32 d);
  void AddPolygon(const std::vector<vtkTypeInt32>& corners); // convex
  ///@}

  /// Adds a closed box from low to high.
  void AddBox(const Vec3& low, const Vec3& high);

  /**
   * Adds a convex polygon in the x, z plane, counter-clockwise as seen from -y, extruded along y:
   * closed.
   */
  void AddPrism(const std::vector<vtkVector2d>& outline, double yLow, double yHigh);

  vtkIdType GetNumberOfTriangles() const { return this->MaterialIds->GetNumberOfValues(); }

  /// Transfers the mesh, shifted by the offset.
  void Finish(vtkPolyData* scene, const double offset[3]);

private:
  vtkNew<vtkDoubleArray> Points;
  vtkNew<vtkTypeInt32Array> Corners;
  vtkNew<vtkIntArray> MaterialIds;
  MaterialTable Materials;
  int MaterialId = 0;
  Vec3 Position{ 0.0, 0.0, 0.0 };
  Rotation Orientation;
};

} // namespace helios

#endif
