// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The cross-section of a beam in cells, and cells of cells.

#ifndef heliosBeamLattice_h
#define heliosBeamLattice_h

#include "heliosPose.h"
#include "vtkHeliosScannerCoreModule.h"

#include <vector>

namespace helios
{

/// A cell: its share of the beam's energy, and directions that stand for it.
struct BeamCell
{
  double Energy;
  Vec3 Centre;    ///< of its energy
  Vec3 Points[4]; ///< with a quarter of its energy each they have its mean and its covariance
};

/**
 * The unit square mapped to the cross-section of a Gaussian beam that is cut at K times its 1/e^2 half
 * angle w: concentrically to a disc of even density (Shirley and Chiu 1997, J. Graphics Tools 2(3)),
 * and from its radius rho to g = w sqrt(-ln(1 - rho^2 F)), F = 1 - exp(-K^2). That is half-way from
 * cells of equal area to cells of equal energy: the energy per area of the square falls with
 * 1 - rho^2 F, a smooth function. BaseCells^2 cells of level 0, and each has four of the next level.
 * All directions are unit vectors in the frame of the beam, whose axis is y.
 */
class VTKHELIOSSCANNERCORE_EXPORT BeamLattice
{
public:
  /// For a beam of a full angle [rad].
  BeamLattice(double divergence, double truncation, int baseCells, int levels);

  bool IsFor(double divergence, double truncation, int baseCells, int levels) const
  {
    return this->Divergence == divergence && this->Truncation == truncation &&
      this->BaseCells == baseCells && this->Levels == levels;
  }

  int GetBaseCells() const { return this->BaseCells; }
  int GetLevels() const { return this->Levels; }

  /// Corners a side: those of the cells of the finest level.
  int GetNumberOfCorners() const { return (this->BaseCells << this->Levels) + 1; }

  /// A corner's number, from its place counted in cells of the finest level.
  std::size_t GetCornerId(int x, int y) const
  {
    return static_cast<std::size_t>(y * this->GetNumberOfCorners() + x);
  }
  const Vec3& GetCorner(std::size_t id) const { return this->Corners[id]; }

  /// A cell of a level from its place counted in cells of that level.
  const BeamCell& GetCell(int level, int x, int y) const
  {
    return this->Cells[static_cast<std::size_t>(level)]
                      [static_cast<std::size_t>(y * (this->BaseCells << level) + x)];
  }

private:
  struct Map;

  double Divergence;
  double Truncation;
  int BaseCells;
  int Levels;
  std::vector<Vec3> Corners;
  std::vector<std::vector<BeamCell>> Cells; // by level
};

} // namespace helios

#endif
