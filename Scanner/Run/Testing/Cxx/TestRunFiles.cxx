// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosRunFiles.h"

#include <catch2/catch.hpp>

#include <string>

using Files = vtkHeliosRunFiles;

TEST_CASE("RunFiles: names of files, by stem, kind, format and channel", "[RunFiles]")
{
  CHECK(Files::GetLegStem(0) == "leg000");
  CHECK(Files::GetLegStem(12345) == "leg12345");
  CHECK(Files::GetStripStem("A") == "strip00A");
  CHECK(Files::GetFileName("leg007", Files::POINTS, "xyz") == "leg007_points.xyz");
  CHECK(Files::GetFileName("leg007", Files::POINTS, "las", "2") == "leg007_points_dev2.las");
  CHECK(Files::GetFileName("leg007", Files::POINTS, "laz") == "leg007_points.laz");
  CHECK(Files::GetFileName("leg007", Files::POINTS, "copc") == "leg007_points.copc.laz");
  CHECK(Files::GetFileName("leg007", Files::WAVEFORMS, "copc", "1") == "leg007_fullwave_dev1.laz");
  CHECK((Files::IsLas("las") && Files::IsLas("laz") && Files::IsLas("copc")));
  CHECK((Files::IsCompressed("laz") && Files::IsCompressed("copc")));
  CHECK_FALSE((Files::IsLas("vtp") || Files::IsCompressed("las")));
  CHECK(Files::GetFileName("leg007", Files::POINTS, "vtp") == "leg007_points.pvtp");
  CHECK(Files::GetFileName("leg007", Files::WAVEFORMS, "las") == "leg007_fullwave.las");
  CHECK(Files::GetFileName("leg007", Files::WAVEFORMS, "vtp") == "leg007_fullwave.pvtt");
  CHECK(Files::GetFileName("leg007", Files::PULSES, "xyz") == "leg007_pulse.txt");
  CHECK(Files::GetFileName("leg007", Files::HITS, "xyz") == "leg007_hits.pvtp");
  CHECK(Files::GetFileName("leg007", Files::TRAJECTORY, "vtp") == "leg007_trajectory.pvtp");
  CHECK(Files::GetFileName("leg007", 5, "xyz").empty());
  CHECK(Files::GetFileName("leg007", -1, "xyz").empty());
  CHECK(Files::GetFileName("leg007", Files::POINTS, "doc").empty());
  CHECK(Files::GetBeside("leg007_points_dev1.las", Files::TRAJECTORY, "las") ==
    "leg007_trajectory.txt");
  CHECK(Files::GetBeside("roof_points.ply", Files::WAVEFORMS, "vtp") == "roof_fullwave.pvtt");
  CHECK(Files::GetBeside("roof.ply", Files::WAVEFORMS, "vtp").empty());
}

TEST_CASE("RunFiles: every name is taken apart again", "[RunFiles]")
{
  REQUIRE(Files::GetNumberOfFormats() == 5);
  CHECK(Files::GetFormat(5) == nullptr);
  CHECK(Files::GetFormat(-1) == nullptr);
  int count = 0;
  for (const char* stem : { "leg000", "leg1234", "strip042", "stripeast_pulse", "strip_dev" })
  {
    for (int kind = Files::POINTS; kind <= Files::TRAJECTORY; ++kind)
    {
      for (int format = 0; format < 4; ++format)
      {
        for (const char* channel : { "", "12" })
        {
          const std::string name =
            Files::GetFileName(stem, kind, Files::GetFormat(format), channel);
          INFO(name);
          CHECK(Files::GetStem(name) == stem);
          CHECK(Files::GetKind(name) == kind);
          CHECK(Files::IsOfLeg(name));
          CHECK(Files::IsOfLeg(name + ".part"));
          CHECK(Files::GetKind(name + ".part") == -1);
          ++count;
        }
      }
    }
  }
  CHECK(count == 200);
  CHECK(Files::GetNumber("leg012_points.xyz") == 12);
  CHECK(Files::GetNumber("strip042_trajectory.txt") == 42);
  CHECK(Files::GetNumber("stripeast_points.xyz") == -1);
  CHECK(Files::GetNumber("leg99999999999_points.xyz") == -1);
  CHECK(Files::GetKind("leg012_points.laz") == Files::POINTS);
  CHECK(Files::GetKind("leg012_points_dev2.copc.laz") == Files::POINTS);
}

TEST_CASE("RunFiles: other names are not those of a run", "[RunFiles]")
{
  for (const char* name : { "", "leg", "leg_points.xyz", "leg12_points.xyz", "leg0a2_points.xyz",
         "points.xyz", "_points.xyz", "stripA_points.xyz", "myleg000_points.xyz", "leg000.xyz" })
  {
    INFO(name);
    CHECK_FALSE(Files::IsOfLeg(name));
    CHECK(Files::GetKind(name) == -1);
    CHECK(Files::GetStem(name).empty());
    CHECK(Files::GetNumber(name) == -1);
  }
  // files of a leg, but not complete, or a part of another file
  for (const char* name : { "leg000_points.wdp", "leg000_points_0.vtp", "leg000_points",
         "leg000_points_dev1", "leg000_trajectory.xyz" })
  {
    INFO(name);
    CHECK(Files::IsOfLeg(name));
    CHECK(Files::GetKind(name) == -1);
  }
}

TEST_CASE("RunFiles: folders of epochs, journal and summary", "[RunFiles]")
{
  CHECK(Files::GetEpochName(0) == "epoch000");
  CHECK(Files::GetEpochName(1000) == "epoch1000");
  CHECK(Files::GetPartName(2, 4) == "part002of004");
  CHECK(Files::GetPartName(12, 1000) == "part012of1000");
  CHECK_FALSE(Files::IsOfLeg(Files::GetPartName(2, 4)));
  CHECK(Files::GetEpoch("epoch007") == 7);
  CHECK(Files::GetEpoch("play007") == 7); // earlier versions wrote it
  for (const char* name :
    { "", "epoch", "epoch7", "epoch-07", "epoch0007", "epochs007", "epoch007x", "play7" })
  {
    INFO(name);
    CHECK(Files::GetEpoch(name) == -1);
  }
  CHECK(Files::GetSummaryName() == std::string("run_summary.json"));
  CHECK(Files::GetJournalName() == std::string("run.journal"));
}
