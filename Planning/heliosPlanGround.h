// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The ground of a scene.

#ifndef heliosPlanGround_h
#define heliosPlanGround_h

#include "heliosSceneGeometry.h"
#include "heliosStatus.h"

#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <map>
#include <utility>
#include <vector>

class vtkHeliosScene;
class vtkPolyData;

namespace helios
{

/// The triangles of a scene with a ground material: of its mesh, and of its instances.
class PlanGround
{
public:
  /// Keeps a reference.
  Status Set(vtkPolyData* scene);

  /// Returns whether the scene has none.
  bool IsEmpty() const;

  /// Returns whether a triangle of the scene is ground.
  bool Has(const SceneGeometry::Cell& at) const;

  /// Makes a scene of the ground alone, without cell arrays.
  vtkSmartPointer<vtkPolyData> Extract();

  /// Returns the cell id in the scene of a triangle of the extracted one.
  vtkIdType GetCell(const SceneGeometry& extracted, vtkIdType cell) const;

private:
  /// The ground of the mesh, or of a prototype.
  struct Ground
  {
    std::vector<bool> IsGround; ///< per triangle; empty: none
    bool IsAll = false;
    std::vector<vtkIdType> Cells; ///< cells of the extracted triangles
  };
  /// An instance of the scene that is extracted.
  struct Source
  {
    const SceneInstance* Instance;
    bool IsWhole;
  };

  bool IsWhole(const SceneInstance& instance) const;
  bool IsExtracted(const SceneInstance& instance) const;
  const Ground& GetPrototype(const SceneInstance& instance) const;
  void ExtractInstances(vtkHeliosScene* scene, vtkHeliosScene* part);
  int AddPrototype(vtkHeliosScene* scene, int prototype, bool isWhole, vtkHeliosScene* part);

  vtkSmartPointer<vtkPolyData> Scene;
  SceneGeometry Geometry; ///< empty without instances
  Ground Mesh;
  std::vector<Ground> Prototypes;
  std::vector<bool> IsGroundMaterial;
  std::map<std::pair<int, bool>, int> Numbers; ///< numbers of extracted prototypes
  std::vector<Source> Sources;                 ///< sources of extracted instances
};

} // namespace helios

#endif
