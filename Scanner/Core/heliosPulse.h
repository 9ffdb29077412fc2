// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A pulse in the world: time, position and the frame of its beam.

#ifndef heliosPulse_h
#define heliosPulse_h

#include "heliosDriftState.h"
#include "heliosPose.h"
#include "heliosTrajectory.h"
#include "vtkHeliosScannerCoreModule.h" // For export macro

#include <vtkType.h>

#include <cstdint>
#include <limits>

class vtkHeliosBeamDeflector;
class vtkHeliosErrorModel;
class vtkHeliosPlatformNoise;

namespace helios
{

struct Pulse
{
  vtkIdType Id;
  double Time;
  Vec3 Origin;
  Rotation Beam; // from the frame of the beam, whose axis is y and major axis x, to the world
  Vec3 Reported; // the direction reported by the instrument
  Vec3 ReportedOrigin;
  int Channel; // channel of the deflector
  /// Faulty terms of the error model: a bit for each term that has no usable value and is left out.
  unsigned FaultyTerms = 0;

  Vec3 GetDirection() const { return this->GetAxis(1); }
  Vec3 GetMajorAxis() const { return this->GetAxis(0); }
  Vec3 GetMinorAxis() const { return this->GetAxis(2); }

private:
  Vec3 GetAxis(int axis) const
  {
    return { this->Beam.M[0][axis], this->Beam.M[1][axis], this->Beam.M[2][axis] };
  }
};

/// The major axis of an elliptical beam: an axis of the deflector, projected across the beam and
/// rotated about it.
struct VTKHELIOSSCANNERCORE_EXPORT BeamRoll
{
  bool IsOn = false; // else any frame will do
  Vec3 CrossAxis{ 1.0, 0.0, 0.0 };
  double Angle = 0.0; // [deg], clockwise along the beam

  /// Returns the frame of a beam along a unit vector.
  Rotation GetFrame(const Vec3& direction) const;
};

/// The ids of the pulses 0, 1, 2 ...
struct PulseIds
{
  vtkIdType First = 0;
  vtkIdType Stride = 1;

  vtkIdType Get(vtkIdType index) const { return this->First + index * this->Stride; }
};

/**
 * The chain of frames from the platform to the deflector: A = A_platform A_mount R_head A_beam, and
 * the lever arms rotate with the attitude, origin = p + A_platform (m + A_mount R_head (b + A_beam
 * o)), with o of the deflector. Errors
 * of deflector, head and angles turn the beam, not the reported direction. Noise moves the
 * platform; its Mode decides whether that is reported. Navigation errors are never reported.
 */
struct PulseSource
{
  const Trajectory* Platform;
  const vtkHeliosBeamDeflector* Deflector;
  double StartTime;
  double PulseFrequency;
  Pose Mount;
  Pose BeamOrigin;
  Vec3 HeadAxis;
  double HeadStart; // [deg]
  double HeadSpeed; // [deg/s]
  const vtkHeliosErrorModel* Errors = nullptr;
  const vtkHeliosPlatformNoise* Noise = nullptr; // null: none
  double AngleAccuracy = 0.0;                    // [rad]
  BeamRoll Roll;
  double PoseInterval = 0.0; // the platform stands still for so long [s]; 0: it does not
  std::uint64_t Seed = 0;
  PulseIds Ids;

  /// The head on the platform, rotated by an angle.
  struct Head
  {
    double Angle = std::numeric_limits<double>::quiet_NaN();
    Rotation Beam; // from the frame of the deflector
    Vec3 Lever;    // to the beam origin
  };

  /// State kept from the previous pulse; one per thread.
  struct Cursor
  {
    Trajectory::Cursor Platform;
    PulseSource::Head Head;
    Trajectory::Cursor TruePlatform; // with a clock offset
    DriftState SlowErrors;
  };

  /// Computes pulse number index; false if the deflector emits none.
  bool GetPulse(vtkIdType index, Cursor& cursor, Pulse& pulse) const;

  /// Returns the velocity of the origin of a pulse [m/s], by trajectory and head, without noise.
  Vec3 GetVelocity(vtkIdType index, Cursor& cursor) const;

private:
  double GetPoseTime(double elapsed) const;
  Quaternion TurnHead(double angle) const;
  const Head& GetHead(double angle, Cursor& cursor) const;
  Vec3 GetLever(vtkIdType index, const Head& head) const;
  void PlaceBeam(const Vec3& position, const Rotation& platform, const Vec3& lever,
    const Rotation& beam, Pulse& pulse) const;
  void AddNoise(vtkIdType index, Vec3& position, Rotation& platform) const;
  void MoveToTruth(
    vtkIdType index, double elapsed, Cursor& cursor, Vec3& position, Rotation& platform) const;
  void AddErrors(double time, Cursor& cursor, Vec3& position, Rotation& platform) const;
  void MoveRay(
    const Quaternion& head, const Rotation& platform, const Vec3& direction, Pulse& pulse) const;
  void TurnBeam(vtkIdType index, double headAngle, const Rotation& platform, Vec3 direction,
    Pulse& pulse) const;
};

/// Returns a frame whose y axis is a unit vector (Duff et al. 2017, J. Computer Graphics Techniques
/// 6).
Rotation BeamFrame(const Vec3& axis);

} // namespace helios

#endif
