// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Moves the dynamic parts of a scene to their positions at the displayed time, and deforms them.

#ifndef heliosSceneMover_h
#define heliosSceneMover_h

#include "heliosInstanceMotion.h"
#include "heliosMessages.h"
#include "heliosMovingInstances.h"

#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <memory>
#include <vector>

class vtkPoints;
class vtkPolyData;

namespace helios::viewer
{

class SceneView;
struct SimulatedLeg;

/// Moves parts along the paths that the run has: by steps, continuously, along trajectories, and on
/// other parts; parts with frames have the shape of that time. The echoes lie on them.
class SceneMover
{
public:
  /// The mesh of a survey's scene, in its start state, and the frames of its parts that deform.
  SceneMover(const SurveyData& survey, vtkPolyData* mesh, const SceneFrames& frames = {});
  ~SceneMover();

  /// Gets the bounds of all triangles at the begin of a leg [m]; false: nothing moves.
  bool GetBounds(const SimulatedLeg& leg, double bounds[6]);

  /// Sets the view that shows the mesh; it must outlive the mover.
  void SetView(SceneView& view);

  /// Moves the parts to their positions at a time [s]; false: unchanged.
  bool MoveTo(const std::vector<SimulatedLeg>& legs, double time);

private:
  struct Part;

  void Begin(const SimulatedLeg& leg);

  SceneView* View = nullptr;
  vtkNew<vtkObject> Owner; // owner of messages already given by the run
  Messages Log;
  std::unique_ptr<MovingInstances> Instances; // null: nothing moves
  std::vector<Part> Parts;
  vtkSmartPointer<vtkPoints> AtRest; // points of the view's moving mesh
  const SimulatedLeg* Leg = nullptr; // they were moved for
  SceneMoment Shown;
};

} // namespace helios::viewer

#endif
