// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosCoverProblem.h"

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
  this->Weight += this->GetGain(candidate);
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

double CoverCounts::GetGain(int candidate) const
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

bool CoverCounts::IsEnough() const
{
  return this->Problem->IsFull ? this->Covered == this->Problem->Coverable
                               : this->Weight >= this->Problem->Required;
}

bool CoverCounts::IsEnoughWithout(int candidate) const
{
  return this->Problem->IsFull
    ? this->IsRedundant(candidate)
    : this->Weight - this->GetExclusiveWeight(candidate) >= this->Problem->Required;
}

} // namespace helios
