// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Where the camera is: in the user's hands, with the platform, in the scanner's place, or on a script.

#ifndef heliosCameraRig_h
#define heliosCameraRig_h

#include "heliosPose.h"

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

class vtkCamera;
class vtkCameraInterpolator;
class vtkRenderer;

namespace helios
{

enum class CameraMode
{
  Free,    ///< the user turns it
  Fly,     ///< the user flies it
  Follow,  ///< goes with the platform; the user turns it
  Scanner, ///< in the scanner's place, towards what it measures
  Top,     ///< straight down, parallel, north up
  Side,    ///< from the south, parallel
  Orbit,   ///< round the scene once a minute
  Script   ///< along key frames
};

/// The names of the modes, as options and the state file have them: free, fly, follow ...
const std::vector<std::string>& GetCameraModeNames();
std::string GetCameraModeName(CameraMode mode);

/// Coordinates are those of the view.
class CameraRig
{
public:
  explicit CameraRig(vtkRenderer* renderer);
  ~CameraRig();

  CameraMode GetMode() const { return this->Mode; }
  void SetMode(CameraMode mode);

  /// What the view's coordinates are relative to [m]; key frames are in the world.
  void SetOrigin(const Vec3& origin) { this->Origin = origin; }

  /// The box that is looked at: of scene and cloud.
  void SetBounds(const double bounds[6]);

  /// Looks at all of it from the south-west and above.
  void Reset();

  /// What moves: the platform, and the mean of the points that the scanner has just measured.
  struct Subject
  {
    Pose Platform;
    Pose Scanner;
    Vec3 Target;
    bool HasTarget = false;
  };

  /// Time passes [s]; a null subject: nothing moves.
  void Update(double seconds, const Subject* subject);

  /// Reads key frames from a JSON file: a list of {"time", "position", "focalPoint", "viewUp"}; says
  /// what is wrong with it, or returns an empty text.
  std::string ReadScript(const std::string& fileName);

private:
  void Follow(const Subject& subject);
  void LookFromScanner(double seconds, const Subject& subject);
  void LookParallel(const Vec3& direction, const Vec3& up);
  void TurnRound(double seconds);
  void FollowScript();
  Vec3 GetCenter() const;
  double GetSize() const;

  vtkRenderer* Renderer;
  vtkNew<vtkCameraInterpolator> Script;
  CameraMode Mode = CameraMode::Free;
  double Bounds[6] = { -1.0, 1.0, -1.0, 1.0, -1.0, 1.0 };
  bool IsFollowing = false;
  Vec3 LastPosition{ 0.0, 0.0, 0.0 };
  Vec3 LookDirection{ 0.0, 0.0, 0.0 };
  double ScriptTime = 0.0;
  Vec3 Origin{ 0.0, 0.0, 0.0 };
};

} // namespace helios

#endif
