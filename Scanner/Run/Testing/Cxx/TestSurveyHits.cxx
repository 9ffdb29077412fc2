// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The hits of sub-rays that a run writes.
#include "heliosBrokenRun.h"
#include "heliosSurveyPlaying.h"
#include "vtkHeliosPointXMLReader.h"
#include "vtkHeliosSurveyPlayer.h"
#include "vtkHeliosSurveySource.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <catch2/catch.hpp>

#include <filesystem>
#include <string>

using namespace helios::test;

TEST_CASE("SurveyHits: they are those of the scanner, in any format", "[SurveyHits]")
{
  const Files files;
  const Reading reading(files, Flight, ThreeLegs);
  Playing playing(files, reading);
  const std::string format = GENERATE("xyz", "las", "vtp");
  playing.Player->SetFormat(format.c_str());
  playing.Player->SetWriteHits(true);
  playing.Player->SetPulsesPerBlock(1000);
  REQUIRE(playing.Player->Run());
  vtkNew<vtkHeliosPointXMLReader> file;
  file->SetFileName((files / "out/test/leg000_hits.pvtp").c_str());
  file->Update();
  vtkPolyData* hits = file->GetOutput();

  vtkNew<vtkHeliosSurveySource> source;
  source->SetSurvey(reading.Reader->GetSurvey());
  source->GenerateSubRaysOn();
  source->SetPulseWindow(0, 40000); // leg 0
  source->Update();
  auto* wanted = vtkPolyData::SafeDownCast(source->GetOutputDataObject(3));
  REQUIRE(wanted->GetNumberOfPoints() >= 40000);
  REQUIRE(hits->GetNumberOfPoints() == wanted->GetNumberOfPoints());
  for (const char* name : { "PulseIds", "Weight", "Range", "CellIds", "IncidenceAngle" })
  {
    INFO(name);
    vtkDataArray* column = hits->GetPointData()->GetArray(name);
    vtkDataArray* other = wanted->GetPointData()->GetArray(name);
    REQUIRE((column && other));
    bool isSame = true;
    for (vtkIdType i = 0; i < column->GetNumberOfTuples(); ++i)
    {
      isSame = isSame && column->GetTuple1(i) == other->GetTuple1(i);
    }
    CHECK(isSame);
  }
}

TEST_CASE("SurveyHits: a file per block, also beside text and LAS", "[SurveyHits]")
{
  const Files files;
  const Reading reading(files, Flight, ThreeLegs);
  Playing playing(files, reading);
  const std::string format = GENERATE("xyz", "las", "vtp");
  playing.Player->SetFormat(format.c_str());
  playing.Player->SetWriteHits(true);
  playing.Player->SetPulsesPerBlock(35000); // less than 40000
  REQUIRE(playing.Player->Run());
  CHECK(std::filesystem::exists(files / "out/test/leg000_hits_0001.vtp"));
  CHECK_FALSE(std::filesystem::exists(files / "out/test/leg000_hits_0002.vtp"));
}

TEST_CASE(
  "SurveyHits: a resumed run is byte-identical, and must ask for them again", "[SurveyHits]")
{
  const Files files;
  const Reading reading(files, Flight, ThreeLegs);
  BlockRun whole(files, reading, "whole");
  whole.Player->SetWriteHits(true);
  REQUIRE(whole.Player->Run());
  BlockRun broken(files, reading);
  broken.Player->SetWriteHits(true);
  broken.AbortAfter(50000);
  REQUIRE_FALSE(broken.Player->Run());
  broken.Player->SetResume(true);
  broken.Blocks->Action = [](vtkHeliosSurveyPlayer*) {};
  SECTION("without")
  {
    broken.Player->SetWriteHits(false);
    broken.CheckFails({ "hits was true and is not given", "use the same inputs and options" });
  }
  SECTION("with")
  {
    REQUIRE(broken.Player->Run());
    const auto expected = ReadAll(files / "whole/test");
    CHECK(expected.count("leg001_hits.pvtp") == 1);
    CHECK((expected == ReadAll(files / "out/test"))); // too long to print
  }
}
