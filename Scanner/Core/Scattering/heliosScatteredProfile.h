// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The light of a pulse that was scattered more than once, by range.

#ifndef heliosScatteredProfile_h
#define heliosScatteredProfile_h

#include "heliosPose.h"
#include "vtkHeliosScannerCoreModule.h" // For export macro

#include <vtkType.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace helios
{

/// A power and its standard error [W].
struct ScatteredPower
{
  double Power = 0.0;
  double Error = 0.0;
};

/**
 * The powers that paths of light return, those of nearly the same range as one return. Batches of
 * paths are independent estimates, whose differences give the standard error: with b batches of the
 * powers p, s^2 = b / (b - 1) sum (p - mean)^2.
 */
class VTKHELIOSSCANNERCORE_EXPORT ScatteredProfile
{
public:
  static constexpr std::size_t NumberOfBatches = 8;

  /// The power of a path, and the last point that scattered it.
  struct Sample
  {
    double Range; // half of the path's length [m]
    double Power; // [W]
    std::size_t Batch;
    vtkIdType Cell;
    double Cosine;
    Vec3 Point;
  };

  /// The return of samples of nearly the same range; cell and point are those of the strongest.
  struct Return
  {
    double Range;
    double Power;
    vtkIdType Cell;
    double Cosine;
    Vec3 Point;
    std::array<double, NumberOfBatches> Batches;
  };

  /// Sets the largest difference of ranges in a return [m].
  explicit ScatteredProfile(double step)
    : Step(step)
  {
  }

  void Clear();
  void Add(const Sample& sample) { this->Samples.push_back(sample); }

  /// Makes the returns of all samples, in the order of range.
  void Finish();

  const std::vector<Return>& GetReturns() const { return this->Returns; }

  /// Swaps the returns of a pulse.
  void SwapReturns(std::vector<Return>& returns) { this->Returns.swap(returns); }

  /// Returns the sum of weight(range) times power, between two ranges, and its standard error.
  template <typename WeightT>
  ScatteredPower GetPower(double from, double to, WeightT weight) const
  {
    std::array<double, NumberOfBatches> sums{};
    auto r = std::lower_bound(this->Returns.begin(), this->Returns.end(), from,
      [](const Return& each, double range) { return each.Range < range; });
    for (; r != this->Returns.end() && r->Range <= to; ++r)
    {
      const double share = weight(r->Range);
      for (std::size_t b = 0; b < NumberOfBatches; ++b)
      {
        sums[b] += share * r->Batches[b];
      }
    }
    return GetSum(sums);
  }

private:
  static ScatteredPower GetSum(const std::array<double, NumberOfBatches>& sums);

  double Step;
  std::vector<Sample> Samples;
  std::vector<Return> Returns;
};

} // namespace helios

#endif
