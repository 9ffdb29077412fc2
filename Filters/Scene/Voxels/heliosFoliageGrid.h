// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Adds up what beams meet in the cells of a grid.

#ifndef heliosFoliageGrid_h
#define heliosFoliageGrid_h

#include "heliosCellGrid.h"
#include "heliosFoliageBeams.h"
#include "heliosFoliageEstimate.h"
#include "heliosLeafProjection.h"

#include <vtkSMPThreadLocal.h>

#include <array>
#include <cstdint>
#include <vector>

namespace helios
{

/**
 * Follows beams through a grid. Sums are whole numbers of small units, so that they do not depend
 * on the order of the beams, nor on threads: paths in units of the diagonal of a cell over 2^30,
 * energies in pulses over 2^30. Each thread has sums of its own.
 */
class FoliageGrid
{
public:
  static constexpr int NumberOfSums = 10;
  static constexpr double BytesPerCell = 8.0 * NumberOfSums;

  /// G is 1 if the hits have weights by their incidence.
  FoliageGrid(const CellGrid& cells, const LeafProjection& leaves, bool usesIncidence)
    : Cells(cells)
    , Leaves(leaves)
    , UsesIncidence(usesIncidence)
  {
  }

  /// Sets the projected area of an element over the volume of a cell [1/m], with G = 1.
  void SetElementAttenuation(double attenuation) { this->ElementAttenuation = attenuation; }

  /// Sets the range beyond which beams meet nothing that would be detected [m].
  void SetMaximumRange(double range) { this->MaximumRange = range; }

  /// Adds beams [begin, end), by many threads.
  void Add(const FoliageBeams& beams, vtkIdType begin, vtkIdType end);

  /// Adds the sums of a cell to others.
  void GetSums(std::vector<FoliageSums>& sums);

private:
  using CellSums = std::array<std::int64_t, NumberOfSums>;

  /// A beam on its way.
  struct Beam
  {
    double Projection;
    double Energy; // that is left
    const FoliageHit* Hit;
    const FoliageHit* End;
  };

  void AddBeam(const FoliageBeams& beams, vtkIdType index, CellSums* sums) const;
  void AddChord(Beam& beam, double from, double to, CellSums& sums) const;
  double GetPath(double length, double projection) const;

  const CellGrid& Cells;
  const LeafProjection& Leaves;
  bool UsesIncidence;
  double ElementAttenuation = 0.0;
  double MaximumRange = 1e300;
  vtkSMPThreadLocal<std::vector<CellSums>> Sums;
};

} // namespace helios

#endif
