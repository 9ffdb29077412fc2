// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The light that a medium scatters back along a beam: water, fog.

#ifndef heliosColumnProfile_h
#define heliosColumnProfile_h

#include "heliosPose.h"
#include "vtkHeliosScannerCoreModule.h" // For export macro

#include <vtkType.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace helios
{

/**
 * Power received from a stretch of ranges, kept as slabs between multiples of a step. Each slab has
 * the power, the mean and the variance of its part of the stretch: as two returns at mean +-
 * deviation its pulses sum up to the pulses of the stretch, for steps up to the standard deviation
 * of a Gaussian pulse to 2e-4 of the power within one deviation. Sub-rays of a beam share the
 * slabs.
 */
class VTKHELIOSSCANNERCORE_EXPORT ColumnProfile
{
public:
  struct Slab
  {
    double Power = 0.0;  // [W]
    double Moment = 0.0; // first moment of the power, about the start of the slab [W m]
    double Second = 0.0;
    vtkIdType Cell = -1; // cell of the first light in the slab: the surface before it
    double Cosine = 1.0;
    Vec3 Point = Vec3(0.0, 0.0, 0.0);
    int Events = 0;
  };

  /// Sets the step in metres of range.
  explicit ColumnProfile(double step)
    : Step(step)
  {
  }

  void Clear() { this->Slabs.clear(); }
  bool IsEmpty() const { return this->Slabs.empty(); }

  /**
   * Adds the power of a stretch of ranges; density(range) is its power per range [W/m], and
   * describe(range, slab) fills what a new slab is otherwise.
   */
  template <typename DensityT, typename DescribeT>
  void Add(double from, double to, DensityT density, DescribeT describe)
  {
    const auto first = static_cast<vtkIdType>(std::floor(from / this->Step));
    for (vtkIdType i = first; from < to && static_cast<double>(i) * this->Step < to; ++i)
    {
      const double origin = static_cast<double>(i) * this->Step;
      const double begin = std::max(from, origin);
      const double half = 0.5 * (std::min(to, origin + this->Step) - begin);
      Slab& slab = this->GetSlab(i);
      if (slab.Cell < 0)
      {
        describe(begin + half, slab);
      }
      constexpr double abscissa = 0.57735026918962576; // Gauss-Legendre, two points
      for (const double u : { -abscissa, abscissa })
      {
        const double range = begin + half * (1.0 + u);
        const double power = half * density(range);
        const double x = range - origin;
        slab.Power += power;
        slab.Moment += power * x;
        slab.Second += power * x * x;
      }
    }
  }

  /// Calls add(range, power, slab) for the two returns of each slab, in order.
  template <typename AddT>
  void ForEachReturn(AddT add) const
  {
    for (std::size_t i = 0; i < this->Slabs.size(); ++i)
    {
      const Slab& slab = this->Slabs[i];
      if (slab.Power > 0.0)
      {
        const double mean = slab.Moment / slab.Power;
        const double deviation = std::sqrt(std::max(0.0, slab.Second / slab.Power - mean * mean));
        const double origin =
          static_cast<double>(this->First + static_cast<vtkIdType>(i)) * this->Step;
        add(origin + mean - deviation, 0.5 * slab.Power, slab);
        add(origin + mean + deviation, 0.5 * slab.Power, slab);
      }
    }
  }

private:
  Slab& GetSlab(vtkIdType index);

  double Step;
  vtkIdType First = 0; // number of the first slab
  std::vector<Slab> Slabs;
};

} // namespace helios

#endif
