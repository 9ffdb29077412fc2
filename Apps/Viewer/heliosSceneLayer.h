// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Triangles of a scene that are drawn together: those that rest, or those that move.

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
class vtkPolyDataMapper;
class vtkProperty;
class vtkRenderer;

namespace helios
{

/**
 * The renderer's coordinates are the world's less the origin, in floats: large coordinates do not
 * tremble. The mesh's cells are shared, its points copied.
 */
class SceneLayer
{
public:
  /// The renderer must outlive the layer.
  SceneLayer(vtkRenderer* renderer, vtkProperty* property);
  ~SceneLayer();
  SceneLayer(const SceneLayer&) = delete;
  void operator=(const SceneLayer&) = delete;

  /// Takes triangles (null: none), and what they are called in the scene; empty: as here.
  void SetMesh(vtkPolyData* mesh, const std::vector<vtkIdType>& cells = {});

  /// Null: there is none.
  vtkPolyData* GetMesh() const { return this->Mesh; }

  /// The same triangles with other points.
  void Move(vtkPolyData* mesh);

  /// Makes what is drawn, less an origin [m]; smooth: over edges of less than 40 degrees.
  void Draw(const Vec3& origin, bool smooth);

  /// Colours the cells by what they are called in the scene.
  void Color(const std::function<Rgb(vtkIdType)>& getColor);

  void SetVisible(bool on);
  bool IsVisible() const { return this->Visible; }

  /// Triangles that are drawn at most while the camera moves.
  static constexpr vtkIdType MostWhileMoving = 200000;

  /// While the camera moves a mesh of more is drawn coarsely. Default: off.
  void SetInteracting(bool on);
  bool IsCoarse() const;

  /// What a ray meets: the cell as it is called in the scene, -1: none; and where its normal goes.
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
  vtkSmartPointer<vtkPolyData> Coarse; // made when it is first due
  vtkNew<vtkActor> Actor;
  vtkNew<vtkPolyDataMapper> Mapper;
  vtkNew<vtkActor> CoarseActor; // of its own: neither is sent to the graphics again and again
  vtkNew<vtkPolyDataMapper> CoarseMapper;
  vtkSmartPointer<vtkHeliosRayCaster> Caster; // made with the first pick
};

} // namespace helios

#endif
