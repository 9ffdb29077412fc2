// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The projection G of a unit of leaf area along a direction, by a leaf angle distribution.

#ifndef heliosLeafProjection_h
#define heliosLeafProjection_h

#include "heliosStatus.h"
#include "vtkHeliosFiltersCoreModule.h" // For export macro

#include <algorithm>
#include <utility>
#include <vector>

class vtkDataArray;

namespace helios
{

/// G as a function of the angle from the vertical, symmetric about the horizontal.
class VTKHELIOSFILTERSCORE_EXPORT LeafProjection
{
public:
  /// Projection of a spherical leaf angle distribution.
  static constexpr double Spherical = 0.5;

  /// Distributions of the angle of leaf normals from the vertical, all of them uniform in azimuth.
  enum class Distribution : char
  {
    Spherical,    // sin a, as on a sphere
    Uniform,      // 2/pi
    Planophile,   // (2 + 2 cos 2a) / pi
    Erectophile,  // (2 - 2 cos 2a) / pi
    Plagiophile,  // (2 - 2 cos 4a) / pi
    Extremophile, // (2 + 2 cos 4a) / pi
    Ellipsoidal,  // by the ratio of axes
    Horizontal,
    Vertical
  };

  /**
   * Makes a table of a distribution with an entry for each degree. The formulas are those of N.
   * Goel and D. Strebel (1984), and of G. Campbell (1986) for Ellipsoidal. ratio is that of the horizontal to the vertical axis of the ellipsoid.
   */
  void Set(Distribution distribution, double ratio = 1.0);

  /// Reads rows x y z G; rows of the same angle are merged to their mean. Without rows: an error.
  Status Set(vtkDataArray* rows);

  /// Makes G spherical.
  void Clear() { this->Rows.clear(); }
  bool IsSpherical() const { return this->Rows.empty(); }

  /// Returns G for an angle from the vertical [rad] in [0, pi/2], linear between the rows.
  double Get(double angle) const
  {
    if (this->Rows.empty())
    {
      return Spherical;
    }
    const auto above =
      std::lower_bound(this->Rows.begin(), this->Rows.end(), std::make_pair(angle, 0.0));
    if (above == this->Rows.begin() || above == this->Rows.end())
    {
      return above == this->Rows.end() ? this->Rows.back().second : above->second;
    }
    const auto below = above - 1;
    const double share = (angle - below->first) / (above->first - below->first);
    return below->second + share * (above->second - below->second);
  }

  const std::vector<std::pair<double, double>>& GetRows() const { return this->Rows; }

private:
  std::vector<std::pair<double, double>> Rows; // angle from the vertical [rad], and G
};

} // namespace helios

#endif
