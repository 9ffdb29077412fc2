// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Draws the mesh of a scene, and tells what of it is at a pixel.

#ifndef heliosSceneView_h
#define heliosSceneView_h

#include "heliosMaterialTable.h"
#include "heliosPose.h"
#include "heliosSceneLayer.h"

#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkType.h>

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

/// A place on the scene.
struct ScenePick
{
  Vec3 Position; ///< [m], in the world
  Vec3 Normal;   ///< unit, towards the camera
  vtkIdType Cell = -1;
  int Part = -1;         ///< -1: the scene has no parts
  int Material = -1;     ///< row of the materials
  bool IsGround = false; ///< of the material
  std::string PartName;
  std::string MaterialName;
};

/**
 * Triangles with the arrays MaterialIds, PartIds and the material columns, as DESIGN has them; all
 * are optional.
 */
class SceneView
{
public:
  enum class Coloring
  {
    ByMaterial,
    ByPart
  };

  /// The renderer must outlive the view.
  explicit SceneView(vtkRenderer* renderer);
  ~SceneView();
  SceneView(const SceneView&) = delete;
  void operator=(const SceneView&) = delete;

  /// What the renderer's coordinates are relative to [m]. Default: 0. Scenes may be shown already.
  void SetOrigin(const Vec3& origin);

  /**
   * Shows a scene (null: none), again after it has changed. Says in words what is wrong and shows
   * nothing, or returns an empty text.
   */
  std::string SetScene(vtkPolyData* scene);
  vtkPolyData* GetScene() const { return this->Scene; }

  /// Parts of the scene that are drawn, and picked, where Move() puts them; the next scene has none.
  void SetMovingParts(const std::vector<int>& parts);

  /// Their triangles, where they are now; null: there are none.
  vtkPolyData* GetMovingMesh() const { return this->Moving.GetMesh(); }

  /// The same triangles, elsewhere.
  void Move(vtkPolyData* parts);

  /// The turbid voxels beside the scene, as translucent boxes of which there are not too many; the mesh's
  /// visibility is theirs. They cannot be picked.
  void SetGrids(const std::vector<vtkSmartPointer<vtkImageData>>& grids);
  vtkIdType GetNumberOfBoxes() const;

  ///@{
  /// At most, of all grids: when still, and while the camera moves.
  static constexpr vtkIdType MostBoxes = 20000;
  static constexpr vtkIdType MostMovingBoxes = 2000;
  ///@}

  /// While the camera moves there are fewer boxes, and larger; and large triangles for small ones where
  /// there are very many. Default: off.
  void SetInteracting(bool on);
  bool IsCoarse() const { return this->Resting.IsCoarse(); }

  /// Default: ByMaterial.
  void SetColoring(Coloring coloring);

  /// Smooth over edges of less than 40 degrees. Default: off (flat triangles).
  void SetSmooth(bool on);
  bool GetSmooth() const { return this->Smooth; }

  /// In [0, 1]. Default: 1.
  void SetOpacity(double opacity);
  void SetWireframe(bool on);
  void SetVisible(bool on);
  bool IsVisible() const;

  /// Shows a part in yellow; -1: none (the default).
  void SetHighlightedPart(int part);
  int GetHighlightedPart() const { return this->HighlightedPart; }

  /// What the ray through a pixel of the window meets first, at double precision.
  std::optional<ScenePick> Pick(double x, double y);

  /// x0 x1 y0 y1 z0 z1 [m] in the world; false without a scene.
  bool GetBounds(double bounds[6]) const;

  /// The name of a part; its number where it has none.
  std::string GetPartName(int part) const;

  static constexpr unsigned char HighlightColor[3] = { 255, 205, 60 };

private:
  void DrawMesh();
  void ColorMesh();
  void DrawBoxes();
  int GetCellId(const char* name, vtkIdType cell) const;

  vtkRenderer* Renderer;
  vtkSmartPointer<vtkPolyData> Scene;
  MaterialTable Materials;
  Vec3 Origin{ 0.0, 0.0, 0.0 };
  Coloring ColorBy = Coloring::ByMaterial;
  bool Smooth = false;
  int HighlightedPart = -1;
  vtkNew<vtkProperty> Look;
  SceneLayer Resting;
  SceneLayer Moving;
  std::vector<vtkSmartPointer<vtkImageData>> Grids;
  vtkSmartPointer<vtkPolyData> BoxSets[2]; // when still, while the camera moves
  bool Interacting = false;
  vtkNew<vtkActor> Boxes;
  vtkNew<vtkPolyDataMapper> BoxMapper;
};

} // namespace helios

#endif
