// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The instances of a scene, drawn without copies.

#ifndef heliosInstanceLayer_h
#define heliosInstanceLayer_h

#include "heliosColorMaps.h"
#include "heliosPose.h"
#include "heliosPrototypeMesh.h"

#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <functional>
#include <memory>
#include <vector>

class vtkActor;
class vtkDataSet;
class vtkGlyph3DMapper;
class vtkPlaneCollection;
class vtkHeliosScene;
class vtkIntArray;
class vtkPolyData;
class vtkProperty;
class vtkRenderer;

namespace helios
{
class Prototype;
class SceneGeometry;
}

namespace helios::viewer
{

/**
 * Instances are glyphs: one for each material of their prototype. If there are too many triangles,
 * each frame draws instances with as many triangles as they have pixels, and none out of sight.
 */
class InstanceLayer
{
public:
  /// The renderer must outlive the layer.
  InstanceLayer(vtkRenderer* renderer, vtkProperty* property);
  ~InstanceLayer();
  InstanceLayer(const InstanceLayer&) = delete;
  void operator=(const InstanceLayer&) = delete;

  ///@{
  /// Maximum number of triangles drawn: when still, and while the camera moves.
  static constexpr vtkIdType MaximumWhenStill = 10000000;
  static constexpr vtkIdType MaximumWhileMoving = 200000;
  ///@}

  /// Sets the instances of a scene (null: none). Its geometry must outlive this.
  void SetScene(vtkHeliosScene* scene, const SceneGeometry& geometry);

  /// Places the instances, relative to an origin [m].
  void Draw(const Vec3& origin, bool smooth);

  /// Colours the instances by their part and material.
  void Color(const std::function<Rgb(int part, int material)>& getColor);

  /// Draws only what is inside of planes; null: all.
  void SetClippingPlanes(vtkPlaneCollection* planes);

  void SetVisible(bool on);

  /// Sets whether the camera moves. Default: off.
  void SetInteracting(bool on);

  /// Returns the triangles drawn in the last frame.
  vtkIdType GetNumberDrawn() const { return this->NumberDrawn; }

private:
  /// A prototype: its meshes, one for each material, and a sphere around it.
  struct Prototype
  {
    Vec3 Centre;
    double Radius = 0.0;
    std::vector<int> Materials;
    std::vector<std::size_t> Meshes;
  };
  /// A mesh of a prototype at an instance.
  struct Glyph
  {
    std::size_t Instance;
    int Material;
    std::size_t Mesh;
  };
  struct View; // view of the camera

  void AddPrototype(vtkDataSet* data, const helios::Prototype& triangles);
  void AddSources();
  void AddGlyphs();
  void ShowVisible();
  vtkIdType ChooseLevels(const View& view, double density);
  void Hide(vtkIdType maximum);
  void SetSources();

  vtkRenderer* Renderer;
  vtkSmartPointer<vtkHeliosScene> Scene;
  const SceneGeometry* Geometry = nullptr;
  std::vector<Prototype> Prototypes;
  std::vector<std::unique_ptr<PrototypeMesh>> Meshes;
  std::vector<int> FirstSource;  // first source of each mesh, its level 0; then of nothing
  std::vector<vtkPolyData*> Set; // the sources of the mapper; null: nothing
  std::vector<Glyph> Glyphs;
  std::vector<Vec3> Centres; // centres of the glyphs, relative to the origin
  std::vector<double> Radii; // radii of the glyphs
  std::vector<int> Chosen;   // levels of the glyphs; -1: not drawn
  vtkIdType NumberOfTriangles = 0;
  vtkIdType NumberDrawn = 0;
  bool Visible = false;
  bool Interacting = false;
  bool IsDirty = false; // whether levels must be chosen again
  vtkMTimeType ViewTime = 0;
  int ViewHeight = 0;
  vtkNew<vtkPolyData> Places;
  vtkNew<vtkIntArray> Sources;
  vtkNew<vtkActor> Actor;
  vtkNew<vtkGlyph3DMapper> Mapper;
  unsigned long Observer;
};

} // namespace helios::viewer

#endif
