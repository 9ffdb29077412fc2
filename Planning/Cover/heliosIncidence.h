// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Angles of incidence of candidates at points.

#ifndef heliosIncidence_h
#define heliosIncidence_h

#include "heliosCoverProblem.h"

#include <array>

namespace helios
{

/// The largest and the mean of the smallest angles of incidence [deg]; NaN: no normals.
struct VTKHELIOSPLANNING_EXPORT Quality
{
  double Worst;
  double Mean;

  /// Compares lexicographically.
  bool IsBetterThan(const Quality& other) const;
};

/// Angles between lines of sight and normals.
class VTKHELIOSPLANNING_EXPORT Incidence
{
public:
  using Vector = std::array<double, 3>;

  Incidence() = default;
  /// A normal of length 0 means no normal.
  Incidence(std::vector<Vector> positions, std::vector<Vector> points, std::vector<Vector> normals);

  /// Returns the same for some of the candidates.
  Incidence Select(const Choice& candidates) const;

  bool HasNormals() const { return !this->Normals.empty(); }

  /**
   * Returns the angle from the normal, folded to [0, 90] [deg], in steps of 1e-9 degrees, so that
   * angles equal up to rounding compare equal; NaN without a normal.
   */
  double GetAngle(int candidate, int point) const;

  /// Returns the mean over the points a candidate sees [deg]; NaN: it sees none with a normal.
  double GetMean(const CoverProblem& problem, int candidate) const;

  /// Returns the smallest angle of every point [deg] over the members that see it; NaN: none.
  std::vector<double> GetBest(const CoverProblem& problem, const Choice& choice) const;

  /// Returns the largest of these angles, and their mean by weight.
  static Quality ComputeQuality(const CoverProblem& problem, const std::vector<double>& best);

private:
  std::vector<Vector> Positions;
  std::vector<Vector> Points;
  std::vector<Vector> Normals; // unit, or NaN
};

} // namespace helios

#endif
