// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Zones of multiple-time-around ranges in the dialect.
#include "heliosReceiverSetup.h"

#include "heliosSurveyFiles.h"
#include "vtkHeliosRunOptions.h"
#include "vtkHeliosScanner.h"

#include <vtkNew.h>

#include <catch2/catch.hpp>

#include <string>

using namespace helios::test;

namespace
{

/// A survey on a tripod whose scanner has these attributes.
Reading Read(const Files& files, const std::string& attributes)
{
  files.Replace("assets.xml", "optics=\"rotating\"", "optics=\"rotating\" " + attributes);
  return Reading(files, Tripod, OneLeg);
}

} // namespace

TEST_CASE("SurveyZones: a scanner takes echoes for a zone", "[SurveyZones]")
{
  for (const int zone : { 0, 1, 2 })
  {
    Files files;
    const Reading reading =
      Read(files, zone == 0 ? "" : "mtaZone=\"" + std::to_string(zone) + "\"");
    INFO(reading.Log->Errors << reading.Log->Warnings);
    REQUIRE(reading.Good);
    vtkNew<vtkHeliosScanner> scanner;
    helios::SetUpReceiver(reading.Data().Scanners.at(0), helios::RunOptions(), scanner);
    CHECK(scanner->GetMTAZone() == zone);
  }
}

TEST_CASE("SurveyZones: a zone below 0 is an error", "[SurveyZones]")
{
  Files files;
  const Reading reading = Read(files, "mtaZone=\"-1\"");
  INFO(reading.Log->Errors);
  CHECK_FALSE(reading.Good);
  CHECK(reading.Log->HasError("mtaZone=\"-1\""));
}
