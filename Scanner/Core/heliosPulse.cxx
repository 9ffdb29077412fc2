// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPulse.h"

#include "vtkHeliosBeamDeflector.h"

#include "heliosPhase.h"
#include "heliosRandom.h"
#include "vtkHeliosErrorModel.h"
#include "vtkHeliosPlatformNoise.h"

#include <cmath>

namespace helios
{

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

Quaternion PulseSource::GetHead(double angle) const
{
  return angle != 0.0 ? this->Mount.Orientation * AxisAngle(this->HeadAxis, angle)
                      : this->Mount.Orientation;
}

bool PulseSource::GetPulse(vtkIdType index, Trajectory::Cursor& cursor, Pulse& pulse) const
{
  double direction[3];
  if (!this->Deflector->GetDirection(index, direction))
  {
    return false;
  }
  const double elapsed =
    PulseTime(0.0, index, this->PulseFrequency) + this->Deflector->GetDelay(index);
  pulse.Id = this->Ids.Get(index);
  pulse.Channel = this->Deflector->GetChannel(index);
  pulse.Time = this->StartTime + elapsed;

  Rotation platform;
  Vec3 position = this->Platform->GetPosition(pulse.Time, cursor, platform);
  const double headAngle = this->HeadStart + this->HeadSpeed * elapsed;
  const Quaternion head = this->GetHead(headAngle);
  const bool isUnknown = this->Noise && this->Noise->IsUnknown();
  if (this->Noise && !isUnknown)
  {
    this->Shake(index, position, platform);
  }
  this->PlaceBeam(position, platform, head, Vec3(direction), pulse);
  pulse.Reported = pulse.GetDirection();
  pulse.ReportedOrigin = pulse.Origin;
  if (isUnknown)
  {
    this->Shake(index, position, platform);
    this->PlaceBeam(position, platform, head, Vec3(direction), pulse);
  }
  if (this->Errors || this->AngleAccuracy > 0.0)
  {
    this->TurnBeam(index, headAngle, platform, Vec3(direction), pulse);
  }
  return true;
}

/// The beam of a platform at a pose.
void PulseSource::PlaceBeam(const Vec3& position, const Rotation& platform, const Quaternion& head,
  const Vec3& direction, Pulse& pulse) const
{
  pulse.Origin =
    position + platform * (this->Mount.Position + Rotate(head, this->BeamOrigin.Position));
  pulse.Beam = platform * (Rotation(head * this->BeamOrigin.Orientation) * BeamFrame(direction));
}

/// Moves and turns the platform by its noise.
void PulseSource::Shake(vtkIdType index, Vec3& position, Rotation& platform) const
{
  double values[6];
  this->Noise->GetValues(static_cast<vtkIdType>(this->Seed), this->Ids.Get(index), values);
  position = position + Vec3(values);
  if (values[3] != 0.0 || values[4] != 0.0 || values[5] != 0.0)
  {
    platform = platform *
      Rotation(AxisAngle({ 1.0, 0.0, 0.0 }, values[3]) * AxisAngle({ 0.0, 1.0, 0.0 }, values[4]) *
        AxisAngle({ 0.0, 0.0, 1.0 }, values[5]));
  }
}

/// Turns the beam to where the pulse really goes.
void PulseSource::TurnBeam(
  vtkIdType index, double headAngle, const Rotation& platform, Vec3 direction, Pulse& pulse) const
{
  if (this->Errors)
  {
    const double theta = vtkMath::RadiansFromDegrees(this->Deflector->GetScanAngle(index));
    const double deflection = vtkMath::DegreesFromRadians(this->Errors->GetDeflectionError(theta));
    const double turn = vtkMath::DegreesFromRadians(this->Errors->GetHeadError(theta));
    direction = Rotate(AxisAngle({ 1.0, 0.0, 0.0 }, deflection), direction);
    pulse.Beam = platform *
      (Rotation(this->GetHead(headAngle + turn) * this->BeamOrigin.Orientation) *
        BeamFrame(direction));
  }
  if (this->AngleAccuracy > 0.0)
  {
    const auto id = static_cast<std::uint64_t>(this->Ids.Get(index));
    const auto noise = NormalPair(this->Seed, RandomStream::AngleNoise, id, 0);
    Vec3 axis(this->AngleAccuracy * noise[0], 1.0, this->AngleAccuracy * noise[1]);
    axis.Normalize();
    pulse.Beam = BeamFrame(pulse.Beam * axis);
  }
}

} // namespace helios
