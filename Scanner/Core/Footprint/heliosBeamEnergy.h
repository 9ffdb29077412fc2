// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The energy of a Gaussian beam in a polygon of its cross-section.

#ifndef heliosBeamEnergy_h
#define heliosBeamEnergy_h

#include "vtkHeliosScannerCoreModule.h" // For export macro

namespace helios
{

struct Polygon;

/// The integrals of the intensity f over a region, whose total over the beam is 1.
struct EnergyMoments
{
  double Energy = 0.0;
  double X = 0.0; ///< moment x f
  double Y = 0.0; ///< moment y f
  double XX = 0.0;
  double XY = 0.0;
  double YY = 0.0;

  void Add(const EnergyMoments& other) { this->AddTimes(1.0, other); }
  void Subtract(const EnergyMoments& other) { this->AddTimes(-1.0, other); }

  void AddTimes(double factor, const EnergyMoments& other)
  {
    this->Energy += factor * other.Energy;
    this->X += factor * other.X;
    this->Y += factor * other.Y;
    this->XX += factor * other.XX;
    this->XY += factor * other.XY;
    this->YY += factor * other.YY;
  }
};

/**
 * A beam whose intensity is exp(-2 theta^2 / w^2) at the angle theta from the axis, cut at K w. Its
 * cross-section is the plane before the apex where the cut is the unit circle: r = tan(theta) /
 * tan(K w).
 *
 * With E(r) the energy within r, the energy in a polygon is the sum over its edges of the integral
 * of E(r) d(azimuth) / 2 pi. With f = f(0) exp(-a r^2), g = f(1) - f and the outward normal n, the
 * divergence theorem gives the first moments, the sums of the integrals of n g ds / 2 a, and the
 * second ones, the integrals of x n g ds / 2 a plus, for x x and y y, (the energy - f(1) times the
 * area) / 2 a. Beyond the circle E is 1 and g is 0. Along an edge the integrals are evaluated by
 * Gauss's rule to 1e-6 of the beam's energy; in a small polygon, to an error that is given, from
 * its area and its moments and the Taylor series of the intensity about its centroid. For wide
 * beams the moments follow a Gaussian in r, which has the same rim.
 */
class VTKHELIOSSCANNERCORE_EXPORT BeamEnergy
{
public:
  BeamEnergy() = default;

  /// Sets a half angle w [rad] at 1/e^2, its multiple K, and the error of the energy in a small
  /// polygon, as a fraction of the beam's.
  BeamEnergy(double halfAngle, double truncation, double error = DefaultError);

  static constexpr double DefaultError = 1e-6;

  /// Returns the tangent of the cut: the unit of the cross-section.
  double GetTangent() const { return this->Tangent; }

  EnergyMoments Integrate(const Polygon& polygon) const;

  /// Returns the intensity at a point of the cross-section, relative to the axis.
  double GetIntensity(double x, double y) const;

  /// Returns a of the intensity exp(-a r^2).
  double GetExponent() const { return this->Exponent; }

  /// Returns whether the intensity at (x, y) is the product of those at (x, 0) and (0, y).
  bool IsProduct() const { return !this->IsWide; }

private:
  /// Sums over edges.
  struct Sums
  {
    double Energy = 0.0;
    double Area = 0.0;                                     ///< inside the circle, twice
    double X = 0.0, Y = 0.0, XX = 0.0, XY = 0.0, YY = 0.0; ///< sums of n g and of x n g
  };
  /// Points of edges, evaluated together.
  struct Nodes
  {
    static constexpr int Capacity = 64;
    int Size = 0;
    double X[Capacity], Y[Capacity];
    double Turn[Capacity];                         ///< r^2 d(azimuth)
    double OutwardX[Capacity], OutwardY[Capacity]; ///< n ds

    void Add(const double place[2], double turn, double outwardX, double outwardY)
    {
      this->X[this->Size] = place[0];
      this->Y[this->Size] = place[1];
      this->Turn[this->Size] = turn;
      this->OutwardX[this->Size] = outwardX;
      this->OutwardY[this->Size] = outwardY;
      ++this->Size;
    }
  };
  bool IsSmall(const Polygon& polygon) const;
  EnergyMoments IntegrateSmall(const Polygon& polygon) const;
  void AddInside(const double from[2], const double step[2], double first, double last,
    Nodes& nodes, Sums& sums) const;
  void AddNodes(Nodes& nodes, Sums& sums) const;

  double Tangent = 0.0;
  bool IsWide = false;
  double Exponent = 0.0;   ///< a
  double Scale = 0.0;      ///< scale of E and f, for the cut
  int Doublings = 0;       ///< doublings of the argument of an exponential
  double Rim = 0.0;        ///< f(1) pi
  double SmallReach = 0.0; ///< squared, of a small polygon
};

} // namespace helios

#endif
