// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosRasterMesh.h"

#include "heliosHeightGrid.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosFiltersCoreModule.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkIntArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTypeInt32Array.h>
#include <vtkTypeInt64Array.h>

#include <algorithm>
#include <limits>

namespace helios
{

template <typename IndexArrayT>
RasterMesh<IndexArrayT>::RasterMesh(std::int64_t columns, const double transform[6])
  : Columns(columns)
  , IsMirrored(transform[1] * transform[5] > transform[2] * transform[4])
  , Heights{ std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity() }
{
  std::copy_n(transform, 6, this->Transform.begin());
}

// Adds a row of heights. The vertices of a row are known after the triangles above and below it:
// one row later.
template <typename IndexArrayT>
bool RasterMesh<IndexArrayT>::AddRow(const double* heights)
{
  const std::int64_t r = this->NumberOfRows++;
  Row& row = this->GetRow(r);
  const std::size_t size = static_cast<std::size_t>(this->Columns);
  row.Heights.assign(heights, heights + this->Columns);
  row.HasHeight.resize(size);
  row.IsUsed.assign(size, 0);
  row.Upper.resize(size);
  row.Lower.resize(size);
  row.Ids.resize(size);
  for (std::int64_t c = 0; c < this->Columns; ++c)
  {
    row.HasHeight[c] = heights[c] == heights[c];
  }
  if (r == 0)
  {
    return true;
  }
  this->FindTriangles(r - 1);
  return this->Complete(r - 1);
}

template <typename IndexArrayT>
bool RasterMesh<IndexArrayT>::Finish()
{
  return this->NumberOfRows < 2 || this->Complete(this->NumberOfRows - 1);
}

template <typename IndexArrayT>
void RasterMesh<IndexArrayT>::FindTriangles(std::int64_t r)
{
  Row& above = this->GetRow(r);
  Row& below = this->GetRow(r + 1);
  const unsigned char* a = above.HasHeight.data();
  const unsigned char* b = below.HasHeight.data();
  unsigned char* upper = above.Upper.data();
  unsigned char* lower = above.Lower.data();
  for (std::int64_t c = 0; c + 1 < this->Columns; ++c)
  {
    upper[c] = a[c] & b[c] & a[c + 1];
    lower[c] = b[c] & b[c + 1] & a[c + 1];
  }
  for (std::int64_t c = 0; c + 1 < this->Columns; ++c)
  {
    above.IsUsed[c] |= upper[c];
    below.IsUsed[c] |= upper[c] | lower[c];
    above.IsUsed[c + 1] |= upper[c] | lower[c];
    below.IsUsed[c + 1] |= lower[c];
  }
}

// Creates the vertices of a row and the triangles above it.
template <typename IndexArrayT>
bool RasterMesh<IndexArrayT>::Complete(std::int64_t r)
{
  const bool isGood = this->AddPoints(r);
  if (isGood && r > 0)
  {
    this->AddTriangles(r - 1);
  }
  return isGood;
}

template <typename IndexArrayT>
bool RasterMesh<IndexArrayT>::AddPoints(std::int64_t r)
{
  Row& row = this->GetRow(r);
  const auto& t = this->Transform;
  const double y = static_cast<double>(r) + 0.5;
  std::int64_t id = this->Points.GetSize() / 3;
  double* point = this->Points.Append(3 * this->Columns);
  for (std::int64_t c = 0; c < this->Columns; ++c)
  {
    const double x = static_cast<double>(c) + 0.5;
    const double z = row.Heights[c];
    point[0] = t[0] + (t[1] * x + t[2] * y);
    point[1] = t[3] + (t[4] * x + t[5] * y);
    point[2] = z;
    row.Ids[c] = static_cast<T>(id);
    if (row.IsUsed[c])
    {
      this->Heights = { std::min(this->Heights[0], z), std::max(this->Heights[1], z) };
      point += 3;
      ++id;
    }
  }
  this->Points.Truncate(3 * id);
  return id <= this->MaximumNumberOfPoints;
}

template <typename IndexArrayT>
void RasterMesh<IndexArrayT>::AddTriangles(std::int64_t r)
{
  const Row& above = this->GetRow(r);
  const Row& below = this->GetRow(r + 1);
  const vtkIdType size = this->Corners.GetSize();
  T* const begin = this->Corners.Append(6 * this->Columns);
  T* corner = begin;
  const int second = this->IsMirrored ? 2 : 1;
  const int third = 3 - second;
  for (std::int64_t c = 0; c + 1 < this->Columns; ++c)
  {
    corner[0] = above.Ids[c];
    corner[second] = below.Ids[c];
    corner[third] = above.Ids[c + 1];
    corner += 3 * above.Upper[c];
    corner[0] = below.Ids[c];
    corner[second] = below.Ids[c + 1];
    corner[third] = above.Ids[c + 1];
    corner += 3 * above.Lower[c];
  }
  this->Corners.Truncate(size + (corner - begin));
}

template <typename IndexArrayT>
void RasterMesh<IndexArrayT>::MoveTo(vtkPolyData* scene)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(VTK_DOUBLE);
  points->SetData(this->Points.Finish(3));

  const vtkIdType count = this->Corners.GetSize() / 3;
  vtkNew<IndexArrayT> offsets;
  offsets->SetNumberOfValues(count + 1);
  T* offset = offsets->GetPointer(0);
  for (vtkIdType i = 0; i <= count; ++i)
  {
    offset[i] = static_cast<T>(3 * i);
  }
  vtkNew<vtkCellArray> triangles;
  triangles->SetData(offsets, this->Corners.Finish(1));

  vtkNew<vtkIntArray> materialIds;
  materialIds->SetName(vtkHeliosArrayNames::MaterialIds);
  materialIds->SetNumberOfValues(count);
  materialIds->FillValue(0);

  scene->SetPoints(points);
  scene->SetPolys(triangles);
  scene->GetCellData()->AddArray(materialIds);
}

template class VTKHELIOSFILTERSCORE_EXPORT RasterMesh<vtkTypeInt32Array>;
template class VTKHELIOSFILTERSCORE_EXPORT RasterMesh<vtkTypeInt64Array>;

Status MakeRasterMesh(const HeightGrid& grid, vtkPolyData* mesh)
{
  RasterMesh<vtkTypeInt32Array> made(grid.Columns, grid.Transform);
  std::vector<double> heights(static_cast<std::size_t>(grid.Columns));
  bool hasRoom = true;
  for (std::int64_t row = 0; hasRoom && row < grid.Rows; ++row)
  {
    for (std::int64_t column = 0; column < grid.Columns; ++column)
    {
      heights[static_cast<std::size_t>(column)] = grid.GetHeight(row, column);
    }
    hasRoom = made.AddRow(heights.data());
  }
  if (!hasRoom || !made.Finish())
  {
    return Status::Error("the raster has more than 2^31 points, too many for a mesh; use the ray "
                         "caster \"beam\", which does not make one, or a part of the raster");
  }
  made.MoveTo(mesh);
  return {};
}

} // namespace helios
