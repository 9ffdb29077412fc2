// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A scene prepared for the rays of planning.

#ifndef heliosPlanScene_h
#define heliosPlanScene_h

#include "heliosPose.h"
#include "heliosStatus.h"

#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <memory>

class vtkHeliosRayCaster;
class vtkPolyData;

namespace helios
{

class PlanGround;
class SceneCells;

class PlanScene
{
public:
  PlanScene();
  ~PlanScene();

  /// Takes all triangles of a scene, which may have instances.
  Status Set(vtkPolyData* scene);

  /// Takes the ground of a scene, which must outlive this.
  Status Set(PlanGround& ground);

  const vtkHeliosRayCaster& GetCaster() const { return *this->Caster; }

  /// Returns x0 x1 y0 y1 z0 z1 of the triangles used.
  const double* GetBounds() const { return this->Bounds; }

  /// Returns the cell of the scene hit, given the hit id of the caster.
  vtkIdType GetCell(vtkIdType hit) const;

  /// Returns the part of the scene that was hit; -1: the scene has no parts.
  int GetPart(vtkIdType hit) const;

  /// Returns the unit normal of the triangle hit, from its corners by the right-hand rule.
  Vec3 GetFaceNormal(vtkIdType hit) const;

  /// Returns the cell array Normals if the scene has it, else the normal from the corners.
  Vec3 GetNormal(vtkIdType hit) const;

  /// Steps not set (0) are a twentieth of the diagonal; bounds not set (NaN) are the scene's.
  double GetStep(double given) const;
  double GetBound(double given, int side) const
  {
    return given == given ? given : this->Bounds[side];
  }

private:
  Status FindBounds(vtkPolyData* scene);

  vtkSmartPointer<vtkHeliosRayCaster> Caster;
  std::unique_ptr<SceneCells> Cells;
  const PlanGround* Ground = nullptr; ///< null: all triangles are taken
  double Bounds[6] = {};
};

} // namespace helios

#endif
