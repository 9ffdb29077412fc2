// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosVoxelMesh.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTypeInt32Array.h>

namespace helios
{

namespace
{

/// The corners of each side in steps from the cell's lowest, counter-clockwise seen from outside.
constexpr int SideCorners[6][4][3] = {
  { { 0, 0, 0 }, { 0, 0, 1 }, { 0, 1, 1 }, { 0, 1, 0 } }, // -x
  { { 1, 0, 0 }, { 1, 1, 0 }, { 1, 1, 1 }, { 1, 0, 1 } }, // +x
  { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 0, 1 }, { 0, 0, 1 } }, // -y
  { { 0, 1, 0 }, { 0, 1, 1 }, { 1, 1, 1 }, { 1, 1, 0 } }, // +y
  { { 0, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 }, { 1, 0, 0 } }, // -z
  { { 0, 0, 1 }, { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } }  // +z
};

/// Numbers the corners of cells that come layer by layer: stores the corners of two levels.
class CornerNumbers
{
public:
  CornerNumbers(const double origin[3], double size, vtkDoubleArray* points)
    : Origin(origin)
    , Size(size)
    , Points(points)
  {
  }

  /// Sets the layer of the cells that follow.
  void SetLayer(std::int64_t layer)
  {
    if (layer != this->Layer)
    {
      std::swap(this->Levels[0], this->Levels[1]);
      this->Levels[1].Clear();
      if (layer != this->Layer + 1)
      {
        this->Levels[0].Clear();
      }
      this->Layer = layer;
    }
  }

  vtkTypeInt32 Get(VoxelKey key)
  {
    const std::int64_t k = GetVoxelIndexAlong(key, 2);
    Level& level = this->Levels[k - this->Layer];
    const std::uint32_t id = level.Map.Insert(key);
    if (id == level.Points.size())
    {
      level.Points.push_back(this->AddPoint(key));
    }
    return level.Points[id];
  }

private:
  struct Level
  {
    VoxelMap Map;
    std::vector<vtkTypeInt32> Points;

    void Clear()
    {
      this->Map.Clear();
      this->Points.clear();
    }
  };

  vtkTypeInt32 AddPoint(VoxelKey key)
  {
    double point[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      const auto index = static_cast<double>(GetVoxelIndexAlong(key, axis));
      point[axis] = this->Origin[axis] + index * this->Size;
    }
    return static_cast<vtkTypeInt32>(this->Points->InsertNextTypedTuple(point));
  }

  const double* Origin;
  double Size;
  vtkDoubleArray* Points;
  Level Levels[2]; // below and above the layer
  std::int64_t Layer = -2;
};

} // namespace

VoxelMesh::VoxelMesh(const std::vector<VoxelMap::Entry>& cells)
  : Cells(cells)
  , Faces(cells.size(), 0)
{
  for (int side = 0; side < 6; ++side)
  {
    this->OpenFaces(side);
  }
}

// Opens faces. The neighbours of sorted cells are sorted as well: both are traversed in parallel.
void VoxelMesh::OpenFaces(int side)
{
  const VoxelKey step = side % 2 == 1 ? VoxelStep[side / 2] : VoxelKey(0) - VoxelStep[side / 2];
  auto neighbor = this->Cells.begin();
  for (std::size_t i = 0; i < this->Cells.size(); ++i)
  {
    const VoxelKey key = this->Cells[i].Key + step;
    while (neighbor != this->Cells.end() && neighbor->Key < key)
    {
      ++neighbor;
    }
    if (neighbor == this->Cells.end() || neighbor->Key != key)
    {
      this->Faces[i] = static_cast<std::uint8_t>(this->Faces[i] | (1u << side));
      this->NumberOfTriangles += 2;
    }
  }
}

void VoxelMesh::Write(const double origin[3], double size, vtkPolyData* scene) const
{
  vtkNew<vtkDoubleArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  vtkNew<vtkTypeInt32Array> corners;
  corners->SetNumberOfValues(3 * this->NumberOfTriangles);
  vtkTypeInt32* corner = corners->GetPointer(0);
  CornerNumbers numbers(origin, size, coordinates);
  for (std::size_t i = 0; i < this->Cells.size(); ++i)
  {
    const VoxelKey key = this->Cells[i].Key;
    numbers.SetLayer(GetVoxelIndexAlong(key, 2));
    for (int side = 0; side < 6; ++side)
    {
      if (!(this->Faces[i] & (1u << side)))
      {
        continue;
      }
      vtkTypeInt32 quad[4];
      for (int c = 0; c < 4; ++c)
      {
        const int* steps = SideCorners[side][c];
        quad[c] = numbers.Get(key + static_cast<VoxelKey>(steps[0]) * VoxelStep[0] +
          static_cast<VoxelKey>(steps[1]) * VoxelStep[1] +
          static_cast<VoxelKey>(steps[2]) * VoxelStep[2]);
      }
      for (const int c : { 0, 1, 2, 0, 2, 3 })
      {
        *corner++ = quad[c];
      }
    }
  }
  coordinates->Squeeze();
  vtkNew<vtkTypeInt32Array> offsets;
  offsets->SetNumberOfValues(this->NumberOfTriangles + 1);
  for (vtkIdType i = 0; i <= this->NumberOfTriangles; ++i)
  {
    offsets->SetValue(i, static_cast<vtkTypeInt32>(3 * i));
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetData(coordinates);
  vtkNew<vtkCellArray> polys;
  polys->SetData(offsets, corners);
  scene->SetPoints(points);
  scene->SetPolys(polys);
}

} // namespace helios
