// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Swapped parts: the scene of each epoch, and the output of the epochs of a survey.
#include "vtkHeliosRunOptions.h"
#include "vtkHeliosSurveyPlayer.h"

#include "heliosEpochs.h"
#include "heliosFormerRun.h"
#include "heliosSurveyPlaying.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <vector>

namespace fs = std::filesystem;
using namespace helios::test;

namespace
{

const std::string Lid =
  R"(<filter type="objloader"><param key="filepath" value="lid.obj"/></filter>)";

std::string Move(double z)
{
  return R"(<filter type="translate"><param key="offset" value="0;0;)" + std::to_string(z) +
    R"("/></filter>)";
}

std::string Swap(const std::string& filters, const std::string& attributes = "")
{
  return "<swap " + attributes + ">" + filters + "</swap>\n";
}

/// A scene of a floor, at z = 0, and of more parts; lid.obj is above it, at z = 1.
void WriteScene(const Files& files, const std::string& parts, const std::string& floor = "")
{
  files.Write("lid.obj", "v -90 -90 1\nv 90 -90 1\nv 90 90 1\nv -90 90 1\nf 1 2 3 4\n");
  files.Write("scene.xml",
    "<document><scene id=\"s\">\n<part id=\"floor\"><filter type=\"objloader\">"
    "<param key=\"filepath\" value=\"plane.obj\"/></filter>\n" +
      floor + "</part>\n" + parts + "</scene></document>");
}

std::string Part(const std::string& inside)
{
  return "<part id=\"lid\">" + inside + "</part>";
}

/// The mean height of the points of an epoch; the swapped surface is horizontal.
double FindHeight(const std::string& folder)
{
  const std::vector<Point> points = ReadPoints(folder + "/leg000_points.xyz");
  INFO(folder);
  REQUIRE(points.size() > 10000);
  double sum = 0.0;
  for (const Point& point : points)
  {
    sum += point.Z;
  }
  return sum / static_cast<double>(points.size());
}

/// Four epochs: the lid at 5 m, at 8 m twice, and removed.
const std::string FourEpochs =
  Part(Lid + Move(4.0) + Swap(Move(7.0), "swapStep=\"2\"") + Swap("", "force_null=\"true\""));

} // namespace

TEST_CASE("Epochs: the state of a part in each epoch", "[SurveyEpochs]")
{
  helios::PartData part;
  part.Swaps.resize(3);
  part.Swaps[0].Epochs = 2;
  part.Swaps[1].IsRemoved = true;
  CHECK(helios::FindPart(part, 0) == &part);
  CHECK(helios::FindPart(part, 1) == &part.Swaps[0].Part);
  CHECK(helios::FindPart(part, 2) == &part.Swaps[0].Part);
  CHECK(helios::FindPart(part, 3) == nullptr);
  CHECK(helios::FindPart(part, 4) == &part.Swaps[2].Part);
  CHECK(helios::FindPart(part, 9) == &part.Swaps[2].Part); // the last swap remains
  CHECK(helios::FindPart(helios::PartData(), 3) != nullptr);
}

TEST_CASE("Epochs: the survey of an epoch", "[SurveyEpochs]")
{
  helios::SurveyData survey;
  survey.Name = "test";
  survey.Scene.Parts.resize(2);
  CHECK(helios::CountEpochs(survey.Scene) == 1);
  helios::PartData& first = survey.Scene.Parts[0];
  helios::PartData& second = survey.Scene.Parts[1];
  first.Name = "0";
  first.Swaps.resize(1);
  first.Swaps[0].IsRemoved = true;
  second.Name = "1";
  second.Swaps.resize(2);
  second.Swaps[0].Epochs = 3;
  second.Swaps[1].Part.Scale = 2.0;
  CHECK(helios::CountEpochs(survey.Scene) == 5); // the part with the longest total

  CHECK(helios::MakeEpoch(survey, 0).Scene.Parts.size() == 2);
  const helios::SurveyData last = helios::MakeEpoch(survey, 4);
  CHECK(last.Name == "test");
  REQUIRE(last.Scene.Parts.size() == 1); // the first part remains removed
  CHECK(last.Scene.Parts[0].Name == "1");
  CHECK(last.Scene.Parts[0].Scale == 2.0);
  CHECK(last.Scene.Parts[0].Swaps.empty());
  CHECK(helios::CountEpochs(last.Scene) == 1);
}

TEST_CASE("Epochs: filters start from the part as loaded", "[SurveyEpochs]")
{
  const Files files;
  WriteScene(files,
    Part(Lid +
      R"(<filter type="repair"/><filter type="scale"><param key="scale" value="3"/></filter>
<filter type="rotate"><param key="rotation" type="rotation"><rot axis="z" angle_deg="90"/></param></filter>
<filter type="translate"><param key="offset" value="1;2;3"/><param key="onGround" value="1"/></filter>)" +
      Swap(Move(7.0), "swapStep=\"2\" keepCRS=\"true\"") +
      Swap(R"(<filter type="geotiffloader"><param key="filepath" value="plane.obj"/></filter>)" +
        Move(1.0)) +
      Swap(R"(<filter type="scale"><param key="scale" value="2"/></filter>)")));
  const Reading reading(files, Flight, ThreeLegs);
  INFO(reading.Log->Errors);
  REQUIRE(reading.Good);
  CHECK(reading.Log->Warnings.empty());
  CHECK(reading.Reader->GetSurvey()->GetNumberOfEpochs() == 5);
  const std::vector<helios::SwapData>& swaps = reading.Data().Scene.Parts.at(1).Swaps;
  REQUIRE(swaps.size() == 3);

  const helios::PartData& moved = swaps[0].Part;
  CHECK(swaps[0].Epochs == 2);
  CHECK(moved.Where == (files / "scene.xml") + ":6");
  CHECK(moved.Files == std::vector<std::string>{ files / "lid.obj" });
  CHECK(moved.Repair); // a property of the mesh, not of its pose
  CHECK(moved.Translation[0] == 0.0);
  CHECK(moved.Translation[2] == 7.0);
  CHECK(moved.Scale == 1.0);
  CHECK(moved.Rotation.GetW() == 1.0);
  CHECK_FALSE(moved.OnGround);

  const helios::PartData& other = swaps[1].Part; // nothing of the part remains
  CHECK(other.Type == helios::Loader::GeoTiff);
  CHECK(other.Files == std::vector<std::string>{ files / "plane.obj" });
  CHECK_FALSE(other.Repair);
  CHECK(other.Translation[2] == 1.0);

  const helios::PartData& last = swaps[2].Part; // based on the part, not on the swap before
  CHECK(last.Files == std::vector<std::string>{ files / "lid.obj" });
  CHECK(last.Scale == 2.0);
  CHECK(last.Translation[2] == 0.0);
}

TEST_CASE("Epochs: bad swaps are errors", "[SurveyEpochs]")
{
  struct Wrong
  {
    std::string Parts;
    std::string Message;
  };
  const std::vector<Wrong> cases = {
    { Part(Lid + Swap(Move(1), "swapStep=\"0\"")),
      "scene.xml:4: swapStep=\"0\" is out of range; give a number from 1 to 9999 [epochs]" },
    { Part(Lid + Swap(Move(1), "swapStep=\"1.5\"")), "swapStep=\"1.5\"" },
    { Part(Lid + Swap(Move(1), "force_null=\"perhaps\"")), "force_null=\"perhaps\"" },
    { Part(Lid + Swap("")), "scene.xml:4: <swap> has no filter; add a loader" },
    { Part(Lid + Swap(Move(1) + "\n" + Lid)),
      "scene.xml:5: filter objloader comes after other filters of a <swap>" },
    { Part(Lid + Swap(Lid + Lid)), "a second loader in one <swap>; remove one" },
    { Part(Lid + Swap(R"(<filter type="objloader"/>)")), "filter objloader has no filepath" },
    { Part(Lid + Swap(R"(<filter type="mover"/>)")), "filter type=\"mover\" is unknown" },
    { "<part><filter type=\"objloader\"><param key=\"efilepath\" value=\".*obj\"/></filter>" +
        Swap(Move(1)) + "</part>",
      "scene.xml:4: <swap> needs one part, but this <part> has several files and no id" },
  };
  for (const Wrong& wrong : cases)
  {
    const Files files;
    WriteScene(files, wrong.Parts);
    const Reading reading(files, Flight, ThreeLegs);
    INFO(wrong.Parts << "\n" << reading.Log->Errors);
    CHECK_FALSE(reading.Good);
    CHECK(reading.Log->HasError(wrong.Message));
  }
}

TEST_CASE("Epochs: an epoch without parts is an error", "[SurveyEpochs]")
{
  const Files files;
  const std::string away = Swap("", "force_null=\"true\"");
  WriteScene(files, Part(Lid + Swap(Move(1)) + away), away);
  const Reading reading(files, Flight, ThreeLegs);
  INFO(reading.Log->Errors);
  CHECK_FALSE(reading.Good);
  CHECK(reading.Log->HasError("scene.xml:1: scene s has no part in epoch 2"));
}

TEST_CASE("Epochs: unused attributes of swaps are reported", "[SurveyEpochs]")
{
  const Files files;
  WriteScene(files,
    Part(Lid + Swap(Move(1), "keepCRS=\"false\" swapIndices=\"[1,2]\"") +
      Swap(Move(1) + Move(2), "force_null=\"true\"")));
  const Reading reading(files, Flight, ThreeLegs);
  INFO(reading.Log->Errors << reading.Log->Warnings);
  CHECK(reading.Good);
  CHECK(reading.Log->HasWarning("scene.xml:4: keepCRS=\"false\" is not used"));
  CHECK(reading.Log->HasWarning("swapIndices"));
  CHECK(reading.Log->HasWarning("scene.xml:5: force_null=\"true\" removes the part"));
  CHECK(reading.Log->HasWarning("replaces the one before it in this <swap>"));
}

TEST_CASE("Epochs: points of each epoch lie on its geometry", "[SurveyEpochs]")
{
  const Files files;
  WriteScene(files, FourEpochs);
  const Reading reading(files, Flight, ThreeLegs);
  INFO(reading.Log->Errors);
  REQUIRE(reading.Good);
  const double heights[] = { 5.0, 8.0, 8.0, 0.0 };
  for (int epoch = 0; epoch < 4; ++epoch)
  {
    Playing playing(files, reading);
    playing.Player->GetOptions()->SetEpoch(epoch);
    const std::string folder = files / ("out/test/epoch00" + std::to_string(epoch));
    CHECK(playing.Player->GetRunFolder() == folder);
    CHECK(playing.Player->Run());
    INFO(playing.Log->Errors);
    CHECK(playing.Player->GetReport().find("\"epoch\" : " + std::to_string(epoch)) !=
      std::string::npos);
    CHECK(FindHeight(folder) == Approx(heights[epoch]).margin(1e-6));
  }
  CHECK(ReadText(files / "out/test/epoch001/leg001_points.xyz") ==
    ReadText(files / "out/test/epoch002/leg001_points.xyz"));
  const std::string summary = ReadText(files / "out/test/epoch003/run_summary.json");
  CHECK(summary.find("lid.obj") == std::string::npos); // not read in this epoch
  CHECK_FALSE(fs::exists(files / "out/test/leg000_points.xyz"));
}

TEST_CASE("Epochs: one player reads only what an epoch changes", "[SurveyEpochs]")
{
  const Files files;
  files.Write("roof.obj", "v -90 -90 9\nv 90 -90 9\nv 90 90 9\nv -90 90 9\nf 1 2 3 4\n");
  const std::string roof =
    R"(<filter type="objloader"><param key="filepath" value="roof.obj"/></filter>)";
  WriteScene(files, Part(Lid + Move(4.0) + Swap(Move(7.0)) + Swap(roof)));
  const Reading reading(files, Flight, ThreeLegs);
  REQUIRE(reading.Good);
  Playing playing(files, reading);
  std::vector<std::string> read;
  const auto note = [](vtkObject* caller, unsigned long, void* list, void*)
  {
    const std::string step = static_cast<vtkHeliosSurveyPlayer*>(caller)->GetMessage();
    if (step.rfind("reading ", 0) == 0)
    {
      static_cast<std::vector<std::string>*>(list)->push_back(fs::path(step).filename());
    }
  };
  vtkNew<vtkCallbackCommand> onStep;
  onStep->SetCallback(note);
  onStep->SetClientData(&read);
  playing.Player->AddObserver(vtkCommand::ProgressEvent, onStep);
  const double heights[] = { 5.0, 8.0, 9.0 };
  const std::vector<std::string> expected[] = { { "plane.obj", "lid.obj" }, {}, { "roof.obj" } };
  for (int epoch = 0; epoch < 3; ++epoch)
  {
    read.clear();
    playing.Player->GetOptions()->SetEpoch(epoch);
    REQUIRE(playing.Player->Run());
    CHECK(read == expected[epoch]);
    const std::string folder = files / ("out/test/epoch00" + std::to_string(epoch));
    CHECK(FindHeight(folder) == Approx(heights[epoch]).margin(1e-6));
  }
  read.clear();
  files.Write("roof.obj", "v -90 -90 7\nv 90 -90 7\nv 90 90 7\nv -90 90 7\nf 1 2 3 4\n");
  playing.Player->OverwriteOn();
  REQUIRE(playing.Player->Run());
  CHECK(FindHeight(files / "out/test/epoch002") == Approx(7.0)); // a changed file is read again
}

TEST_CASE("Epochs: equal geometry has equal noise", "[SurveyEpochs]")
{
  const Files files;
  files.Replace("assets.xml", "optics=\"conic\"", "optics=\"conic\" accuracy_m=\"0.02\"");
  WriteScene(files, Part(Lid + Swap(Lid)));
  const Reading reading(files, Flight, ThreeLegs);
  REQUIRE(reading.Good);
  for (int epoch = 0; epoch < 2; ++epoch)
  {
    Playing playing(files, reading);
    playing.Player->GetOptions()->SetEpoch(epoch);
    REQUIRE(playing.Player->Run());
  }
  const std::string first = ReadText(files / "out/test/epoch000/leg000_points.xyz");
  CHECK(first.size() > 100000);
  CHECK(first == ReadText(files / "out/test/epoch001/leg000_points.xyz"));
}

TEST_CASE("Epochs: an epoch that does not exist", "[SurveyEpochs]")
{
  const Files files;
  SECTION("of several")
  {
    WriteScene(files, FourEpochs);
    const Reading reading(files, Flight, ThreeLegs);
    Playing playing(files, reading);
    playing.Player->GetOptions()->SetEpoch(4);
    playing.CheckFails({ "Epoch is 4, but the survey has 4 epochs; give 0 to 3" });
    CHECK_FALSE(playing.Player->Estimate());
  }
  SECTION("of one")
  {
    const Reading reading(files, Flight, ThreeLegs);
    Playing playing(files, reading);
    CHECK(playing.Player->GetRunFolder() == files / "out/test"); // no folders of epochs
    playing.Player->GetOptions()->SetEpoch(1);
    playing.CheckFails({ "Epoch is 1, but the survey has 1 epoch; give 0 to 0" });
  }
  CHECK_FALSE(fs::exists(files / "out"));
}

namespace
{

/// Stops a run after some pulses.
void BreakOff(vtkHeliosSurveyPlayer* player)
{
  const auto abort = [](vtkObject* caller, unsigned long, void*, void*)
  {
    auto* self = static_cast<vtkHeliosSurveyPlayer*>(caller);
    if (self->GetCount("pulses") >= 50000)
    {
      self->Abort();
    }
  };
  vtkNew<vtkCallbackCommand> onBlock;
  onBlock->SetCallback(abort);
  player->AddObserver(vtkCommand::ProgressEvent, onBlock);
  CHECK_FALSE(player->Run());
}

} // namespace

TEST_CASE("Epochs: each epoch is resumed separately", "[SurveyEpochs]")
{
  const Files files;
  WriteScene(files, FourEpochs);
  const Reading reading(files, Flight, ThreeLegs);
  REQUIRE(reading.Good);
  const auto resume = [&](int epoch, const std::string& expected)
  {
    Playing playing(files, reading);
    playing.Player->SetPulsesPerBlock(10000);
    playing.Player->GetOptions()->SetEpoch(epoch);
    playing.Player->SetResume(true);
    const bool good = playing.Player->Run();
    INFO(epoch << ": " << playing.Player->GetMessage());
    CHECK(good == expected.empty());
    CHECK(playing.Log->HasError(expected));
    return playing.Player->GetWasFinished();
  };
  resume(0, "nothing to resume"); // the first one needs an earlier run
  for (int epoch = 0; epoch < 2; ++epoch)
  {
    Playing playing(files, reading);
    playing.Player->SetPulsesPerBlock(10000);
    playing.Player->GetOptions()->SetEpoch(epoch);
    if (epoch == 0)
    {
      CHECK(playing.Player->Run());
    }
    else
    {
      BreakOff(playing.Player);
    }
  }
  REQUIRE(fs::exists(files / "out/test/epoch001/run.journal"));
  SECTION("equal to an uninterrupted run")
  {
    CHECK(resume(0, ""));       // was finished
    CHECK_FALSE(resume(1, "")); // resumed
    CHECK_FALSE(resume(2, "")); // started
    for (const char* name : { "leg000_points.xyz", "leg001_points.xyz", "leg001_trajectory.txt" })
    {
      CHECK(ReadText((files / "out/test/epoch001/") + name) ==
        ReadText((files / "out/test/epoch002/") + name));
    }
    CHECK(FindHeight(files / "out/test/epoch001") == Approx(8.0).margin(1e-6));
  }
  SECTION("in the folder of an earlier version")
  {
    fs::rename(files / "out/test/epoch001", files / "out/test/play001");
    MakeFormer(files / "out/test/play001");
    CHECK_FALSE(resume(1, ""));
    CHECK_FALSE(resume(2, ""));
    CHECK_FALSE(fs::exists(files / "out/test/epoch001"));
    CHECK(ReadText(files / "out/test/play001/leg000_points.xyz") ==
      ReadText(files / "out/test/epoch002/leg000_points.xyz"));
    CHECK(ReadText(files / "out/test/play001/run_summary.json").find("\"epoch\" : 1") !=
      std::string::npos);
  }
  SECTION("unless its files have changed")
  {
    files.Replace("lid.obj", "90 90 1", "80 80 1");
    resume(1, "lid.obj has changed");
  }
}
