// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Camera modes: user-controlled, following the platform, at the scanner, or scripted.

#ifndef heliosCameraRig_h
#define heliosCameraRig_h

#include "heliosPose.h"
#include "heliosStatus.h"

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

class vtkCamera;
class vtkCameraInterpolator;
class vtkRenderer;

namespace helios::viewer
{

enum class CameraMode
{
  Free,    ///< rotated by the user
  Fly,     ///< flown by the user
  Follow,  ///< follows the platform; the user rotates it
  Scanner, ///< at the scanner, facing what it measures
  Top,     ///< nadir view, parallel, north up
  Side,    ///< from the south, parallel
  Orbit,   ///< orbits once a minute
  Script   ///< along key frames
};

/// Returns the mode names used by options and the state file: free, fly, follow ...
const std::vector<std::string>& GetCameraModeNames();
std::string GetCameraModeName(CameraMode mode);

/// Coordinates are view coordinates.
class CameraRig
{
public:
  explicit CameraRig(vtkRenderer* renderer);
  ~CameraRig();

  CameraMode GetMode() const { return this->Mode; }
  void SetMode(CameraMode mode);

  /// Sets the origin of the view coordinates [m]; key frames are in world coordinates.
  void SetOrigin(const Vec3& origin) { this->Origin = origin; }

  /// Bounds of scene and cloud to be viewed.
  void SetBounds(const double bounds[6]);

  /// Sets the points to be framed; none: the corners of the bounds.
  void SetPoints(const std::vector<Vec3>& points) { this->Points = points; }

  /// Sets the parts of the window's height that panels cover at its bottom and top.
  void SetMargins(double bottom, double top);

  /// Frames everything from the south-west and above.
  void Reset();

  /// Views a point horizontally, in parallel projection: the view direction, and half the width of
  /// the view [m].
  void SetSideView(const Vec3& center, const Vec3& direction, double halfWidth);

  /// Moving target: the platform, and the mean of the points just measured.
  struct Subject
  {
    Pose Platform;
    Pose Scanner;
    Vec3 Target;
    bool HasTarget = false;
  };

  /// Advances by a time [s]; null subject: no motion.
  void Update(double seconds, const Subject* subject);

  /// Reads key frames from a JSON file: a list of {"time", "position", "focalPoint", "viewUp"}.
  Status ReadScript(const std::string& fileName);

private:
  void Follow(const Subject& subject);
  void ViewFromScanner(double seconds, const Subject& subject);
  void SetParallelView(const Vec3& direction, const Vec3& up);
  struct Frustum;
  Frustum MakeFrustum(const Vec3& direction, const Vec3& up) const;
  std::vector<Vec3> GetFramedPoints() const;
  void TurnRound(double seconds);
  void FollowScript();
  Vec3 GetCenter() const;
  double GetSize() const;

  vtkRenderer* Renderer;
  vtkNew<vtkCameraInterpolator> Script;
  CameraMode Mode = CameraMode::Free;
  double Bounds[6] = { -1.0, 1.0, -1.0, 1.0, -1.0, 1.0 };
  std::vector<Vec3> Points;
  double Margins[2] = { 0.0, 0.0 };
  bool IsFollowing = false;
  Vec3 LastPosition{ 0.0, 0.0, 0.0 };
  Vec3 ViewDirection{ 0.0, 0.0, 0.0 };
  double ScriptTime = 0.0;
  Vec3 Origin{ 0.0, 0.0, 0.0 };
};

} // namespace helios::viewer

#endif
