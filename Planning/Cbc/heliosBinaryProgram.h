// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Linear programs of columns that are binary, or continuous in [0, 1], by branch and cut.

#ifndef heliosBinaryProgram_h
#define heliosBinaryProgram_h

#include "vtkHeliosPlanningCbcModule.h" // For export macro

#include <functional>
#include <vector>

namespace helios
{

/// Minimizes the cost of columns in [0, 1], subject to sum(coefficient * column) >= lower in every
/// row.
struct VTKHELIOSPLANNINGCBC_EXPORT BinaryProgram
{
  std::vector<double> Costs;       // one per column
  std::vector<char> IsBinary;      // 0: continuous in [0, 1]
  std::vector<int> Starts = { 0 }; // start of each row in Columns; one more at the end
  std::vector<int> Columns;
  std::vector<double> Coefficients;
  std::vector<double> Lower;  // one per row
  bool HasWholeCosts = false; // all solutions cost whole numbers: a better one is better by 1
  std::vector<double> Start;  // a known solution; empty: none
  double TimeLimit = 60.0;    // wall time [s]
  std::function<bool()> Stop; // also polled within linear solves; empty: never stops

  int AddColumn(double cost, bool isBinary);
  void Add(int column, double coefficient);
  /// Ends the row filled by Add.
  void EndRow(double lower);
};

struct BinaryAnswer
{
  std::vector<double> Values; // the best solution found; empty: none
  double LinearBound = 0.0;   // bound of the relaxation; 0: not solved in time
  double Bound = 0.0;         // lower bound on the cost of any solution
  bool IsProved = false;      // Values is proved optimal, or no solution exists
};

/// Prints nothing; leaves the signal handlers unchanged.
VTKHELIOSPLANNINGCBC_EXPORT BinaryAnswer SolveBinary(const BinaryProgram& program);

/// Returns the relaxation alone; 0 if it was stopped or exceeded the time limit.
VTKHELIOSPLANNINGCBC_EXPORT double SolveRelaxed(const BinaryProgram& program);

} // namespace helios

#endif
