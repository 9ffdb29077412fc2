// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Selection of scan positions as a set cover: candidates that see points, a weight per point, and
// the weight to be seen. A choice is a list of candidates.

#ifndef heliosCoverProblem_h
#define heliosCoverProblem_h

#include "heliosBitMatrix.h"
#include "vtkHeliosPlanningModule.h" // For export macro

#include <functional>
#include <vector>

namespace helios
{

using Choice = std::vector<int>;

/// Polled in long loops: true stops them.
using StopTest = std::function<bool()>;

struct VTKHELIOSPLANNING_EXPORT CoverProblem
{
  BitRows Rows;                // the points each candidate sees
  std::vector<double> Weights; // of points; empty: 1 each
  Words Coverable;             // points that some candidate sees
  double Required = 0.0;       // the weight to be seen
  bool IsFull = true;          // all coverable points are required

  CoverProblem() = default;
  /// Requires all coverable points.
  explicit CoverProblem(const BitRows& rows, std::vector<double> weights = {});

  /// Requires this weight, with a tolerance for rounding.
  void Require(double weight);

  double GetWeight(int point) const { return this->Weights.empty() ? 1.0 : this->Weights[point]; }
  double GetWeight(const Word* set) const;
  double GetCommonWeight(const Word* a, const Word* b) const;
};

/// How many members of a choice see each point; candidates join and leave.
class VTKHELIOSPLANNING_EXPORT CoverCounts
{
public:
  explicit CoverCounts(const CoverProblem& problem, const Choice& choice = {});

  void Add(int candidate);
  void Remove(int candidate);

  int GetCount(int point) const { return this->Counts[point]; }
  const Words& GetCovered() const { return this->Covered; }
  double GetCoveredWeight() const { return this->Weight; }

  /// Whether a member sees no point exclusively.
  bool IsRedundant(int candidate) const;

  /// The weight and number of points that only this member sees.
  double GetExclusiveWeight(int candidate) const;
  int GetExclusiveCount(int candidate) const;

  /// The weight of points that a candidate sees and no member does.
  double GetGain(int candidate) const;

  /// Whether enough is covered; also without the points that only one given member sees.
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
