// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// An expression of one variable, as surveys write it.

#ifndef heliosExpression_h
#define heliosExpression_h

#include <vtkExprTkFunctionParser.h>
#include <vtkSmartPointer.h>

#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace helios
{

/**
 * Numbers, pi, e, the variable t (or THETA), + - * / ^, brackets, and exp ln sqrt abs cos sin tan acos
 * asin atan cosh sinh tanh atan2(a, b). VTK's parser evaluates it, one parser a thread at a time.
 */
class Expression
{
public:
  static constexpr std::size_t LongestText = 1000;
  static constexpr std::size_t DeepestBracket = 100;

  /// What messages show of a text that may be long.
  static std::string Shorten(const std::string& text);

  /// What is wrong with a text and how to mend it; nothing: it is an expression, or empty. One that
  /// has no finite value for any angle or range is wrong, too.
  static std::string FindFault(const std::string& text);

  explicit Expression(const std::string& text);

  /// The value for a variable, which may be not finite. Thread-safe.
  double Evaluate(double variable);

private:
  using Parser = vtkSmartPointer<vtkExprTkFunctionParser>;

  Parser TakeParser();
  void ReturnParser(Parser parser);

  std::string Text;
  std::mutex Mutex;
  std::vector<Parser> Idle;
};

} // namespace helios

#endif
