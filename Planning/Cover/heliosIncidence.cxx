// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosIncidence.h"

#include <vtkMath.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace helios
{

namespace
{

constexpr double None = std::numeric_limits<double>::quiet_NaN();

/// Tolerance for comparing means [deg]: sums depend on the order of their terms.
constexpr double MeanTolerance = 1e-9;

} // namespace

bool Quality::IsBetterThan(const Quality& other) const
{
  return this->Worst != other.Worst ? this->Worst < other.Worst
                                    : this->Mean < other.Mean - MeanTolerance;
}

Incidence::Incidence(
  std::vector<Vector> positions, std::vector<Vector> points, std::vector<Vector> normals)
  : Positions(std::move(positions))
  , Points(std::move(points))
  , Normals(std::move(normals))
{
  for (Vector& n : this->Normals)
  {
    const double length = vtkMath::Norm(n.data());
    for (double& component : n)
    {
      component = length > 0.0 ? component / length : None;
    }
  }
}

Incidence Incidence::Select(const Choice& candidates) const
{
  Incidence some = *this;
  some.Positions.clear();
  for (const int a : candidates)
  {
    some.Positions.push_back(this->Positions[a]);
  }
  return some;
}

double Incidence::GetAngle(int candidate, int point) const
{
  if (this->Normals.empty())
  {
    return None;
  }
  const Vector& p = this->Positions[candidate];
  const Vector& v = this->Points[point];
  const Vector d = { v[0] - p[0], v[1] - p[1], v[2] - p[2] };
  const double along = vtkMath::Dot(d.data(), this->Normals[point].data());
  const double length = vtkMath::Norm(d.data());
  const double cosine = length > 0.0 ? std::min(std::abs(along) / length, 1.0) : 1.0;
  const double angle = vtkMath::DegreesFromRadians(std::acos(cosine));
  return std::round(angle * 1e9) / 1e9;
}

double Incidence::GetMean(const CoverProblem& problem, int candidate) const
{
  double sum = 0.0;
  double count = 0.0;
  VisitBits(problem.Rows.Get(candidate), problem.Rows.Length,
    [&](int v)
    {
      const double angle = this->GetAngle(candidate, v);
      sum += std::isnan(angle) ? 0.0 : angle;
      count += std::isnan(angle) ? 0.0 : 1.0;
    });
  return count > 0.0 ? sum / count : None;
}

std::vector<double> Incidence::GetBest(const CoverProblem& problem, const Choice& choice) const
{
  std::vector<double> best(problem.Rows.Columns, None);
  for (const int candidate : choice)
  {
    VisitBits(problem.Rows.Get(candidate), problem.Rows.Length,
      [&](int v) { best[v] = std::fmin(best[v], this->GetAngle(candidate, v)); });
  }
  return best;
}

Quality Incidence::ComputeQuality(const CoverProblem& problem, const std::vector<double>& best)
{
  double worst = None;
  double sum = 0.0;
  double weight = 0.0;
  for (int v = 0; v < problem.Rows.Columns; ++v)
  {
    if (!std::isnan(best[v]))
    {
      worst = std::fmax(worst, best[v]);
      sum += problem.GetWeight(v) * best[v];
      weight += problem.GetWeight(v);
    }
  }
  return { worst, weight > 0.0 ? sum / weight : None };
}

} // namespace helios
