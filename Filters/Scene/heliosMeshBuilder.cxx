// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosMeshBuilder.h"

#include "vtkHeliosArrayNames.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>

namespace helios
{

MeshBuilder::MeshBuilder()
{
  this->Points->SetNumberOfComponents(3);
  this->MaterialIds->SetName(vtkHeliosArrayNames::MaterialIds);
}

void MeshBuilder::Reserve(vtkIdType points, vtkIdType triangles)
{
  this->Points->Resize(points);
  this->Corners->Resize(3 * triangles);
  this->MaterialIds->Resize(triangles);
}

void MeshBuilder::SetFrame(const Pose& frame)
{
  this->Position = frame.Position;
  this->Orientation = Rotation(frame.Orientation);
}

void MeshBuilder::SetMaterial(const Material& material)
{
  const auto known = std::find(this->Materials.begin(), this->Materials.end(), material);
  this->MaterialId = static_cast<int>(known - this->Materials.begin());
  if (known == this->Materials.end())
  {
    this->Materials.push_back(material);
  }
}

vtkTypeInt32 MeshBuilder::AddPoint(const Vec3& point)
{
  const Vec3 placed = this->Position + this->Orientation * point;
  return static_cast<vtkTypeInt32>(this->Points->InsertNextTypedTuple(placed.GetData()));
}

void MeshBuilder::AddTriangle(vtkTypeInt32 a, vtkTypeInt32 b, vtkTypeInt32 c)
{
  this->Corners->InsertNextValue(a);
  this->Corners->InsertNextValue(b);
  this->Corners->InsertNextValue(c);
  this->MaterialIds->InsertNextValue(this->MaterialId);
}

void MeshBuilder::AddQuad(vtkTypeInt32 a, vtkTypeInt32 b, vtkTypeInt32 c, vtkTypeInt32 d)
{
  this->AddTriangle(a, b, c);
  this->AddTriangle(a, c, d);
}

void MeshBuilder::AddPolygon(const std::vector<vtkTypeInt32>& corners)
{
  for (std::size_t i = 2; i < corners.size(); ++i)
  {
    this->AddTriangle(corners[0], corners[i - 1], corners[i]);
  }
}

void MeshBuilder::AddBox(const Vec3& low, const Vec3& high)
{
  this->AddPrism(
    { { low[0], low[2] }, { high[0], low[2] }, { high[0], high[2] }, { low[0], high[2] } }, low[1],
    high[1]);
}

void MeshBuilder::AddPrism(const std::vector<vtkVector2d>& outline, double yLow, double yHigh)
{
  std::vector<vtkTypeInt32> front;
  std::vector<vtkTypeInt32> back;
  for (const vtkVector2d& corner : outline)
  {
    front.push_back(this->AddPoint({ corner[0], yLow, corner[1] }));
    back.push_back(this->AddPoint({ corner[0], yHigh, corner[1] }));
  }
  const std::size_t count = outline.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::size_t next = (i + 1) % count;
    this->AddQuad(front[i], back[i], back[next], front[next]);
  }
  this->AddPolygon(front);
  std::reverse(back.begin(), back.end());
  this->AddPolygon(back);
}

void MeshBuilder::Finish(vtkPolyData* scene, const double offset[3])
{
  double* coordinates = this->Points->GetPointer(0);
  for (vtkIdType i = 0; i < this->Points->GetNumberOfValues(); ++i)
  {
    coordinates[i] += offset[i % 3];
  }
  this->Points->Squeeze();
  this->Corners->Squeeze();
  this->MaterialIds->Squeeze();

  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetData(this->Points);
  vtkNew<vtkTypeInt32Array> offsets;
  offsets->SetNumberOfValues(this->GetNumberOfTriangles() + 1);
  for (vtkIdType i = 0; i < offsets->GetNumberOfValues(); ++i)
  {
    offsets->SetValue(i, static_cast<vtkTypeInt32>(3 * i));
  }
  vtkNew<vtkCellArray> polys;
  polys->SetData(offsets, this->Corners);
  scene->SetPoints(points);
  scene->SetPolys(polys);
  scene->GetCellData()->AddArray(this->MaterialIds);
  SetMaterials(scene, this->Materials);
}

} // namespace helios
