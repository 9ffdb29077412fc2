// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosCoverExact.h"

#if VTK_MODULE_ENABLE_vtkHelios_PlanningCbc
#include "heliosBinaryProgram.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <utility>
#endif

namespace helios
{

#if VTK_MODULE_ENABLE_vtkHelios_PlanningCbc

namespace
{

double GetSeconds()
{
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(now).count();
}

/// Requires that every point is seen: one row each.
void AddPoints(const CoverProblem& problem, const BitRows& points, BinaryProgram& program)
{
  VisitBits(problem.Coverable.data(), problem.Rows.Length,
    [&](int v)
    {
      VisitBits(points.Get(v), points.Length, [&](int a) { program.Add(a, 1.0); });
      program.EndRow(1.0);
    });
}

/// Requires enough weight, in all and of each object: one column for all points of an object that
/// are seen by the same candidates.
void AddShares(const CoverProblem& problem, const BitRows& points, BinaryProgram& program)
{
  using Class = std::pair<int, Words>; // the object, and the candidates
  std::map<Class, double> classes;
  const bool hasObjects = problem.HasObjects();
  VisitBits(problem.Coverable.data(), problem.Rows.Length,
    [&](int v)
    {
      Words seers(points.Get(v), points.Get(v) + points.Length);
      classes[{ hasObjects ? problem.Objects.Of[v] : -1, std::move(seers) }] +=
        problem.GetWeight(v);
    });
  std::vector<std::pair<int, double>> weights;
  const int first = static_cast<int>(program.Costs.size());
  for (const auto& [seen, weight] : classes)
  {
    weights.emplace_back(seen.first, weight);
    const int z = program.AddColumn(0.0, false);
    VisitBits(seen.second.data(), points.Length, [&](int a) { program.Add(a, 1.0); });
    program.Add(z, -1.0);
    program.EndRow(0.0);
  }
  // Counts shares, not m2: the solver's tolerances are absolute.
  const auto require = [&](double required, int object)
  {
    for (std::size_t k = 0; k < weights.size() && required > 0.0; ++k)
    {
      if (object < 0 || weights[k].first == object)
      {
        program.Add(first + static_cast<int>(k), weights[k].second / required);
      }
    }
    if (required > 0.0)
    {
      program.EndRow(1.0);
    }
  };
  require(problem.Required, -1);
  for (std::size_t k = 0; hasObjects && k < problem.Objects.Required.size(); ++k)
  {
    require(problem.Objects.Required[k], static_cast<int>(k));
  }
}

BinaryProgram MakeProgram(const CoverProblem& problem)
{
  BinaryProgram program;
  const BitMatrix points = Transpose(problem.Rows);
  for (int a = 0; a < problem.Rows.Rows; ++a)
  {
    program.AddColumn(1.0, true);
  }
  program.HasWholeCosts = true;
  if (problem.IsFull)
  {
    AddPoints(problem, points.View(), program);
  }
  else
  {
    AddShares(problem, points.View(), program);
  }
  return program;
}

/// Returns the choice as columns; the shares follow from it.
std::vector<double> GetValues(
  const CoverProblem& problem, const Choice& choice, const BinaryProgram& program)
{
  std::vector<double> values(program.Costs.size());
  for (const int a : choice)
  {
    values[a] = 1.0;
  }
  std::size_t row = 0;
  for (std::size_t z = problem.Rows.Rows; z < values.size(); ++z, ++row)
  {
    double seen = 0.0;
    for (int k = program.Starts[row]; k < program.Starts[row + 1] - 1; ++k)
    {
      seen += values[program.Columns[k]];
    }
    values[z] = std::min(1.0, seen);
  }
  return values;
}

Choice GetChoice(const CoverProblem& problem, const std::vector<double>& values)
{
  Choice choice;
  for (int a = 0; a < problem.Rows.Rows; ++a)
  {
    if (values[a] > 0.5)
    {
      choice.push_back(a);
    }
  }
  return choice;
}

/// Returns the neighbours of a part adjacent to the region reachable from b without them: a
/// separator.
Choice FindSeparator(OverlapNetwork& network, const Choice& part, int b, int candidates)
{
  const int length = GetWordCount(candidates);
  Words around(length);
  for (const int a : part)
  {
    for (int w = 0; w < length; ++w)
    {
      around[w] |= network.GetNeighbours(a)[w];
    }
  }
  Words isNew(length, ~Word(0));
  for (int w = 0; w < length; ++w)
  {
    isNew[w] = ~around[w];
  }
  Words separator(length);
  Choice queue = { b };
  ClearBit(isNew.data(), b);
  for (std::size_t k = 0; k < queue.size(); ++k)
  {
    const Words& neighbours = network.GetNeighbours(queue[k]);
    for (int w = 0; w < length; ++w)
    {
      separator[w] |= neighbours[w] & around[w];
      VisitWord(neighbours[w] & isNew[w], w, [&queue](int c) { queue.push_back(c); });
      isNew[w] &= ~neighbours[w];
    }
  }
  Choice result;
  VisitBits(separator.data(), length, [&result](int c) { result.push_back(c); });
  return result;
}

void AddCuts(
  OverlapNetwork& network, const std::vector<Choice>& parts, int candidates, BinaryProgram& program)
{
  for (std::size_t p = 0; p < parts.size(); ++p)
  {
    for (std::size_t q = 0; q < parts.size(); ++q)
    {
      for (const int b : p != q ? parts[q] : Choice())
      {
        const Choice separator = FindSeparator(network, parts[p], b, candidates);
        for (const int a : parts[p])
        {
          program.Add(a, -1.0);
          program.Add(b, -1.0);
          for (const int c : separator)
          {
            program.Add(c, 1.0);
          }
          program.EndRow(-1.0);
        }
      }
    }
  }
}

} // namespace

bool HasExactSolver()
{
  return true;
}

ExactAnswer SolveCover(const CoverProblem& problem, const Choice& start, OverlapNetwork* network,
  double timeLimit, const StopTest& stop)
{
  ExactAnswer answer{ start, 0, false };
  const double end = GetSeconds() + timeLimit;
  BinaryProgram program = MakeProgram(problem);
  program.Start = GetValues(problem, start, program);
  program.Stop = stop;
  while (!answer.IsProved && GetSeconds() < end && !(stop && stop()))
  {
    program.TimeLimit = end - GetSeconds();
    const BinaryAnswer found = SolveBinary(program);
    answer.Bound = std::max(answer.Bound, static_cast<int>(std::ceil(found.Bound)));
    const Choice choice = GetChoice(problem, found.Values);
    const std::vector<Choice> parts =
      network ? network->GetParts(choice) : std::vector<Choice>{ choice };
    if (parts.size() > 1)
    {
      AddCuts(*network, parts, problem.Rows.Rows, program);
      continue;
    }
    const bool isFewer = choice.size() < answer.Best.size();
    const bool isEnough = CoverCounts(problem, choice).IsEnough(); // within the cover's tolerance
    answer.Best = isFewer && isEnough ? choice : answer.Best;
    answer.IsProved = found.IsProved && (isEnough || !isFewer);
    break;
  }
  const int count = static_cast<int>(answer.Best.size());
  answer.IsProved = answer.IsProved || answer.Bound >= count;
  answer.Bound = answer.IsProved ? count : answer.Bound;
  return answer;
}

double GetLinearBound(
  const CoverProblem& problem, std::int64_t maximumBits, double timeLimit, const StopTest& stop)
{
  if (problem.Rows.GetSize() > maximumBits)
  {
    return 0.0;
  }
  BinaryProgram program = MakeProgram(problem);
  program.TimeLimit = timeLimit;
  program.Stop = stop;
  return SolveRelaxed(program);
}

#else

bool HasExactSolver()
{
  return false;
}

ExactAnswer SolveCover(
  const CoverProblem&, const Choice& start, OverlapNetwork*, double, const StopTest&)
{
  return { start, 0, false };
}

double GetLinearBound(const CoverProblem&, std::int64_t, double, const StopTest&)
{
  return 0.0;
}

#endif

} // namespace helios
