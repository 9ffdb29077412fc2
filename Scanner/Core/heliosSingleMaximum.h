// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The maximum of a sum of Gaussians that come nearly at one place.

#ifndef heliosSingleMaximum_h
#define heliosSingleMaximum_h

#include "vtkHeliosScannerCoreModule.h"

#include <cstddef>
#include <vector>

namespace helios
{

/**
 * A sum of p_k exp(-(x - x_k)^2 / (2 sigma^2)). Where the x_k spread over no more than two sigma it
 * has exactly one maximum, for its logarithm is concave between them; Newton's method finds it.
 */
class VTKHELIOSSCANNERCORE_EXPORT SingleMaximum
{
public:
  struct Result
  {
    double Place;
    double Value;
    double Variance; ///< of the x_k, weighted by p_k
  };

  /// Room for so many terms, all of them nothing.
  void Open(std::size_t count);
  void Set(std::size_t index, double place, double power)
  {
    this->Places[index] = place;
    this->Powers[index] = power;
  }

  /// For terms that spread over no more than two sigma; false where they have no power.
  bool Find(double sigma, Result& result) const;

private:
  struct Moments;
  struct Sums;
  Moments GetMoments() const;
  Sums GetSums(double place, double scale) const;

  std::size_t Count = 0; ///< rounded up to a full number of lanes
  std::vector<double> Places;
  std::vector<double> Powers;
};

} // namespace helios

#endif
