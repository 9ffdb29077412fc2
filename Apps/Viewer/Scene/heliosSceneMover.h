// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Moves the dynamic parts of a scene to their positions at the pulse emission time.

#ifndef heliosSceneMover_h
#define heliosSceneMover_h

#include "heliosMessages.h"
#include "heliosMovingScene.h"

#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkType.h>

#include <memory>
#include <vector>

namespace helios::viewer
{

class SceneView;
struct SimulatedLeg;

/// Moves them as the run does, but for rays: its echoes lie on them.
class SceneMover
{
public:
  /// The view shows the mesh of this scene in its start state, and must outlive the mover.
  SceneMover(const SceneData& scene, SceneView& view);

  /// Moves the parts to their positions at a time [s]; false: unchanged.
  bool MoveTo(const std::vector<SimulatedLeg>& legs, double time);

private:
  SceneView& View;
  vtkNew<vtkObject> Owner; // owner of messages already given by the run
  Messages Log;
  std::unique_ptr<MovingScene> Parts; // null: nothing moves
  const SimulatedLeg* Leg = nullptr;  // they were moved for
  vtkIdType First = 0;                // first pulse of this state
  vtkIdType Next = 0;                 // number of the next state
};

} // namespace helios::viewer

#endif
