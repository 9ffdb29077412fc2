// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The moving parts of a scene, drawn where they are when the pulses of a time leave.

#ifndef heliosSceneMover_h
#define heliosSceneMover_h

#include "heliosMessages.h"
#include "heliosMovingScene.h"

#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkType.h>

#include <memory>
#include <vector>

namespace helios
{

class SceneView;
struct SimulatedLeg;

/// Moves them as the run does, but for rays: its echoes are on them.
class SceneMover
{
public:
  /// The view shows the mesh of this scene, as it is at the start, and must outlive the mover.
  SceneMover(const SceneData& scene, SceneView& view);

  /// Shows the parts where they are at a time [s]; false: they are there already.
  bool MoveTo(const std::vector<SimulatedLeg>& legs, double time);

private:
  SceneView& View;
  vtkNew<vtkObject> Owner; // of messages that the run has given already
  Messages Log;
  std::unique_ptr<MovingScene> Parts; // null: nothing moves
  const SimulatedLeg* Leg = nullptr;  // that they were moved for
  vtkIdType First = 0;                // pulse of it that sees them so
  vtkIdType Next = 0;                 // that does not
};

} // namespace helios

#endif
