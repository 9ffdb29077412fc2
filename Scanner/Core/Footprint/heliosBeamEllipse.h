// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The elliptical cross-section of a beam.

#ifndef heliosBeamEllipse_h
#define heliosBeamEllipse_h

#include "heliosBeamEnergy.h"

namespace helios
{

/**
 * Maps between the cross-section of an elliptical beam, in the frame of a ConeView, and the
 * cross-section of the circular beam that results from stretching it along its minor axis by 1 /
 * Ratio. Depths along the axis of the beam, straight edges and what hides what are the same in
 * both; the circular beam has the divergence of the major axis.
 */
class BeamEllipse
{
public:
  BeamEllipse() = default;

  /// Sets the ratio of the minor axis to the major one, in (0, 1].
  explicit BeamEllipse(double ratio)
    : Ratio(ratio)
  {
  }

  bool IsCircle() const { return this->Ratio == 1.0; }

  /// Sets the axes, for a frame (rows: two axes across, the axis) and a unit vector along the minor
  /// axis, in the world.
  void Align(const double frame[3][3], const double minor[3])
  {
    for (int i = 0; i < 2; ++i)
    {
      this->Minor[i] = frame[i][0] * minor[0] + frame[i][1] * minor[1] + frame[i][2] * minor[2];
    }
  }

  /// Maps a point of the ellipse to the circle.
  void ToCircle(double point[2]) const { this->Stretch(1.0 / this->Ratio - 1.0, point); }

  /// Maps points of the ellipse, of vectors of coordinates, to the circle.
  template <typename LaneT>
  void ToCircle(LaneT& x, LaneT& y) const
  {
    const LaneT along = x * this->Minor[0] + y * this->Minor[1];
    const double factor = 1.0 / this->Ratio - 1.0;
    x += factor * along * this->Minor[0];
    y += factor * along * this->Minor[1];
  }

  /// Maps a point of the circle to the ellipse.
  void FromCircle(double point[2]) const { this->Stretch(this->Ratio - 1.0, point); }

  /// Returns the integral of the squared distance from the axis of the ellipse, of moments in the
  /// circle.
  double GetSquare(const EnergyMoments& m) const
  {
    const double* n = this->Minor;
    const double along = n[0] * n[0] * m.XX + 2.0 * n[0] * n[1] * m.XY + n[1] * n[1] * m.YY;
    return m.XX + m.YY + (this->Ratio * this->Ratio - 1.0) * along;
  }

private:
  /// Adds a multiple of the part along the minor axis.
  void Stretch(double factor, double point[2]) const
  {
    const double along = point[0] * this->Minor[0] + point[1] * this->Minor[1];
    point[0] += factor * along * this->Minor[0];
    point[1] += factor * along * this->Minor[1];
  }

  double Ratio = 1.0;
  double Minor[2] = { 0.0, 1.0 };
};

} // namespace helios

#endif
