// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosErrorObserver.h"
#include "heliosRandom.h"
#include "vtkHeliosExpressionErrorModel.h"

#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkSMPTools.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <string>
#include <vector>

namespace
{

double Evaluate(const std::string& text, double t)
{
  vtkNew<vtkHeliosExpressionErrorModel> model;
  model->SetRangeErrorExpression(text);
  return model->GetRangeError(t);
}

} // namespace

TEST_CASE("ExpressionErrorModel: every function of the dialect", "[ExpressionErrorModel]")
{
  constexpr double t = 0.3;
  CHECK(Evaluate("0.001 * THETA + 2", t) == 0.001 * t + 2.0);
  CHECK(Evaluate("t^2 - t/4", t) == Approx(t * t - t / 4).epsilon(1e-15));
  CHECK(Evaluate("2^3^2", t) == 512.0);
  CHECK(Evaluate("-t^2", t) == Approx(-t * t).epsilon(1e-15));
  CHECK(Evaluate("pi + e", t) == vtkMath::Pi() + std::exp(1.0));
  CHECK(Evaluate("atan2(t, 1 - (t))", t) == Approx(std::atan2(t, 1 - t)).epsilon(1e-15));
  const std::pair<const char*, double> functions[] = { { "exp", std::exp(t) },
    { "ln", std::log(t) }, { "sqrt", std::sqrt(t) }, { "abs", t }, { "cos", std::cos(t) },
    { "sin", std::sin(t) }, { "tan", std::tan(t) }, { "acos", std::acos(t) },
    { "asin", std::asin(t) }, { "atan", std::atan(t) }, { "cosh", std::cosh(t) },
    { "sinh", std::sinh(t) }, { "tanh", std::tanh(t) } };
  for (const auto& [name, value] : functions)
  {
    CAPTURE(name);
    CHECK(Evaluate(std::string(name) + "(t)", t) == Approx(value).epsilon(1e-14));
    CHECK(Evaluate(std::string(name) + " ( THETA )", t) == Approx(value).epsilon(1e-14));
  }
}

TEST_CASE("ExpressionErrorModel: each property is independent", "[ExpressionErrorModel]")
{
  vtkNew<vtkHeliosExpressionErrorModel> model;
  CHECK(model->GetRangeError(1.0) == 0.0);
  CHECK(model->GetDeflectionError(1.0) == 0.0);
  CHECK(model->GetHeadError(1.0) == 0.0);
  CHECK(model->GetRangeNoiseFactor(1.0) == 1.0);
  model->SetRangeErrorExpression("t");
  model->SetDeflectionErrorExpression("2 * t");
  model->SetHeadErrorExpression("3 * t");
  model->SetRangeNoiseFactorExpression("1 + t / 100");
  CHECK(model->GetRangeError(0.5) == 0.5);
  CHECK(model->GetDeflectionError(0.5) == 1.0);
  CHECK(model->GetHeadError(0.5) == 1.5);
  CHECK(model->GetRangeNoiseFactor(200.0) == 3.0);
  CHECK(model->GetDeflectionErrorExpression() == "2 * t");
  const vtkMTimeType before = model->GetMTime();
  model->SetRangeErrorExpression("t");
  CHECK(model->GetMTime() == before);
  model->SetRangeErrorExpression("");
  CHECK(model->GetRangeError(0.5) == 0.0);
  CHECK(model->GetMTime() > before);
}

TEST_CASE("ExpressionErrorModel: the head error avoids zeros of the sine", "[ExpressionErrorModel]")
{
  vtkNew<vtkHeliosExpressionErrorModel> model;
  model->SetHeadErrorExpression("1 / sin(t)");
  model->SetZeroSinThreshold(1.0);
  const double least = vtkMath::RadiansFromDegrees(1.0);
  CHECK(model->GetHeadError(0.0) == Approx(1.0 / std::sin(least)));
  CHECK(model->GetHeadError(-1e-3) == Approx(-1.0 / std::sin(least)));
  CHECK(model->GetHeadError(vtkMath::Pi() + 1e-3) == Approx(-1.0 / std::sin(least)));
  CHECK(model->GetHeadError(0.5) == Approx(1.0 / std::sin(0.5)));
}

TEST_CASE(
  "ExpressionErrorModel: values that are not finite are passed on", "[ExpressionErrorModel]")
{
  CHECK_FALSE(std::isfinite(Evaluate("1 / t", 0.0)));
  CHECK_FALSE(std::isfinite(Evaluate("sqrt(t)", -1.0)));
  CHECK(Evaluate("sqrt(t)", 4.0) == 2.0);
  vtkNew<vtkHeliosExpressionErrorModel> model;
  model->SetRangeNoiseFactorExpression("ln(t)");
  CHECK_FALSE(std::isfinite(model->GetRangeNoiseFactor(-1.0)));
  using Model = vtkHeliosErrorModel;
  CHECK(model->GetTermName(Model::RANGE_NOISE_FACTOR) == "RangeNoiseFactorExpression \"ln(t)\"");
  model->SetTermName(Model::RANGE_NOISE_FACTOR, "file:1: expr=\"ln(t)\"");
  CHECK(model->GetTermName(Model::RANGE_NOISE_FACTOR) == "file:1: expr=\"ln(t)\"");
}

TEST_CASE("ExpressionErrorModel: bad expressions are refused", "[ExpressionErrorModel]")
{
  const std::pair<const char*, const char*> bad[] = {
    { "foo(t)", "foo is not known; use t or THETA, pi, e, exp, ln" },
    { "theta", "theta is not known" },
    { "2 * x", "x is not known" },
    { "1,5 * t", "a comma outside atan2(a, b); write decimals with a point (character 2)" },
    { "atan2(t)", "atan2 has one argument; give two (character 8)" },
    { "sin t", "sin has no argument; write sin(t) (character 1)" },
    { "t(2)", "t is not a function; write an operator after it (character 1)" },
    { "0.1 * (t", "a bracket is not closed; add ) (character 9)" },
    { "t)", "')' is not expected; remove it (character 2)" },
    { "t; t", "';' is not expected; remove it (character 2)" },
    { "1 + * 2", "Invalid token sequence" },
    { "t t", "write a term between operators" },
    { "2 +", "write a term between operators" },
    { "()", "write a term between operators" },
    { "1e999", "a number is not valid" },
    { " ", "it is blank; write for example" },
    { "while(true){}", "while is not known" },
    { "ln(-1)", "its value is never finite" },
    { "1/0*t", "its value is never finite" },
    { "1e308*1e308", "its value is never finite" },
  };
  for (const auto& [text, part] : bad)
  {
    CAPTURE(text);
    vtkNew<vtkHeliosExpressionErrorModel> model;
    auto log = vtkSmartPointer<helios::ErrorObserver>::Take(helios::ErrorObserver::New());
    log->Watch(model);
    model->SetRangeErrorExpression("t");
    model->SetRangeErrorExpression(text);
    CAPTURE(log->Errors);
    CHECK(log->HasError("RangeErrorExpression \"" + std::string(text) + "\": "));
    CHECK(log->HasError(part));
    CHECK(model->GetRangeErrorExpression() == "t");
    CHECK_FALSE(vtkHeliosExpressionErrorModel::FindFault(text).empty());
  }
  CHECK(vtkHeliosExpressionErrorModel::FindFault("0.001 * sin(t)").empty());
  CHECK(vtkHeliosExpressionErrorModel::FindFault("").empty());
}

TEST_CASE(
  "ExpressionErrorModel: any sequence of words is read or refused", "[ExpressionErrorModel]")
{
  const std::vector<std::string> words = { "t", "2", "+", "-", "^", "/", "(", ")", "sin", "atan2",
    ",", " ", ".", "e", "1e" };
  vtkNew<vtkHeliosExpressionErrorModel> model;
  auto log = vtkSmartPointer<helios::ErrorObserver>::Take(helios::ErrorObserver::New());
  log->Watch(model);
  int sound = 0;
  for (std::uint64_t item = 0; item < 1500; ++item)
  {
    std::string text;
    for (std::uint32_t draw = 0; draw < 2; ++draw)
    {
      for (const double u : helios::Uniform4(1, helios::RandomStream::Scene, item, draw))
      {
        text += words[static_cast<std::size_t>(u * static_cast<double>(words.size()))];
      }
      text = item % 2 == 0 && draw == 0 ? "(" + text + ")" : text;
    }
    text = text.substr(0, 1 + item % 8);
    log->Clear();
    model->SetRangeErrorExpression("");
    model->SetRangeErrorExpression(text);
    CAPTURE(text);
    CHECK(log->Errors.empty() == (model->GetRangeErrorExpression() == text));
    CHECK(std::isfinite(model->GetRangeError(0.3)));
    sound += log->Errors.empty() ? 1 : 0;
  }
  CHECK(sound > 20);
}

TEST_CASE("ExpressionErrorModel: can be used by several threads", "[ExpressionErrorModel]")
{
  vtkNew<vtkHeliosExpressionErrorModel> model;
  model->SetRangeErrorExpression("sin(t) + t^2");
  std::vector<double> values(20000);
  vtkSMPTools::For(0, static_cast<vtkIdType>(values.size()), 16,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        values[static_cast<std::size_t>(i)] = model->GetRangeError(1e-4 * static_cast<double>(i));
      }
    });
  for (std::size_t i = 0; i < values.size(); i += 7)
  {
    REQUIRE(values[i] == model->GetRangeError(1e-4 * static_cast<double>(i)));
  }
}
