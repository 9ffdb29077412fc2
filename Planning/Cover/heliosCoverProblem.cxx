// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosCoverProblem.h"

#include <algorithm>
#include <utility>

namespace helios
{

namespace
{

/// Relative tolerance for comparing sums of areas.
constexpr double Rounding = 1e-12;

} // namespace

CoverProblem::CoverProblem(const BitRows& rows, std::vector<double> weights)
  : Rows(rows)
  , Weights(std::move(weights))
  , Coverable(rows.Length)
{
  for (int c = 0; c < rows.Rows; ++c)
  {
    for (int w = 0; w < rows.Length; ++w)
    {
      this->Coverable[w] |= rows.Get(c)[w];
    }
  }
  this->Require(this->GetWeight(this->Coverable.data()));
}

void CoverProblem::Require(double weight)
{
  const double all = this->GetWeight(this->Coverable.data());
  this->IsFull = weight >= all * (1.0 - Rounding);
  this->Required = weight * (1.0 - Rounding);
}

void CoverProblem::RequireObjects(
  const std::vector<int>& objects, const std::vector<double>& weights)
{
  this->Objects.Of = objects;
  this->Objects.Required = weights;
  for (double& weight : this->Objects.Required)
  {
    weight *= 1.0 - Rounding;
  }
}

double CoverProblem::GetWeight(const Word* set) const
{
  return this->GetCommonWeight(set, set);
}

double CoverProblem::GetCommonWeight(const Word* a, const Word* b) const
{
  double weight = 0.0;
  int count = 0;
  for (int w = 0; w < this->Rows.Length; ++w)
  {
    const Word common = a[w] & b[w];
    count += __builtin_popcountll(common);
    if (!this->Weights.empty())
    {
      VisitWord(common, w, [&](int v) { weight += this->Weights[v]; });
    }
  }
  return this->Weights.empty() ? count : weight;
}

CoverCounts::CoverCounts(const CoverProblem& problem, const Choice& choice)
  : Problem(&problem)
  , Counts(problem.Rows.Columns)
  , ObjectWeights(problem.HasObjects() ? problem.Objects.Required.size() : 0)
  , Covered(problem.Rows.Length)
  , Once(problem.Rows.Length)
{
  for (const int candidate : choice)
  {
    this->Add(candidate);
  }
}

void CoverCounts::Add(int candidate)
{
  const Word* row = this->Problem->Rows.Get(candidate);
  this->Weight += this->GetNewWeight(candidate);
  if (this->Problem->HasObjects())
  {
    this->ChangeObjects(this->GetNew(candidate), 1.0);
  }
  VisitBits(row, this->Problem->Rows.Length, [this](int v) { ++this->Counts[v]; });
  for (int w = 0; w < this->Problem->Rows.Length; ++w)
  {
    this->Once[w] = (this->Once[w] & ~row[w]) | (row[w] & ~this->Covered[w]);
    this->Covered[w] |= row[w];
  }
}

void CoverCounts::Remove(int candidate)
{
  const Word* row = this->Problem->Rows.Get(candidate);
  this->Weight -= this->GetExclusiveWeight(candidate);
  if (this->Problem->HasObjects())
  {
    this->ChangeObjects(this->GetExclusive(candidate), -1.0);
  }
  for (int w = 0; w < this->Problem->Rows.Length; ++w)
  {
    const Word alone = this->Once[w] & row[w];
    this->Covered[w] &= ~alone;
    this->Once[w] &= ~alone;
    Word nowOnce = 0;
    VisitWord(
      row[w], w, [&](int v) { nowOnce |= static_cast<Word>(--this->Counts[v] == 1) << (v % 64); });
    this->Once[w] |= nowOnce;
  }
}

bool CoverCounts::IsRedundant(int candidate) const
{
  return !HasCommon(
    this->Problem->Rows.Get(candidate), this->Once.data(), this->Problem->Rows.Length);
}

double CoverCounts::GetExclusiveWeight(int candidate) const
{
  return this->Problem->GetCommonWeight(this->Problem->Rows.Get(candidate), this->Once.data());
}

int CoverCounts::GetExclusiveCount(int candidate) const
{
  const Word* row = this->Problem->Rows.Get(candidate);
  int count = 0;
  for (int w = 0; w < this->Problem->Rows.Length; ++w)
  {
    count += __builtin_popcountll(row[w] & this->Once[w]);
  }
  return count;
}

double CoverCounts::GetNewWeight(int candidate) const
{
  const Word* row = this->Problem->Rows.Get(candidate);
  double gain = 0.0;
  for (int w = 0; w < this->Problem->Rows.Length; ++w)
  {
    const Word fresh = row[w] & ~this->Covered[w];
    if (this->Problem->Weights.empty())
    {
      gain += __builtin_popcountll(fresh);
    }
    else
    {
      VisitWord(fresh, w, [&](int v) { gain += this->Problem->Weights[v]; });
    }
  }
  return gain;
}

std::vector<double> CoverCounts::SumObjects(const Word* points) const
{
  std::vector<double> weights(this->ObjectWeights.size());
  VisitBits(points, this->Problem->Rows.Length,
    [&](int v)
    {
      if (const int object = this->GetObject(v); object >= 0)
      {
        weights[object] += this->Problem->GetWeight(v);
      }
    });
  return weights;
}

Words CoverCounts::GetExclusive(int candidate) const
{
  const Word* row = this->Problem->Rows.Get(candidate);
  Words points(this->Once);
  for (int w = 0; w < this->Problem->Rows.Length; ++w)
  {
    points[w] &= row[w];
  }
  return points;
}

Words CoverCounts::GetNew(int candidate) const
{
  const Word* row = this->Problem->Rows.Get(candidate);
  Words points(this->Covered.size());
  for (int w = 0; w < this->Problem->Rows.Length; ++w)
  {
    points[w] = row[w] & ~this->Covered[w];
  }
  return points;
}

void CoverCounts::ChangeObjects(const Words& points, double sign)
{
  const std::vector<double> weights = this->SumObjects(points.data());
  for (std::size_t k = 0; k < weights.size(); ++k)
  {
    this->ObjectWeights[k] += sign * weights[k];
  }
}

double CoverCounts::GetGain(int candidate) const
{
  if (!this->Problem->HasObjects())
  {
    return this->GetNewWeight(candidate);
  }
  const std::vector<double> weights = this->SumObjects(this->GetNew(candidate).data());
  const double missing = std::max(0.0, this->Problem->Required - this->Weight);
  double gain = missing > 0.0 ? std::min(missing, this->GetNewWeight(candidate)) : 0.0;
  for (std::size_t k = 0; k < weights.size(); ++k)
  {
    gain += std::min(weights[k], std::max(0.0, this->GetMissing(k)));
  }
  return gain;
}

bool CoverCounts::IsNeeded(int point) const
{
  if (!this->Problem->HasObjects() || this->Weight < this->Problem->Required)
  {
    return true;
  }
  const int object = this->GetObject(point);
  return object >= 0 && this->GetMissing(static_cast<std::size_t>(object)) > 0.0;
}

bool CoverCounts::IsEnough() const
{
  if (this->Problem->IsFull)
  {
    return this->Covered == this->Problem->Coverable;
  }
  bool isEnough = this->Weight >= this->Problem->Required;
  for (std::size_t k = 0; k < this->ObjectWeights.size() && isEnough; ++k)
  {
    isEnough = this->GetMissing(k) <= 0.0;
  }
  return isEnough;
}

bool CoverCounts::IsEnoughWithout(int candidate) const
{
  if (this->Problem->IsFull)
  {
    return this->IsRedundant(candidate);
  }
  if (this->Weight - this->GetExclusiveWeight(candidate) < this->Problem->Required)
  {
    return false;
  }
  if (!this->Problem->HasObjects())
  {
    return true;
  }
  const std::vector<double> weights = this->SumObjects(this->GetExclusive(candidate).data());
  bool isEnough = true;
  for (std::size_t k = 0; k < weights.size() && isEnough; ++k)
  {
    isEnough = weights[k] == 0.0 || this->GetMissing(k) + weights[k] <= 0.0;
  }
  return isEnough;
}

} // namespace helios
