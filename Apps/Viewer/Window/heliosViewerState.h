// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The viewer state as JSON: for scripts that drive it, and for tests.

#ifndef heliosViewerState_h
#define heliosViewerState_h

#include "heliosPose.h"

#include <vtkType.h>

#include <json/forwards.h>

#include <memory>
#include <string>
#include <vector>

class vtkRenderWindow;
class vtkRenderer;

namespace helios::viewer
{

class CameraRig;
class Cloud;
class CloudView;
class Hud;
class PlatformView;
class PlayClock;
class Recorder;
class SceneView;
class Simulation;
class ViewerTool;

/// The parts of a viewer that it describes.
struct ViewerState
{
  vtkRenderWindow* Window;
  vtkRenderer* Renderer;
  const Vec3& Origin; ///< origin of everything drawn [m]
  const CameraRig& Camera;
  const PlayClock& Clock;
  const Recorder& Video;
  const Simulation* Running; ///< null: not running
  const Cloud& Points;
  const CloudView& PointsView;
  const SceneView* Mesh;        ///< null: no scene (yet)
  const PlatformView* Platform; ///< null: none
  const Hud& Words;
  const std::vector<std::unique_ptr<ViewerTool>>& Tools;
  vtkIdType NumberOfFrames;
  double FramesPerSecond;
  double PulsesPerSecond;
  const std::string& Message;

  Json::Value Describe() const;

  /// Replaces a file atomically, so that it is never read half written; an empty name: no file.
  void Write(const std::string& fileName) const;

private:
  Json::Value DescribeCamera() const;
  Json::Value DescribeTime() const;
  Json::Value DescribeCloud() const;
  Json::Value DescribePanels() const;
  void DescribeTexts(Json::Value& state) const;
  void DescribeDialog(Json::Value& state) const;
};

} // namespace helios::viewer

#endif
