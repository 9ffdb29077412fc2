// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The choice of scan positions as a set cover: candidates that see points, a weight a point, and how
// much weight is to be seen. A choice is a list of candidates.

#ifndef heliosCoverProblem_h
#define heliosCoverProblem_h

#include "heliosBitMatrix.h"
#include "vtkHeliosPlanningModule.h" // For export macro

#include <functional>
#include <vector>

namespace helios
{

using Choice = std::vector<int>;

/// Asked in long loops: true stops them.
using StopTest = std::function<bool()>;

struct VTKHELIOSPLANNING_EXPORT CoverProblem
{
  BitRows Rows;                // the points a candidate sees
  std::vector<double> Weights; // of points; empty: 1 each
  Words Coverable;             // points that some candidate sees
  double Required = 0.0;       // the weight to be seen
  bool IsFull = true;          // every coverable point is to be seen

  CoverProblem() = default;
  /// All coverable points are required.
  explicit CoverProblem(const BitRows& rows, std::vector<double> weights = {});

  /// Requires so much weight, with a tolerance for rounding.
  void Require(double weight);

  double GetWeight(int point) const { return this->Weights.empty() ? 1.0 : this->Weights[point]; }
  double GetWeight(const Word* set) const;
  double GetCommonWeight(const Word* a, const Word* b) const;
};

/// How often each point is seen by a choice that candidates join and leave.
class VTKHELIOSPLANNING_EXPORT CoverCounts
{
public:
  explicit CoverCounts(const CoverProblem& problem, const Choice& choice = {});

  void Add(int candidate);
  void Remove(int candidate);

  int GetCount(int point) const { return this->Counts[point]; }
  const Words& GetCovered() const { return this->Covered; }
  const Words& GetCoveredOnce() const { return this->Once; }
  double GetCoveredWeight() const { return this->Weight; }

  /// Whether a member sees no point alone.
  bool IsRedundant(int candidate) const;

  /// The weight and number of points that a member sees alone.
  double GetExclusiveWeight(int candidate) const;
  int GetExclusiveCount(int candidate) const;

  /// The weight of points that no member sees, and a candidate does.
  double GetGain(int candidate) const;

  /// Whether enough is covered; with what a member sees alone taken off.
  bool IsEnough() const;
  bool IsEnoughWithout(int candidate) const;

private:
  const CoverProblem* Problem;
  std::vector<int> Counts;
  Words Covered;
  Words Once;
  double Weight = 0.0;
};

} // namespace helios

#endif
