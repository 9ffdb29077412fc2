// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A scene whose moving parts are instances.

#ifndef heliosMovingInstances_h
#define heliosMovingInstances_h

#include "heliosPartSpeeds.h"
#include "heliosPulseClock.h"
#include "heliosSceneMotions.h"
#include "heliosSurveyData.h"
#include "vtkHeliosScannerSurveyModule.h" // For export macro

#include <vtkSmartPointer.h>

#include <memory>
#include <vector>

class vtkPolyData;

namespace helios
{

class Messages;

/**
 * The triangles of parts that move become prototypes, each at an instance with MotionIds; cell ids
 * stay as they are. A scene in which nothing moves is not touched.
 */
class VTKHELIOSSCANNERSURVEY_EXPORT MovingInstances
{
public:
  /// Reports errors of trajectories.
  MovingInstances(const SceneData& scene, vtkPolyData* mesh, const SceneFrames& frames,
    AngleConvention convention, Messages& log);
  ~MovingInstances();

  bool IsMoving() const { return this->Motions != nullptr; }

  /// Returns the scene to cast rays at: with instances, or as it was.
  vtkPolyData* GetScene() const { return this->Scene; }

  /// Leaves the parts where they are at time 0 of the survey, at rest: the scene has them there.
  void StandStill();

  /// Returns the parts that move, with their speeds in legs.
  std::vector<PartSpeeds> GetSpeeds(const std::vector<LegClock>& legs) const;

  /// Checks that the trajectories and frames of the parts have a span of the survey [s]; false after an
  /// error.
  bool CheckSpan(double start, double end) const;

  /// Returns the motions during a leg; null if nothing moves.
  std::shared_ptr<const InstanceMotions> MakeMotions(const PulseClock& clock) const;

private:
  class Split;

  bool ReadTracks(
    const SceneData& scene, AngleConvention convention, SceneMotions::Content& motions);
  static void FindCarriers(SceneMotions::Content& motions);

  Messages& Log;
  vtkSmartPointer<vtkPolyData> Whole; ///< the scene as it was
  vtkSmartPointer<vtkPolyData> Scene;
  std::shared_ptr<SceneMotions::Content> Motions;
};

} // namespace helios

#endif
