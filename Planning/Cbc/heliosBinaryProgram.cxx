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
#include <coin/CoinPackedMatrix.hpp>
#include <coin/OsiClpSolverInterface.hpp>

#include <algorithm>
#include <csignal>

namespace helios
{

namespace
{

/// What rounding may add to a bound.
constexpr double Rounding = 1e-7;

/// A solution of whole costs is better by 1, or not at all.
constexpr double WholeIncrement = 0.999;

/// Puts the handler of interrupts back: the linear solver sets its own.
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

/// Ends a search when it is told to.
class StopHandler : public CbcEventHandler
{
public:
  explicit StopHandler(const std::function<bool()>& test)
    : Stop(test)
  {
  }

  CbcAction event(CbcEvent) override { return this->Stop && this->Stop() ? stop : noAction; }
  CbcEventHandler* clone() const override { return new StopHandler(*this); }

private:
  std::function<bool()> Stop;
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

/// True: solved. The relaxation of a programme with solutions always has one.
bool Relax(const BinaryProgram& program, OsiClpSolverInterface& solver)
{
  solver.getModelPtr()->setMaximumSeconds(program.TimeLimit);
  solver.initialSolve();
  solver.getModelPtr()->setMaximumSeconds(-1.0);
  return solver.isProvenOptimal();
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

void Search(const BinaryProgram& program, CbcModel& model)
{
  model.setLogLevel(0);
  model.messageHandler()->setLogLevel(0);
  model.setTypePresolve(0);
  AddCuts(model);
  CbcRounding rounding(model);
  model.addHeuristic(&rounding);
  StopHandler handler(program.Stop);
  model.passInEventHandler(&handler);
  model.setMaximumSeconds(program.TimeLimit);
  model.setNumberStrong(10);
  model.setNumberBeforeTrust(5);
  if (program.HasWholeCosts)
  {
    model.setDblParam(CbcModel::CbcCutoffIncrement, WholeIncrement);
  }
  Start(program, model);
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
  OsiClpSolverInterface solver;
  Load(program, solver);
  return Relax(program, solver) ? solver.getObjValue() - Rounding : 0.0;
}

BinaryAnswer SolveBinary(const BinaryProgram& program)
{
  const SignalGuard guard;
  BinaryAnswer answer;
  answer.Values = program.Start;
  OsiClpSolverInterface solver;
  Load(program, solver);
  if (!Relax(program, solver))
  {
    answer.IsProved = solver.isProvenPrimalInfeasible();
    return answer;
  }
  answer.LinearBound = solver.getObjValue() - Rounding;
  CbcModel model(solver);
  Search(program, model);
  if (model.bestSolution())
  {
    answer.Values.assign(model.bestSolution(), model.bestSolution() + program.Costs.size());
  }
  answer.IsProved = model.isProvenOptimal() || model.isProvenInfeasible();
  answer.Bound = std::max(answer.LinearBound, model.getBestPossibleObjValue() - Rounding);
  return answer;
}

} // namespace helios
