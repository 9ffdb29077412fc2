// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A scene as plain triangles: points and corner indices, shared with the scene where possible.

#ifndef heliosTriangleMesh_h
#define heliosTriangleMesh_h

#include "heliosPose.h"
#include "heliosStatus.h"
#include "vtkHeliosFiltersCoreModule.h"

#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <string>
#include <vector>

class vtkPolyData;

namespace helios
{

/// Returns an error for a scene with instances (vtkHeliosScene).
VTKHELIOSFILTERSCORE_EXPORT Status CheckNoInstances(vtkPolyData* scene);

/// Returns the unit normal by the right-hand rule; zero for a degenerate triangle.
VTKHELIOSFILTERSCORE_EXPORT Vec3 GetTriangleNormal(
  const double p[3], const double q[3], const double r[3]);

/// Returns the weights of the corners at the place of a triangle that is nearest to a point: none
/// negative.
VTKHELIOSFILTERSCORE_EXPORT Vec3 GetTriangleWeights(const double corners[3][3], const Vec3& point);

/**
 * Cell i of the scene is triangle i. Points are double and corner indices 32-bit: a scene with this
 * storage (vtkDoubleArray points, 32-bit vtkCellArray) is not copied.
 */
class VTKHELIOSFILTERSCORE_EXPORT TriangleMesh
{
public:
  TriangleMesh() = default;
  TriangleMesh(TriangleMesh&&) = default;
  TriangleMesh& operator=(TriangleMesh&&) = default;

  /**
   * Sets a scene and keeps a reference. Errors: cells other than triangles, corners that are
   * invalid or not finite, more than 2^31 points, instances (vtkHeliosScene).
   */
  Status Set(vtkPolyData* scene);

  vtkIdType GetNumberOfTriangles() const { return this->NumberOfTriangles; }
  vtkIdType GetNumberOfPoints() const { return this->NumberOfPoints; }
  const double* GetPoints() const { return this->Points; }
  const vtkTypeInt32* GetCorners() const { return this->Corners; }

  const double* GetCorner(vtkIdType triangle, int corner) const
  {
    return this->Points + 3 * static_cast<vtkIdType>(this->Corners[3 * triangle + corner]);
  }

  /// Returns the unit normal of a triangle, see GetTriangleNormal().
  Vec3 GetNormal(vtkIdType triangle) const;

  /// Computes the smallest and largest coordinates of the points that triangles use: x0 x1 y0 y1 z0
  /// z1.
  void GetBounds(double bounds[6]) const;

  /// Bytes held by this object in addition to the scene.
  std::size_t GetMemorySize() const;

private:
  vtkSmartPointer<vtkPolyData> Scene;
  std::vector<double> OwnPoints;
  std::vector<vtkTypeInt32> OwnCorners;
  const double* Points = nullptr;
  const vtkTypeInt32* Corners = nullptr;
  vtkIdType NumberOfTriangles = 0;
  vtkIdType NumberOfPoints = 0;
};

} // namespace helios

#endif
