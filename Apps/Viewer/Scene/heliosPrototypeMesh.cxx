// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPrototypeMesh.h"

#include "heliosDrawnMesh.h"
#include "heliosHeightField.h"
#include "heliosHeightGrid.h"
#include "heliosRasterMesh.h"
#include "heliosTriangleMesh.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace helios::viewer
{

namespace
{

constexpr vtkIdType TriangleRatio = 6; // triangles of a level over triangles of the next
constexpr vtkIdType RasterRatio = 4;
constexpr double MaximumDivisions = 128.0; // divisions of coarse levels: a cube takes 80 bytes

/// Makes a mesh of some triangles, with the points that they use, as floats relative to a centre.
vtkSmartPointer<vtkPolyData> MakeLocal(
  const TriangleMesh& mesh, const std::vector<vtkTypeInt32>& triangles, const Vec3& centre)
{
  std::vector<vtkTypeInt32> known(static_cast<std::size_t>(mesh.GetNumberOfPoints()), -1);
  vtkNew<vtkFloatArray> xyz;
  xyz->SetNumberOfComponents(3);
  vtkNew<vtkCellArray> polys;
  polys->Use32BitStorage();
  for (const vtkTypeInt32 triangle : triangles)
  {
    vtkIdType corners[3];
    for (int k = 0; k < 3; ++k)
    {
      const vtkTypeInt32 point = mesh.GetCorners()[3 * static_cast<vtkIdType>(triangle) + k];
      vtkTypeInt32& id = known[static_cast<std::size_t>(point)];
      if (id < 0)
      {
        const Vec3 p = Vec3(mesh.GetCorner(triangle, k)) - centre;
        id = static_cast<vtkTypeInt32>(xyz->InsertNextTuple(p.GetData()));
      }
      corners[k] = id;
    }
    polys->InsertNextCell(3, corners);
  }
  vtkNew<vtkPoints> points;
  points->SetData(xyz);
  auto local = vtkSmartPointer<vtkPolyData>::New();
  local->SetPoints(points);
  local->SetPolys(polys);
  return local;
}

std::vector<vtkTypeInt32> GetAllTriangles(const TriangleMesh& mesh)
{
  std::vector<vtkTypeInt32> all(static_cast<std::size_t>(mesh.GetNumberOfTriangles()));
  std::iota(all.begin(), all.end(), 0);
  return all;
}

/// Copies every n-th pixel of a row and column of a grid; the heights are in a buffer.
HeightGrid CopyEvery(const HeightGrid& grid, std::int64_t n, std::vector<float>& heights)
{
  HeightGrid coarse = grid;
  coarse.Columns = (grid.Columns - 1) / n + 1;
  coarse.Rows = (grid.Rows - 1) / n + 1;
  for (std::int64_t row = 0; row < coarse.Rows; ++row)
  {
    for (std::int64_t column = 0; column < coarse.Columns; ++column)
    {
      heights.push_back(static_cast<float>(grid.GetHeight(n * row, n * column)));
    }
  }
  coarse.Floats = heights.data();
  coarse.Doubles = nullptr;
  const double size = static_cast<double>(n);
  for (const int axis : { 0, 3 }) // the centre of the first pixel stays
  {
    const double* t = grid.Transform + axis;
    coarse.Transform[axis] = t[0] + 0.5 * (1.0 - size) * (t[1] + t[2]);
    coarse.Transform[axis + 1] = size * t[1];
    coarse.Transform[axis + 2] = size * t[2];
  }
  return coarse;
}

} // namespace

//------------------------------------------------------------------------------
PrototypeMesh::PrototypeMesh(vtkIdType count, vtkIdType ratio, const Vec3& centre)
  : Centre(centre)
{
  this->Counts.push_back(count);
  while (this->Counts.back() > MinimumTriangles)
  {
    this->Counts.push_back(this->Counts.back() / ratio);
  }
  this->Levels.resize(this->Counts.size());
}

//------------------------------------------------------------------------------
void PrototypeMesh::SetSmooth(bool on)
{
  if (on != this->Smooth)
  {
    this->Smooth = on;
    this->Levels[0] = nullptr;
  }
}

//------------------------------------------------------------------------------
vtkPolyData* PrototypeMesh::GetLevel(int level)
{
  const auto index = static_cast<std::size_t>(level);
  if (!this->Levels[index])
  {
    this->Levels[index] = this->MakeLevel(level);
  }
  return this->Levels[index];
}

//------------------------------------------------------------------------------
PrototypeTriangles::PrototypeTriangles(
  const TriangleMesh& mesh, std::vector<vtkTypeInt32> triangles, const Vec3& centre)
  : PrototypeMesh(static_cast<vtkIdType>(triangles.size()), TriangleRatio, centre)
  , Mesh(mesh)
  , Triangles(std::move(triangles))
{
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> PrototypeTriangles::MakeLevel(int level)
{
  if (level == 0)
  {
    return this->Smooth ? this->MakeAllSmooth() : this->MakeAll();
  }
  // all triangles are needed for a moment only, unless they are drawn
  const bool isAll = level == 1 && !this->HasLevel(0);
  vtkSmartPointer<vtkPolyData> finer = isAll ? this->MakeAll() : nullptr;
  finer = isAll ? finer.Get() : this->GetLevel(level - 1);
  const vtkIdType maximum = this->GetCount(level);
  return MakeCoarse(
    finer, maximum, std::min(MaximumDivisions, std::sqrt(static_cast<double>(maximum))));
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> PrototypeTriangles::MakeAll() const
{
  return MakeLocal(this->Mesh, this->Triangles, this->Centre);
}

//------------------------------------------------------------------------------
/// Makes normals of the whole prototype: they are smooth where materials meet.
vtkSmartPointer<vtkPolyData> PrototypeTriangles::MakeAllSmooth() const
{
  const auto whole = MakeSmooth(MakeLocal(this->Mesh, GetAllTriangles(this->Mesh), this->Centre));
  vtkNew<vtkCellArray> polys;
  polys->Use32BitStorage();
  for (const vtkTypeInt32 triangle : this->Triangles)
  {
    vtkIdType size;
    const vtkIdType* corners;
    whole->GetPolys()->GetCellAtId(triangle, size, corners);
    polys->InsertNextCell(size, corners);
  }
  whole->SetPolys(polys);
  whole->GetCellData()->Initialize();
  return whole;
}

//------------------------------------------------------------------------------
PrototypeRaster::PrototypeRaster(const HeightField& heights, const Vec3& centre)
  : PrototypeMesh(heights.GetNumberOfTriangles(), RasterRatio, centre)
  , Heights(heights)
{
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> PrototypeRaster::MakeLevel(int level)
{
  vtkNew<vtkPolyData> made;
  std::vector<float> heights;
  const HeightGrid& grid = this->Heights.GetGrid();
  const HeightGrid every = level == 0 ? grid : CopyEvery(grid, std::int64_t(1) << level, heights);
  TriangleMesh mesh;
  if (!MakeRasterMesh(every, made).IsOk() || !mesh.Set(made).IsOk())
  {
    return vtkSmartPointer<vtkPolyData>::New(); // so coarse that no triangle is left
  }
  const auto local = MakeLocal(mesh, GetAllTriangles(mesh), this->Centre);
  return this->Smooth ? MakeSmooth(local) : local;
}

} // namespace helios::viewer
