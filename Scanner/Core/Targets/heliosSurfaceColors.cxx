// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSurfaceColors.h"

#include "vtkHeliosArrayNames.h"
#include "vtkHeliosScene.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>

namespace names = vtkHeliosArrayNames;

namespace helios
{

namespace
{

/// A cell array with a tuple for each triangle; null: none.
vtkDataArray* FindArray(vtkPolyData* mesh, const char* name, int components)
{
  vtkDataArray* array = mesh->GetCellData()->GetArray(name);
  const bool fits = array && array->GetNumberOfComponents() == components &&
    array->GetNumberOfTuples() == mesh->GetNumberOfCells();
  return fits ? array : nullptr;
}

/// The weights of the corners at the place of a triangle that is nearest to a point: none negative.
Vec3 GetWeights(const double corners[3][3], const Vec3& point)
{
  const Vec3 a(corners[0]);
  const Vec3 u = Vec3(corners[1]) - a;
  const Vec3 v = Vec3(corners[2]) - a;
  const Vec3 p = point - a;
  const double uu = u.Dot(u);
  const double uv = u.Dot(v);
  const double vv = v.Dot(v);
  const double area = uu * vv - uv * uv;
  const double s = area > 0.0 ? (vv * p.Dot(u) - uv * p.Dot(v)) / area : 0.0;
  const double t = area > 0.0 ? (uu * p.Dot(v) - uv * p.Dot(u)) / area : 0.0;
  const Vec3 weights(std::max(0.0, 1.0 - s - t), std::max(0.0, s), std::max(0.0, t));
  return (1.0 / (weights[0] + weights[1] + weights[2])) * weights;
}

float Clamp(double share)
{
  return static_cast<float>(std::min(1.0, std::max(0.0, share)));
}

/// The colour of a triangle; false: it has none.
bool GetOwnColor(vtkDataArray* colors, vtkIdType triangle, Rgb& color)
{
  if (!colors)
  {
    return false;
  }
  colors->GetTuple(triangle, color.data());
  const bool isReal = colors->GetDataType() == VTK_FLOAT || colors->GetDataType() == VTK_DOUBLE;
  const double scale = isReal ? 1.0 : 1.0 / colors->GetDataTypeMax();
  std::transform(
    color.begin(), color.end(), color.begin(), [scale](double value) { return scale * value; });
  return !std::isnan(color[0]);
}

} // namespace

//------------------------------------------------------------------------------
void SurfaceColors::Set(vtkPolyData* scene, const std::vector<vtkImageData*>& grids,
  const SceneGeometry* geometry, TextureStore& store, std::vector<std::string>& faults)
{
  this->Geometry = geometry;
  this->HasColors = false;
  this->Rows.clear();
  this->Prototypes.clear();
  this->Mesh = this->FindArrays(scene);
  if (auto* whole = vtkHeliosScene::SafeDownCast(scene))
  {
    for (int i = 0; i < whole->GetNumberOfPrototypes(); ++i)
    {
      auto* mesh = vtkPolyData::SafeDownCast(whole->GetPrototype(i));
      this->Prototypes.push_back(mesh ? this->FindArrays(mesh) : Arrays());
    }
  }
  this->AddMaterials(scene, store, faults);
  for (vtkImageData* grid : grids)
  {
    this->AddMaterials(grid, store, faults);
  }
}

//------------------------------------------------------------------------------
SurfaceColors::Arrays SurfaceColors::FindArrays(vtkPolyData* mesh)
{
  const Arrays arrays{ FindArray(mesh, names::RGB, 3),
    FindArray(mesh, names::TextureCoordinates, 6) };
  this->HasColors = this->HasColors || arrays.Colors;
  return arrays;
}

//------------------------------------------------------------------------------
void SurfaceColors::AddMaterials(
  vtkDataObject* data, TextureStore& store, std::vector<std::string>& faults)
{
  for (const Material& material : GetMaterials(data))
  {
    const std::string& path = material.Color.Texture;
    this->Rows.push_back({ material.Color, path.empty() ? nullptr : store.Get(path, faults) });
    this->HasColors = this->HasColors || material.Color.IsSet();
  }
}

//------------------------------------------------------------------------------
std::array<float, 3> SurfaceColors::Find(vtkIdType cell, int material, const Vec3& point) const
{
  const Row& row = this->Rows[static_cast<std::size_t>(material)];
  const bool isTriangle = this->Geometry && cell < this->Geometry->GetNumberOfTriangles();
  Rgb color{};
  if (row.Color.IsSet())
  {
    color = row.Color.Base;
  }
  if (isTriangle)
  {
    const SceneGeometry::Cell at = this->Geometry->Find(cell);
    const Arrays& arrays = at.Instance
      ? this->Prototypes[static_cast<std::size_t>(at.Instance->PrototypeId)]
      : this->Mesh;
    double place[2];
    if (!GetOwnColor(arrays.Colors, at.Triangle, color) && row.Image &&
      this->GetCoordinates(arrays, at.Triangle, cell, point, place))
    {
      const Rgb pixel = row.Image->Get(place[0], place[1]);
      std::transform(color.begin(), color.end(), pixel.begin(), color.begin(),
        [](double base, double share) { return base * share; });
    }
  }
  return { Clamp(color[0]), Clamp(color[1]), Clamp(color[2]) };
}

//------------------------------------------------------------------------------
/// The texture coordinates of a point of a triangle; false: it has none.
bool SurfaceColors::GetCoordinates(const Arrays& arrays, vtkIdType triangle, vtkIdType cell,
  const Vec3& point, double coordinates[2]) const
{
  if (!arrays.Coordinates)
  {
    return false;
  }
  double uv[6];
  arrays.Coordinates->GetTuple(triangle, uv);
  double corners[3][3];
  this->Geometry->GetCorners(cell, corners);
  const Vec3 weights = GetWeights(corners, point);
  for (int i = 0; i < 2; ++i)
  {
    coordinates[i] = weights[0] * uv[i] + weights[1] * uv[2 + i] + weights[2] * uv[4 + i];
  }
  return std::isfinite(coordinates[0]) && std::isfinite(coordinates[1]);
}

} // namespace helios
