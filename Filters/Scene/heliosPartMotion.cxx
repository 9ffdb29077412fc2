// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPartMotion.h"

#include <algorithm>
#include <cmath>

namespace helios
{

namespace
{

constexpr long double RadiansPerDegree = 3.141592653589793238462643383279502884L / 180.0L;

vtkIdType AddLengths(vtkIdType a, vtkIdType b)
{
  return a > VTK_ID_MAX - b ? VTK_ID_MAX : a + b;
}

} // namespace

//------------------------------------------------------------------------------
PartMotion::PartMotion(const std::vector<MotionSequence>& sequences, const Vec3& centroid)
  : Centroid(centroid)
{
  this->AddLinks(sequences);
  this->HeadLength = this->GetLength(0, this->CycleBegin);
  this->CycleLength = this->GetLength(this->CycleBegin, this->Chain.size());
  vtkIdType all = VTK_ID_MAX;
  if (this->CycleLength > 0)
  {
    this->Head = this->Walk(0, all = this->HeadLength);
    this->Cycle = this->Walk(this->CycleBegin, all = this->CycleLength);
  }
}

//------------------------------------------------------------------------------
/// Adds the sequences in order, until one repeats, is unlimited, or is the last.
void PartMotion::AddLinks(const std::vector<MotionSequence>& sequences)
{
  std::vector<std::size_t> places(sequences.size(), MotionSequence::None);
  std::size_t next = sequences.empty() ? MotionSequence::None : 0;
  while (next != MotionSequence::None && places[next] == MotionSequence::None)
  {
    const MotionSequence& sequence = sequences[next];
    Link link;
    for (const Motion& motion : sequence.Motions)
    {
      link.Step = this->MakeStep(motion) * link.Step;
      link.Rests = link.Rests && motion.Kind == MotionKind::Identity;
      link.Motions.push_back(motion);
    }
    link.Loop = sequence.Loop > 0 ? sequence.Loop : VTK_ID_MAX;
    places[next] = this->Chain.size();
    this->Chain.push_back(link);
    next = sequence.Loop > 0 ? sequence.Next : MotionSequence::None;
  }
  this->CycleBegin = next == MotionSequence::None ? this->Chain.size() : places[next];
}

//------------------------------------------------------------------------------
vtkIdType PartMotion::GetLength(std::size_t begin, std::size_t end) const
{
  vtkIdType length = 0;
  for (std::size_t i = begin; i < end; ++i)
  {
    length = AddLengths(length, this->Chain[i].Loop);
  }
  return length;
}

//------------------------------------------------------------------------------
/// Walks the chain from a link on; steps becomes the number left at its end.
PartMotion::Steps PartMotion::Walk(std::size_t link, vtkIdType& steps) const
{
  Steps all;
  for (; link < this->Chain.size() && steps > 0; ++link)
  {
    const vtkIdType count = std::min(steps, this->Chain[link].Loop);
    all = (this->Chain[link].Step ^ count) * all;
    steps -= count;
  }
  return all;
}

//------------------------------------------------------------------------------
PartMotion::Steps PartMotion::GetSteps(vtkIdType step) const
{
  Steps all;
  if (this->CycleLength > 0 && step > this->HeadLength)
  {
    const vtkIdType steps = step - this->HeadLength;
    vtkIdType rest = steps % this->CycleLength;
    all = (this->Cycle ^ (steps / this->CycleLength)) * this->Head;
    all = this->Walk(this->CycleBegin, rest) * all;
  }
  else
  {
    all = this->Walk(0, step);
  }
  return all;
}

//------------------------------------------------------------------------------
MotionMap PartMotion::GetMap(vtkIdType step) const
{
  const Steps all = this->GetSteps(step);
  MotionMap map;
  map.Center = this->Centroid;
  for (int i = 0; i < 3; ++i)
  {
    map.Shift[i] = static_cast<double>(all.Shift.V[i]);
    for (int j = 0; j < 3; ++j)
    {
      map.Linear.M[i][j] = static_cast<double>(all.Turn.M[i][j]);
      map.Turns = map.Turns || map.Linear.M[i][j] != (i == j ? 1.0 : 0.0);
    }
  }
  return map;
}

//------------------------------------------------------------------------------
vtkIdType PartMotion::FindNextMove(vtkIdType step) const
{
  vtkIdType begin = 0; // first step of a link
  if (this->CycleLength > 0 && step >= this->HeadLength)
  {
    begin = step - (step - this->HeadLength) % this->CycleLength;
  }
  std::size_t link = begin > 0 ? this->CycleBegin : 0;
  for (std::size_t i = 0; i < 2 * this->Chain.size(); ++i) // at most one cycle
  {
    if (link == this->Chain.size())
    {
      if (this->CycleLength == 0)
      {
        return VTK_ID_MAX;
      }
      link = this->CycleBegin;
    }
    const vtkIdType end = AddLengths(begin, this->Chain[link].Loop);
    if (end > step && !this->Chain[link].Rests)
    {
      return std::max(begin, step) + 1;
    }
    begin = end;
    ++link;
  }
  return VTK_ID_MAX;
}

//------------------------------------------------------------------------------
vtkIdType PartMotion::FindLastMove(vtkIdType step) const
{
  if (this->CycleLength > 0 && step > this->HeadLength)
  {
    const vtkIdType begin = step - 1 - (step - 1 - this->HeadLength) % this->CycleLength;
    vtkIdType last = this->FindLastMove(this->CycleBegin, begin, step);
    if (last == 0 && begin > this->HeadLength)
    {
      last = this->FindLastMove(this->CycleBegin, begin - this->CycleLength, begin);
    }
    if (last > 0)
    {
      return last;
    }
    step = this->HeadLength; // the cycle does not move
  }
  return this->FindLastMove(0, 0, step);
}

//------------------------------------------------------------------------------
/// Returns the same along the chain from a link on that begins after a step.
vtkIdType PartMotion::FindLastMove(std::size_t link, vtkIdType begin, vtkIdType step) const
{
  vtkIdType last = 0;
  for (; link < this->Chain.size() && begin < step; ++link)
  {
    const vtkIdType end = AddLengths(begin, this->Chain[link].Loop);
    last = this->Chain[link].Rests ? last : std::min(end, step);
    begin = end;
  }
  return last;
}

//------------------------------------------------------------------------------
PartMotion::Steps PartMotion::MakeStep(const Motion& motion) const
{
  Steps step;
  Vector move; // [m], of the centroid
  const Vector axis = Normalize(motion.Vector);
  const auto addAlong = [&move](const Vector& direction, Real length)
  {
    for (int i = 0; i < 3; ++i)
    {
      move.V[i] += length * direction.V[i];
    }
  };
  const auto add = [&addAlong](const Vec3& v) {
    addAlong({ { Real(v[0]), Real(v[1]), Real(v[2]) } }, 1.0L);
  };
  Vec3 center = motion.Center;
  switch (motion.Kind)
  {
    case MotionKind::Identity:
      return step;
    case MotionKind::Translation:
      add(motion.Vector);
      break;
    case MotionKind::Helical:
      addAlong(axis, motion.Glide);
      step.Turn = Turn(axis, motion.Angle);
      center = Vec3(0.0, 0.0, 0.0);
      break;
    case MotionKind::Rotation:
      step.Turn = Turn(axis, motion.Angle);
      break;
    case MotionKind::RotaryReflection:
      step.Turn = Turn(axis, motion.Angle) * Mirror(axis);
      break;
    case MotionKind::GlidePlane:
      add(motion.Shift);
      step.Turn = Mirror(axis);
      center = Vec3(0.0, 0.0, 0.0);
      break;
    case MotionKind::Reflection:
      step.Turn = Mirror(axis);
      center = Vec3(0.0, 0.0, 0.0);
      break;
  }
  // Relative to the old, or the new, centroid the fixed point is f: c' = B c + f - B f.
  Vector fixed;
  for (int i = 0; i < 3; ++i)
  {
    fixed.V[i] = Real(center[i]) - (motion.IsSelf ? Real(0) : Real(this->Centroid[i]));
  }
  const bool turns = motion.Kind != MotionKind::Translation;
  const Vector turned = Apply(step.Turn, fixed);
  for (int i = 0; turns && i < 3; ++i)
  {
    move.V[i] += fixed.V[i] - turned.V[i];
  }
  step.Path = motion.IsSelf ? Matrix() : step.Turn;
  step.Shift = move;
  return step;
}

//------------------------------------------------------------------------------
PartMotion::Matrix PartMotion::Matrix::operator*(const Matrix& b) const
{
  Matrix product;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      product.M[i][j] =
        this->M[i][0] * b.M[0][j] + this->M[i][1] * b.M[1][j] + this->M[i][2] * b.M[2][j];
    }
  }
  return product;
}

//------------------------------------------------------------------------------
PartMotion::Steps PartMotion::Steps::operator*(const Steps& b) const
{
  Steps both{ this->Turn * b.Turn, this->Path * b.Path, Apply(this->Path, b.Shift) };
  for (int i = 0; i < 3; ++i)
  {
    both.Shift.V[i] += this->Shift.V[i];
  }
  return both;
}

//------------------------------------------------------------------------------
/// Computes a power by squaring.
PartMotion::Steps PartMotion::Steps::operator^(vtkIdType power) const
{
  Steps result;
  for (Steps square = *this; power > 0; square = square * square, power /= 2)
  {
    result = power % 2 == 1 ? square * result : result;
  }
  return result;
}

//------------------------------------------------------------------------------
PartMotion::Vector PartMotion::Apply(const Matrix& m, const Vector& v)
{
  Vector result;
  for (int i = 0; i < 3; ++i)
  {
    result.V[i] = m.M[i][0] * v.V[0] + m.M[i][1] * v.V[1] + m.M[i][2] * v.V[2];
  }
  return result;
}

//------------------------------------------------------------------------------
PartMotion::Vector PartMotion::Normalize(const Vec3& v)
{
  const Real length = std::hypot(Real(v[0]), Real(v[1]), Real(v[2]));
  const Real factor = length > 0 ? 1 / length : 0;
  return { { factor * v[0], factor * v[1], factor * v[2] } };
}

//------------------------------------------------------------------------------
/// Returns a right-handed rotation by Rodrigues' formula.
PartMotion::Matrix PartMotion::Turn(const Vector& axis, double degrees)
{
  const Real angle = RadiansPerDegree * std::remainder(degrees, 360.0);
  const Real c = std::cos(angle);
  const Real s = std::sin(angle);
  const Real half = std::sin(angle / 2);
  const Real* u = axis.V;
  const Real cross[3][3] = { { 0, -u[2], u[1] }, { u[2], 0, -u[0] }, { -u[1], u[0], 0 } };
  Matrix turn;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      turn.M[i][j] = (i == j ? c : 0) + 2 * half * half * u[i] * u[j] + s * cross[i][j];
    }
  }
  return turn;
}

//------------------------------------------------------------------------------
PartMotion::Matrix PartMotion::Mirror(const Vector& normal)
{
  Matrix mirror;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      mirror.M[i][j] = (i == j ? 1 : 0) - 2 * normal.V[i] * normal.V[j];
    }
  }
  return mirror;
}

} // namespace helios
