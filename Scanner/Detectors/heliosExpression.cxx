// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosExpression.h"

#include "heliosErrorTerms.h"
#include "heliosStatus.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkMath.h>
#include <vtkNew.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <set>

namespace helios
{
namespace
{

using Parser = vtkSmartPointer<vtkExprTkFunctionParser>;

const std::set<std::string> Variables = { "t", "THETA", "pi", "e" };
const std::set<std::string> Functions = { "exp", "ln", "sqrt", "abs", "cos", "sin", "tan", "acos",
  "asin", "atan", "cosh", "sinh", "tanh", "atan2" };

Parser MakeParser(const std::string& text)
{
  auto parser = Parser::New();
  parser->SetScalarVariableValue("t", 0.0);
  parser->SetScalarVariableValue("THETA", 0.0);
  parser->SetScalarVariableValue("pi", vtkMath::Pi());
  parser->SetScalarVariableValue("e", std::exp(1.0));
  parser->ReplaceInvalidValuesOn();
  parser->SetReplacementValue(vtkMath::Nan());
  parser->SetFunction(text.c_str());
  return parser;
}

/// Checks the tokens of an expression in sequence; VTK's parser accepts more than allowed.
class Reader
{
public:
  explicit Reader(const std::string& text)
    : Text(text)
  {
  }

  Status FindFault()
  {
    Status status;
    if (this->Text.find_first_not_of(" \t\r\n") == std::string::npos)
    {
      // VTK's parser would crash
      status = Status::Error("it is blank; write for example 0.001 * sin(t), or leave it empty");
    }
    while (status.IsOk() && this->Position < this->Text.size())
    {
      const char c = this->Text[this->Position];
      if (std::isspace(static_cast<unsigned char>(c)))
      {
        ++this->Position;
      }
      else if (std::isdigit(static_cast<unsigned char>(c)) || c == '.')
      {
        status = this->ReadNumber();
      }
      else if (std::isalpha(static_cast<unsigned char>(c)))
      {
        status = this->ReadName();
      }
      else
      {
        status = this->ReadSign(c);
      }
    }
    if (status.IsOk() && !this->Brackets.empty())
    {
      status = Status::Error("a bracket is not closed; add )" + this->At(this->Position));
    }
    return status;
  }

private:
  const std::string& Text;
  std::size_t Position = 0;
  bool IsAfterAtan2 = false;
  std::vector<int> Brackets; // the commas that each may still contain

  std::string At(std::size_t position) const
  {
    return " (character " + std::to_string(position + 1) + ")";
  }

  Status ReadNumber()
  {
    double value = 0.0;
    const char* begin = this->Text.data() + this->Position;
    const char* all = this->Text.data() + this->Text.size();
    const auto [end, status] = std::from_chars(begin, all, value);
    const std::size_t start = this->Position;
    this->Position += static_cast<std::size_t>(end - begin);
    return status == std::errc() && std::isfinite(value)
      ? Status()
      : Status::Error("a number is not valid; write it like 0.001" + this->At(start));
  }

  Status ReadName()
  {
    const std::size_t start = this->Position;
    while (this->Position < this->Text.size() &&
      std::isalnum(static_cast<unsigned char>(this->Text[this->Position])))
    {
      ++this->Position;
    }
    const std::string name = this->Text.substr(start, this->Position - start);
    this->IsAfterAtan2 = name == "atan2";
    const std::size_t next = this->Text.find_first_not_of(" \t\r\n", this->Position);
    const bool isCalled = next != std::string::npos && this->Text[next] == '(';
    if (Functions.count(name) > 0)
    {
      return isCalled
        ? Status()
        : Status::Error(name + " has no argument; write " + name + "(t)" + this->At(start));
    }
    if (Variables.count(name) > 0)
    {
      return isCalled
        ? Status::Error(name + " is not a function; write an operator after it" + this->At(start))
        : Status();
    }
    return Status::Error(name +
      " is not known; use t or THETA, pi, e, exp, ln, sqrt, abs, cos, sin, tan, acos, asin, atan, "
      "cosh, sinh, tanh, atan2" +
      this->At(start));
  }

  Status ReadSign(char c)
  {
    const std::size_t start = this->Position++;
    if (c == '(' && this->Brackets.size() == Expression::DeepestBracket)
    {
      return Status::Error("more than " + std::to_string(Expression::DeepestBracket) +
        " nested brackets; use fewer" + this->At(start));
    }
    if (c == '(')
    {
      this->Brackets.push_back(this->IsAfterAtan2 ? 1 : 0);
      this->IsAfterAtan2 = false;
      return {};
    }
    if (c == ')' && !this->Brackets.empty())
    {
      const int commas = this->Brackets.back();
      this->Brackets.pop_back();
      return commas == 0 ? Status()
                         : Status::Error("atan2 has one argument; give two" + this->At(start));
    }
    if (c == ',' && !this->Brackets.empty() && this->Brackets.back() > 0)
    {
      --this->Brackets.back();
      return {};
    }
    if (c == ',')
    {
      return Status::Error(
        "a comma outside atan2(a, b); write decimals with a point" + this->At(start));
    }
    return std::string("+-*/^").find(c) != std::string::npos
      ? Status()
      : Status::Error(std::string("'") + c + "' is not expected; remove it" + this->At(start));
  }
};

/// Returns the error of VTK's parser for a text, without its source location.
Status Parse(const std::string& text)
{
  std::string message;
  vtkNew<vtkCallbackCommand> listener;
  listener->SetClientData(&message);
  listener->SetCallback(
    [](vtkObject*, unsigned long, void* client, void* data)
    {
      auto& log = *static_cast<std::string*>(client);
      const char* report = static_cast<const char*>(data);
      log = log.empty() && report ? report : log;
    });
  const Parser parser = MakeParser(text);
  parser->AddObserver(vtkCommand::ErrorEvent, listener);
  if (parser->IsScalarResult() && message.empty())
  {
    return {};
  }
  const std::size_t from = message.find(" - ");
  const std::size_t to = message.find("\tExpression");
  const std::string core =
    from == std::string::npos ? "it has no value" : message.substr(from + 3, to - from - 3);
  return Status::Error(core + "; write a term between operators, such as 0.001 * sin(t)");
}

/// Returns an error if an expression has no valid value: neither for any angle nor for any range.
Status FindUsableValue(const std::string& text)
{
  constexpr int steps = 90;
  Expression expression(text);
  for (int i = -steps; i <= steps; ++i)
  {
    const double angle = vtkMath::Pi() * i / steps;
    const double range = std::pow(10.0, 6.0 * std::abs(i) / steps); // up to 1000 km
    if (IsUsableTerm(expression.Evaluate(angle)) || IsUsableTerm(expression.Evaluate(range)))
    {
      return {};
    }
  }
  return Status::Error(
    "its value is never finite and within 1e9, neither for an angle nor for a range; correct "
    "it");
}

} // namespace

//------------------------------------------------------------------------------
Status Expression::FindFault(const std::string& text)
{
  if (text.empty())
  {
    return {};
  }
  if (text.size() > LongestText)
  {
    return Status::Error("it has " + std::to_string(text.size()) + " characters, and at most " +
      std::to_string(LongestText) + " are allowed; write a shorter one");
  }
  Status status = Reader(text).FindFault();
  status = status.IsOk() ? Parse(text) : status;
  return status.IsOk() ? FindUsableValue(text) : status;
}

//------------------------------------------------------------------------------
std::string Expression::Shorten(const std::string& text)
{
  constexpr std::size_t longestShown = 200;
  return text.size() <= longestShown ? text : text.substr(0, longestShown) + "...";
}

//------------------------------------------------------------------------------
Expression::Expression(const std::string& text)
  : Text(text)
{
}

//------------------------------------------------------------------------------
double Expression::Evaluate(double variable)
{
  const Parser parser = this->AcquireParser();
  parser->SetScalarVariableValue(0, variable);
  parser->SetScalarVariableValue(1, variable);
  const double value = parser->GetScalarResult();
  this->ReturnParser(parser);
  return value;
}

//------------------------------------------------------------------------------
Expression::Parser Expression::AcquireParser()
{
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    if (!this->Idle.empty())
    {
      Parser parser = std::move(this->Idle.back());
      this->Idle.pop_back();
      return parser;
    }
  }
  return MakeParser(this->Text);
}

//------------------------------------------------------------------------------
void Expression::ReturnParser(Parser parser)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->Idle.push_back(std::move(parser));
}

} // namespace helios
