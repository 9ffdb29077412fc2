// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// An expression of one variable, as in surveys.

#ifndef heliosExpression_h
#define heliosExpression_h

#include "heliosStatus.h"

#include <vtkExprTkFunctionParser.h>
#include <vtkSmartPointer.h>

#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace helios
{

/**
 * Numbers, pi, e, the variable t (or THETA), + - * / ^, brackets, and exp ln sqrt abs cos sin tan
 * acos asin atan cosh sinh tanh atan2(a, b). VTK's parser evaluates it, one parser per thread.
 */
class Expression
{
public:
  static constexpr std::size_t LongestText = 1000;
  static constexpr std::size_t DeepestBracket = 100;

  /// Returns the part of a possibly long string that messages show.
  static std::string Shorten(const std::string& text);

  /// Returns an error with a remedy if a text is neither a valid expression nor empty. An expression
  /// without a finite value for any angle or range is not valid either.
  static Status FindFault(const std::string& text);

  explicit Expression(const std::string& text);

  /// Returns the value for a variable, which may be non-finite. Thread-safe.
  double Evaluate(double variable);

private:
  using Parser = vtkSmartPointer<vtkExprTkFunctionParser>;

  Parser AcquireParser();
  void ReturnParser(Parser parser);

  std::string Text;
  std::mutex Mutex;
  std::vector<Parser> Idle;
};

} // namespace helios

#endif
