// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// One flight line and the pulses that it leaves on the ground.

#ifndef heliosStrip_h
#define heliosStrip_h

#include "heliosPose.h"

#include <vector>

class vtkHeliosSwath;

namespace helios
{

/// A place on the ground, and its slopes in x and y.
struct GroundPlace
{
  Vec3 Position;
  double SlopeX = 0.0;
  double SlopeY = 0.0;
};

/// A place as a line sees it.
struct PlaceInStrip
{
  double Along = 0.0;  ///< [m], from the beginning
  double Across = 0.0; ///< [m], to the right
  double Height = 0.0; ///< [m], of the line above the place
};

class Strip
{
public:
  /// A line by its waypoints, which are straight in x, y, and its speed.
  Strip(std::vector<Vec3> waypoints, double speed);

  PlaceInStrip Find(const Vec3& place) const;

  /// Computes the pulses per square metre at a place.
  double ComputeDensity(const GroundPlace& place, const vtkHeliosSwath& swath) const;

  double GetLength() const { return this->Distances.back(); }

private:
  struct Level
  {
    double Z;
    double GroundSpeed; ///< [m/s], in x, y
  };

  Level GetLevel(double along) const;

  double Speed;
  Vec3 Begin;
  Vec3 Forward;
  Vec3 Right;
  std::vector<double> Distances; // distances of the waypoints along the line
  std::vector<double> Heights;
};

} // namespace helios

#endif
