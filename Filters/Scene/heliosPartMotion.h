// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The stepwise motion of a part of a scene: a function of the step number only.

#ifndef heliosPartMotion_h
#define heliosPartMotion_h

#include "heliosPose.h"
#include "vtkHeliosFiltersSceneModule.h"

#include <vtkType.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace helios
{

enum class MotionKind
{
  Identity,
  Translation,
  Rotation,
  Reflection,
  GlidePlane,
  Helical,
  RotaryReflection
};

/// One motion within a step.
struct Motion
{
  MotionKind Kind = MotionKind::Identity;
  Vec3 Vector{ 0.0, 0.0, 0.0 }; ///< translation [m]; else axis, or normal of a plane; not 0
  double Angle = 0.0;           ///< [deg] per step
  Vec3 Center{ 0.0, 0.0, 0.0 }; ///< [m], of a rotation: a point on the axis
  Vec3 Shift{ 0.0, 0.0, 0.0 };  ///< [m], of a glide plane
  double Glide = 0.0;           ///< [m], along the axis of a helix
  /// in the frame of the part's centroid; else in the frame of the scene
  bool IsSelf = false;
};

/// The motions of a step, in order, and the number of steps.
struct MotionSequence
{
  static constexpr std::size_t None = static_cast<std::size_t>(-1);

  std::vector<Motion> Motions;
  vtkIdType Loop = 0;      ///< steps; 0: unlimited
  std::size_t Next = None; ///< the next sequence
};

/// Maps a point: p' = p + Shift without rotation, else Center + Linear (p - Center) + Shift.
struct MotionMap
{
  bool Turns = false;
  Rotation Linear; ///< or a reflection
  Vec3 Center{ 0.0, 0.0, 0.0 };
  Vec3 Shift{ 0.0, 0.0, 0.0 };

  Vec3 operator*(const Vec3& p) const
  {
    return this->Turns ? this->Center + this->Linear * (p - this->Center) + this->Shift
                       : p + this->Shift;
  }
};

/**
 * A run of equal steps, at any fraction of a step: a step is a screw, whose powers are the motion in
 * between. The part rotates about the axis of Turn, and its centroid about the axis of Path while it
 * glides along it.
 */
class VTKHELIOSFILTERSSCENE_EXPORT MotionSection
{
public:
  vtkIdType GetBegin() const { return this->Begin; }
  vtkIdType GetEnd() const { return this->End; } ///< VTK_ID_MAX: none

  /// Returns the map after a number of steps since the start of the motion, in the section.
  MotionMap GetMap(double steps) const;

  /// Returns the rotation [rad] and the way of the centroid [m] in a step: along an arc, and
  /// straight; and whether steps mirror the part, so that there are no fractions of steps.
  double GetAngle() const { return std::abs(this->TurnAngle); }
  double GetArc() const;
  double GetChord() const { return this->Chord; }
  bool IsMirror() const { return this->Mirrors; }

  /// Computes the derivatives by steps: velocity of the centroid, and the rotation.
  void GetRates(double steps, Vec3& velocity, Vec3& rotation) const;

private:
  friend class PartMotion;
  using Real = long double;

  Vec3 GetCentroid(Real since) const;

  vtkIdType Begin = 0;
  vtkIdType End = VTK_ID_MAX;
  Vec3 Centroid{ 0.0, 0.0, 0.0 }; // at the start of the motion
  Vec3 Shift{ 0.0, 0.0, 0.0 };    // shift of the centroid, at the begin
  Rotation Turned;                // at the begin
  bool HasTurned = false;         // it is not the identity
  bool Mirrors = false;
  Vec3 TurnAxis{ 0.0, 0.0, 1.0 };
  Real TurnAngle = 0; // [rad] a step
  Vec3 PathAxis{ 0.0, 0.0, 1.0 };
  Real PathAngle = 0;          // [rad] a step; 0: the centroid moves straight on
  Real Fixed[3] = { 0, 0, 0 }; // a point on that axis, from the centroid
  Vec3 Glide{ 0.0, 0.0, 0.0 }; // [m] a step
  double Chord = 0.0;
};

/// The motion of a part; it starts with the first sequence.
class VTKHELIOSFILTERSSCENE_EXPORT PartMotion
{
public:
  explicit PartMotion(
    const std::vector<MotionSequence>& sequences, const Vec3& centroid = Vec3(0.0, 0.0, 0.0));

  /// Returns the map after a number of steps: powers of whole sequences, so errors do not
  /// accumulate.
  MotionMap GetMap(vtkIdType step) const;

  /// Returns the section of the steps that follow a step.
  MotionSection GetSection(vtkIdType step) const;

  /// Returns the first step after this one that moves the part; VTK_ID_MAX: none.
  vtkIdType FindNextMove(vtkIdType step) const;

  /// Returns the last step up to this one that moved the part; 0: none. The part has not moved
  /// since.
  vtkIdType FindLastMove(vtkIdType step) const;

  /// Returns whether the part ever moves.
  bool IsMoving() const { return this->FindNextMove(0) != VTK_ID_MAX; }

private:
  /// Numbers in long double: the error of a million steps is below double precision.
  using Real = long double;
  struct Matrix
  {
    Real M[3][3] = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
    Matrix operator*(const Matrix& b) const;
  };
  struct Vector
  {
    Real V[3] = { 0, 0, 0 };
  };
  /// The effect of steps, relative to the initial centroid: the part is rotated by Turn, and its
  /// centroid c moves to Path c + Shift.
  struct Steps
  {
    Matrix Turn;
    Matrix Path;
    Vector Shift;

    /// Applies b first, then this.
    Steps operator*(const Steps& b) const;
    Steps operator^(vtkIdType power) const;
  };
  /// A sequence in the chain.
  struct Link
  {
    Steps Step;
    bool Rests = true;
    vtkIdType Loop = VTK_ID_MAX;
    std::vector<Motion> Motions;
  };

  static Vector Apply(const Matrix& m, const Vector& v);
  static Vector Normalize(const Vec3& v);
  static Matrix Turn(const Vector& axis, double degrees);
  static Matrix Mirror(const Vector& normal);
  Steps MakeStep(const Motion& motion) const;
  void AddLinks(const std::vector<MotionSequence>& sequences);
  Steps Walk(std::size_t link, vtkIdType& steps) const;
  Steps GetSteps(vtkIdType step) const;
  void SetScrew(const Link& link, MotionSection& section) const;
  vtkIdType FindLastMove(std::size_t link, vtkIdType begin, vtkIdType step) const;
  vtkIdType GetLength(std::size_t begin, std::size_t end) const;

  Vec3 Centroid;
  std::vector<Link> Chain;
  std::size_t CycleBegin = 0; // in the chain; its end: no cycle
  vtkIdType HeadLength = 0;   // steps before the cycle
  vtkIdType CycleLength = 0;  // 0: no cycle
  Steps Head;
  Steps Cycle;
};

} // namespace helios

#endif
