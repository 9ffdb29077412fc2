// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosRunOptions.h"

#include <vtkNew.h>

#include <catch2/catch.hpp>

#include <set>
#include <sstream>
#include <string>

using Options = vtkHeliosRunOptions;

TEST_CASE("RunOptions: every option has a row of its own", "[RunOptions]")
{
  vtkNew<Options> options;
  std::ostringstream text;
  options->Print(text);
  std::set<std::string> names;
  for (int i = 0; i < Options::GetNumberOfOptions(); ++i)
  {
    names.insert(Options::GetOptionText(i, "name"));
    const std::string property = Options::GetOptionText(i, "property");
    CHECK(text.str().find("  " + property + ": ") != std::string::npos);
    const std::string argument = Options::GetOptionText(i, "argument");
    CHECK(argument.empty() == Options::GetOptionText(i, "help").empty());
  }
  CHECK(names.size() == static_cast<std::size_t>(Options::GetNumberOfOptions()));
  CHECK(Options::GetOptionText(-1, "name").empty());
  CHECK(Options::GetOptionText(Options::GetNumberOfOptions(), "name").empty());
  CHECK(Options::GetOptionText(0, "colour").empty());
}

TEST_CASE("RunOptions: those that change echoes are compared", "[RunOptions]")
{
  vtkNew<Options> one;
  vtkNew<Options> other;
  one->AccuracyReportOff();
  CHECK(one->GetData() == other->GetData());
  one->SetEpoch(1);
  CHECK_FALSE(one->GetData() == other->GetData());
  one->SetEpoch(-4); // clamped
  CHECK(one->GetData() == other->GetData());
  one->SetWeather("fog 1");
  CHECK_FALSE(one->GetData() == other->GetData());
  other->SetWeather("fog 1");
  one->SetSeed(7);
  CHECK_FALSE(one->GetData() == other->GetData());
}
