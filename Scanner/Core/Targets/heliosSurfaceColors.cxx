// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSurfaceColors.h"

#include "vtkHeliosArrayNames.h"
#include "vtkHeliosScene.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>

namespace names = vtkHeliosArrayNames;

namespace helios
{

namespace
{

/// Returns a cell array with a tuple for each triangle; null: none.
vtkDataArray* FindArray(vtkPolyData* mesh, const char* name, int components)
{
  vtkDataArray* array = mesh->GetCellData()->GetArray(name);
  const bool fits = array && array->GetNumberOfComponents() == components &&
    array->GetNumberOfTuples() == mesh->GetNumberOfCells();
  return fits ? array : nullptr;
}

float Clamp(double share)
{
  return static_cast<float>(std::min(1.0, std::max(0.0, share)));
}

/// Returns the factor by which the colours of an array become shares.
double GetScale(vtkDataArray* colors)
{
  const bool isReal = colors->GetDataType() == VTK_FLOAT || colors->GetDataType() == VTK_DOUBLE;
  return isReal ? 1.0 : 1.0 / colors->GetDataTypeMax();
}

/// Returns the colours of points by the corners of triangles; null: there are none.
vtkSmartPointer<vtkDataArray> MakeCornerColors(vtkPolyData* mesh)
{
  vtkDataArray* colors = mesh->GetPointData()->GetArray(names::RGB);
  if (!colors || colors->GetNumberOfComponents() != 3 || mesh->GetNumberOfPolys() == 0)
  {
    return nullptr;
  }
  vtkNew<vtkFloatArray> corners;
  corners->SetNumberOfComponents(9);
  corners->SetNumberOfTuples(mesh->GetNumberOfPolys());
  vtkNew<vtkIdList> ids;
  const double scale = GetScale(colors);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPolys(); ++i)
  {
    mesh->GetPolys()->GetCellAtId(i, ids);
    for (int k = 0; k < 9; ++k)
    {
      corners->SetTypedComponent(
        i, k, static_cast<float>(scale * colors->GetComponent(ids->GetId(k / 3), k % 3)));
    }
  }
  return corners;
}

/// Returns the mean of values at the corners of a triangle, u v of a texture or red green blue.
template <std::size_t Count>
std::array<double, Count> Interpolate(
  vtkDataArray* corners, vtkIdType triangle, const Vec3& weights)
{
  std::array<double, 3 * Count> values;
  corners->GetTuple(triangle, values.data());
  std::array<double, Count> mean{};
  for (std::size_t i = 0; i < 3 * Count; ++i)
  {
    mean[i % Count] += weights[static_cast<int>(i / Count)] * values[i];
  }
  return mean;
}

} // namespace

//------------------------------------------------------------------------------
void SurfaceColors::Set(vtkPolyData* scene, const std::vector<vtkImageData*>& grids,
  const SceneGeometry* geometry, const TextureStore& store)
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
  this->AddMaterials(scene, store);
  for (vtkImageData* grid : grids)
  {
    this->AddMaterials(grid, store);
  }
}

//------------------------------------------------------------------------------
SurfaceColors::Arrays SurfaceColors::FindArrays(vtkPolyData* mesh)
{
  const Arrays arrays{ FindArray(mesh, names::RGB, 3), MakeCornerColors(mesh),
    FindArray(mesh, names::TextureCoordinates, 6) };
  this->HasColors = this->HasColors || arrays.Colors || arrays.CornerColors;
  return arrays;
}

//------------------------------------------------------------------------------
void SurfaceColors::AddMaterials(vtkDataObject* data, const TextureStore& store)
{
  for (const Material& material : GetMaterials(data))
  {
    const std::string& path = material.Color.Texture;
    this->Rows.push_back({ material.Color, store.Find(path) });
    this->HasColors = this->HasColors || material.Color.IsSet();
  }
}

//------------------------------------------------------------------------------
std::array<float, 3> SurfaceColors::Find(vtkIdType cell, int material, const Vec3& point) const
{
  const Row& row = this->Rows[static_cast<std::size_t>(material)];
  Rgb color{};
  if (row.Color.IsSet())
  {
    color = row.Color.Base;
  }
  if (this->Geometry && cell < this->Geometry->GetNumberOfTriangles())
  {
    color = this->FindOnTriangle(cell, point, row.Image.get(), color);
  }
  return { Clamp(color[0]), Clamp(color[1]), Clamp(color[2]) };
}

//------------------------------------------------------------------------------
/// Returns the colour of a point of a triangle, whose material has a base colour and perhaps a
/// texture.
Rgb SurfaceColors::FindOnTriangle(
  vtkIdType cell, const Vec3& point, const Texture* image, const Rgb& base) const
{
  const SceneGeometry::Cell at = this->Geometry->Find(cell);
  const Arrays& arrays =
    at.Instance ? this->Prototypes[static_cast<std::size_t>(at.Instance->PrototypeId)] : this->Mesh;
  Rgb color = base;
  if (arrays.Colors)
  {
    arrays.Colors->GetTuple(at.Triangle, color.data());
    const double scale = GetScale(arrays.Colors);
    color = { scale * color[0], scale * color[1], scale * color[2] };
    if (!std::isnan(color[0]))
    {
      return color;
    }
  }
  if (arrays.CornerColors)
  {
    return Interpolate<3>(arrays.CornerColors, at.Triangle, this->FindWeights(cell, point));
  }
  if (!image || !arrays.Coordinates)
  {
    return base;
  }
  const auto [u, v] =
    Interpolate<2>(arrays.Coordinates, at.Triangle, this->FindWeights(cell, point));
  if (!std::isfinite(u) || !std::isfinite(v))
  {
    return base;
  }
  const Rgb pixel = image->Get(u, v);
  return { base[0] * pixel[0], base[1] * pixel[1], base[2] * pixel[2] };
}

//------------------------------------------------------------------------------
/// Computes the weights of the corners of a triangle at a point.
Vec3 SurfaceColors::FindWeights(vtkIdType cell, const Vec3& point) const
{
  double corners[3][3];
  this->Geometry->GetCorners(cell, corners);
  return GetTriangleWeights(corners, point);
}

} // namespace helios
