// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A scene with moving parts: their positions at the time of a pulse.

#ifndef heliosMovingScene_h
#define heliosMovingScene_h

#include "heliosSurveyData.h"
#include "vtkHeliosScannerSurveyModule.h" // For export macro

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <vector>

class vtkDataObject;
class vtkHeliosRayCaster;
class vtkHeliosSceneMotion;
class vtkPolyData;

namespace helios
{

class Messages;

/// Pulse times of a leg: pulse i leaves at StartTime + i / Rate, as pulse FirstShot + i of the run.
struct PulseClock
{
  vtkIdType FirstShot = 0; ///< pulses of a channel in the legs before
  double StartTime = 0.0;  ///< [s]
  double Rate = 1.0;       ///< [Hz]
};

/// Returns the motion step of a part at a pulse of a leg.
VTKHELIOSSCANNERSURVEY_EXPORT vtkIdType FindSeenStep(
  const MotionData& motion, const PulseClock& clock, vtkIdType pulse);

/// Returns the first pulse of a leg, from 0, after a step of a part.
VTKHELIOSSCANNERSURVEY_EXPORT vtkIdType FindPulseOfStep(
  const MotionData& motion, const PulseClock& clock, vtkIdType step);

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

  /// Returns a ray caster of a kind that rebuilds only the moving parts.
  vtkSmartPointer<vtkHeliosRayCaster> MakeRayCaster(vtkHeliosRayCaster* kind) const;

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
