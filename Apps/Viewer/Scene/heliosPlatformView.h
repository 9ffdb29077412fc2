// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The platform with its scanner, its trajectory, and the fan of the newest beams.

#ifndef heliosPlatformView_h
#define heliosPlatformView_h

#include "heliosModelFile.h"
#include "heliosPose.h"
#include "heliosSimulation.h"
#include "heliosStatus.h"

#include <vtkNew.h>
#include <vtkType.h>

#include <memory>
#include <string>
#include <vector>

class vtkActor;
class vtkPolyData;
class vtkRenderer;

namespace helios::viewer
{

class PlatformView
{
public:
  /// Everything is drawn relative to an origin [m]. Models already read need not be read again.
  PlatformView(vtkRenderer* renderer, const Vec3& origin,
    std::shared_ptr<ModelFiles> models = std::make_shared<ModelFiles>());
  ~PlatformView();

  /// Sets the trajectories of the legs, as lines; scan positions as points.
  void SetTrajectories(const std::vector<SimulatedLeg>& legs);

  /// Shows or hides platform, scanner, trajectories.
  void SetVisible(bool visible);

  /// Shows or hides platform and scanner, which would block the view from the scanner.
  void SetModelVisible(bool visible);

  void SetFanVisible(bool visible);
  bool IsFanVisible() const;

  /// Reads the models of all legs; the error has one line per file.
  Status ReadModels(const std::vector<SimulatedLeg>& legs);

  /// Places the platform of a leg at a time [m], [s], scaled up to stay visible. Its model is
  /// shown, or one of its kind if that cannot be shown.
  void Place(const SimulatedLeg& leg, const Pose& platform, double time);

  /// Sets the beams that end at these points, from the scanner [m].
  void SetFan(const Vec3& scanner, const std::vector<Vec3>& ends);

  vtkIdType GetNumberOfBeams() const;

private:
  double FindScale(const Vec3& position, double size) const;
  void ShowModels(const SimulatedLeg& leg);

  vtkRenderer* Renderer;
  Vec3 Origin;
  std::shared_ptr<ModelFiles> Models;
  std::string Shown; // which models
  double Size = 1.0; // size of the platform [m]
  bool HasModel = false;
  bool IsVisible = true;
  vtkNew<vtkActor> Body;
  vtkNew<vtkActor> Scanner;
  vtkNew<vtkActor> Trajectories;
  vtkNew<vtkActor> Stands;
  vtkNew<vtkActor> Fan;
  vtkNew<vtkPolyData> Beams;
};

} // namespace helios::viewer

#endif
