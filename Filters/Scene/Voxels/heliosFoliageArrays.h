// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The sums and densities of cells as arrays of an image.

#ifndef heliosFoliageArrays_h
#define heliosFoliageArrays_h

#include "heliosFoliageEstimate.h"

#include <vtkType.h>

#include <vector>

class vtkImageData;

namespace helios
{

class LeafProjection;

/// How densities are estimated.
struct FoliageSettings
{
  FoliageEstimator Estimator = FoliageEstimator::MaximumLikelihoodCorrected;
  double ElementArea = 0.0; // [m2]
  double CellVolume = 1.0;  // [m3]
  double MinimumPath = 0.0; // free path that makes a cell seen [m]
};

/// Reads the sums of an image; zeros if it has none.
std::vector<FoliageSums> ReadSums(vtkImageData* grid);

/// Adds the sums, and the densities that they give.
void AddFoliageArrays(
  const std::vector<FoliageSums>& sums, const FoliageSettings& settings, vtkImageData* grid);

/// Adds the rows x y z G.
void AddLeafTable(const LeafProjection& leaves, vtkImageData* grid);

} // namespace helios

#endif
