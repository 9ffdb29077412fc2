// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Runs resumed with a damaged journal or damaged files.
#include "heliosBrokenRun.h"
#include "heliosFormerRun.h"

namespace fs = std::filesystem;
using namespace helios::test;

namespace
{

/// Flips a byte of a file.
void Flip(const Files& files, const std::string& name, std::size_t place)
{
  std::string bytes = ReadText(files / name);
  REQUIRE(place < bytes.size());
  bytes[place] = static_cast<char>(bytes[place] ^ 4);
  files.Write(name, bytes);
}

} // namespace

TEST_CASE("SurveyDamage: changed journal lines", "[SurveyDamage]")
{
  const Files files;
  const Reading reading(files, Flight, ThreeLegs);
  BreakOff(files, reading);
  std::vector<std::string> lines = SplitLines(ReadText(files / Journal));
  REQUIRE(lines.size() == 7); // fingerprint, 4 blocks, end of the leg, 1 block
  CHECK(Reseal(lines) == JoinLines(lines));
  BlockRun playing(files, reading);
  playing.Player->SetResume(true);
  std::string place = "(line 3, which is not the last one)";
  SECTION("deleted")
  {
    lines.erase(lines.begin() + 2);
  }
  SECTION("duplicated")
  {
    lines.insert(lines.begin() + 2, lines[1]);
  }
  SECTION("swapped")
  {
    std::swap(lines[2], lines[3]);
  }
  SECTION("a number changed")
  {
    lines[2].replace(lines[2].find("\"points\":20000"), 14, "\"points\":20001");
  }
  SECTION("the fingerprint changed")
  {
    lines[0].replace(lines[0].find("\"seed\":0"), 8, "\"seed\":1");
    place = "(line 1, which is not the last one)";
  }
  files.Write(Journal, JoinLines(lines));
  playing.CheckFails({ "run.journal has a damaged line " + place, "set Overwrite (--overwrite)" });
}

TEST_CASE("SurveyDamage: missing last lines of the journal", "[SurveyDamage]")
{
  const Files files;
  const Reading reading(files, Flight, ThreeLegs);
  BreakOff(files, reading);
  std::vector<std::string> lines = SplitLines(ReadText(files / Journal));
  lines.resize(GENERATE(1, 2, 5));
  files.Write(Journal, JoinLines(lines));
  BlockRun playing(files, reading);
  playing.Player->SetResume(true);
  CHECK(playing.Player->Run());
  BlockRun whole(files, reading, "whole");
  REQUIRE(whole.Player->Run());
  CHECK((ReadAll(files / "whole/test") == ReadAll(files / "out/test")));
}

TEST_CASE("SurveyDamage: a journal of an earlier version", "[SurveyDamage]")
{
  const Files files;
  const Reading reading(files, Flight, ThreeLegs);
  BreakOff(files, reading);
  std::vector<std::string> lines = SplitLines(ReadText(files / Journal));
  for (std::string& line : lines)
  {
    line = Unseal(line);
  }
  files.Write(Journal, JoinLines(lines));
  BlockRun playing(files, reading);
  playing.Player->SetResume(true);
  playing.CheckFails({ "run.journal was written by an earlier version of vtkHelios: it has no "
                       "checksums",
    "set Overwrite (--overwrite) to start again" });
}

TEST_CASE("SurveyDamage: invalid content of lines with a correct checksum", "[SurveyDamage]")
{
  struct Case
  {
    std::size_t Line;
    const char* From;
    const char* To;
    const char* Message;
  };
  const Case test = GENERATE(values<Case>({
    { 2, "\"blocks\":2,", "", "line 3: \"blocks\" is missing" },
    { 2, "\"blocks\":2,", "\"blocks\":2.5,", "\"blocks\" is 2.5, not a whole number" },
    { 2, "\"blocks\":2,", "\"blocks\":2.0,", "\"blocks\" is 2.0, not a whole number" },
    { 2, "\"blocks\":2,", "\"blocks\":-2,", "\"blocks\" is -2, which is negative" },
    { 2, "\"blocks\":2,", "\"blocks\":\"2\",", "\"blocks\" is \"2\", not a whole number" },
    { 2, "\"blocks\":2,", "\"blocks\":3000000000,", "\"blocks\" is 3000000000, which is too" },
    { 2, "\"blocks\":2,", "\"blocks\":3,",
      "line 3: \"leg\" 0 with \"blocks\" 3 does not follow from the lines before" },
    { 2, "\"blocks\":2,", "\"blocks\":2,\"pieces\":3000000000,",
      "\"pieces\" is 3000000000, which is too large" },
    { 2, "\"blocks\":2,", "\"blocks\":2,\"pieces\":true,",
      "\"pieces\" is true, not a whole number" },
    { 2, "\"blocks\":2,", "\"blocks\":2,\"pieces\":1,",
      "line 3: \"leg\" 0 with \"blocks\" 2 and \"pieces\" 1 does not follow from the lines "
      "before" },
    { 2, "\"done\":false,", "", "\"done\" is missing" },
    { 2, "\"done\":false", "\"done\":0", "\"done\" is 0, not true or false" },
    { 2, "\"done\":false", "\"done\":true", "does not follow from the lines before" },
    { 2, "\"leg\":0", "\"leg\":1", "\"leg\" 1 with \"blocks\" 2 does not follow" },
    { 2, "\"counts\":{", "\"counting\":{", "\"counts\" is missing" },
    { 2, "\"points\":20000,", "", "\"points\" is missing" },
    { 2, "\"points\":20000,", "\"points\":9999,", "a number of \"counts\" is smaller than in" },
    { 2, "\"points\":20000,", "\"points\":9223372036854775808,", "not a whole number" },
    { 2, "\"largestAmplitude_W\":", "\"largestAmplitude_W\":-", "not a number of at least 0" },
    { 2, "\"files\":[", "\"files\":0,\"f\":[", "\"files\" is 0, not a list" },
    { 2, "\"name\":\"leg000_points.xyz\",\"r", "\"name\":\"../points.xyz\",\"r",
      "\"name\" is \"../points.xyz\", not the name of a file" },
    { 2, "\"records\":20000,", "\"records\":1,",
      "a number of leg000_points.xyz is smaller than in a line before" },
    { 2, "\"head\":\"\",", "", "\"head\" is missing" },
    { 1, "\"begin\":0,", "\"begin\":900000000,", "\"end\" of a block of leg000" },
    { 2, "\"seconds\":", "\"second\":", "\"seconds\" is missing" },
    { 6, "\"leg\":1", "\"leg\":0", "\"leg\" 0 with \"blocks\" 1 does not follow" },
    { 2, "{", "{,", "line 3: it is not JSON" },
  }));
  const Files files;
  const Reading reading(files, Flight, ThreeLegs);
  BreakOff(files, reading);
  std::vector<std::string> lines = SplitLines(ReadText(files / Journal));
  std::string& line = lines[test.Line];
  INFO(line << "\nhas no " << test.From);
  REQUIRE(line.find(test.From) != std::string::npos);
  line.replace(line.find(test.From), std::string(test.From).size(), test.To);
  files.Write(Journal, Reseal(lines));
  BlockRun playing(files, reading);
  playing.Player->SetResume(true);
  playing.CheckFails({ "run.journal, line ", test.Message, "set Overwrite (--overwrite)" });
}

TEST_CASE("SurveyDamage: a leg that begins before the last one ends", "[SurveyDamage]")
{
  const Files files;
  const Reading reading(files, Flight, ThreeLegs);
  BreakOff(files, reading);
  std::vector<std::string> lines = SplitLines(ReadText(files / Journal));
  lines.erase(lines.begin() + 5); // the end of leg 0
  files.Write(Journal, Reseal(lines));
  BlockRun playing(files, reading);
  playing.Player->SetResume(true);
  playing.CheckFails({ "run.journal, line 6: \"leg\" 1 with \"blocks\" 1 does not follow" });
}

TEST_CASE("SurveyDamage: a leg that ends twice", "[SurveyDamage]")
{
  const Files files;
  const Reading reading(files, Flight, ThreeLegs);
  BreakOff(files, reading);
  std::vector<std::string> lines = SplitLines(ReadText(files / Journal));
  REQUIRE(lines[5].find("\"done\":true") != std::string::npos);
  lines.insert(lines.begin() + 5, lines[5]);
  files.Write(Journal, Reseal(lines));
  BlockRun playing(files, reading);
  playing.Player->SetResume(true);
  playing.CheckFails({ "run.journal, line 7: \"leg\" 0 with \"blocks\" 4 does not follow" });
}

TEST_CASE("SurveyDamage: changed bytes of files", "[SurveyDamage]")
{
  const std::string format = GENERATE("xyz", "las", "vtp");
  const std::vector<std::string> names = format == "xyz"
    ? std::vector<std::string>{ "leg000_points.xyz", "leg000_trajectory.txt",
        "leg001_points.xyz.part", "leg001_fullwave.txt.part" }
    : format == "las" ? std::vector<std::string>{ "leg000_fullwave.las", "leg000_fullwave.wdp",
        "leg001_points.las.part", "leg001_fullwave.wdp.part" }
                      : std::vector<std::string>{ "leg000_points.pvtp", "leg000_points_0001.vtp",
                          "leg001_points.pvtp.part", "leg001_fullwave_0000.vtt" };
  const Files files;
  const Reading reading(files, Flight, ThreeLegs);
  BlockRun broken(files, reading);
  broken.Player->SetFormat(format.c_str());
  broken.AbortAfter(50000);
  REQUIRE_FALSE(broken.Player->Run());
  for (const std::string& name : names)
  {
    INFO(name);
    BlockRun playing(files, reading);
    playing.Player->SetFormat(format.c_str());
    playing.Player->SetResume(true);
    for (const double place : { 0.03, 0.5, 0.85 })
    {
      const std::string path = "out/test/" + name;
      const auto size = static_cast<double>(fs::file_size(files / path));
      const auto at = static_cast<std::size_t>(place * size);
      // The header of a continued LAS file is checked once restored, and the header of its .wdp is
      // rewritten.
      Flip(files, path, at);
      playing.CheckFails({ path, "the file was changed or is damaged; set Overwrite" });
      Flip(files, path, at);
    }
  }
  BlockRun whole(files, reading, "whole");
  whole.Player->SetFormat(format.c_str());
  REQUIRE(whole.Player->Run());
  BlockRun again(files, reading);
  again.Player->SetFormat(format.c_str());
  again.Player->SetResume(true);
  CHECK(again.Player->Run());
  CHECK((ReadAll(files / "whole/test") == ReadAll(files / "out/test")));
}

TEST_CASE("SurveyDamage: the header of an unfinished LAS file", "[SurveyDamage]")
{
  const Files files;
  const Reading reading(files, Flight, ThreeLegs);
  BlockRun broken(files, reading);
  broken.Player->SetFormat("las");
  broken.AbortAfter(50000);
  REQUIRE_FALSE(broken.Player->Run());
  Flip(files, "out/test/leg001_points.las.part", 156); // byte of the offset of x
  BlockRun playing(files, reading);
  playing.Player->SetFormat("las");
  playing.Player->SetResume(true);
  playing.CheckFails({ "leg001_points.las.part: its header does not match its checksum in",
    "set Overwrite (--overwrite) to start again" });
}

TEST_CASE("SurveyDamage: an additional file that is longer or missing", "[SurveyDamage]")
{
  const Files files;
  const Reading reading(files, Flight, ThreeLegs);
  const std::string format = GENERATE("las", "vtp");
  BlockRun broken(files, reading);
  broken.Player->SetFormat(format.c_str());
  broken.AbortAfter(50000);
  REQUIRE_FALSE(broken.Player->Run());
  const std::string name =
    std::string("out/test/leg000_") + (format == "las" ? "fullwave.wdp" : "points_0002.vtp");
  BlockRun playing(files, reading);
  playing.Player->SetFormat(format.c_str());
  playing.Player->SetResume(true);
  playing.Player->SetBytesToCheck(0);
  files.Write(name, ReadText(files / name) + "more");
  playing.CheckFails({ name + ": was complete with", "to start again" });
  fs::remove(files / name);
  playing.CheckFails({ name + ": was complete with", "cannot be read: No such file" });
}

TEST_CASE("SurveyDamage: the range of bytes that is compared", "[SurveyDamage]")
{
  const Files files;
  const Reading reading(files, Flight, ThreeLegs);
  BreakOff(files, reading);
  BlockRun playing(files, reading);
  vtkHeliosSurveyPlayer* player = playing.Player;
  CHECK(player->GetBytesToCheck() == 1073741824);
  player->SetResume(true);
  Flip(files, "out/test/leg000_points.xyz", 1000);
  SECTION("the newest blocks, not the oldest")
  {
    player->SetBytesToCheck(10000);
    CHECK(player->Run());
    return;
  }
  SECTION("the newest block")
  {
    Flip(files, "out/test/leg001_points.xyz.part", 1000);
    player->SetBytesToCheck(3000000);
    playing.CheckFails(
      { "leg001_points.xyz.part: bytes 0 to", " do not match their checksum in run.journal;" });
  }
  player->SetBytesToCheck(VTK_ID_MAX);
  Flip(files, "out/test/leg000_points.xyz", 1001);
  playing.CheckFails({ "do not match their checksum" });
}

TEST_CASE("SurveyDamage: comparison can be aborted", "[SurveyDamage]")
{
  const Files files;
  const Reading reading(files, Flight, ThreeLegs);
  BreakOff(files, reading);
  class Stop : public vtkCommand
  {
  public:
    static Stop* New() { return new Stop; }
    void Execute(vtkObject* caller, unsigned long, void*) override
    {
      auto* player = static_cast<vtkHeliosSurveyPlayer*>(caller);
      if (player->GetMessage() == "checking the files of the earlier run")
      {
        player->Abort();
      }
    }
  };
  vtkNew<Stop> stop;
  BlockRun playing(files, reading);
  playing.Player->SetResume(true);
  playing.Player->AddObserver(vtkCommand::ProgressEvent, stop);
  CHECK_FALSE(playing.Player->Run());
  CHECK(playing.Player->GetMessage() == "Stopped.");
  CHECK(playing.Log->Errors.empty());
  CHECK(fs::exists(files / Journal));
}

TEST_CASE("SurveyDamage: a finished run", "[SurveyDamage]")
{
  const Files files;
  const Reading reading(files, Flight, ThreeLegs);
  const std::string format = GENERATE("xyz", "las", "vtp");
  BlockRun playing(files, reading);
  playing.Player->SetFormat(format.c_str());
  REQUIRE(playing.Player->Run());
  const std::string summary = "out/test/run_summary.json";
  const std::string text = ReadText(files / summary);
  playing.Player->SetResume(true);
  REQUIRE(playing.Player->Run());
  SECTION("a number of its summary changed")
  {
    files.Replace(summary, "\"points\" : 40000", "\"points\" : 40001");
    playing.CheckFails({ "run_summary.json is damaged: it does not match its checksum" });
  }
  SECTION("no checksum in its summary")
  {
    files.Replace(summary, "\"checksum\"", "\"check\"");
    playing.CheckFails({ "run_summary.json has no checksum: it was changed, or written by an "
                         "earlier version of vtkHelios; ",
      "set Overwrite (--overwrite)" });
  }
  SECTION("zeros after it")
  {
    files.Write(summary, text + std::string(10, '\0'));
    playing.CheckFails({ "run_summary.json is damaged" });
  }
  SECTION("too deep")
  {
    files.Write(summary, "{\"a\":" + std::string(5000, '['));
    playing.CheckFails({ "run_summary.json is damaged" });
  }
  SECTION("a shorter file")
  {
    const std::string name = format == "vtp" ? "points_0001.vtp"
      : format == "las"                      ? "fullwave.wdp"
                                             : "points.xyz";
    const std::string file = format == "vtp" ? "points.pvtp"
      : format == "las"                      ? "fullwave.las"
                                             : "points.xyz";
    files.Write("out/test/leg001_" + name, "short");
    playing.CheckFails({ "leg001_" + file, ": was complete with", "to start again" });
  }
  CHECK(playing.Player->GetReport().empty());
}

TEST_CASE("SurveyDamage: the folder is removed and replaced", "[SurveyDamage]")
{
  const Files files;
  const Reading reading(files, Flight, ThreeLegs);
  const std::string format = GENERATE("xyz", "las", "vtp");
  const bool isReplaced = GENERATE(false, true);
  const vtkIdType when = GENERATE(20000, 40000); // within a leg, and at its end
  BlockRun playing(files, reading);
  playing.Player->SetFormat(format.c_str());
  playing.Blocks->Action = [&](vtkHeliosSurveyPlayer* player)
  {
    if (player->GetCount("pulses") == when)
    {
      std::error_code error = std::make_error_code(std::errc::interrupted);
      while (error) // the player renames its files meanwhile
      {
        fs::remove_all(files / "out", error);
      }
      if (isReplaced)
      {
        fs::create_directories(files / "out/test");
      }
    }
  };
  playing.CheckFails({ "nothing is kept, since the folder", "out/test is gone" });
  CHECK_FALSE(playing.Log->HasError("are kept"));
  CHECK_FALSE(playing.Log->HasError("are safe"));
  CHECK(playing.Log->HasError("or was replaced by another one") == isReplaced);
  CHECK(fs::exists(files / "out") == isReplaced);
  // A piece of VTK XML is a file of its own, which was perhaps being written.
  const auto first = fs::directory_iterator(isReplaced ? files / "out/test" : files / ".");
  const auto count = isReplaced ? std::distance(first, fs::directory_iterator()) : 0;
  CHECK(count <= (format == "vtp" ? 2 : 0));
}
