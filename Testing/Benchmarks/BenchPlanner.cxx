// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Planning time for many candidates and test points with distinct viewsheds.
//
//   BenchPlanner [candidates a side, 100] [test points a side, 316] [reach, 0.1] [share hidden, 0]
//
// Viewsheds cover a fraction of the site that varies smoothly with position and direction, as over
// relief. Checks full coverage and the lower bound of scans for every plan before it prints a time.

#include "heliosPlan.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <random>

namespace
{

using Vectors = std::vector<helios::Incidence::Vector>;

Vectors MakeGrid(int side, double offset, double height)
{
  Vectors grid;
  for (int i = 0; i < side * side; ++i)
  {
    grid.push_back({ (i % side + offset) / side, (i / side + offset) / side, height });
  }
  return grid;
}

/// View distance of a candidate in a direction [share of site].
double GetReach(const helios::Incidence::Vector& c, double direction)
{
  double sum = 0.0;
  for (int k = 1; k <= 4; ++k)
  {
    sum += std::sin(11.0 * k * c[0] + 17.0 * c[1] / k + k + 2.0 * k * direction);
  }
  return 1.0 + 0.35 * sum;
}

helios::BitMatrix FindVisible(
  const Vectors& candidates, const Vectors& points, double reach, double hidden)
{
  std::mt19937 random(1);
  helios::BitMatrix rows(static_cast<int>(candidates.size()), static_cast<int>(points.size()));
  for (std::size_t a = 0; a < candidates.size(); ++a)
  {
    for (std::size_t v = 0; v < points.size(); ++v)
    {
      const double x = points[v][0] - candidates[a][0];
      const double y = points[v][1] - candidates[a][1];
      const double distance = std::hypot(x, y);
      if (distance < 2.4 * reach && distance < reach * GetReach(candidates[a], std::atan2(y, x)) &&
        (hidden == 0.0 || random() % 1000 >= 1000.0 * hidden))
      {
        rows.Set(static_cast<int>(a), static_cast<int>(v));
      }
    }
  }
  return rows;
}

/// Processor time, as machines are shared.
double GetSeconds()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// One method: checks it, then times it.
bool Run(const helios::CoverProblem& problem, const helios::Incidence& incidence,
  helios::PlanMethod method, const char* name)
{
  helios::PlanSettings settings;
  settings.Method = method;
  const double start = GetSeconds();
  const helios::PlanResult result = helios::MakePlan(problem, incidence, settings);
  const double seconds = GetSeconds() - start;
  if (!helios::CoverCounts(problem, result.Selected).IsEnough() ||
    result.Bound > static_cast<int>(result.Selected.size()))
  {
    std::printf("%s: WRONG\n", name);
    return false;
  }
  std::printf(
    "%-24s %5zu scans, bound %5d, %7.2f s\n", name, result.Selected.size(), result.Bound, seconds);
  return true;
}

} // namespace

int main(int argc, char* argv[])
{
  const auto get = [&](int k, double value) { return argc > k ? std::atof(argv[k]) : value; };
  const Vectors candidates = MakeGrid(static_cast<int>(get(1, 100)), 0.4, 0.01);
  const Vectors points = MakeGrid(static_cast<int>(get(2, 316)), 0.5, 0.0);
  const helios::BitMatrix rows = FindVisible(candidates, points, get(3, 0.1), get(4, 0.0));
  const helios::CoverProblem problem(rows.View());
  double bits = 0.0;
  for (int a = 0; a < rows.View().Rows; ++a)
  {
    bits += rows.View().GetSize(a);
  }
  std::printf("%zu candidates, %zu test points, %.1f %% of the pairs see each other\n",
    candidates.size(), points.size(),
    100.0 * bits / static_cast<double>(candidates.size()) / static_cast<double>(points.size()));
  const helios::Incidence none;
  const helios::Incidence normals(candidates, points, Vectors(points.size(), { 0.0, 0.0, 1.0 }));
  const bool isRight = Run(problem, none, helios::PlanMethod::ViewshedSize, "ViewshedSize") &&
    Run(problem, none, helios::PlanMethod::Greedy, "Greedy") &&
    Run(problem, none, helios::PlanMethod::Best, "Best, no normals") &&
    Run(problem, normals, helios::PlanMethod::Best, "Best");
  return isRight ? 0 : 1;
}
