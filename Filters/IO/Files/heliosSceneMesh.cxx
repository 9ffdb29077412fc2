// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSceneMesh.h"

#include "heliosTriangleArea.h"
#include "heliosZeroIds.h"
#include "vtkHeliosArrayNames.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace helios
{

namespace
{

// Computes the minimum and maximum coordinates: x0 x1 y0 y1 z0 z1.
void FindBounds(const double* points, vtkIdType count, double bounds[6])
{
  for (int axis = 0; axis < 3; ++axis)
  {
    bounds[2 * axis] = bounds[2 * axis + 1] = points[axis];
  }
  for (vtkIdType i = 0; i < 3 * count; i += 3)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      bounds[2 * axis] = std::min(bounds[2 * axis], points[i + axis]);
      bounds[2 * axis + 1] = std::max(bounds[2 * axis + 1], points[i + axis]);
    }
  }
}

// Returns the vertex that is farthest from the median along an axis.
vtkIdType FindFarthest(const double* points, vtkIdType count, int axis)
{
  std::vector<double> values(static_cast<std::size_t>(count));
  for (vtkIdType i = 0; i < count; ++i)
  {
    values[i] = points[3 * i + axis];
  }
  auto middle = values.begin() + (count - 1) / 2;
  std::nth_element(values.begin(), middle, values.end());
  const double median = *middle;
  vtkIdType farthest = 0;
  for (vtkIdType i = 1; i < count; ++i)
  {
    if (std::abs(points[3 * i + axis] - median) > std::abs(points[3 * farthest + axis] - median))
    {
      farthest = i;
    }
  }
  return farthest;
}

vtkNew<vtkStringArray> MakeStrings(const char* name, const std::vector<std::string>& values)
{
  vtkNew<vtkStringArray> array;
  array->SetName(name);
  for (const std::string& value : values)
  {
    array->InsertNextValue(value);
  }
  return array;
}

// Returns the ids; if all are zero, in an array that takes no memory.
vtkSmartPointer<vtkIntArray> FinishIds(GrowingArray<vtkIntArray>& ids, const char* name)
{
  const vtkIdType count = ids.GetSize();
  const int* values = ids.GetValues();
  if (std::all_of(values, values + count, [](int id) { return id == 0; }))
  {
    ids.Truncate(0);
    ids.Finish(1);
    return MakeZeroIds(name, count);
  }
  vtkIntArray* array = ids.Finish(1);
  array->SetName(name);
  return array;
}

std::string FormatNumbers(const char* format, double a, double b, double c = 0.0)
{
  char text[128];
  std::snprintf(text, sizeof(text), format, a, b, c);
  return text;
}

} // namespace

//------------------------------------------------------------------------------
void SceneMesh::AddPoint(double x, double y, double z)
{
  double* point = this->Points.Append(3);
  point[0] = x;
  point[1] = y;
  point[2] = z;
}

//------------------------------------------------------------------------------
void SceneMesh::AddTriangle(vtkTypeInt32 a, vtkTypeInt32 b, vtkTypeInt32 c, int material)
{
  vtkTypeInt32* corner = this->Corners.Append(3);
  corner[0] = a;
  corner[1] = b;
  corner[2] = c;
  *this->MaterialIds.Append(1) = material;
  if (!this->PartNames.empty())
  {
    *this->PartIds.Append(1) = static_cast<int>(this->PartNames.size()) - 1;
  }
}

//------------------------------------------------------------------------------
void SceneMesh::DropFlatTriangles(const std::string& path, TextReport& report)
{
  const vtkIdType count = this->MaterialIds.GetSize();
  const double* points = this->Points.GetValues();
  vtkTypeInt32* corners = this->Corners.GetValues();
  int* ids = this->MaterialIds.GetValues();
  float* textures =
    this->TextureCoordinates.GetSize() > 0 ? this->TextureCoordinates.GetValues() : nullptr;
  int* parts = this->PartIds.GetSize() > 0 ? this->PartIds.GetValues() : nullptr;
  this->IsUsed.assign(static_cast<std::size_t>(this->Points.GetSize() / 3), this->KeepsAll);
  if (this->KeepsAll)
  {
    return;
  }

  vtkIdType kept = 0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    const vtkTypeInt32* triangle = corners + 3 * i;
    const auto point = [points, triangle](int corner)
    { return points + 3 * static_cast<vtkIdType>(triangle[corner]); };
    if (IsFlat(point(0), point(1), point(2)))
    {
      continue;
    }
    for (int corner = 0; corner < 3; ++corner)
    {
      this->IsUsed[triangle[corner]] = 1;
      corners[3 * kept + corner] = triangle[corner];
    }
    if (textures)
    {
      std::copy_n(textures + 6 * i, 6, textures + 6 * kept);
    }
    if (parts)
    {
      parts[kept] = parts[i];
    }
    ids[kept++] = ids[i];
  }
  this->Corners.Truncate(3 * kept);
  this->TextureCoordinates.Truncate(textures ? 6 * kept : 0);
  this->MaterialIds.Truncate(kept);
  this->PartIds.Truncate(parts ? kept : 0);
  this->DroppedTriangles = count - kept;
  if (this->DroppedTriangles > 0)
  {
    report.Warn(path + ": dropped " + std::to_string(this->DroppedTriangles) + " of " +
      std::to_string(count) + " triangles, which have no area");
  }
}

//------------------------------------------------------------------------------
void SceneMesh::CheckExtent(const std::string& path, TextReport& report,
  const std::function<std::string(vtkIdType)>& findPlace)
{
  const double* points = this->Points.GetValues();
  const vtkIdType count = this->Points.GetSize() / 3;
  if (count == 0)
  {
    return;
  }
  double b[6];
  FindBounds(points, count, b);
  const double extents[3] = { b[1] - b[0], b[3] - b[2], b[5] - b[4] };
  const int axis = static_cast<int>(std::max_element(extents, extents + 3) - extents);
  if (extents[axis] <= LargestExtent)
  {
    return;
  }
  const vtkIdType vertex = FindFarthest(points, count, axis);
  const double* p = points + 3 * vertex;
  report.Warn((findPlace ? findPlace(vertex) : path + ": ") + "vertex " +
    std::to_string(vertex + 1) + FormatNumbers(" (%g, %g, %g)", p[0], p[1], p[2]) +
    " lies far from the others: the scene's extent is" + FormatNumbers(" x %g to %g,", b[0], b[1]) +
    FormatNumbers(" y %g to %g,", b[2], b[3]) + FormatNumbers(" z %g to %g m; ", b[4], b[5]) +
    (this->IsUsed[vertex] ? "correct the vertex" : "it is left out, as no face uses it"));
}

//------------------------------------------------------------------------------
void SceneMesh::DropUnusedPoints()
{
  const std::size_t count = this->IsUsed.size();
  double* points = this->Points.GetValues();
  if (std::all_of(
        this->IsUsed.begin(), this->IsUsed.end(), [](unsigned char used) { return used; }))
  {
    return;
  }
  std::vector<vtkTypeInt32> newIds(count);
  vtkTypeInt32 kept = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    newIds[i] = kept;
    std::copy_n(points + 3 * i, 3, points + 3 * static_cast<std::size_t>(kept));
    kept += this->IsUsed[i];
  }
  vtkTypeInt32* corners = this->Corners.GetValues();
  for (vtkIdType i = 0; i < this->Corners.GetSize(); ++i)
  {
    corners[i] = newIds[corners[i]];
  }
  this->Points.Truncate(3 * static_cast<vtkIdType>(kept));
}

//------------------------------------------------------------------------------
void SceneMesh::TurnUp()
{
  double* points = this->Points.GetValues();
  for (vtkIdType i = 0; i < this->Points.GetSize(); i += 3)
  {
    const double y = points[i + 1];
    points[i + 1] = -points[i + 2];
    points[i + 2] = y;
  }
}

//------------------------------------------------------------------------------
void SceneMesh::MoveTo(vtkPolyData* scene)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(VTK_DOUBLE);
  points->SetData(this->Points.Finish(3));

  const vtkIdType count = this->MaterialIds.GetSize();
  vtkNew<vtkTypeInt32Array> offsets;
  offsets->SetNumberOfValues(count + 1);
  for (vtkIdType i = 0; i <= count; ++i)
  {
    offsets->SetValue(i, static_cast<vtkTypeInt32>(3 * i));
  }
  vtkNew<vtkCellArray> triangles;
  triangles->SetData(offsets, this->Corners.Finish(1));

  const vtkSmartPointer<vtkIntArray> materialIds =
    FinishIds(this->MaterialIds, vtkHeliosArrayNames::MaterialIds);

  scene->SetPoints(points);
  scene->SetPolys(triangles);
  scene->GetCellData()->AddArray(materialIds);
  if (this->TextureCoordinates.GetSize() > 0)
  {
    vtkFloatArray* coordinates = this->TextureCoordinates.Finish(6);
    coordinates->SetName(vtkHeliosArrayNames::TextureCoordinates);
    scene->GetCellData()->AddArray(coordinates);
  }
  if (!this->Notes.empty())
  {
    scene->GetFieldData()->AddArray(MakeStrings(vtkHeliosArrayNames::Notes, this->Notes));
  }
  if (!this->PartNames.empty())
  {
    scene->GetCellData()->AddArray(FinishIds(this->PartIds, vtkHeliosArrayNames::PartIds));
    scene->GetFieldData()->AddArray(MakeStrings(vtkHeliosArrayNames::PartName, this->PartNames));
  }
  SetMaterials(scene, this->Materials);
}

} // namespace helios
