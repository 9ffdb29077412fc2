// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosScatteredProfile.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace helios
{

//------------------------------------------------------------------------------
void ScatteredProfile::Clear()
{
  this->Samples.clear();
  this->Returns.clear();
}

//------------------------------------------------------------------------------
void ScatteredProfile::Finish()
{
  std::stable_sort(this->Samples.begin(), this->Samples.end(),
    [](const Sample& a, const Sample& b) { return a.Range < b.Range; });
  for (auto first = this->Samples.begin(), last = first; first != this->Samples.end(); first = last)
  {
    Return sum{ 0.0, 0.0, -1, 1.0, Vec3(0.0, 0.0, 0.0), {} };
    double strongest = 0.0;
    for (; last != this->Samples.end() && last->Range - first->Range <= this->Step; ++last)
    {
      sum.Range += last->Power * last->Range;
      sum.Power += last->Power;
      sum.Batches[last->Batch] += last->Power;
      if (last->Power > strongest)
      {
        strongest = last->Power;
        sum.Cell = last->Cell;
        sum.Cosine = last->Cosine;
        sum.Point = last->Point;
      }
    }
    sum.Range /= sum.Power;
    this->Returns.push_back(sum);
  }
}

//------------------------------------------------------------------------------
ScatteredPower ScatteredProfile::GetSum(const std::array<double, NumberOfBatches>& sums)
{
  constexpr double count = NumberOfBatches;
  const double sum = std::accumulate(sums.begin(), sums.end(), 0.0);
  double squares = 0.0;
  for (const double each : sums)
  {
    squares += (each - sum / count) * (each - sum / count);
  }
  return { sum, std::sqrt(count / (count - 1.0) * squares) };
}

} // namespace helios
