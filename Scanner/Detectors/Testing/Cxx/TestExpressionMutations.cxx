// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Damaged expressions are rejected with a reason, or have values.
#include "heliosErrorObserver.h"
#include "heliosMutation.h"
#include "vtkHeliosExpressionErrorModel.h"

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <catch2/catch.hpp>

#include <string>

namespace
{

const char* const Expressions[] = { "0.001 * t", "sin(THETA) * 1e-3 + 2 * pi / (1 + t^2)",
  "atan2(t, 1) * -1e-3 + e - exp(1)", "abs(sqrt(t) * 1e-4) + ln(2 + t)",
  "-((cosh(t)-tanh(2))*.5)" };

/// A text with many repeated brackets, signs or digits.
std::string Repeat(const std::string& text, int i)
{
  static const char* const units[] = { "(", "-", "9", "t+", "sin(", "2^", ")" };
  std::string many;
  for (int n = 0; n < 20 * (i % 50); ++n)
  {
    many += units[static_cast<std::size_t>(i) % std::size(units)];
  }
  return many + text;
}

} // namespace

TEST_CASE("ExpressionMutations: damaged expressions are refused or have values",
  "[ExpressionMutations][mutation]")
{
  helios::Mutator mutate(20203);
  int errorCount = 0;
  int goodCount = 0;
  for (int i = 0; i < helios::GetNumberOfMutations(); ++i)
  {
    std::string text = mutate(Expressions[static_cast<std::size_t>(i) % std::size(Expressions)]);
    text = i % 10 == 9 ? Repeat(text, i) : text;
    INFO("case " << i << "\n" << text);
    vtkNew<vtkHeliosExpressionErrorModel> model;
    const auto log = vtkSmartPointer<helios::ErrorObserver>::Take(helios::ErrorObserver::New());
    log->Watch(model);
    model->SetRangeErrorExpression(text);
    const bool isGood = vtkHeliosExpressionErrorModel::FindFault(text).empty();
    (isGood ? goodCount : errorCount) += 1;
    REQUIRE(isGood == log->Errors.empty());
    for (const double t : { -1.0, 0.0, 0.7, 1e9 })
    {
      const double value = model->GetRangeError(t);
      REQUIRE((isGood || value == 0.0)); // rejected: the previous one, empty, is kept
    }
  }
  CHECK(errorCount > 20);
  CHECK(goodCount > 20);
}
