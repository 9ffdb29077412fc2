// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The stepwise motion of a part of a scene: a function of the step number only.

#ifndef heliosPartMotion_h
#define heliosPartMotion_h

#include "heliosPose.h"
#include "vtkHeliosFiltersSceneModule.h"

#include <vtkType.h>

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

/// The motion of a part; it starts with the first sequence.
class VTKHELIOSFILTERSSCENE_EXPORT PartMotion
{
public:
  explicit PartMotion(
    const std::vector<MotionSequence>& sequences, const Vec3& centroid = Vec3(0.0, 0.0, 0.0));

  /// Returns the map after a number of steps: powers of whole sequences, so errors do not
  /// accumulate.
  MotionMap GetMap(vtkIdType step) const;

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
  };

  static Vector Apply(const Matrix& m, const Vector& v);
  static Vector Normalize(const Vec3& v);
  static Matrix Turn(const Vector& axis, double degrees);
  static Matrix Mirror(const Vector& normal);
  Steps MakeStep(const Motion& motion) const;
  void AddLinks(const std::vector<MotionSequence>& sequences);
  Steps Walk(std::size_t link, vtkIdType& steps) const;
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
