// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The triangles of a prototype as drawn, in several levels of detail.

#ifndef heliosPrototypeMesh_h
#define heliosPrototypeMesh_h

#include "heliosPose.h"

#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <vector>

class vtkPolyData;

namespace helios
{
class HeightField;
class TriangleMesh;
}

namespace helios::viewer
{

/**
 * Triangles of one material: level 0 is all of them, the next ones have fewer and larger ones.
 * Levels are made when they are first needed. Points are floats, relative to a centre.
 */
class PrototypeMesh
{
public:
  static constexpr vtkIdType MinimumTriangles = 16; ///< triangles of the last level, about

  virtual ~PrototypeMesh() = default;
  PrototypeMesh(const PrototypeMesh&) = delete;
  void operator=(const PrototypeMesh&) = delete;

  /// Sets whether level 0 is smooth over edges below 40 degrees. Default: off.
  void SetSmooth(bool on);

  int GetNumberOfLevels() const { return static_cast<int>(this->Levels.size()); }

  /// Returns the triangles of a level, about.
  vtkIdType GetCount(int level) const { return this->Counts[static_cast<std::size_t>(level)]; }

  vtkPolyData* GetLevel(int level);

protected:
  /// Each level has a share of the triangles of the one before.
  PrototypeMesh(vtkIdType count, vtkIdType ratio, const Vec3& centre);

  virtual vtkSmartPointer<vtkPolyData> MakeLevel(int level) = 0;

  bool HasLevel(int level) const { return this->Levels[static_cast<std::size_t>(level)]; }

  Vec3 Centre;
  bool Smooth = false;

private:
  std::vector<vtkIdType> Counts;
  std::vector<vtkSmartPointer<vtkPolyData>> Levels; // null: not needed yet
};

/// Triangles of a mesh; in other levels large ones stand for a sixth of those before.
class PrototypeTriangles : public PrototypeMesh
{
public:
  /// The mesh must outlive this.
  PrototypeTriangles(
    const TriangleMesh& mesh, std::vector<vtkTypeInt32> triangles, const Vec3& centre);

private:
  vtkSmartPointer<vtkPolyData> MakeLevel(int level) override;
  vtkSmartPointer<vtkPolyData> MakeAll() const;
  vtkSmartPointer<vtkPolyData> MakeAllSmooth() const;

  const TriangleMesh& Mesh;
  std::vector<vtkTypeInt32> Triangles;
};

/// A raster of heights; in other levels of every second, fourth, eighth pixel of a row and column.
class PrototypeRaster : public PrototypeMesh
{
public:
  /// The heights must outlive this.
  PrototypeRaster(const HeightField& heights, const Vec3& centre);

private:
  vtkSmartPointer<vtkPolyData> MakeLevel(int level) override;

  const HeightField& Heights;
};

} // namespace helios::viewer

#endif
