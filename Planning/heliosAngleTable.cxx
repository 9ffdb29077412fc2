// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosCoverQuality.h"

#include <algorithm>
#include <cmath>

namespace helios
{

AngleTable::AngleTable(const CoverProblem& problem, const Incidence& incidence)
  : Candidates(problem.Rows.Rows)
  , Points(problem.Rows.Columns)
  , Angles(static_cast<std::size_t>(Candidates) * Points, HUGE_VAL)
  , Weights(Points)
{
  for (int v = 0; v < this->Points; ++v)
  {
    this->Weights[v] = problem.GetWeight(v);
  }
  for (int a = 0; a < this->Candidates; ++a)
  {
    double* angles = this->Angles.data() + static_cast<std::size_t>(a) * this->Points;
    VisitBits(problem.Rows.Get(a), problem.Rows.Length,
      [&](int v)
      {
        angles[v] = incidence.GetAngle(a, v);
        if (std::isnan(angles[v]))
        {
          angles[v] = 0.0;
          this->Weights[v] = 0.0;
        }
      });
  }
}

BitMatrix AngleTable::Restrict(double angle) const
{
  BitMatrix rows(this->Candidates, this->Points);
  for (int a = 0; a < this->Candidates; ++a)
  {
    const double* angles = this->Get(a);
    for (int v = 0; v < this->Points; ++v)
    {
      if (angles[v] <= angle)
      {
        rows.Set(a, v);
      }
    }
  }
  return rows;
}

std::vector<double> AngleTable::GetThresholds(double below) const
{
  std::vector<double> best(this->Points, HUGE_VAL);
  for (int a = 0; a < this->Candidates; ++a)
  {
    const double* angles = this->Get(a);
    for (int v = 0; v < this->Points; ++v)
    {
      best[v] = std::min(best[v], angles[v]);
    }
  }
  double minimum = 0.0;
  for (const double angle : best)
  {
    minimum = angle < HUGE_VAL ? std::max(minimum, angle) : minimum;
  }
  std::vector<double> thresholds;
  std::copy_if(this->Angles.begin(), this->Angles.end(), std::back_inserter(thresholds),
    [=](double angle) { return angle >= minimum && angle < below; });
  std::sort(thresholds.begin(), thresholds.end());
  thresholds.erase(std::unique(thresholds.begin(), thresholds.end()), thresholds.end());
  return thresholds;
}

} // namespace helios
