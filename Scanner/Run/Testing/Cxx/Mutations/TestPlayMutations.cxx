// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Surveys with files damaged in structure or values are run: each gives points, or a message with
// the place and the reason; none hangs.
#include "heliosMutation.h"
#include "heliosSurveyFiles.h"
#include "heliosXmlMutation.h"
#include "vtkHeliosRunOptions.h"
#include "vtkHeliosSurveyPlayer.h"

#include <vtkCallbackCommand.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <regex>

#include <unistd.h>

namespace
{

namespace fs = std::filesystem;

const char* const Flight = R"(<document>
<platformSettings id="place" x="-10" y="2" z="60" movePerSec_m="20"/>
<scannerSettings id="base" pulseFreq_hz="2000" scanFreq_hz="50" scanAngle_deg="5"/>
<scannerSettings id="slow" template="base" scanFreq_hz="20"/>
<survey name="test" scene="scene.xml#s" platform="assets.xml#PLATFORM" scanner="assets.xml#SCANNER">
<FWFSettings binSize_ns="0.25" winSize_ns="1" beamSampleQuality="2"/>
<detectorSettings accuracy_m="0.01" rangeMax_m="500"/>
<leg><platformSettings template="place"/><scannerSettings template="base" active="true"/></leg>
<leg><platformSettings template="place" x="0" onGround="false"/><scannerSettings template="slow"
 beamDivergence_rad="0.001" trajectoryTimeInterval_s="0.1" opticsWarmupPhase_s="0.1"/></leg>
<leg><platformSettings x="10" y="1e1" z="50"/><scannerSettings template="base" active="false"/></leg>
</survey></document>
)";

const char* const Stand = R"(<document>
<survey name="test" scene="scene.xml#s" platform="assets.xml#PLATFORM" scanner="assets.xml#SCANNER">
<leg maxDuration_s="1"><platformSettings x="1" y="2" onGround="true"/><scannerSettings
 pulseFreq_hz="2000" scanFreq_hz="50" headRotatePerSec_deg="10" headRotateStart_deg="-10"
 headRotateStop_deg="10" trajectoryTimeInterval_s="0.5"/></leg>
<leg><platformSettings x="5" y="-2" z="3"/><scannerSettings pulseFreq_hz="2000" scanFreq_hz="50"
 headRotatePerSec_deg="20" headRotateStop_deg="10"/></leg>
</survey></document>
)";

const char* const Drive = R"(<document>
<scannerSettings id="base" pulseFreq_hz="500" scanFreq_hz="50" scanAngle_deg="5"/>
<survey name="test" scene="scene.xml#s" platform="assets.xml#PLATFORM" scanner="assets.xml#SCANNER" seed="7"
 legRandomOffset="true" legRandomOffsetMean="0" legRandomOffsetStdev="0.01">
<origin x="1" y="2" z="0"/><positionZNoise type="UNIFORM" min="-0.01" max="0.01" fixedLifespan="5"/>
<leg stripId="a"><platformSettings x="-10" z="5" movePerSec_m="8" stopAndTurn="false" smoothTurn="true"/>
<scannerSettings template="base"/></leg>
<leg stripId="a"><platformSettings x="0" y="8" z="5" movePerSec_m="8" yawAtDeparture_deg="30"
 slowdownEnabled="true"/><scannerSettings template="base"/></leg>
<leg><platformSettings x="5" y="8" z="5"/><scannerSettings template="base" active="false"/></leg>
</survey></document>
)";

const char* const Recorded = R"(<document>
<survey name="test" scene="scene.xml#s" platform="interpolated" basePlatform="assets.xml#PLATFORM"
 scanner="assets.xml#SCANNER" rotationSpec="ARINC 705"><scannerMount z="1"><rot axis="x" angle_deg="-90"/>
</scannerMount>
<leg><platformSettings trajectory="path.csv" trajectory_separator="," tIndex="0" rollIndex="1"
 pitchIndex="2" yawIndex="3" xIndex="4" yIndex="5" zIndex="6" toRadians="true" tStart="0" tEnd="1"
 interpolationDomain="position_and_attitude" slopeFilterThreshold="0"/>
<scannerSettings pulseFreq_hz="1000" scanFreq_hz="50" scanAngle_deg="5"/></leg>
<leg><platformSettings tStart="1.5" tEnd="2" teleportToStart="true" syncGPSTime="false"/>
<scannerSettings pulseFreq_hz="1000" scanFreq_hz="50" scanAngle_deg="5"/></leg>
</survey></document>
)";

const char* const Path = R"(#HEADER: "t", "roll", "pitch", "yaw", "x", "y", "z"
0,0,0,350,-10,0,60
0.5,1,2,355,-5,1,61
1,2,1,1,0,2,60
1.5,0,0,5,5,3,59
2,0,0,9,10,4,60
)";

const char* const Scene = R"(<document><scene id="s" name="all" crs="EPSG:32632">
<part id="floor"><filter type="objloader"><param type="string" key="filepath" value="plane.obj"/>
<param type="string" key="up" value="z"/></filter>
<filter type="rotate"><param key="rotation" type="rotation"><rot axis="z" angle_deg="30"/></param></filter>
<filter type="scale"><param type="double" key="scale" value="1.5"/></filter>
<filter type="repair"/></part>
<part id="hedge"><filter type="xyzloader">
<param type="string" key="filepath" value="points.xyz"/>
<param type="double" key="voxelSize" value="0.25"/><param type="string" key="separator" value=";"/>
<param type="int" key="normalXIndex" value="3"/><param type="vec3" key="defaultNormal" value="0;0;1"/>
</filter><filter type="translate"><param type="vec3" key="offset" value="1;2;3"/>
<param type="integer" key="onGround" value="1"/></filter>
<swap swapStep="1" keepCRS="true"><filter type="translate"><param key="offset" value="2;2;1"/></filter></swap>
<swap><filter type="objloader"><param key="filepath" value="plane.obj"/></filter></swap></part>
<part id="crown"><filter type="detailedvoxels"><param type="string" key="filepath" value="crown.vox"/>
<param type="string" key="intersectionMode" value="transmittive"/>
<param type="double" key="intersectionArgument" value="0.5"/></filter></part>
</scene></document>
)";

const char* const Crown = R"(VOXEL SPACE
#min_corner: -4 -4 10
#max_corner: 4 4 12
#split: 2 2 1
#res: 4 #max_pad: 1.6
i j k PadBVTotal transmittance
0 0 0 0.5 0.5
1 0 0 1.6 0.1
0 1 0 0 1
1 1 0 0.2 0.8
)";

const char* const Instruments = R"(
<scanner id="zigzag" optics="oscillating" pulseFreqs_Hz="2000" scanAngleMax_deg="20"
 scanFreqMax_Hz="80" scanPattern="sinusoidal" scanProduct="1e5" turningPulses="3" maxNOR="5">
<rangeError expr="sin(THETA) * 0.001"/><FWFSettings numFullwaveBins="200"/></scanner>
<scanner id="fibres" optics="line" pulseFreqs_Hz="2000" scanAngleMax_deg="20" numFibers="16"
 detectorNoise_nW="0.001" angleAccuracy_rad="1e-5" averagePower_w="10" opticalEfficiency="0.9"/>
<scanner id="prisms" optics="risley" pulseFreqs_Hz="2000" angle1_deg="10" angle2_deg="-8"
 refrIndex1="1.5" refrIndex2="1.5" rotorFreq1_Hz="70" rotorFreq2_Hz="-50" refrIndex_air="1"
 atmosphericVisibility_km="10" wavelength_nm="905" headRotatePerSecMax_deg="60" rangeMin_m="0.5" rangeMax_m="400">
<beamOrigin z="0.1"><rot axis="y" angle_deg="3"/></beamOrigin>
<headRotateAxis x="0" y="0" z="1"/></scanner>
<scanner id="pair" optics="rotating" pulseFreqs_Hz="500" scanAngleMax_deg="60" scanFreqMax_Hz="90">
<channels><channel id="a"><beamOrigin><rot axis="z" angle_deg="2"/></beamOrigin></channel>
<channel id="b" wavelength_nm="532" beamDivergence_rad="0.001" optics="line" scanAngleMax_deg="9"
 numFibers="3"><FWFSettings binSize_ns="0.5"/></channel></channels></scanner>
<platform id="car" type="groundvehicle" drag="0.001"><scannerMount z="2"><rot axis="x" angle_deg="-90"/>
</scannerMount><attitudeXNoise type="NORMAL" mean="0" stdev="0.001" clipEnabled="true" clipMin="-0.01"
 clipMax="0.01"/></platform>
<platform id="copter" type="multicopter" drag="0.01" engine_max_force="0.1" speedup_magnitude="2"
 slowdown_magnitude="2" slowdown_distance="5" base_pitch_deg="-5" yaw_speed_deg="85" roll_speed_deg="28"
 pitch_speed_deg="85" roll_offset_deg="25" pitch_offset_deg="35"><scannerMount z="-0.2">
<rot axis="x" angle_deg="-90"/></scannerMount><positionXNoise stdev="0.01"/></platform>
</document>)";

/// Aborts the process after this time for a case [s], with the case in the report.
constexpr unsigned LongestCase = 300;

void Hang(int)
{
  std::abort();
}

/// The result of one survey.
struct Play
{
  bool Read = false;
  bool Ran = false;
  bool Stopped = false;
  vtkIdType Points = 0;
  std::string Message;
  std::string Errors;

  explicit Play(const helios::test::Files& files, int number = 0)
  {
    const helios::test::Reading reading(files);
    this->Read = reading.Good;
    this->Errors = reading.Log->Errors;
    if (this->Read)
    {
      const int epochs = reading.Reader->GetSurvey()->GetNumberOfEpochs();
      this->Player->GetOptions()->SetEpoch(std::min(number, epochs - 1));
      this->Run(files, reading.Reader->GetSurvey());
    }
  }

  void Run(const helios::test::Files& files, vtkHeliosSurvey* survey)
  {
    this->Start = std::chrono::steady_clock::now();
    const auto log = helios::test::Observe(this->Player);
    vtkNew<vtkCallbackCommand> onProgress;
    onProgress->SetClientData(this);
    onProgress->SetCallback(Play::StopWhenLong);
    this->Player->AddObserver(vtkCommand::ProgressEvent, onProgress);
    this->Player->SetSurvey(survey);
    this->Player->SetOutputDirectory((files / "out").c_str());
    this->Player->SetOverwrite(true);
    this->Player->SetPulsesPerBlock(500);
    this->Ran = this->Player->Run();
    this->Points = this->Player->GetCount("points");
    this->Message = this->Player->GetMessage();
    this->Errors += log->Errors;
  }

  /// Stops long runs, as a user would.
  static void StopWhenLong(vtkObject*, unsigned long, void* self, void*)
  {
    auto* play = static_cast<Play*>(self);
    const auto spent = std::chrono::steady_clock::now() - play->Start;
    if (play->Player->GetCount("pulses") > 12000 || spent > std::chrono::seconds(2))
    {
      play->Stopped = true;
      play->Player->Abort();
    }
  }

  /// Whether an error names the file and the place in it.
  bool NamesPlace() const
  {
    static const std::regex place("[.](xml|obj|xyz|mtl|csv|vox)(:[0-9]+|: )");
    return std::regex_search(this->Errors, place);
  }

  vtkNew<vtkHeliosSurveyPlayer> Player;
  std::chrono::steady_clock::time_point Start;
};

std::uintmax_t GetSizeOfPoints(const std::string& folder)
{
  std::uintmax_t size = 0;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
  {
    const bool isPoints = entry.path().filename().string().find("_points") != std::string::npos;
    size += isPoints ? entry.file_size() : 0;
  }
  return size;
}

std::string MakeAssets(const helios::test::Files& files)
{
  std::string assets = helios::test::ReadText(files / "assets.xml");
  return assets.replace(assets.find("</document>"), std::string::npos, Instruments);
}

struct Pair
{
  const char* Survey;
  const char* Platform;
  const char* Scanner;
};
const Pair Pairs[] = { { Flight, "plane", "als" }, { Stand, "tripod", "tls" },
  { Drive, "copter", "zigzag" }, { Stand, "tripod", "prisms" }, { Recorded, "plane", "als" },
  { Flight, "plane", "fibres" }, { Drive, "car", "pair" } };

std::string MakeSurvey(const Pair& pair)
{
  std::string survey = pair.Survey;
  survey.replace(survey.find("PLATFORM"), 8, pair.Platform);
  return survey.replace(survey.find("SCANNER"), 7, pair.Scanner);
}

/// Writes the survey, its scene and its assets again; one of them may be damaged afterwards.
void WriteAll(const helios::test::Files& files, const Pair& pair, const std::string& assets)
{
  files.Write("survey.xml", MakeSurvey(pair));
  files.Write("scene.xml", Scene);
  files.Write("path.csv", Path);
  files.Write("crown.vox", Crown);
  files.Write("assets.xml", assets);
}

void CheckPlay(const Play& play, const helios::test::Files& files)
{
  INFO(play.Message << "\n" << play.Errors);
  if (play.Ran)
  {
    REQUIRE(play.Points > 0);
    REQUIRE(play.Errors.empty());
    REQUIRE(GetSizeOfPoints(files / "out") > 0);
    return;
  }
  REQUIRE((play.Stopped || !play.Errors.empty()));
  REQUIRE((!play.Read || !play.Message.empty()));
  REQUIRE((play.Stopped || play.NamesPlace()));
}

} // namespace

TEST_CASE("PlayMutations: damaged surveys give points or an error", "[PlayMutations][mutation]")
{
  const helios::test::Files files;
  const std::string assets = MakeAssets(files);
  files.Write("points.xyz", "0;0;0;0;0;1\n0;0;1;0;0;1\n1;0;0;0;1;0\n");
  for (const Pair& pair : Pairs)
  {
    WriteAll(files, pair, assets);
    const Play play(files);
    INFO(pair.Scanner << "\n" << play.Message << "\n" << play.Errors);
    REQUIRE(play.Ran);
  }

  helios::XmlMutator mutate(815);
  helios::Mutator mutateBytes(816);
  std::array<int, 4> count{}; // rejected, without points, stopped, with points
  std::signal(SIGALRM, Hang);
  for (int i = 0; i < 2 * helios::GetNumberOfMutations(); ++i)
  {
    const Pair& pair = Pairs[static_cast<std::size_t>(i) % std::size(Pairs)];
    WriteAll(files, pair, assets);
    const char* const names[] = { "survey.xml", "scene.xml", "assets.xml", "path.csv" };
    const std::string texts[] = { MakeSurvey(pair), Scene, assets, Path };
    const int k = pair.Survey == Recorded ? 3 * (i / 7 % 2) : i / 2 % 3;
    const std::string text = k < 3 ? mutate(texts[k]) : mutateBytes(texts[k]);
    files.Write(names[k], text);
    INFO("case " << i << ", " << names[k] << ", scanner " << pair.Scanner << "\n" << text);
    ::alarm(LongestCase);
    const Play play(files, i % 3);
    ::alarm(0);
    CheckPlay(play, files);
    ++count[play.Ran ? 3 : play.Stopped ? 2 : play.Read ? 1 : 0];
  }
  for (const int number : count)
  {
    CHECK(number > 0);
  }
}
