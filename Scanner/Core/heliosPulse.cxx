// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPulse.h"

#include "vtkHeliosBeamDeflector.h"

#include "heliosPhase.h"

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

bool PulseSource::GetPulse(vtkIdType index, Trajectory::Cursor& cursor, Pulse& pulse) const
{
  double direction[3];
  if (!this->Deflector->GetDirection(index, direction))
  {
    return false;
  }
  const double elapsed = PulseTime(0.0, index, this->PulseFrequency);
  pulse.Time = this->StartTime + elapsed;

  Rotation platform;
  const Vec3 position = this->Platform->GetPosition(pulse.Time, cursor, platform);
  Quaternion head = this->Mount.Orientation;
  const double headAngle = this->HeadStart + this->HeadSpeed * elapsed;
  if (headAngle != 0.0)
  {
    head = head * AxisAngle(this->HeadAxis, headAngle);
  }
  pulse.Origin =
    position + platform * (this->Mount.Position + Rotate(head, this->BeamOrigin.Position));
  pulse.Beam =
    platform * (Rotation(head * this->BeamOrigin.Orientation) * BeamFrame(Vec3(direction)));
  return true;
}

} // namespace helios
