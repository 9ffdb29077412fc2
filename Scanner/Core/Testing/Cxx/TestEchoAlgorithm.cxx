// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosEchoAlgorithm.h"
#include "vtkHeliosScanner.h"

#include <vtkNew.h>

#include <catch2/catch.hpp>

#include <set>
#include <sstream>
#include <string>

using Outputs = vtkHeliosEchoAlgorithm::Outputs;

TEST_CASE("EchoAlgorithm: every output has a row of its own", "[EchoAlgorithm]")
{
  std::set<std::string> names;
  std::set<const bool*> flags;
  const Outputs outputs;
  for (const auto& row : vtkHeliosEchoAlgorithm::GetOutputRows())
  {
    names.insert(row.Name);
    flags.insert(&(outputs.*row.Flag));
    CHECK_FALSE(outputs.*row.Flag); // off by default
    CHECK(std::string(row.Help) != "");
  }
  const auto count = static_cast<std::size_t>(vtkHeliosEchoAlgorithm::GetNumberOfOutputs());
  CHECK(names.size() == count);
  CHECK(flags.size() == count);
  CHECK(sizeof(Outputs) == count); // no flag without a row
}

TEST_CASE("EchoAlgorithm: fields of rows are found by name", "[EchoAlgorithm]")
{
  CHECK(std::string(vtkHeliosEchoAlgorithm::GetOutputText(0, "name")) == "waveforms");
  CHECK(std::string(vtkHeliosEchoAlgorithm::GetOutputText(0, "player")) == "WriteWaveforms");
  CHECK(vtkHeliosEchoAlgorithm::GetOutputText(0, "colour") == nullptr);
  CHECK(vtkHeliosEchoAlgorithm::GetOutputText(-1, "name") == nullptr);
  CHECK(vtkHeliosEchoAlgorithm::GetOutputText(
          vtkHeliosEchoAlgorithm::GetNumberOfOutputs(), "name") == nullptr);
}

TEST_CASE("EchoAlgorithm: outputs are set one by one, or all", "[EchoAlgorithm]")
{
  vtkNew<vtkHeliosScanner> scanner;
  vtkMTimeType time = scanner->GetMTime();
  scanner->GenerateTruthOn();
  CHECK(scanner->GetMTime() > time);
  CHECK(scanner->GetWantedOutputs().Truth);
  Outputs all = scanner->GetWantedOutputs();
  time = scanner->GetMTime();
  scanner->SetWantedOutputs(all);
  CHECK(scanner->GetMTime() == time);
  for (const auto& row : vtkHeliosEchoAlgorithm::GetOutputRows())
  {
    all.*row.Flag = true;
  }
  scanner->SetWantedOutputs(all);
  CHECK(scanner->GetMTime() > time);
  CHECK(scanner->GetGenerateColors());
  std::ostringstream text;
  scanner->Print(text);
  CHECK(text.str().find("GenerateSubRays: 1\n") != std::string::npos);
  CHECK(text.str().find("SplitByChannel") == std::string::npos); // outputs of files only
}
