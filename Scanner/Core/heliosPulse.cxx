// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPulse.h"

#include "vtkHeliosBeamDeflector.h"

#include "heliosErrorTerms.h"
#include "heliosRandom.h"
#include "vtkHeliosErrorModel.h"
#include "vtkHeliosPlatformNoise.h"

#include <cmath>

namespace helios
{
namespace
{

// distance of a unit axis; a beam along it has no direction across
constexpr double MinimumAcross = 1e-6;

/// Returns a term of the error model; 0, and marked, if it is invalid.
double UseTerm(double value, int term, Pulse& pulse)
{
  const bool isUsable = IsUsableTerm(value);
  pulse.FaultyTerms |= isUsable ? 0u : 1u << static_cast<unsigned>(term);
  return isUsable ? value : 0.0;
}

/// Returns an elliptical beam turned to a direction nearby, the shortest way: its axes turn with
/// it.
Rotation TurnTo(const Rotation& beam, const Vec3& direction)
{
  const auto& m = beam.M;
  Vec3 local(0.0, 0.0, 0.0);
  for (int i = 0; i < 3; ++i)
  {
    local = local + direction[i] * Vec3(m[i][0], m[i][1], m[i][2]);
  }
  return beam * BeamFrame(local);
}

/// Returns Rx(a) Ry(b) Rz(c), of angles [deg].
Rotation RotateAboutAxes(const double angles[3])
{
  return Rotation(AxisAngle({ 1.0, 0.0, 0.0 }, angles[0]) *
    AxisAngle({ 0.0, 1.0, 0.0 }, angles[1]) * AxisAngle({ 0.0, 0.0, 1.0 }, angles[2]));
}

} // namespace

Rotation BeamFrame(const Vec3& axis)
{
  const double sign = std::copysign(1.0, axis[1]);
  const double a = -1.0 / (sign + axis[1]);
  const double b = axis[0] * axis[2] * a;
  Rotation frame;
  auto& m = frame.M; // columns: x, axis, z
  m[0][0] = 1.0 + sign * axis[0] * axis[0] * a;
  m[1][0] = -sign * axis[0];
  m[2][0] = sign * b;
  m[0][1] = axis[0];
  m[1][1] = axis[1];
  m[2][1] = axis[2];
  m[0][2] = b;
  m[1][2] = -axis[2];
  m[2][2] = sign + axis[2] * axis[2] * a;
  return frame;
}

Rotation BeamRoll::GetFrame(const Vec3& direction) const
{
  if (!this->IsOn)
  {
    return BeamFrame(direction);
  }
  Vec3 across = this->CrossAxis - this->CrossAxis.Dot(direction) * direction;
  if (!(across.Norm() > MinimumAcross))
  {
    return BeamFrame(direction);
  }
  across.Normalize();
  const Vec3 other = across.Cross(direction);
  const double angle = vtkMath::RadiansFromDegrees(this->Angle);
  const Vec3 columns[3] = { std::cos(angle) * across - std::sin(angle) * other, direction,
    std::sin(angle) * across + std::cos(angle) * other };
  Rotation frame;
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      frame.M[row][column] = columns[column][row];
    }
  }
  return frame;
}

Quaternion PulseSource::TurnHead(double angle) const
{
  return angle != 0.0 ? this->Mount.Orientation * AxisAngle(this->HeadAxis, angle)
                      : this->Mount.Orientation;
}

const PulseSource::Head& PulseSource::GetHead(double angle, Cursor& cursor) const
{
  Head& head = cursor.Head;
  if (head.Angle != angle)
  {
    const Quaternion turned = this->TurnHead(angle);
    head.Angle = angle;
    head.Beam = Rotation(turned * this->BeamOrigin.Orientation);
    head.Lever = this->Mount.Position + Rotate(turned, this->BeamOrigin.Position);
  }
  return head;
}

/// Returns when the platform has the pose of a pulse.
double PulseSource::GetPoseTime(double elapsed) const
{
  const double since = this->PoseInterval > 0.0
    ? std::floor(elapsed / this->PoseInterval) * this->PoseInterval
    : elapsed;
  return this->StartTime + since;
}

bool PulseSource::GetPulse(vtkIdType index, Cursor& cursor, Pulse& pulse) const
{
  double direction[3];
  if (!this->Deflector->GetDirection(index, direction))
  {
    return false;
  }
  const double elapsed = this->Deflector->GetElapsedTime(index);
  pulse.Id = this->Ids.Get(index);
  pulse.Channel = this->Deflector->GetChannel(index);
  pulse.Time = this->StartTime + elapsed;

  Rotation platform;
  Vec3 position =
    this->Platform->GetPosition(this->GetPoseTime(elapsed), cursor.Platform, platform);
  const double headAngle = this->HeadStart + this->HeadSpeed * elapsed;
  const Head& head = this->GetHead(headAngle, cursor);
  const Rotation beam = head.Beam * this->Roll.GetFrame(Vec3(direction));
  const Vec3 lever = this->GetLever(index, head);
  const bool isUnknown = this->Noise && (this->Noise->IsUnknown() || this->Noise->HasErrors());
  if (this->Noise && !this->Noise->IsUnknown())
  {
    this->AddNoise(index, position, platform);
  }
  this->PlaceBeam(position, platform, lever, beam, pulse);
  pulse.Reported = pulse.GetDirection();
  pulse.ReportedOrigin = pulse.Origin;
  if (isUnknown)
  {
    this->MoveToTruth(index, elapsed, cursor, position, platform);
    this->PlaceBeam(position, platform, lever, beam, pulse);
  }
  if (this->Errors || this->AngleAccuracy > 0.0)
  {
    this->TurnBeam(index, headAngle, platform, Vec3(direction), pulse);
  }
  return true;
}

Vec3 PulseSource::GetVelocity(vtkIdType index, Cursor& cursor) const
{
  const double elapsed = this->Deflector->GetElapsedTime(index);
  const double time = this->GetPoseTime(elapsed);
  const Head& head = this->GetHead(this->HeadStart + this->HeadSpeed * elapsed, cursor);
  const Vec3 lever = this->GetLever(index, head);
  Rotation platform;
  this->Platform->GetPosition(time, cursor.Platform, platform);
  const Trajectory::Rates rates =
    this->PoseInterval > 0.0 ? Trajectory::Rates() : this->Platform->GetRates(time);
  Vec3 axis = this->HeadAxis;
  axis.Normalize();
  const Vec3 turn = vtkMath::RadiansFromDegrees(this->HeadSpeed) * axis;
  const Vec3 ofHead = Rotate(this->Mount.Orientation, turn).Cross(lever - this->Mount.Position);
  return rates.Velocity + rates.Rotation.Cross(platform * lever) + platform * ofHead;
}

/// Returns the vector from the platform to where a pulse starts.
Vec3 PulseSource::GetLever(vtkIdType index, const Head& head) const
{
  double origin[3];
  return this->Deflector->GetOrigin(index, origin) ? head.Lever + head.Beam * Vec3(origin)
                                                   : head.Lever;
}

/// Sets the beam for a pose of the platform.
void PulseSource::PlaceBeam(const Vec3& position, const Rotation& platform, const Vec3& lever,
  const Rotation& beam, Pulse& pulse) const
{
  pulse.Origin = position + platform * lever;
  pulse.Beam = platform * beam;
}

/// Replaces the reported pose by the true one.
void PulseSource::MoveToTruth(
  vtkIdType index, double elapsed, Cursor& cursor, Vec3& position, Rotation& platform) const
{
  const double offset = this->Noise->GetClockOffset();
  if (offset != 0.0)
  {
    const double time = this->GetPoseTime(elapsed + offset);
    position = this->Platform->GetPosition(time, cursor.TruePlatform, platform);
  }
  if (offset != 0.0 || this->Noise->IsUnknown())
  {
    this->AddNoise(index, position, platform);
  }
  if (this->Noise->HasErrors())
  {
    this->AddErrors(this->StartTime + elapsed, cursor, position, platform);
  }
}

/// Moves the platform by its slow errors, and so that its mount has boresight and lever arm errors.
void PulseSource::AddErrors(double time, Cursor& cursor, Vec3& position, Rotation& platform) const
{
  double values[6];
  this->Noise->GetSlowErrors(static_cast<vtkIdType>(this->Seed), time, cursor.SlowErrors, values);
  position = position + Vec3(values);
  platform = platform * RotateAboutAxes(values + 3);
  const Rotation boresight = RotateAboutAxes(this->Noise->GetBoresight());
  const Vec3 lever = this->Mount.Position + Vec3(this->Noise->GetLeverArmError());
  position = position + platform * (lever - boresight * this->Mount.Position);
  platform = platform * boresight;
}

/// Moves and rotates the platform by its noise.
void PulseSource::AddNoise(vtkIdType index, Vec3& position, Rotation& platform) const
{
  double values[6];
  this->Noise->GetValues(static_cast<vtkIdType>(this->Seed), this->Ids.Get(index), values);
  position = position + Vec3(values);
  if (values[3] != 0.0 || values[4] != 0.0 || values[5] != 0.0)
  {
    platform = platform * RotateAboutAxes(values + 3);
  }
}

/// Moves the beam by the errors of the instrument; direction in the frame of the deflector.
void PulseSource::MoveRay(
  const Quaternion& head, const Rotation& platform, const Vec3& direction, Pulse& pulse) const
{
  Vec3 ray = Rotate(this->BeamOrigin.Orientation, direction);
  Vec3 offset(0.0, 0.0, 0.0);
  if (this->Errors->MoveRay(offset.GetData(), ray.GetData()))
  {
    const Rotation toWorld = platform * Rotation(head);
    pulse.Beam = this->Roll.IsOn ? TurnTo(pulse.Beam, toWorld * ray) : toWorld * BeamFrame(ray);
    pulse.Origin = pulse.Origin + toWorld * offset;
  }
}

/// Turns the beam to the true direction of the pulse.
void PulseSource::TurnBeam(
  vtkIdType index, double headAngle, const Rotation& platform, Vec3 direction, Pulse& pulse) const
{
  pulse.FaultyTerms = 0;
  if (this->Errors)
  {
    using Model = vtkHeliosErrorModel;
    const double theta = vtkMath::RadiansFromDegrees(this->Deflector->GetScanAngle(index));
    const double deflection = vtkMath::DegreesFromRadians(
      UseTerm(this->Errors->GetDeflectionError(theta), Model::DEFLECTION_ERROR, pulse));
    const double turn = vtkMath::DegreesFromRadians(
      UseTerm(this->Errors->GetHeadError(theta), Model::HEAD_ERROR, pulse));
    direction = Rotate(AxisAngle({ 1.0, 0.0, 0.0 }, deflection), direction);
    const Quaternion head = this->TurnHead(headAngle + turn);
    pulse.Beam =
      platform * (Rotation(head * this->BeamOrigin.Orientation) * this->Roll.GetFrame(direction));
    this->MoveRay(head, platform, direction, pulse);
  }
  if (this->AngleAccuracy > 0.0)
  {
    const auto id = static_cast<std::uint64_t>(this->Ids.Get(index));
    const auto noise = NormalPair(this->Seed, RandomStream::AngleNoise, id, 0);
    Vec3 axis(this->AngleAccuracy * noise[0], 1.0, this->AngleAccuracy * noise[1]);
    axis.Normalize();
    const Vec3 turned = pulse.Beam * axis;
    pulse.Beam = this->Roll.IsOn ? TurnTo(pulse.Beam, turned) : BeamFrame(turned);
  }
}

} // namespace helios
