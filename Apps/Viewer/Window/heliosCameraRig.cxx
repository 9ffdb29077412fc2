// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosCameraRig.h"

#include "heliosInputFile.h"
#include "heliosJsonText.h"
#include "heliosStatus.h"

#include <vtkCamera.h>
#include <vtkCameraInterpolator.h>
#include <vtkMath.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>
#include <fstream>

namespace helios::viewer
{

namespace
{

constexpr double ViewAngle = 45.0;        // [deg]
constexpr double ScannerViewAngle = 75.0; // [deg]
// share of the free part of the window, filled by the first view
constexpr double FilledShare = 0.94;
constexpr double DegreesPerSecond = 6.0; // speed of the orbit
constexpr double NearestFollow = 20.0;   // [m], from the platform
constexpr double TurnSeconds = 0.4;      // for the scanner view to turn
constexpr double LargestNumber = 1e9;    // limit of key frames [m, s]
const Vec3 FromSouthWest{ -0.55, -0.65, 0.5 };

Vec3 Unit(Vec3 v)
{
  v.Normalize();
  return v;
}

/// Returns whether a number allows camera interpolation.
bool IsNumber(const Json::Value& value)
{
  return value.isNumeric() && std::abs(value.asDouble()) <= LargestNumber;
}

bool ReadVector(const Json::Value& value, Vec3& v)
{
  bool isGood = value.isArray() && value.size() == 3;
  for (Json::ArrayIndex i = 0; isGood && i < 3; ++i)
  {
    isGood = IsNumber(value[i]);
    v[static_cast<int>(i)] = isGood ? value[i].asDouble() : 0.0;
  }
  return isGood;
}

} // namespace

//------------------------------------------------------------------------------
const std::vector<std::string>& GetCameraModeNames()
{
  static const std::vector<std::string> names{ "free", "fly", "follow", "scanner", "top", "side",
    "orbit", "script" };
  return names;
}

//------------------------------------------------------------------------------
std::string GetCameraModeName(CameraMode mode)
{
  return GetCameraModeNames()[static_cast<std::size_t>(mode)];
}

//------------------------------------------------------------------------------
CameraRig::CameraRig(vtkRenderer* renderer)
  : Renderer(renderer)
{
  this->Script->SetInterpolationTypeToSpline();
}

//------------------------------------------------------------------------------
CameraRig::~CameraRig() = default;

//------------------------------------------------------------------------------
void CameraRig::SetBounds(const double bounds[6])
{
  std::copy_n(bounds, 6, this->Bounds);
}

//------------------------------------------------------------------------------
Vec3 CameraRig::GetCenter() const
{
  const double* b = this->Bounds;
  return { 0.5 * (b[0] + b[1]), 0.5 * (b[2] + b[3]), 0.5 * (b[4] + b[5]) };
}

//------------------------------------------------------------------------------
/// Returns the radius of the bounding sphere.
double CameraRig::GetSize() const
{
  const double* b = this->Bounds;
  return std::max(1e-3, 0.5 * std::hypot(b[1] - b[0], b[3] - b[2], b[5] - b[4]));
}

//------------------------------------------------------------------------------
void CameraRig::SetMargins(double bottom, double top)
{
  this->Margins[0] = bottom;
  this->Margins[1] = top;
}

//------------------------------------------------------------------------------
std::vector<Vec3> CameraRig::GetFramedPoints() const
{
  if (!this->Points.empty())
  {
    return this->Points;
  }
  std::vector<Vec3> corners;
  for (int i = 0; i < 8; ++i)
  {
    corners.emplace_back(
      this->Bounds[i & 1], this->Bounds[2 + ((i >> 1) & 1)], this->Bounds[4 + ((i >> 2) & 1)]);
  }
  return corners;
}

//------------------------------------------------------------------------------
/// The part of the picture that points shall fill, in units of half its height.
struct CameraRig::Frustum
{
  Vec3 Right, Up, Forward;
  double Low[2], High[2]; ///< across, up

  /// Finds the ends of x - slope * depth over all points, for low and high slopes.
  static void FindEnds(const std::vector<Vec3>& points, const Vec3& across, const Vec3& forward,
    double lowSlope, double highSlope, double& minimum, double& maximum)
  {
    minimum = HUGE_VAL;
    maximum = -HUGE_VAL;
    for (const Vec3& p : points)
    {
      minimum = std::min(minimum, p.Dot(across) - lowSlope * p.Dot(forward));
      maximum = std::max(maximum, p.Dot(across) - highSlope * p.Dot(forward));
    }
  }

  /**
   * Returns the closest eye that has all points in the part, for the tangent of half the view
   * angle: with e the eye, a point is inside if low <= (x - e_x) / (z - e_z) <= high, which is
   * linear in e.
   */
  Vec3 FindEye(const std::vector<Vec3>& points, double tangent) const
  {
    const Vec3 axes[2] = { this->Right, this->Up };
    double minimum[2], maximum[2];
    double depth = HUGE_VAL;
    for (int i = 0; i < 2; ++i)
    {
      const double low = tangent * this->Low[i], high = tangent * this->High[i];
      FindEnds(points, axes[i], this->Forward, low, high, minimum[i], maximum[i]);
      depth = std::min(depth, (minimum[i] - maximum[i]) / (high - low));
    }
    Vec3 eye = depth * this->Forward;
    for (int i = 0; i < 2; ++i)
    {
      const double low = minimum[i] + tangent * this->Low[i] * depth;
      const double high = maximum[i] + tangent * this->High[i] * depth;
      eye = eye + 0.5 * (low + high) * axes[i];
    }
    return eye;
  }

  /// Finds half the height of a parallel view of all points [m]; moves the centre across.
  double FindScale(const std::vector<Vec3>& points, Vec3& center) const
  {
    const Vec3 axes[2] = { this->Right, this->Up };
    double minimum[2], maximum[2];
    double scale = 0.0;
    for (int i = 0; i < 2; ++i)
    {
      FindEnds(points, axes[i], this->Forward, 0.0, 0.0, minimum[i], maximum[i]);
      scale = std::max(scale, (maximum[i] - minimum[i]) / (this->High[i] - this->Low[i]));
    }
    for (int i = 0; i < 2; ++i)
    {
      const double middle =
        0.5 * (minimum[i] + maximum[i]) - 0.5 * scale * (this->Low[i] + this->High[i]);
      center = center + (middle - center.Dot(axes[i])) * axes[i];
    }
    return scale;
  }
};

//------------------------------------------------------------------------------
CameraRig::Frustum CameraRig::MakeFrustum(const Vec3& direction, const Vec3& up) const
{
  Frustum frustum;
  frustum.Forward = direction;
  frustum.Right = Unit(direction.Cross(up));
  frustum.Up = frustum.Right.Cross(direction);
  const double aspect = this->Renderer->GetTiledAspectRatio();
  frustum.Low[0] = -FilledShare * aspect;
  frustum.High[0] = FilledShare * aspect;
  const double bottom = -1.0 + 2.0 * this->Margins[0], top = 1.0 - 2.0 * this->Margins[1];
  frustum.Low[1] = 0.5 * (bottom + top) - 0.5 * FilledShare * (top - bottom);
  frustum.High[1] = 0.5 * (bottom + top) + 0.5 * FilledShare * (top - bottom);
  return frustum;
}

//------------------------------------------------------------------------------
void CameraRig::SetMode(CameraMode mode)
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  const bool wasParallel = camera->GetParallelProjection() != 0;
  this->Mode = mode;
  this->IsFollowing = false;
  this->ViewDirection = Vec3(0.0, 0.0, 0.0);
  this->ScriptTime = 0.0;
  camera->SetParallelProjection(mode == CameraMode::Top || mode == CameraMode::Side);
  camera->SetViewAngle(mode == CameraMode::Scanner ? ScannerViewAngle : ViewAngle);
  if (mode == CameraMode::Top)
  {
    this->SetParallelView(Vec3(0.0, 0.0, -1.0), Vec3(0.0, 1.0, 0.0));
  }
  else if (mode == CameraMode::Side)
  {
    this->SetParallelView(Vec3(0.0, 1.0, 0.0), Vec3(0.0, 0.0, 1.0));
  }
  else if (wasParallel || mode == CameraMode::Orbit)
  {
    this->Reset();
  }
}

//------------------------------------------------------------------------------
void CameraRig::Reset()
{
  if (this->Mode == CameraMode::Top || this->Mode == CameraMode::Side)
  {
    this->SetMode(this->Mode);
    return;
  }
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  const Vec3 direction = -1.0 * Unit(FromSouthWest);
  Frustum frustum = this->MakeFrustum(direction, Vec3(0.0, 0.0, 1.0));
  const double tangent = std::tan(vtkMath::RadiansFromDegrees(0.5 * ViewAngle));
  const Vec3 eye = frustum.FindEye(this->GetFramedPoints(), tangent);
  const double distance = std::max(1e-3, (this->GetCenter() - eye).Dot(direction));
  const Vec3 focal = eye + distance * direction;
  camera->ParallelProjectionOff(); // a section leaves it on
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->SetFocalPoint(focal.GetData());
  camera->SetPosition(eye.GetData());
  this->IsFollowing = false;
}

//------------------------------------------------------------------------------
void CameraRig::SetSideView(const Vec3& center, const Vec3& direction, double halfWidth)
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  const Vec3 eye = center - 3.0 * this->GetSize() * direction;
  camera->ParallelProjectionOn();
  camera->SetFocalPoint(center.GetData());
  camera->SetPosition(eye.GetData());
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->SetParallelScale(std::max(1e-3, halfWidth / this->Renderer->GetTiledAspectRatio()));
}

//------------------------------------------------------------------------------
void CameraRig::SetParallelView(const Vec3& direction, const Vec3& up)
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  Vec3 center = this->GetCenter();
  Frustum frustum = this->MakeFrustum(direction, up);
  const double scale = frustum.FindScale(this->GetFramedPoints(), center);
  const Vec3 eye = center - 3.0 * this->GetSize() * direction;
  camera->SetFocalPoint(center.GetData());
  camera->SetPosition(eye.GetData());
  camera->SetViewUp(up.GetData());
  camera->SetParallelScale(std::max(scale, 1e-3));
}

//------------------------------------------------------------------------------
void CameraRig::Update(double seconds, const Subject* subject)
{
  if (this->Mode == CameraMode::Script)
  {
    this->ScriptTime += seconds;
    this->FollowScript();
  }
  else if (this->Mode == CameraMode::Orbit)
  {
    this->TurnRound(seconds);
  }
  else if (this->Mode == CameraMode::Follow && subject)
  {
    this->Follow(*subject);
  }
  else if (this->Mode == CameraMode::Scanner && subject)
  {
    this->ViewFromScanner(seconds, *subject);
  }
}

//------------------------------------------------------------------------------
void CameraRig::FollowScript()
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  vtkNew<vtkCamera> frame;
  frame->DeepCopy(camera);
  this->Script->InterpolateCamera(this->ScriptTime, frame);
  const Vec3 eye = Vec3(frame->GetPosition()) - this->Origin;
  const Vec3 focal = Vec3(frame->GetFocalPoint()) - this->Origin;
  camera->SetPosition(eye.GetData());
  camera->SetFocalPoint(focal.GetData());
  camera->SetViewUp(frame->GetViewUp());
}

//------------------------------------------------------------------------------
/// Follows the platform: initially behind and above it; then moves with it.
void CameraRig::Follow(const Subject& subject)
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  const Vec3 at = subject.Platform.Position;
  if (!this->IsFollowing)
  {
    this->IsFollowing = true;
    const double above = std::max(0.0, at[2] - this->Bounds[4]);
    const double distance =
      std::clamp(1.6 * above, NearestFollow, std::max(NearestFollow, 1.5 * this->GetSize()));
    Vec3 forward = Rotate(subject.Platform.Orientation, Vec3(0.0, 1.0, 0.0));
    forward[2] = 0.0;
    const Vec3 eye = at - 0.85 * distance * Unit(forward) + Vec3(0.0, 0.0, 0.5 * distance);
    const Vec3 focal = at + 0.2 * distance * Unit(forward) - Vec3(0.0, 0.0, 0.5 * above);
    camera->SetViewUp(0.0, 0.0, 1.0);
    camera->SetFocalPoint(focal.GetData());
    camera->SetPosition(eye.GetData());
  }
  else
  {
    const Vec3 step = at - this->LastPosition;
    const Vec3 eye = Vec3(camera->GetPosition()) + step;
    const Vec3 focal = Vec3(camera->GetFocalPoint()) + step;
    camera->SetPosition(eye.GetData());
    camera->SetFocalPoint(focal.GetData());
  }
  this->LastPosition = at;
}

//------------------------------------------------------------------------------
void CameraRig::ViewFromScanner(double seconds, const Subject& subject)
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  const Vec3 eye = subject.Scanner.Position;
  const Vec3 ahead = Rotate(subject.Scanner.Orientation, Vec3(0.0, 1.0, 0.0));
  const Vec3 wish = subject.HasTarget ? Unit(subject.Target - eye) : ahead;
  const bool isFirst = this->ViewDirection.SquaredNorm() == 0.0;
  const double share = isFirst ? 1.0 : 1.0 - std::exp(-seconds / TurnSeconds);
  this->ViewDirection = Unit(this->ViewDirection + share * (wish - this->ViewDirection));
  const Vec3 focal = eye + this->GetSize() * this->ViewDirection;
  Vec3 up(0.0, 0.0, 1.0);
  if (std::abs(this->ViewDirection[2]) > 0.95) // straight down: forward is up
  {
    up = Rotate(subject.Platform.Orientation, Vec3(0.0, 1.0, 0.0));
  }
  camera->SetPosition(eye.GetData());
  camera->SetFocalPoint(focal.GetData());
  camera->SetViewUp(up.GetData());
}

//------------------------------------------------------------------------------
void CameraRig::TurnRound(double seconds)
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  const Vec3 center(camera->GetFocalPoint());
  const Vec3 arm = Vec3(camera->GetPosition()) - center;
  const Vec3 eye = center + Rotate(AxisAngle({ 0.0, 0.0, 1.0 }, DegreesPerSecond * seconds), arm);
  camera->SetPosition(eye.GetData());
  camera->SetViewUp(0.0, 0.0, 1.0);
}

//------------------------------------------------------------------------------
Status CameraRig::ReadScript(const std::string& fileName)
{
  if (const Status status = CheckInputFile(fileName); !status.IsOk())
  {
    return Status::Error(fileName + ": " + status.Message());
  }
  std::ifstream file(fileName);
  Json::Value frames;
  std::string errors;
  if (!file)
  {
    return Status::Error(fileName + ": cannot be read; check the name of the camera script");
  }
  if (!ReadJson(file, frames, errors))
  {
    return Status::Error(
      fileName + ": is not JSON: " + errors.substr(0, errors.find_last_not_of('\n') + 1));
  }
  this->Script->Initialize();
  for (Json::ArrayIndex i = 0; frames.isArray() && i < frames.size(); ++i)
  {
    const Json::Value& frame = frames[i];
    Vec3 position;
    Vec3 focal;
    Vec3 up(0.0, 0.0, 1.0);
    const bool isGood = frame.isObject() && IsNumber(frame["time"]) &&
      ReadVector(frame["position"], position) && ReadVector(frame["focalPoint"], focal) &&
      (!frame.isMember("viewUp") || ReadVector(frame["viewUp"], up));
    if (!isGood)
    {
      return Status::Error(fileName + ": key frame " + std::to_string(i) +
        R"( is not {"time": s, "position": [x, y, z], "focalPoint": [x, y, z]} with numbers within 1e9)");
    }
    vtkNew<vtkCamera> camera;
    camera->SetPosition(position.GetData());
    camera->SetFocalPoint(focal.GetData());
    camera->SetViewUp(up.GetData());
    camera->SetViewAngle(ViewAngle);
    this->Script->AddCamera(frame["time"].asDouble(), camera);
  }
  return this->Script->GetNumberOfCameras() > 0
    ? Status()
    : Status::Error(fileName + ": has no key frames; give a list of them");
}

} // namespace helios::viewer
