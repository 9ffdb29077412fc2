// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Bends in a plane that wheels and wings can follow.

#ifndef heliosTurn_h
#define heliosTurn_h

#include "vtkHeliosScannerPlatformsModule.h" // For export macro

#include <optional>

namespace helios
{

/**
 * A bend to the left: along the path the curvature grows at a constant rate (a clothoid), is
 * constant, and falls at the same rate. It starts at (0, 0) with the heading along Forward. Without
 * a ramp it is an arc of a circle. Arcs are in closed form, clothoids by Gauss-Legendre quadrature,
 * to rounding.
 */
class VTKHELIOSSCANNERPLATFORMS_EXPORT Turn
{
public:
  struct Point
  {
    double Forward = 0.0; // [m]
    double Left = 0.0;    // [m]
    double Heading = 0.0; // [rad], to the left
    double Curvature = 0.0;
  };

  Turn() = default;

  /// Makes a turn by an angle [rad] >= 0 at a curvature [1/m] > 0 that is reached over the length
  /// ramp [m]; a turn too small for it stays below that curvature.
  Turn(double angle, double curvature, double ramp);

  double GetAngle() const { return this->Angle; }
  double GetLength() const { return 2.0 * this->Ramp + this->Arc; }
  double GetCurvature() const { return this->Curvature; }

  /// Returns the point after the length s, in [0, GetLength()].
  Point At(double s) const;

private:
  Point AlongArc(double s) const;
  Point AlongRamp(const Point& from, double s, double rate) const;

  double Angle = 0.0;
  double Curvature = 0.0;
  double Ramp = 0.0;
  double Arc = 0.0;
  Point ArcStart;
  Point ArcEnd;
};

/// Finds the first turn after which a point that is not to the right is straight ahead; none if the
/// point is too near.
VTKHELIOSSCANNERPLATFORMS_EXPORT std::optional<Turn> FindTurn(
  double forward, double left, double curvature, double ramp);

} // namespace helios

#endif
