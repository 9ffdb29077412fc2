// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Triangles of a polygon in space, which may be concave and have holes.

#ifndef heliosPolygonTriangulator_h
#define heliosPolygonTriangulator_h

#include "heliosPlanarTriangulation.h"
#include "heliosPose.h"
#include "vtkHeliosFiltersCoreModule.h" // For export macro

#include <vtkType.h>

#include <vector>

namespace helios
{

/// Rings of vertex indices: the boundary, then the holes.
using PolygonRings = std::vector<std::vector<vtkTypeInt32>>;

class VTKHELIOSFILTERSCORE_EXPORT PolygonTriangulator
{
public:
  /**
   * Triangulates a polygon: as a fan about its first corner if that covers it once (a convex
   * polygon), else by PlanarTriangulation in the plane of the two axes that it covers most. Rings
   * may touch themselves and each other, in vertices and along sides. The triangles have the
   * orientation of the boundary, whatever the orientation of the holes. A polygon without area has
   * none.
   *
   * False if sides cross or a hole is outside: the area of the triangles, seen along the normal of
   * the polygon, is not its own. Sides that cross by less than a ten thousandth of the area are
   * taken to touch, as rounded coordinates do.
   */
  bool Triangulate(const double* points, const PolygonRings& rings);

  /// Returns three vertex indices per triangle of the last polygon.
  const std::vector<vtkTypeInt32>& GetCorners() const { return this->Corners; }

  /// Returns the places of these corners in the rings, counted through all of them.
  const std::vector<int>& GetPlaces() const { return this->Places; }

private:
  bool SetRings(const double* points, const PolygonRings& rings);
  bool IsFlatRing(const std::vector<int>& ring) const;
  void AddFan(const std::vector<vtkTypeInt32>& ring);
  bool AddPlanar(const Vec3& origin, const Vec3& right, const Vec3& up);
  bool AddInPlane();
  void AddTriangle(int a, int b, int c);
  double ComputeTriangleArea() const;
  bool IsTorn() const;
  const double* GetPoint(int place) const;
  Vec3 GetSide(int from, int to) const;
  Vec3 GetCross(int a, int b, int c) const;
  Vec3 GetAreaVector(const std::vector<int>& ring) const;

  const double* Points = nullptr;
  std::vector<vtkTypeInt32> Vertices;  // one vertex per place
  std::vector<std::vector<int>> Rings; // places, without repeated vertices
  Vec3 Normal{ 0.0, 0.0, 0.0 };        // unit
  double Area = 0.0;                   // [m2], seen along the normal
  PlanarTriangulation Plane;
  std::vector<vtkTypeInt32> Corners;
  std::vector<int> Places;
};

} // namespace helios

#endif
