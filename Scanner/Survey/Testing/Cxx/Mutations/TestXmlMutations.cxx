// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Damaged surveys, scenes and assets give an error that names the file, or a survey to run.
#include "heliosMutation.h"
#include "heliosSurveyFiles.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>

namespace
{

const char* const Scene = R"(<?xml version="1.0" encoding="UTF-8"?>
<document><scene id="s" name="all" crs="EPSG:32632">
<part id="floor">
<filter type="objloader"><param type="string" key="filepath" value="plane.obj"/>
<param type="string" key="up" value="z"/></filter>
<filter type="rotate"><param key="rotation" type="rotation"><rot axis="z" angle_deg="30"/></param></filter>
<filter type="scale"><param type="double" key="scale" value="1.5"/></filter>
<filter type="translate"><param type="vec3" key="offset" value="1;2;3"/>
<param type="integer" key="onGround" value="0"/></filter>
<filter type="repair"/>
<filter type="simplify"><param type="double" key="maximumDistance" value="0.01"/></filter>
</part>
<part id="hedge"><filter type="xyzloader">
<param type="string" key="filepath" value="points.xyz"/>
<param type="double" key="voxelSize" value="0.25"/><param type="string" key="separator" value=";"/>
<param type="int" key="normalXIndex" value="3"/><param type="int" key="normalYIndex" value="4"/>
<param type="int" key="normalZIndex" value="5"/><param type="vec3" key="defaultNormal" value="0;0;1"/>
</filter></part>
<part id="hills"><filter type="geotiffloader"><param key="filepath" value="height.tif"/>
<param key="matfile" value="ground.mtl"/><param key="matname" value="grass"/></filter>
<filter type="crs"><param key="source" value="EPSG:4326"/><param key="target" value="EPSG:32632"/></filter>
</part>
</scene></document>
)";

const char* const Survey = R"(<?xml version="1.0"?>
<!-- a flight -->
<document>
<platformSettings id="place" x="5" y="6" z="70" movePerSec_m="50"/>
<scannerSettings id="base" pulseFreq_hz="100000" scanFreq_hz="50" scanAngle_deg="5"/>
<scannerSettings id="slow" template="base" scanFreq_hz="20"/>
<survey name="test" scene="scene.xml#s" platform="assets.xml#plane" scanner="assets.xml#als">
<leg><platformSettings template="place" x="0"/><scannerSettings template="base" active="true"/></leg>
<leg><platformSettings template="place" onGround="false"/><scannerSettings template="slow"
 beamDivergence_rad="0.001" trajectoryTimeInterval_s="0.1"/></leg>
<leg><platformSettings x="20" y="1e1" z="100"/><scannerSettings template="base" active="false"/></leg>
</survey></document>
)";

const char* const Standing = R"(<document>
<survey name="test" scene="scene.xml#s" platform="assets.xml#tripod" scanner="assets.xml#tls">
<leg><platformSettings x="1" y="2" z="3"/><scannerSettings pulseFreq_hz="300000" scanFreq_hz="50"
 headRotatePerSec_deg="10" headRotateStart_deg="-10" headRotateStop_deg="10"
 verticalAngleMin_deg="-30" verticalAngleMax_deg="30"/></leg>
</survey></document>
)";

bool AreFinite(std::initializer_list<double> values)
{
  return std::all_of(values.begin(), values.end(), [](double x) { return std::isfinite(x); });
}

bool IsFinite(const helios::Vec3& v)
{
  return AreFinite({ v[0], v[1], v[2] });
}

bool IsPose(const helios::Pose& pose)
{
  const helios::Quaternion& q = pose.Orientation;
  return IsFinite(pose.Position) &&
    std::abs(std::hypot(std::hypot(q.GetW(), q.GetX()), std::hypot(q.GetY(), q.GetZ())) - 1.0) <
    1e-9;
}

bool IsValid(const helios::ScannerData& s)
{
  const bool pulses = // optional if the legs give theirs
    std::all_of(s.PulseFrequencies.begin(), s.PulseFrequencies.end(),
      [](double f) { return std::isfinite(f) && f > 0.0; });
  return pulses && IsPose(s.Beam) && IsFinite(s.HeadRotateAxis) && s.HeadRotateAxis.Norm() > 0.0 &&
    s.Receiver.PulseLength > 0.0 && s.Receiver.BinSize > 0.0 && s.BeamDivergence >= 0.0 &&
    s.Receiver.Wavelength > 0.0 && s.Receiver.AveragePower > 0.0 &&
    s.Receiver.ReceiverDiameter > 0.0 && s.Receiver.DetectionThreshold >= 0.0 &&
    s.Receiver.RangeAccuracy >= 0.0 && s.Receiver.RangeMin >= 0.0 &&
    s.Receiver.RangeMax > s.Receiver.RangeMin && s.Receiver.MaximumNumberOfReturns >= 0 &&
    s.Receiver.NumberOfCircles >= 0 &&
    AreFinite(
      { s.Receiver.PulseLength, s.BeamDivergence, s.Receiver.Wavelength, s.Receiver.AveragePower,
        s.Receiver.OpticalEfficiency, s.Receiver.ReceiverDiameter, s.Receiver.AtmosphericVisibility,
        s.Receiver.DetectionThreshold, s.Receiver.RangeAccuracy, s.Receiver.RangeMin,
        s.Receiver.RangeMax, s.ScanAngleMax, s.ScanAngleEffectiveMax, s.ScanFrequencyMin,
        s.ScanFrequencyMax, s.HeadRotateSpeedMax, s.Receiver.BinSize, s.Receiver.PeakWindow,
        s.Receiver.MaximumWaveformLength, s.Receiver.RangeTolerance, s.Receiver.EnergyTolerance });
}

bool IsValid(const helios::ScanData& scan)
{
  return scan.PulseFrequency > 0.0 && scan.ScanFrequency >= 0.0 && scan.BeamDivergence >= 0.0 &&
    scan.GetHeadTime() >= 0.0 && scan.VerticalAngleMin <= scan.VerticalAngleMax &&
    AreFinite({ scan.PulseFrequency, scan.ScanFrequency, scan.ScanAngle, scan.VerticalAngleMin,
      scan.VerticalAngleMax, scan.HeadRotateSpeed, scan.HeadRotateStart, scan.HeadRotateStop,
      scan.BeamDivergence, scan.WarmUpTime, scan.GetHeadTime() });
}

bool IsValid(const helios::PartData& part)
{
  const helios::Quaternion& q = part.Rotation;
  return !part.Files.empty() &&
    AreFinite({ part.Scale, part.SimplifyDistance, part.Voxels.Size }) && part.Scale > 0.0 &&
    part.SimplifyDistance >= 0.0 && part.Voxels.Size > 0.0 &&
    *std::min_element(part.Voxels.NormalIndex, part.Voxels.NormalIndex + 3) >= 0 &&
    IsFinite(part.Translation) && IsFinite(part.Voxels.DefaultNormal) &&
    AreFinite({ q.GetW(), q.GetX(), q.GetY(), q.GetZ() }) &&
    std::all_of(part.Crs.begin(), part.Crs.end(),
      [](const helios::CrsData& crs) { return !crs.Target.empty(); });
}

bool IsValid(const helios::LegData& leg)
{
  return IsFinite(leg.Position) && leg.Speed >= 0.0 && leg.TrajectoryTimeInterval >= 0.0 &&
    AreFinite({ leg.Speed, leg.TrajectoryTimeInterval, leg.MaximumDuration }) &&
    !leg.Scans.empty() &&
    std::all_of(leg.Scans.begin(), leg.Scans.end(),
      [](const helios::ScanData& scan) { return IsValid(scan); });
}

bool IsValid(const helios::PlatformData& platform)
{
  return IsPose(platform.Mount);
}

template <typename T>
bool AreValid(const std::vector<T>& all)
{
  return !all.empty() && std::all_of(all.begin(), all.end(), [](const T& x) { return IsValid(x); });
}

bool IsValid(const helios::SurveyData& survey)
{
  return !survey.Name.empty() && AreValid(survey.Scanners) && AreValid(survey.Platforms) &&
    AreValid(survey.Scene.Parts) && AreValid(survey.Legs);
}

} // namespace

TEST_CASE("XmlMutations: damaged files give an error or a survey", "[XmlMutations][mutation]")
{
  helios::Mutator mutate(4711);
  const helios::test::Files files;
  files.Write("points.xyz", "0;0;0;0;0;1\n");
  files.Write("height.tif", "");
  files.Write("ground.mtl", "newmtl grass\n");
  const std::string assets = helios::test::ReadText(files / "assets.xml");
  const auto writeAll = [&](const char* survey)
  {
    files.Write("scene.xml", Scene);
    files.Write("assets.xml", assets);
    files.Write("survey.xml", survey);
  };
  for (const char* survey : { Survey, Standing })
  {
    writeAll(survey);
    const helios::test::Reading reading(files);
    INFO(reading.Log->Errors);
    REQUIRE(reading.Good);
    REQUIRE(IsValid(reading.Data()));
  }

  std::array<int, 2> count = { 0, 0 };
  for (int i = 0; i < helios::GetNumberOfMutations(); ++i)
  {
    const char* survey = i % 2 == 0 ? Survey : Standing;
    writeAll(survey);
    const char* const names[] = { "survey.xml", "scene.xml", "assets.xml" };
    const std::string texts[] = { survey, Scene, assets };
    const std::string text = mutate(texts[i / 2 % 3]);
    files.Write(names[i / 2 % 3], text);
    INFO("file " << i << ", " << names[i / 2 % 3] << "\n" << text);
    const helios::test::Reading reading(files);
    INFO(reading.Log->Errors);
    ++count[reading.Good];
    REQUIRE(reading.Good == reading.Log->Errors.empty());
    REQUIRE(reading.Good == (reading.Reader->GetSurvey() != nullptr));
    REQUIRE((!reading.Good || IsValid(reading.Data())));
    REQUIRE((reading.Good || reading.Log->HasError(".xml")));
  }
  CHECK(count[0] > 0);
  CHECK(count[1] > 0);
}
