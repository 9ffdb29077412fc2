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
constexpr double DegreesPerSecond = 6.0;  // of the orbit
constexpr double NearestFollow = 20.0;    // [m], from the platform
constexpr double TurnSeconds = 0.4;       // for the scanner view to turn
constexpr double LargestNumber = 1e9;     // of key frames [m, s]
const Vec3 FromSouthWest{ -0.55, -0.65, 0.5 };

Vec3 Unit(Vec3 v)
{
  v.Normalize();
  return v;
}

/// A number that allows camera interpolation.
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
/// The radius of the bounding sphere.
double CameraRig::GetSize() const
{
  const double* b = this->Bounds;
  return std::max(1e-3, 0.5 * std::hypot(b[1] - b[0], b[3] - b[2], b[5] - b[4]));
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
  const double distance = this->GetSize() / std::sin(vtkMath::RadiansFromDegrees(0.5 * ViewAngle));
  const Vec3 center = this->GetCenter();
  const Vec3 eye = center + 0.85 * distance * Unit(FromSouthWest);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->SetFocalPoint(center.GetData());
  camera->SetPosition(eye.GetData());
  this->IsFollowing = false;
}

//------------------------------------------------------------------------------
void CameraRig::SetParallelView(const Vec3& direction, const Vec3& up)
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  const Vec3 center = this->GetCenter();
  const Vec3 eye = center - 3.0 * this->GetSize() * direction;
  camera->SetFocalPoint(center.GetData());
  camera->SetPosition(eye.GetData());
  camera->SetViewUp(up.GetData());
  const double* b = this->Bounds;
  const double width = b[1] - b[0];
  const double height = up[1] > 0.5 ? b[3] - b[2] : b[5] - b[4];
  const double aspect = this->Renderer->GetTiledAspectRatio();
  camera->SetParallelScale(0.55 * std::max({ height, width / aspect, 1e-3 }));
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
/// Initially behind and above the platform; then moves with it.
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
