// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Triangles of a scene that are drawn together: the static or the moving ones.

#ifndef heliosSceneLayer_h
#define heliosSceneLayer_h

#include "heliosColorMaps.h"
#include "heliosPose.h"
#include "vtkHeliosRayCaster.h"

#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <functional>
#include <vector>

class vtkActor;
class vtkPolyData;
class vtkPlaneCollection;
class vtkPolyDataMapper;
class vtkProperty;
class vtkRenderer;

namespace helios::viewer
{

/**
 * Renderer coordinates are relative to the origin, in floats: large coordinates do not jitter. The
 * mesh's cells are shared, its points copied.
 */
class SceneLayer
{
public:
  /// The renderer must outlive the layer.
  SceneLayer(vtkRenderer* renderer, vtkProperty* property);
  ~SceneLayer();
  SceneLayer(const SceneLayer&) = delete;
  void operator=(const SceneLayer&) = delete;

  /// Sets the triangles (null: none) and their cell ids in the scene; empty: the same.
  void SetMesh(vtkPolyData* mesh, const std::vector<vtkIdType>& cells = {});

  /// Returns the mesh; null: not set.
  vtkPolyData* GetMesh() const { return this->Mesh; }

  /// Replaces the points of the same triangles.
  void Move(vtkPolyData* mesh);

  /// Builds the drawn mesh, relative to an origin [m]; smooth: over edges below 40 degrees.
  void Draw(const Vec3& origin, bool smooth);

  /// Colours the cells by their ids in the scene.
  void Color(const std::function<Rgb(vtkIdType)>& getColor);

  void SetVisible(bool on);
  bool IsVisible() const { return this->Visible; }

  /// Maximum number of triangles drawn while the camera moves.
  static constexpr vtkIdType MaximumWhileMoving = 200000;

  /// Sets whether the camera moves: larger meshes are then drawn coarsely. Default: off.
  void SetInteracting(bool on);
  bool IsCoarse() const;

  /// Draws only what is inside of planes; null: all.
  void SetClippingPlanes(vtkPlaneCollection* planes);

  /// Intersects a ray: the cell id in the scene, -1: none; and the normal.
  vtkHeliosHit Pick(const vtkHeliosRay& ray, Vec3& normal);

private:
  vtkIdType GetSceneCell(vtkIdType cell) const;
  void DropCoarse();
  void ShowWhatIsDue();

  vtkRenderer* Renderer;
  vtkSmartPointer<vtkPolyData> Mesh;
  std::vector<vtkIdType> Cells;
  Vec3 Origin{ 0.0, 0.0, 0.0 };
  bool Smooth = false;
  bool Visible = false;
  bool Interacting = false;
  vtkSmartPointer<vtkPolyData> Drawn;
  vtkSmartPointer<vtkPolyData> Coarse; // built on first use
  vtkNew<vtkActor> Actor;
  vtkNew<vtkPolyDataMapper> Mapper;
  vtkNew<vtkActor> CoarseActor; // separate: avoids repeated uploads to the GPU
  vtkNew<vtkPolyDataMapper> CoarseMapper;
  vtkSmartPointer<vtkHeliosRayCaster> Caster; // built at the first pick
};

} // namespace helios::viewer

#endif
