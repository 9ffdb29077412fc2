// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Draws the mesh of a scene, and picks from it at a pixel.

#ifndef heliosSceneView_h
#define heliosSceneView_h

#include "heliosInstanceLayer.h"
#include "heliosMaterialTable.h"
#include "heliosPose.h"
#include "heliosSceneGeometry.h"
#include "heliosSceneLayer.h"
#include "heliosSlab.h"
#include "heliosStatus.h"

#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

class vtkActor;
class vtkImageData;
class vtkPolyData;
class vtkPolyDataMapper;
class vtkProperty;
class vtkRenderer;

namespace helios
{
class SceneCells;
}

namespace helios::viewer
{

/// A point on the scene.
struct ScenePick
{
  Vec3 Position; ///< [m], world frame
  Vec3 Normal;   ///< unit, towards the camera
  vtkIdType Cell = -1;
  int Part = -1;         ///< -1: the scene has no parts
  int Material = -1;     ///< row of the materials
  bool IsGround = false; ///< the material is ground
  std::string PartName;
  std::string MaterialName;
};

/**
 * Draws triangles with the optional arrays MaterialIds, PartIds and the material columns; for a
 * vtkHeliosScene also its instances.
 */
class SceneView
{
public:
  enum class Coloring
  {
    ByMaterial,
    ByPart
  };

  /// Draws with a renderer, which must outlive the view.
  explicit SceneView(vtkRenderer* renderer);
  ~SceneView();
  SceneView(const SceneView&) = delete;
  void operator=(const SceneView&) = delete;

  /// Sets the origin of the renderer's coordinates [m]. Default: 0. Scenes may already be shown.
  void SetOrigin(const Vec3& origin);

  /**
   * Shows a scene (null: none); call again after changes. Shows nothing on error.
   */
  Status SetScene(vtkPolyData* scene);
  vtkPolyData* GetScene() const { return this->Scene; }

  /// Parts of the scene that are drawn and picked where Move() puts them; reset by the next scene.
  /// Not of scenes with instances.
  void SetMovingParts(const std::vector<int>& parts);

  /// Returns the triangles of the moving parts in the current state; null: there are none.
  vtkPolyData* GetMovingMesh() const { return this->Moving.GetMesh(); }

  /// Replaces the same triangles by moved ones.
  void Move(vtkPolyData* parts);

  /// Sets the turbid voxels of the scene, drawn as a limited number of translucent boxes with the
  /// visibility of the mesh. They cannot be picked.
  void SetGrids(const std::vector<vtkSmartPointer<vtkImageData>>& grids);
  vtkIdType GetNumberOfBoxes() const;

  ///@{
  /// Maximum, over all grids: when still, and while the camera moves.
  static constexpr vtkIdType MaximumBoxes = 20000;
  static constexpr vtkIdType MaximumMovingBoxes = 2000;
  ///@}

  /// Sets whether the camera moves: draws fewer and larger boxes, and large triangles for small
  /// ones in very large meshes. Default: off.
  void SetInteracting(bool on);
  bool IsCoarse() const { return this->Resting.IsCoarse(); }

  /// Returns the triangles of instances drawn in the last frame.
  vtkIdType GetInstanceTrianglesDrawn() const { return this->Instances.GetNumberDrawn(); }

  /// Sets the colouring. Default: ByMaterial.
  void SetColoring(Coloring coloring);

  /// Covers the colours of the mesh, so that echoes on it stand out. Default: no veil.
  void SetVeil(const Veil& veil);

  /// Sets whether triangles are smooth over edges below 40 degrees. Default: off (flat triangles).
  void SetSmooth(bool on);

  /// Sets the opacity in [0, 1]. Default: 1.
  void SetOpacity(double opacity);
  void SetWireframe(bool on);
  void SetVisible(bool on);
  bool IsVisible() const;

  /// Draws only what is in a slab [m], in world coordinates; none: all. Picking ignores it.
  void SetSection(const std::optional<Slab>& slab);

  /// Highlights a part in yellow; -1: none (default).
  void SetHighlightedPart(int part);
  int GetHighlightedPart() const { return this->HighlightedPart; }

  /// Returns the first hit of the ray through a window pixel, in double precision.
  std::optional<ScenePick> Pick(double x, double y);

  /// Returns the height of a place above what is below it [m]; a place on a surface is not below it.
  std::optional<double> FindHeight(const Vec3& place);

  /// Gets world bounds x0 x1 y0 y1 z0 z1 [m]; false without a scene.
  bool GetBounds(double bounds[6]) const;

  /// Returns the part of a cell; -1: the scene has no parts, or no such cell.
  int GetPart(vtkIdType cell) const;

  /// Finds a part by its name, and its box [m]; false if no part of that name has triangles.
  bool FindPart(const std::string& name, int& part, double bounds[6]) const;

  /// Returns the name of a part; its number if it has none.
  std::string GetPartName(int part) const;

  static constexpr unsigned char HighlightColor[3] = { 255, 205, 60 };

private:
  void DrawMesh();
  void ColorMesh();
  void DrawBoxes();
  Rgb GetColor(const std::vector<Rgb>& materialColors, int part, int material) const;

  vtkRenderer* Renderer;
  vtkSmartPointer<vtkPolyData> Scene;
  SceneGeometry Geometry;
  std::unique_ptr<SceneCells> Cells;
  MaterialTable Materials;
  Vec3 Origin{ 0.0, 0.0, 0.0 };
  Coloring ColorBy = Coloring::ByMaterial;
  Veil Cover;
  bool Smooth = false;
  int HighlightedPart = -1;
  vtkNew<vtkProperty> Look;
  SceneLayer Resting;
  SceneLayer Moving;
  InstanceLayer Instances;
  std::vector<vtkSmartPointer<vtkImageData>> Grids;
  vtkSmartPointer<vtkPolyData> BoxSets[2]; // when still, while the camera moves
  bool Interacting = false;
  vtkNew<vtkActor> Boxes;
  vtkNew<vtkPolyDataMapper> BoxMapper;
  vtkNew<vtkPlaneCollection> Planes;
};

} // namespace helios::viewer

#endif
