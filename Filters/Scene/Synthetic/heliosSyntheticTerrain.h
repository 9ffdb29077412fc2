// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Hills: a sum of sine waves with lengths from 0.8 down to 1/240 of the side.

#ifndef heliosSyntheticTerrain_h
#define heliosSyntheticTerrain_h

#include <vtkType.h>

#include <array>

namespace helios
{

class MeshBuilder;

class Terrain
{
public:
  /// Hills with a period of about the side and heights within +/- half the relief.
  Terrain(double side, double relief, vtkIdType seed);

  double GetHeight(double x, double y) const;

private:
  struct Wave
  {
    double X; // [rad/m]
    double Y;
    double Phase;
    double Amplitude;
  };
  std::array<Wave, 12> Waves;
};

/// Adds the hills over a square of the given side about the z axis, sampled at parts x parts
/// squares.
void AddTerrain(MeshBuilder& mesh, const Terrain& terrain, double side, int parts);

} // namespace helios

#endif
