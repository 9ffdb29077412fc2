// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Linear programmes of columns that are 0 or 1, or in between, by branch and cut.

#ifndef heliosBinaryProgram_h
#define heliosBinaryProgram_h

#include "vtkHeliosPlanningCbcModule.h" // For export macro

#include <functional>
#include <vector>

namespace helios
{

/// Minimise the costs of columns in [0, 1], where sum of coefficient times column >= lower in every row.
struct VTKHELIOSPLANNINGCBC_EXPORT BinaryProgram
{
  std::vector<double> Costs;       // a column each
  std::vector<char> IsBinary;      // 0: any value in [0, 1]
  std::vector<int> Starts = { 0 }; // of a row in Columns; one more at the end
  std::vector<int> Columns;
  std::vector<double> Coefficients;
  std::vector<double> Lower;  // a row each
  bool HasWholeCosts = false; // of every solution: it takes a better one to be better by 1
  std::vector<double> Start;  // a solution that is known; empty: none
  double TimeLimit = 60.0;    // of the clock on the wall, however busy the machine is [s]
  std::function<bool()> Stop; // asked within linear solves, too; empty: never stops

  int AddColumn(double cost, bool isBinary);
  void Add(int column, double coefficient);
  /// Ends the row that Add has filled.
  void EndRow(double lower);
};

struct BinaryAnswer
{
  std::vector<double> Values; // the best solution found; empty: none
  double LinearBound = 0.0;   // of the relaxation; 0: not solved in time
  double Bound = 0.0;         // no solution costs less
  bool IsProved = false;      // that Values is the best, or that there is none
};

/// Prints nothing, and leaves the handlers of signals as they are.
VTKHELIOSPLANNINGCBC_EXPORT BinaryAnswer SolveBinary(const BinaryProgram& program);

/// The relaxation alone; 0 where it was stopped or took longer than the time limit.
VTKHELIOSPLANNINGCBC_EXPORT double SolveRelaxed(const BinaryProgram& program);

} // namespace helios

#endif
