// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosFlatScene.h"

#include "heliosHeightCache.h"
#include "heliosHeightField.h"
#include "heliosMemoryCheck.h"
#include "heliosRasterMesh.h"
#include "heliosSceneGeometry.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosScene.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTypeInt32Array.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <string>

namespace names = vtkHeliosArrayNames;

namespace helios
{

namespace
{

/// Makes a scene with meshes in place of its rasters.
Status MakeMeshes(vtkHeliosScene* scene, vtkHeliosScene* meshes)
{
  meshes->vtkPolyData::ShallowCopy(scene);
  meshes->SetInstances(scene->GetInstances());
  Status status;
  for (int i = 0; status.IsOk() && i < scene->GetNumberOfPrototypes(); ++i)
  {
    vtkSmartPointer<vtkDataSet> prototype = scene->GetPrototype(i);
    if (auto* raster = vtkImageData::SafeDownCast(prototype))
    {
      vtkNew<vtkPolyData> mesh;
      std::shared_ptr<const HeightField> field;
      status = GetHeightField(raster, field);
      const auto count = static_cast<double>(field->GetNumberOfTriangles());
      status =
        status.IsOk() ? CheckMemory("triangles of a raster", count, BytesPerTriangle) : status;
      status = status.IsOk() ? MakeRasterMesh(field->GetGrid(), mesh) : status;
      status = status.IsOk()
        ? status
        : Status::Error("prototype " + std::to_string(i) + ": " + status.Message());
      prototype = mesh;
    }
    meshes->AddPrototype(prototype);
  }
  return status;
}

/// Makes the mesh of all triangles of a scene without rasters.
class Flattener
{
public:
  explicit Flattener(vtkHeliosScene* scene)
    : Scene(scene)
  {
  }

  Status Run(vtkPolyData* mesh)
  {
    Status status = this->Geometry.Set(this->Scene);
    status = status.IsOk() ? this->CheckSize() : status;
    if (status.IsOk())
    {
      mesh->Initialize();
      mesh->SetPoints(this->MakePoints());
      mesh->SetPolys(this->MakeCells());
      mesh->GetFieldData()->PassData(this->Scene->GetFieldData());
      mesh->GetCellData()->AddArray(this->MakeMaterialIds());
      mesh->GetCellData()->AddArray(this->MakePartIds());
      this->AddNormals(mesh);
    }
    return status;
  }

private:
  Status CheckSize()
  {
    this->PointCount = this->Geometry.GetMesh().GetNumberOfPoints();
    for (const SceneInstance& instance : this->Geometry.GetInstances())
    {
      this->PointCount += this->Geometry.GetPrototype(instance).GetMesh().GetNumberOfPoints();
    }
    const vtkIdType count = this->Geometry.GetNumberOfTriangles();
    if (std::max(this->PointCount, 3 * count) > std::numeric_limits<vtkTypeInt32>::max())
    {
      return Status::Error("the scene has " + std::to_string(count) + " triangles in " +
        std::to_string(this->Geometry.GetInstances().size()) +
        " instances, too many for one mesh (2^31 points or corners); use the ray caster \"beam\", "
        "which does not copy them, or a part of the scene");
    }
    return CheckMemory("triangles of all instances", static_cast<double>(count), BytesPerTriangle);
  }

  vtkSmartPointer<vtkPoints> MakePoints() const
  {
    vtkNew<vtkDoubleArray> all;
    all->SetNumberOfComponents(3);
    all->SetNumberOfTuples(this->PointCount);
    const TriangleMesh& mesh = this->Geometry.GetMesh();
    double* to = std::copy_n(mesh.GetPoints(), 3 * mesh.GetNumberOfPoints(), all->GetPointer(0));
    for (const SceneInstance& instance : this->Geometry.GetInstances())
    {
      const TriangleMesh& prototype = this->Geometry.GetPrototype(instance).GetMesh();
      for (vtkIdType i = 0; i < prototype.GetNumberOfPoints(); ++i, to += 3)
      {
        instance.Place.Apply(prototype.GetPoints() + 3 * i, to);
      }
    }
    auto points = vtkSmartPointer<vtkPoints>::New();
    points->SetData(all);
    return points;
  }

  vtkSmartPointer<vtkCellArray> MakeCells() const
  {
    const vtkIdType count = this->Geometry.GetNumberOfTriangles();
    vtkNew<vtkTypeInt32Array> offsets, corners;
    offsets->SetNumberOfValues(count + 1);
    for (vtkIdType i = 0; i <= count; ++i)
    {
      offsets->SetValue(i, static_cast<vtkTypeInt32>(3 * i));
    }
    corners->SetNumberOfValues(3 * count);
    vtkTypeInt32* to = corners->GetPointer(0);
    const TriangleMesh& mesh = this->Geometry.GetMesh();
    const auto add = [&to](
                       const TriangleMesh& from, vtkIdType begin, vtkIdType end, vtkIdType first)
    {
      to = std::transform(from.GetCorners() + 3 * begin, from.GetCorners() + 3 * end, to,
        [first](vtkTypeInt32 corner) { return static_cast<vtkTypeInt32>(corner + first); });
    };
    vtkIdType done = 0; // triangles of the mesh come first
    vtkIdType firstPoint = mesh.GetNumberOfPoints();
    for (const SceneInstance& instance : this->Geometry.GetInstances())
    {
      const TriangleMesh& prototype = this->Geometry.GetPrototype(instance).GetMesh();
      add(mesh, done, instance.CellsBefore, 0);
      add(prototype, 0, prototype.GetNumberOfTriangles(), firstPoint);
      done = instance.CellsBefore;
      firstPoint += prototype.GetNumberOfPoints();
    }
    add(mesh, done, mesh.GetNumberOfTriangles(), 0);
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    cells->SetData(offsets, corners);
    return cells;
  }

  /// Returns the mesh of a cell, with its own cell.
  vtkDataSet* GetData(const SceneGeometry::Cell& cell) const
  {
    return cell.Instance ? this->Scene->GetPrototype(cell.Instance->PrototypeId) : this->Scene;
  }

  template <typename GetT>
  vtkSmartPointer<vtkIntArray> MakeIds(const char* name, GetT get) const
  {
    auto ids = vtkSmartPointer<vtkIntArray>::New();
    ids->SetName(name);
    ids->SetNumberOfValues(this->Geometry.GetNumberOfTriangles());
    for (vtkIdType i = 0; i < ids->GetNumberOfValues(); ++i)
    {
      ids->SetValue(i, get(this->Geometry.Find(i)));
    }
    return ids;
  }

  static int GetId(vtkDataSet* data, const char* name, vtkIdType cell)
  {
    vtkDataArray* ids = data->GetCellData()->GetArray(name);
    return ids && cell < ids->GetNumberOfTuples() ? static_cast<int>(ids->GetComponent(cell, 0))
                                                  : 0;
  }

  vtkSmartPointer<vtkIntArray> MakeMaterialIds() const
  {
    return this->MakeIds(names::MaterialIds,
      [this](const SceneGeometry::Cell& cell)
      {
        return cell.Instance && cell.Instance->Material >= 0
          ? cell.Instance->Material
          : GetId(this->GetData(cell), names::MaterialIds, cell.Triangle);
      });
  }

  vtkSmartPointer<vtkIntArray> MakePartIds() const
  {
    return this->MakeIds(names::PartIds,
      [this](const SceneGeometry::Cell& cell)
      {
        return cell.Instance ? cell.Instance->Part
                             : GetId(this->Scene, names::PartIds, cell.Triangle);
      });
  }

  bool HasNormals() const
  {
    bool has = this->Scene->GetCellData()->GetArray(names::Normals);
    for (int i = 0; i < this->Scene->GetNumberOfPrototypes(); ++i)
    {
      has = has || this->Scene->GetPrototype(i)->GetCellData()->GetArray(names::Normals);
    }
    return has;
  }

  void AddNormals(vtkPolyData* mesh) const
  {
    if (!this->HasNormals())
    {
      return;
    }
    vtkNew<vtkFloatArray> normals;
    normals->SetName(names::Normals);
    normals->SetNumberOfComponents(3);
    normals->SetNumberOfTuples(this->Geometry.GetNumberOfTriangles());
    normals->Fill(0.0);
    for (vtkIdType i = 0; i < normals->GetNumberOfTuples(); ++i)
    {
      const SceneGeometry::Cell cell = this->Geometry.Find(i);
      vtkDataArray* from = this->GetData(cell)->GetCellData()->GetArray(names::Normals);
      if (from && cell.Triangle < from->GetNumberOfTuples())
      {
        const Vec3 normal(from->GetTuple3(cell.Triangle));
        const Vec3 turned = cell.Instance ? cell.Instance->Place.Rotate(normal) : normal;
        normals->SetTuple(i, turned.GetData());
      }
    }
    mesh->GetCellData()->SetNormals(normals);
  }

  vtkHeliosScene* Scene;
  SceneGeometry Geometry;
  vtkIdType PointCount = 0;
};

} // namespace

//------------------------------------------------------------------------------
Status FlattenScene(vtkHeliosScene* scene, vtkPolyData* mesh)
{
  vtkNew<vtkHeliosScene> meshes;
  const Status status = MakeMeshes(scene, meshes);
  return status.IsOk() ? Flattener(meshes).Run(mesh) : status;
}

//------------------------------------------------------------------------------
Status GetFlatScene(vtkPolyData* scene, vtkSmartPointer<vtkPolyData>& mesh)
{
  mesh = scene;
  if (!vtkHeliosScene::HasInstances(scene))
  {
    return {};
  }
  mesh = vtkSmartPointer<vtkPolyData>::New();
  return FlattenScene(vtkHeliosScene::SafeDownCast(scene), mesh);
}

} // namespace helios
