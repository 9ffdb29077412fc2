// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The triangles of a scene: of its mesh, and of prototypes at instances.

#ifndef heliosSceneGeometry_h
#define heliosSceneGeometry_h

#include "heliosInstanceMotion.h"
#include "heliosPose.h"
#include "heliosPrototype.h"
#include "heliosSimilarity.h"
#include "heliosStatus.h"
#include "heliosTriangleMesh.h"
#include "vtkHeliosFiltersCoreModule.h" // For export macro

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <memory>
#include <utility>
#include <vector>

class vtkHeliosScene;

namespace helios
{

/// A prototype at a place.
struct SceneInstance
{
  Similarity Place;
  int PrototypeId = 0;
  int Tree = 0; ///< number of its tree: the prototype's, or one of its own, of a mesh that deforms
  int Part = 0;
  int Material = -1;                ///< material of all triangles; -1: materials of the prototype
  int Motion = -1;                  ///< number of its motion; -1: at rest
  vtkIdType FirstCell = 0;          ///< the cell id of its first triangle
  vtkIdType CellsBefore = 0;        ///< triangles of the mesh with lower cell ids
  const MeshShape* Shape = nullptr; ///< shape of a mesh that deforms; null: the prototype's

  /// Computes the corners of a triangle of the prototype in the scene.
  void GetCorners(const Prototype& prototype, vtkIdType triangle, double corners[3][3]) const
  {
    this->Shape ? this->GetShapeCorners(prototype, triangle, corners)
                : prototype.GetCorners(triangle, corners);
    for (int corner = 0; corner < 3; ++corner)
    {
      this->Place.Apply(corners[corner], corners[corner]);
    }
  }

  /// Computes the corners of a triangle of a mesh that deforms, in the frame of the prototype.
  void GetShapeCorners(const Prototype& prototype, vtkIdType triangle, double corners[3][3]) const
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      this->Shape->GetPoint(
        prototype.GetMesh().GetCorners()[3 * triangle + corner], corners[corner]);
    }
  }
};

/// The instances that move, where they are at a moment: each is moved once it is used. One per
/// thread.
class VTKHELIOSFILTERSCORE_EXPORT MovedInstances
{
public:
  explicit MovedInstances(std::shared_ptr<const InstanceMotions> motions);

  void MoveTo(const SceneMoment& moment)
  {
    this->Moment = moment;
    ++this->Move;
  }
  const SceneMoment& GetMoment() const { return this->Moment; }
  const std::shared_ptr<const InstanceMotions>& GetMotions() const { return this->Motions; }

  /// Returns a moving instance at the moment.
  const SceneInstance& Get(const SceneInstance& atRest)
  {
    Slot& slot = this->Slots[static_cast<std::size_t>(atRest.Motion)];
    if (slot.Move != this->Move)
    {
      this->Fill(slot, atRest);
      slot.Move = this->Move;
      slot.Track->Move(this->Moment, slot.Instance.Place);
      slot.Follower ? this->Follow(slot) : void();
    }
    return slot.Instance;
  }

  /// Sets what is fitted to the shape of an instance with frames, before it is used; and its tree.
  void SetFollower(const SceneInstance& instance, std::unique_ptr<ShapeFollower> follower, int tree)
  {
    Slot& slot = this->Slots[static_cast<std::size_t>(instance.Motion)];
    this->Fill(slot, instance);
    slot.Follower = std::move(follower);
    slot.Instance.Tree = tree;
    slot.Instance.Shape = &slot.Shape;
  }

  /// Returns the shape of a moving instance, which is set once that is used.
  const MeshShape& GetShape(const SceneInstance& instance) const
  {
    return this->Slots[static_cast<std::size_t>(instance.Motion)].Shape;
  }

  /// Returns the track of a moving instance.
  InstanceTrack& GetTrack(const SceneInstance& instance)
  {
    Slot& slot = this->Slots[static_cast<std::size_t>(instance.Motion)];
    this->Fill(slot, instance);
    return *slot.Track;
  }

private:
  struct Slot
  {
    SceneInstance Instance;
    std::unique_ptr<InstanceTrack> Track; ///< null: not used yet
    vtkTypeUInt64 Move = 0;               ///< move for which its place was set
    MeshShape Shape;
    std::unique_ptr<ShapeFollower> Follower; ///< null: it is rigid
  };
  void Fill(Slot& slot, const SceneInstance& instance) const
  {
    if (!slot.Track)
    {
      slot.Instance = instance;
      slot.Track = this->Motions->MakeTrack(instance.Motion);
    }
  }

  void Follow(Slot& slot) const
  {
    slot.Track->FindShape(this->Moment, slot.Shape);
    slot.Follower->Follow();
  }

  std::shared_ptr<const InstanceMotions> Motions;
  std::vector<Slot> Slots; ///< by number of motion
  SceneMoment Moment;
  vtkTypeUInt64 Move = 1;
};

/**
 * Cell ids count all triangles, 64-bit; the ids of an instance are consecutive. Corners of
 * instances equal the corners of a copy of the prototype moved by vtkHeliosSceneTransform. Copies
 * share the triangles.
 */
class VTKHELIOSFILTERSCORE_EXPORT SceneGeometry
{
public:
  /**
   * Sets a scene, which may be a vtkHeliosScene, and keeps references. Errors: see TriangleMesh and
   * HeightField; and instances whose values are invalid.
   */
  Status Set(vtkPolyData* scene);

  vtkPolyData* GetScene() const { return this->Scene; }

  /// Returns the same scene, whose instances move. One per thread.
  SceneGeometry MakeMoving(const std::shared_ptr<const InstanceMotions>& motions) const;

  /// Returns the moving instances; null: all are at rest.
  MovedInstances* GetMoved() const { return this->Moved.get(); }

  /// Returns the triangles that are no instance's; may be empty.
  const TriangleMesh& GetMesh() const { return this->Shared->Mesh; }
  const std::vector<Prototype>& GetPrototypes() const { return this->Shared->Prototypes; }
  const Prototype& GetPrototype(const SceneInstance& instance) const
  {
    return this->Shared->Prototypes[static_cast<std::size_t>(instance.PrototypeId)];
  }

  /// Returns the instances, all at rest.
  const std::vector<SceneInstance>& GetInstances() const { return this->Shared->Instances; }

  /// Returns an instance, moved to where it is.
  const SceneInstance& GetInstance(std::size_t number) const
  {
    return this->Place(this->Shared->Instances[number]);
  }

  vtkIdType GetNumberOfTriangles() const { return this->Shared->NumberOfTriangles; }

  /// Where the triangle of a cell is stored.
  struct Cell
  {
    const SceneInstance* Instance; ///< null: in the mesh
    vtkIdType Triangle;
  };
  Cell Find(vtkIdType cell) const
  {
    return this->GetInstances().empty() ? Cell{ nullptr, cell } : this->FindInstance(cell);
  }

  /// Returns the cell id of a triangle of the mesh.
  vtkIdType GetCell(vtkIdType triangle) const
  {
    return this->GetInstances().empty() ? triangle : this->CountCells(triangle);
  }

  void GetCorners(vtkIdType cell, double corners[3][3]) const;

  /// Returns the unit normal of a cell, see TriangleMesh::GetNormal().
  Vec3 GetNormal(vtkIdType cell) const;

  /// Computes a box that contains all corners, to rounding: x0 x1 y0 y1 z0 z1. Tight for the mesh.
  void GetBounds(double bounds[6]) const;

  /// Computes the box of an instance.
  void GetBounds(const SceneInstance& instance, double bounds[6]) const;

  /// Bytes held by this object in addition to the scene.
  std::size_t GetMemorySize() const;

private:
  /// The triangles and instances, which do not change.
  struct Content
  {
    TriangleMesh Mesh;
    std::vector<Prototype> Prototypes;
    std::vector<SceneInstance> Instances;
    vtkIdType NumberOfTriangles = 0;
  };

  const SceneInstance& Place(const SceneInstance& instance) const
  {
    return this->Moved && instance.Motion >= 0 ? this->Moved->Get(instance) : instance;
  }
  Status AddPrototypes(vtkHeliosScene* scene);
  Status AddInstances(vtkPolyData* instances);
  Status SetCells(vtkPolyData* instances);
  Cell FindInstance(vtkIdType cell) const;
  vtkIdType CountCells(vtkIdType triangle) const;

  vtkSmartPointer<vtkPolyData> Scene;
  std::shared_ptr<Content> Shared = std::make_shared<Content>();
  std::shared_ptr<MovedInstances> Moved; ///< null: all are at rest
};

} // namespace helios

#endif
