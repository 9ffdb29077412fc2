// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosBinaryProgram.h"

#include <coin/CbcEventHandler.hpp>
#include <coin/CbcHeuristic.hpp>
#include <coin/CbcHeuristicLocal.hpp>
#include <coin/CbcModel.hpp>
#include <coin/CglClique.hpp>
#include <coin/CglGomory.hpp>
#include <coin/CglMixedIntegerRounding2.hpp>
#include <coin/CglProbing.hpp>
#include <coin/CglZeroHalf.hpp>
#include <coin/ClpEventHandler.hpp>
#include <coin/ClpSolve.hpp>
#include <coin/CoinPackedMatrix.hpp>
#include <coin/OsiClpSolverInterface.hpp>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdint>

namespace helios
{

namespace
{

/// Tolerance for rounding in a bound.
constexpr double Rounding = 1e-7;

/// Increment with whole costs, where a better solution is better by 1.
constexpr double WholeIncrement = 0.999;

/// Restores the SIGINT handler: the linear solver sets its own.
class SignalGuard
{
public:
  SignalGuard() { sigaction(SIGINT, nullptr, &this->Old); }
  ~SignalGuard() { sigaction(SIGINT, &this->Old, nullptr); }
  SignalGuard(const SignalGuard&) = delete;
  SignalGuard& operator=(const SignalGuard&) = delete;

private:
  struct sigaction Old = {};
};

/// End of a search: a stop request, or the wall time limit. CBC's own limits count CPU time and are
/// checked between nodes only.
class Limit
{
public:
  explicit Limit(const BinaryProgram& program)
    : Stop(program.Stop)
    , WorkOfIteration(program.Starts.back())
    , End(Clock::now() + Duration(program.TimeLimit))
    , NodeEnd(this->End - Duration(std::min(LongestSpare, SpareShare * program.TimeLimit)))
  {
  }

  /// Returns whether a search ends between nodes; the bound stays valid.
  bool IsOverAtNode() { return this->IsOver() || Clock::now() >= this->NodeEnd; }

  /// Returns whether a linear solve ends; its result is then invalid.
  bool IsOverAtIteration()
  {
    this->WorkToSpare -= this->WorkOfIteration;
    return this->WorkToSpare < 0 && this->IsOver();
  }

  /// Remains true once set.
  bool IsOver()
  {
    this->IsCut = this->IsCut || Clock::now() >= this->End || (this->Stop && this->Stop());
    return this->IsCut;
  }

  void SpareNothing() { this->WorkToSpare = 0; }
  bool WasCut() const { return this->IsCut; }
  double GetNodeTime() const
  {
    return std::max(0.0, Duration(this->NodeEnd - Clock::now()).count());
  }

  double Bound = 0.0; // at the previous node

private:
  using Clock = std::chrono::steady_clock;
  using Duration = std::chrono::duration<double>;
  using Time = std::chrono::time_point<Clock, Duration>;

  /// Coefficients times iterations of a relaxation that is completed after the limit, in a few
  /// milliseconds, to obtain a bound.
  std::int64_t WorkToSpare = 10000000;

  static constexpr double SpareShare = 0.1;
  static constexpr double LongestSpare = 0.5; // [s]

  const std::function<bool()>& Stop;
  std::int64_t WorkOfIteration;
  Time End;
  Time NodeEnd;
  bool IsCut = false;
};

/// Stops a search between nodes.
class NodeHandler : public CbcEventHandler
{
public:
  explicit NodeHandler(Limit& limit)
    : Known(limit)
  {
  }

  CbcAction event(CbcEvent what) override
  {
    if (this->Known.IsOverAtNode())
    {
      return stop;
    }
    if (what == node)
    {
      this->Known.Bound = std::max(this->Known.Bound, this->getModel()->getBestPossibleObjValue());
    }
    return noAction;
  }
  CbcEventHandler* clone() const override { return new NodeHandler(*this); }

private:
  Limit& Known;
};

/// Stops a linear solve, and those after it.
class IterationHandler : public ClpEventHandler
{
public:
  explicit IterationHandler(Limit& limit)
    : Known(limit)
  {
  }

  int event(Event what) override
  {
    const bool isPlace = what == endOfIteration || what == endOfFactorization;
    return isPlace && this->Known.IsOverAtIteration() ? 0 : -1;
  }
  ClpEventHandler* clone() const override { return new IterationHandler(*this); }

private:
  Limit& Known;
};

void Load(const BinaryProgram& program, OsiClpSolverInterface& solver)
{
  const int columns = static_cast<int>(program.Costs.size());
  const int rows = static_cast<int>(program.Lower.size());
  const CoinPackedMatrix matrix(false, columns, rows, program.Starts.back(),
    program.Coefficients.data(), program.Columns.data(),
    std::vector<CoinBigIndex>(program.Starts.begin(), program.Starts.end()).data(), nullptr);
  const std::vector<double> zeros(columns, 0.0);
  const std::vector<double> ones(columns, 1.0);
  const std::vector<double> upper(rows, solver.getInfinity());
  solver.messageHandler()->setLogLevel(0);
  solver.getModelPtr()->messageHandler()->setLogLevel(0);
  solver.setHintParam(OsiDoReducePrint, true, OsiHintTry);
  solver.loadProblem(
    matrix, zeros.data(), ones.data(), program.Costs.data(), program.Lower.data(), upper.data());
  for (int c = 0; c < columns; ++c)
  {
    if (program.IsBinary[c])
    {
      solver.setInteger(c);
    }
  }
}

/// Solves the relaxation; true: solved. The relaxation of a program with solutions always has one.
bool Relax(OsiClpSolverInterface& solver, Limit& limit)
{
  IterationHandler handler(limit);
  solver.getModelPtr()->passInEventHandler(&handler); // makes a copy
  ClpSolve options;
  options.setSpecialOption(2, 1); // no SIGINT handler
  solver.setSolveOptions(options);
  solver.initialSolve();
  return !limit.WasCut() && solver.isProvenOptimal();
}

void AddCuts(CbcModel& model)
{
  CglProbing probing;
  probing.setUsingObjective(1);
  probing.setMaxPass(1);
  probing.setMaxProbe(10);
  probing.setMaxLook(10);
  probing.setRowCuts(3);
  CglGomory gomory;
  gomory.setLimit(300);
  CglClique clique;
  clique.setStarCliqueReport(false);
  clique.setRowCliqueReport(false);
  CglMixedIntegerRounding2 rounding;
  CglZeroHalf zeroHalf;
  model.addCutGenerator(&probing, -1, "Probing");
  model.addCutGenerator(&gomory, -1, "Gomory");
  model.addCutGenerator(&clique, -1, "Clique");
  model.addCutGenerator(&rounding, -1, "Rounding");
  model.addCutGenerator(&zeroHalf, -1, "ZeroHalf");
}

void Start(const BinaryProgram& program, CbcModel& model)
{
  if (program.Start.empty())
  {
    return;
  }
  double cost = 0.0;
  for (std::size_t c = 0; c < program.Costs.size(); ++c)
  {
    cost += program.Costs[c] * program.Start[c];
  }
  model.setBestSolution(program.Start.data(), static_cast<int>(program.Start.size()), cost, true);
}

void Search(const BinaryProgram& program, Limit& limit, CbcModel& model)
{
  model.setLogLevel(0);
  model.messageHandler()->setLogLevel(0);
  model.setTypePresolve(0);
  AddCuts(model);
  CbcRounding rounding(model);
  model.addHeuristic(&rounding);
  NodeHandler handler(limit);
  model.passInEventHandler(&handler);
  model.setUseElapsedTime(true);
  model.setMaximumSeconds(limit.GetNodeTime());
  model.setNumberStrong(10);
  model.setNumberBeforeTrust(5);
  if (program.HasWholeCosts)
  {
    model.setDblParam(CbcModel::CbcCutoffIncrement, WholeIncrement);
  }
  Start(program, model);
  limit.SpareNothing();
  model.branchAndBound();
}

} // namespace

int BinaryProgram::AddColumn(double cost, bool isBinary)
{
  this->Costs.push_back(cost);
  this->IsBinary.push_back(isBinary);
  return static_cast<int>(this->Costs.size()) - 1;
}

void BinaryProgram::Add(int column, double coefficient)
{
  this->Columns.push_back(column);
  this->Coefficients.push_back(coefficient);
}

void BinaryProgram::EndRow(double lower)
{
  this->Lower.push_back(lower);
  this->Starts.push_back(static_cast<int>(this->Columns.size()));
}

double SolveRelaxed(const BinaryProgram& program)
{
  const SignalGuard guard;
  Limit limit(program);
  OsiClpSolverInterface solver;
  Load(program, solver);
  return Relax(solver, limit) ? solver.getObjValue() - Rounding : 0.0;
}

BinaryAnswer SolveBinary(const BinaryProgram& program)
{
  const SignalGuard guard;
  Limit limit(program);
  BinaryAnswer answer;
  answer.Values = program.Start;
  OsiClpSolverInterface solver;
  Load(program, solver);
  if (!Relax(solver, limit))
  {
    answer.IsProved = !limit.WasCut() && solver.isProvenPrimalInfeasible();
    return answer;
  }
  answer.LinearBound = solver.getObjValue() - Rounding;
  CbcModel model(solver);
  Search(program, limit, model);
  if (model.bestSolution())
  {
    answer.Values.assign(model.bestSolution(), model.bestSolution() + program.Costs.size());
  }
  // A node whose linear solve was interrupted looks like one without solutions.
  const bool isWhole = !limit.WasCut();
  answer.IsProved = isWhole && (model.isProvenOptimal() || model.isProvenInfeasible());
  const double bound = isWhole ? model.getBestPossibleObjValue() : limit.Bound;
  answer.Bound = std::max(answer.LinearBound, bound - Rounding);
  return answer;
}

} // namespace helios
