// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosMotion.h"

#include "heliosHermite.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace helios
{
namespace
{

/// Returns the angle between two attitudes [rad], accurate for small angles.
double GetAngle(const Quaternion& a, const Quaternion& b)
{
  const Quaternion d = a.Conjugated() * b;
  const double sine = std::sqrt(d.GetX() * d.GetX() + d.GetY() * d.GetY() + d.GetZ() * d.GetZ());
  return 2.0 * std::atan2(sine, std::abs(d.GetW()));
}

class Sampler
{
public:
  Sampler(const MotionPiece& piece, double tolerance, std::vector<MotionSample>& samples)
    : Piece(piece)
    , Tolerance(tolerance)
    , Samples(samples)
  {
  }

  /// Appends the samples between two samples, and the second.
  void Fill(const MotionSample& a, const MotionSample& b, int depth)
  {
    const double middle = 0.5 * (a.Time + b.Time);
    const MotionSample m{ middle, this->Piece.At(middle) };
    const bool small = !(a.Time < middle && middle < b.Time) || depth == 0;
    if (small || (this->Fits(a, b, m) && this->FitsAt(a, b, 0.25) && this->FitsAt(a, b, 0.75)))
    {
      this->Samples.push_back(b);
      return;
    }
    this->Fill(a, m, depth - 1);
    this->Fill(m, b, depth - 1);
  }

private:
  bool FitsAt(const MotionSample& a, const MotionSample& b, double s) const
  {
    const double t = a.Time + s * (b.Time - a.Time);
    return this->Fits(a, b, { t, this->Piece.At(t) });
  }

  /// Returns whether the interpolation of two samples is accurate at a time.
  bool Fits(const MotionSample& a, const MotionSample& b, const MotionSample& truth) const
  {
    const HermiteSegment segment(
      a.Time, a.State.Position, a.State.Velocity, b.Time, b.State.Position, b.State.Velocity);
    const double s = (truth.Time - a.Time) / (b.Time - a.Time);
    const Vec3& p = truth.State.Position;
    const double rounding = 8.0 * std::numeric_limits<double>::epsilon() * p.Norm();
    return (segment(s) - p).Norm() <= 0.8 * this->Tolerance + rounding &&
      GetAngle(a.State.Orientation.Slerp(s, b.State.Orientation).Normalized(),
        truth.State.Orientation) <= 0.8 * this->Tolerance;
  }

  const MotionPiece& Piece;
  double Tolerance;
  std::vector<MotionSample>& Samples;
};

} // namespace

//------------------------------------------------------------------------------
std::vector<MotionSample> SamplePiece(const MotionPiece& piece, double tolerance)
{
  const MotionSample start{ 0.0, piece.At(0.0) };
  const MotionSample end{ piece.Duration, piece.At(piece.Duration) };
  std::vector<MotionSample> samples{ start };
  Sampler(piece, tolerance, samples).Fill(start, end, 30);
  return samples;
}

} // namespace helios
