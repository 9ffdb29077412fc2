// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A scene of a survey whose parts move: where they are when a pulse leaves.

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

/// When the pulses of a leg leave: pulse i at StartTime + i / Rate, as the one with that number in the run.
struct PulseClock
{
  vtkIdType FirstShot = 0; ///< pulses of a channel in the legs before
  double StartTime = 0.0;  ///< [s]
  double Rate = 1.0;       ///< [Hz]
};

/// The step that a part is seen at by a pulse of a leg.
VTKHELIOSSCANNERSURVEY_EXPORT vtkIdType FindSeenStep(
  const MotionData& motion, const PulseClock& clock, vtkIdType pulse);

/// The first pulse of a leg, from 0, that leaves when a part has made a step.
VTKHELIOSSCANNERSURVEY_EXPORT vtkIdType FindPulseOfStep(
  const MotionData& motion, const PulseClock& clock, vtkIdType step);

/// Nothing of it costs anything where no part moves.
class VTKHELIOSSCANNERSURVEY_EXPORT MovingScene
{
public:
  MovingScene(const SceneData& scene, vtkPolyData* mesh, Messages& log);
  ~MovingScene();

  bool IsMoving() const { return !this->Parts.empty(); }

  /// The PartIds of what moves.
  std::vector<int> GetParts() const;

  /// Moves the parts to where a pulse of a leg sees them; returns the first pulse that sees them
  /// elsewhere.
  vtkIdType MoveTo(const PulseClock& clock, vtkIdType pulse);

  /// The mesh of another scene with the same points and triangles, as it is now.
  vtkSmartPointer<vtkDataObject> Move(vtkDataObject* scene) const;

  /// A ray caster of a kind for which only what moves costs.
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
  vtkNew<vtkHeliosSceneMotion> Filter;
};

} // namespace helios

#endif
