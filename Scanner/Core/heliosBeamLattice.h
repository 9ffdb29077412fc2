// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Directions over the cross-section of a beam, such that equal squares hold equal energy.

#ifndef heliosBeamLattice_h
#define heliosBeamLattice_h

#include "heliosPose.h"
#include "vtkHeliosScannerCoreModule.h"

#include <vector>

namespace helios
{

/**
 * The unit square, mapped to the cross-section of a Gaussian beam that is cut at K times its 1/e^2
 * half angle w: concentrically to a disc of even density (Shirley and Chiu 1997, J. Graphics Tools
 * 2(3)), whose radius squared p becomes the quantile of the energy, g = w sqrt(-ln(1 - p E) / 2),
 * E = 1 - exp(-2 K^2). The lattice has 2 cells + 1 points a side: corners of cells at even places,
 * centres at odd ones.
 */
class VTKHELIOSSCANNERCORE_EXPORT BeamLattice
{
public:
  /// For a beam of a full angle [rad] cut at K, and so many cells a side.
  BeamLattice(double divergence, double truncation, int cells);

  int GetSide() const { return 2 * this->Cells + 1; }

  /// A unit vector in the frame of the beam, whose axis is y.
  const Vec3& GetDirection(int x, int y) const
  {
    return this->Directions[static_cast<std::size_t>(y * this->GetSide() + x)];
  }

private:
  int Cells;
  std::vector<Vec3> Directions;
};

} // namespace helios

#endif
