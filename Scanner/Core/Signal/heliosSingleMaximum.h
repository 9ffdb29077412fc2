// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The maximum of a sum of nearly coincident Gaussians.

#ifndef heliosSingleMaximum_h
#define heliosSingleMaximum_h

#include "vtkHeliosScannerCoreModule.h"

#include <cstddef>
#include <vector>

namespace helios
{

/**
 * A sum of p_k exp(-(x - x_k)^2 / (2 sigma^2)). If the x_k spread over no more than two sigma, it
 * has exactly one maximum, since its logarithm is concave between them; Newton's method finds it.
 */
class VTKHELIOSSCANNERCORE_EXPORT SingleMaximum
{
public:
  struct Result
  {
    double Place;
    double Value;
    double Variance; ///< variance of the x_k, weighted by p_k
  };

  /// Restarts, with memory for n terms.
  void Open(std::size_t maximum);

  /// Adds a term, if isWanted.
  void Add(double place, double power, bool isWanted = true)
  {
    this->Places[this->Count] = place;
    this->Powers[this->Count] = power;
    this->Count += isWanted ? 1 : 0;
  }

  /// Finds the maximum for one or more terms that spread over no more than two sigma; false if they
  /// have no power. Call once: it modifies the terms.
  bool Find(double sigma, Result& result);

private:
  struct Moments;
  struct Sums;
  void FillLanes();
  Moments GetMoments() const;
  Sums GetSums(double place, double scale) const;

  std::size_t Count = 0;
  double First = 0.0;         ///< place
  std::vector<double> Places; ///< relative to the first, once complete
  std::vector<double> Powers;
};

} // namespace helios

#endif
