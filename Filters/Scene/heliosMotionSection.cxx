// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Steps as screws, and the motion between them.
#include "heliosPartMotion.h"

#include <algorithm>
#include <cmath>

namespace helios
{

namespace
{

using Real = long double;
constexpr Real MinimumSine = 1e-15L; // sine of half the angle of a rotation
constexpr Real Pi = 3.141592653589793238462643383279502884L;

/// Returns the right-handed rotation about a unit axis by an angle [rad].
Rotation Turn(const Vec3& u, Real angle)
{
  const auto turn = static_cast<double>(std::remainder(angle, 2 * Pi));
  const double s = std::sin(turn);
  const double half = std::sin(0.5 * turn);
  const double cross[3][3] = { { 0.0, -u[2], u[1] }, { u[2], 0.0, -u[0] }, { -u[1], u[0], 0.0 } };
  Rotation r;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      const double across = u[i] * u[j] - (i == j ? 1.0 : 0.0);
      r.M[i][j] = (i == j ? 1.0 : 0.0) + 2.0 * half * half * across + s * cross[i][j];
    }
  }
  return r;
}

Vec3 ToVector(const Real v[3])
{
  return { static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2]) };
}

bool IsRotating(const Motion& motion)
{
  return motion.Kind == MotionKind::Rotation || motion.Kind == MotionKind::Helical;
}

bool IsMirroring(const Motion& motion)
{
  return motion.Kind == MotionKind::Reflection || motion.Kind == MotionKind::GlidePlane ||
    motion.Kind == MotionKind::RotaryReflection;
}

/// Returns the axis of a rotation, and sets its angle, in [0, pi].
Vec3 FindAxis(const Real m[3][3], Real& angle)
{
  const Vec3 odd(static_cast<double>(m[2][1] - m[1][2]), static_cast<double>(m[0][2] - m[2][0]),
    static_cast<double>(m[1][0] - m[0][1]));
  const double sine = 0.5 * odd.Norm();
  angle = std::atan2(Real(sine), (m[0][0] + m[1][1] + m[2][2] - 1) / 2);
  if (sine > 1e-6 || angle < 1)
  {
    return sine > 0.0 ? (0.5 / sine) * odd : Vec3(0.0, 0.0, 1.0);
  }
  int k = 0; // half a turn: the largest column of (M + 1) / 2 = u u^T
  k = m[1][1] > m[k][k] ? 1 : k;
  k = m[2][2] > m[k][k] ? 2 : k;
  Vec3 axis(
    static_cast<double>(m[0][k]), static_cast<double>(m[1][k]), static_cast<double>(m[2][k]));
  axis[k] += 1.0;
  axis.Normalize();
  return axis.Dot(odd) < 0.0 ? -1.0 * axis : axis;
}

/// Finds a point on the axis of one rotation, from the centroid, and the way along it.
bool FindPath(
  const Motion& rotation, const Vec3& centroid, const Vec3& axis, Vec3& glide, Real fixed[3])
{
  const bool isHelix = rotation.Kind == MotionKind::Helical;
  glide = isHelix ? rotation.Glide * axis : Vec3(0.0, 0.0, 0.0);
  for (int i = 0; i < 3; ++i)
  {
    fixed[i] = Real(isHelix ? 0.0 : rotation.Center[i]) - Real(centroid[i]);
  }
  return true;
}

/// Likewise of a rotation with a shift: the point that, across the axis, stays where it is,
/// (1 - R) p = w. False for whole turns, which have none.
bool FindPath(const Real shift[3], Real angle, const Vec3& axis, Vec3& glide, Real fixed[3])
{
  const Real half = angle / 2;
  if (std::abs(std::sin(half)) < MinimumSine)
  {
    return false;
  }
  const Real along = shift[0] * axis[0] + shift[1] * axis[1] + shift[2] * axis[2];
  const Real w[3] = { shift[0] - along * axis[0], shift[1] - along * axis[1],
    shift[2] - along * axis[2] };
  const Real cross[3] = { axis[1] * w[2] - axis[2] * w[1], axis[2] * w[0] - axis[0] * w[2],
    axis[0] * w[1] - axis[1] * w[0] };
  glide = static_cast<double>(along) * axis;
  for (int i = 0; i < 3; ++i)
  {
    fixed[i] = (w[i] + cross[i] / std::tan(half)) / 2;
  }
  return true;
}

} // namespace

//------------------------------------------------------------------------------
MotionSection PartMotion::GetSection(vtkIdType step) const
{
  MotionSection section;
  section.Centroid = this->Centroid;
  vtkIdType begin = 0;
  std::size_t link = 0;
  if (this->CycleLength > 0 && step >= this->HeadLength)
  {
    begin = step - (step - this->HeadLength) % this->CycleLength;
    link = this->CycleBegin;
  }
  while (link < this->Chain.size() && this->Chain[link].Loop <= step - begin)
  {
    begin += this->Chain[link++].Loop;
  }
  section.Begin = begin;
  const Steps all = this->GetSteps(begin);
  for (int i = 0; i < 3; ++i)
  {
    section.Shift[i] = static_cast<double>(all.Shift.V[i]);
    for (int j = 0; j < 3; ++j)
    {
      section.Turned.M[i][j] = static_cast<double>(all.Turn.M[i][j]);
      section.HasTurned = section.HasTurned || section.Turned.M[i][j] != (i == j ? 1.0 : 0.0);
    }
  }
  if (link < this->Chain.size())
  {
    const Link& next = this->Chain[link];
    section.End = next.Loop > VTK_ID_MAX - begin ? VTK_ID_MAX : begin + next.Loop;
    this->SetScrew(next, section);
  }
  return section;
}

//------------------------------------------------------------------------------
/// Sets the screw of a step. Of one rotation its own axis and angle count, which may be more than a
/// turn; of several the rotation that they are together.
void PartMotion::SetScrew(const Link& link, MotionSection& section) const
{
  const auto& motions = link.Motions;
  const Steps& s = link.Step;
  const Vec3 at = section.Shift;
  const Vector to = Apply(s.Path, { { at[0], at[1], at[2] } });
  const Real move[3] = { to.V[0] + s.Shift.V[0] - at[0], to.V[1] + s.Shift.V[1] - at[1],
    to.V[2] + s.Shift.V[2] - at[2] };
  section.Chord = ToVector(move).Norm();
  section.Mirrors = std::any_of(motions.begin(), motions.end(), IsMirroring);
  if (section.Mirrors)
  {
    return;
  }
  const auto rotating = std::find_if(motions.begin(), motions.end(), IsRotating);
  const bool isOne = std::count_if(motions.begin(), motions.end(), IsRotating) == 1;
  section.TurnAxis = FindAxis(s.Turn.M, section.TurnAngle);
  section.PathAxis = FindAxis(s.Path.M, section.PathAngle);
  section.Glide = ToVector(s.Shift.V);
  if (isOne)
  {
    section.TurnAxis = rotating->Vector;
    section.TurnAxis.Normalize();
    section.TurnAngle = rotating->Angle * Pi / 180;
    section.PathAxis = section.TurnAxis;
    section.PathAngle = rotating->IsSelf ? 0 : section.TurnAngle;
  }
  const bool isAlone = isOne &&
    std::count_if(motions.begin(), motions.end(),
      [](const Motion& motion) { return motion.Kind != MotionKind::Identity; }) == 1;
  if (section.PathAngle == 0)
  {
    return; // the centroid moves straight on
  }
  const bool hasAxis = isAlone
    ? FindPath(*rotating, this->Centroid, section.PathAxis, section.Glide, section.Fixed)
    : FindPath(s.Shift.V, section.PathAngle, section.PathAxis, section.Glide, section.Fixed);
  section.PathAngle = hasAxis ? section.PathAngle : 0;
}

//------------------------------------------------------------------------------
/// Returns the shift of the centroid some steps after the begin.
Vec3 MotionSection::GetCentroid(Real since) const
{
  Vec3 arm(0.0, 0.0, 0.0);
  for (int i = 0; i < 3; ++i)
  {
    arm[i] = static_cast<double>(Real(this->Shift[i]) - this->Fixed[i]);
  }
  const Vec3 turned =
    this->PathAngle != 0 ? Turn(this->PathAxis, since * this->PathAngle) * arm : arm;
  const auto steps = static_cast<double>(since);
  Vec3 shift(0.0, 0.0, 0.0);
  for (int i = 0; i < 3; ++i)
  {
    shift[i] = static_cast<double>(
                 this->PathAngle != 0 ? this->Fixed[i] + turned[i] : Real(this->Shift[i])) +
      steps * this->Glide[i];
  }
  return shift;
}

//------------------------------------------------------------------------------
MotionMap MotionSection::GetMap(double steps) const
{
  const Real since = Real(steps) - Real(this->Begin);
  MotionMap map;
  map.Center = this->Centroid;
  map.Shift = this->GetCentroid(since);
  map.Turns = this->HasTurned || this->TurnAngle != 0;
  if (this->TurnAngle != 0)
  {
    const Rotation turn = Turn(this->TurnAxis, since * this->TurnAngle);
    map.Linear = this->HasTurned ? turn * this->Turned : turn;
  }
  else
  {
    map.Linear = this->Turned;
  }
  return map;
}

//------------------------------------------------------------------------------
double MotionSection::GetArc() const
{
  Vec3 velocity, rotation;
  this->GetRates(static_cast<double>(this->Begin), velocity, rotation);
  return velocity.Norm();
}

//------------------------------------------------------------------------------
void MotionSection::GetRates(double steps, Vec3& velocity, Vec3& rotation) const
{
  rotation = static_cast<double>(this->TurnAngle) * this->TurnAxis;
  velocity = this->Glide;
  if (this->PathAngle != 0)
  {
    const Vec3 at = this->GetCentroid(Real(steps) - Real(this->Begin));
    Vec3 arm(0.0, 0.0, 0.0);
    for (int i = 0; i < 3; ++i)
    {
      arm[i] = static_cast<double>(Real(at[i]) - this->Fixed[i]);
    }
    velocity = velocity + (static_cast<double>(this->PathAngle) * this->PathAxis).Cross(arm);
  }
}

} // namespace helios
