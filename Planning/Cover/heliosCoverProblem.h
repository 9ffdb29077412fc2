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

/// Objects of which a weight of their points is required, each.
struct ObjectDemands
{
  std::vector<int> Of;          // the object of each point; -1: none
  std::vector<double> Required; // by object; 0: nothing
};

struct VTKHELIOSPLANNING_EXPORT CoverProblem
{
  BitRows Rows;                // the points each candidate sees
  std::vector<double> Weights; // weights of points; empty: 1 each
  Words Coverable;             // points that some candidate sees
  double Required = 0.0;       // the weight to be seen
  bool IsFull = true;          // all coverable points are required
  ObjectDemands Objects;       // besides Required; with IsFull they are met

  CoverProblem() = default;
  /// Requires all coverable points.
  explicit CoverProblem(const BitRows& rows, std::vector<double> weights = {});

  /// Requires this weight, with a tolerance for rounding.
  void Require(double weight);

  /// Requires a weight of the points of each object, too, likewise; with IsFull they are met.
  void RequireObjects(const std::vector<int>& objects, const std::vector<double>& weights);

  bool HasObjects() const { return !this->IsFull && !this->Objects.Required.empty(); }

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

  /// Returns whether a member sees no point exclusively.
  bool IsRedundant(int candidate) const;

  /// Returns the weight and number of points that only this member sees.
  double GetExclusiveWeight(int candidate) const;
  int GetExclusiveCount(int candidate) const;

  /// Returns the weight of points that a candidate sees and no member does.
  double GetNewWeight(int candidate) const;

  /// Returns the same, but not above what is still required, in all and of each object.
  double GetGain(int candidate) const;

  /// Returns whether more weight is required of the object of a point, or in all.
  bool IsNeeded(int point) const;

  /// Returns whether enough is covered; also without the points that only one given member sees.
  bool IsEnough() const;
  bool IsEnoughWithout(int candidate) const;

private:
  double GetMissing(std::size_t object) const
  {
    return this->Problem->Objects.Required[object] - this->ObjectWeights[object];
  }
  int GetObject(int point) const { return this->Problem->Objects.Of[point]; }
  Words GetExclusive(int candidate) const;
  Words GetNew(int candidate) const;
  std::vector<double> SumObjects(const Word* points) const;
  void ChangeObjects(const Words& points, double sign);

  const CoverProblem* Problem;
  std::vector<int> Counts;
  std::vector<double> ObjectWeights; // covered, by object
  Words Covered;
  Words Once;
  double Weight = 0.0;
};

} // namespace helios

#endif
