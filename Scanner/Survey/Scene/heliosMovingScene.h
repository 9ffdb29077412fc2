// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A scene with moving parts: their positions at the time of a pulse.

#ifndef heliosMovingScene_h
#define heliosMovingScene_h

#include "heliosPulseClock.h"
#include "heliosSurveyData.h"
#include "vtkHeliosScannerSurveyModule.h" // For export macro

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <vector>

class vtkDataObject;
class vtkHeliosSceneMotion;
class vtkPolyData;

namespace helios
{

class Messages;

/// No overhead without moving parts.
class VTKHELIOSSCANNERSURVEY_EXPORT MovingScene
{
public:
  MovingScene(const SceneData& scene, vtkPolyData* mesh, Messages& log);
  ~MovingScene();

  bool IsMoving() const { return !this->Parts.empty(); }

  /// Returns the PartIds of the moving parts.
  std::vector<int> GetParts() const;

  /// Moves the parts to their positions at a pulse of a leg; returns the first pulse with other
  /// positions.
  vtkIdType MoveTo(const PulseClock& clock, vtkIdType pulse);

  /// Moves the mesh of another scene with the same points and triangles.
  vtkSmartPointer<vtkDataObject> Move(vtkDataObject* scene) const;

  /// Changes when parts have moved.
  vtkMTimeType GetMoveTime() const;

private:
  struct Part
  {
    int Id;
    MotionData Data;
    PartMotion Motion;
  };

  std::vector<Part> Parts;
  vtkSmartPointer<vtkPolyData> Mesh; ///< with its instances
  vtkNew<vtkHeliosSceneMotion> Filter;
};

} // namespace helios

#endif
