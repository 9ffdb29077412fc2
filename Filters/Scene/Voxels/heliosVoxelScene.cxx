// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosVoxelScene.h"

#include "heliosMaterialTable.h"
#include "vtkHeliosArrayNames.h"

#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

namespace names = vtkHeliosArrayNames;

namespace helios
{

namespace
{

MaterialTable MakeMaterials(int count)
{
  MaterialTable materials(static_cast<std::size_t>(count));
  for (int i = 0; count > 1 && i < count; ++i)
  {
    materials[static_cast<std::size_t>(i)].Name += '.' + std::to_string(i);
  }
  return materials;
}

/// Adds one number per triangle, from the id of its cell.
template <typename Function>
void AddIds(const char* name, const VoxelMesh& mesh, vtkPolyData* scene, Function&& getId)
{
  vtkNew<vtkIntArray> ids;
  ids->SetName(name);
  ids->SetNumberOfValues(mesh.GetNumberOfTriangles());
  int* id = ids->GetPointer(0);
  mesh.ForEachTriangle([&](std::size_t cell, int) { *id++ = static_cast<int>(getId(cell)); });
  scene->GetCellData()->AddArray(ids);
}

/// Makes three numbers per triangle; get(cell) is called once per cell, then side(value, side) per
/// triangle.
template <typename Get, typename Turn>
vtkSmartPointer<vtkFloatArray> MakeTriples(
  const char* name, const VoxelMesh& mesh, Get&& get, Turn&& turn)
{
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(mesh.GetNumberOfTriangles());
  float* to = array->GetPointer(0);
  std::size_t known = std::numeric_limits<std::size_t>::max();
  Vec3 value;
  mesh.ForEachTriangle(
    [&](std::size_t cell, int side)
    {
      value = cell == known ? value : get(cell);
      known = cell;
      const Vec3 triple = turn(value, side);
      to = std::copy_n(triple.GetData(), 3, to);
    });
  return array;
}

Vec3 GetFaceNormal(int side)
{
  Vec3 normal(0.0, 0.0, 0.0);
  normal[side / 2] = side % 2 == 1 ? 1.0 : -1.0;
  return normal;
}

} // namespace

void WriteVoxelScene(const VoxelGrid& grid, const std::vector<VoxelMap::Entry>& cells,
  const VoxelMesh& mesh, const VoxelSceneOptions& options, vtkPolyData* scene)
{
  mesh.Write(grid.GetOrigin(), grid.GetVoxelSize(), scene);
  const auto materials = static_cast<std::size_t>(options.NumberOfMaterials);
  AddIds(names::MaterialIds, mesh, scene, [=](std::size_t cell) { return cell % materials; });
  SetMaterials(scene, MakeMaterials(options.NumberOfMaterials));
  if (options.HasVoxelIds)
  {
    AddIds(names::VoxelIds, mesh, scene, [](std::size_t cell) { return cell; });
  }
  if (options.HasColors)
  {
    const auto get = [&](std::size_t cell) { return grid.GetColor(cells[cell].Id); };
    const auto same = [](const Vec3& color, int) { return color; };
    scene->GetCellData()->AddArray(MakeTriples(names::RGB, mesh, get, same));
  }
  const Vec3 none(0.0, 0.0, 0.0);
  if (options.HasNormals || !(options.DefaultNormal == none))
  {
    const auto get = [&](std::size_t cell)
    {
      const Vec3 normal = options.HasNormals ? grid.GetNormal(cells[cell].Id) : none;
      return normal == none ? options.DefaultNormal : normal;
    };
    const auto turn = [&](const Vec3& normal, int side)
    { return normal == none ? GetFaceNormal(side) : normal; };
    scene->GetCellData()->SetNormals(MakeTriples(names::Normals, mesh, get, turn));
  }
}

} // namespace helios
