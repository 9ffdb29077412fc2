// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The dialect: legs and their settings.
#include "heliosXmlTables.h"

#include "heliosStatus.h"
#include "heliosSurveyData.h"

namespace helios
{

using namespace rows;

namespace
{

constexpr auto Leg = &LegSettings::Leg;
constexpr auto Scan = &LegSettings::Scan;
constexpr auto Track = &LegData::Trajectory;

/// Finds the fault of a part of file names.
Status FindNameFault(const std::string& text)
{
  const bool isGood = text.find_first_of("/\\") == std::string::npos;
  return isGood ? Status()
                : Status::Error(" is not valid in a file name; give one without / and \\");
}

} // namespace

//------------------------------------------------------------------------------
std::vector<XmlElementRule> MakeLegRules()
{
  // clang-format off
  return {
  { "leg", "a scan position; on a moving platform, the trajectory to the next leg",
    {
      Reference("scanner", "the scanner of this leg").Default("the survey's"),
      Reference("platform", "the platform of this leg").Default("the survey's"),
      Number("x", "position in a scan of the Java program").In("m").At<Leg, &LegData::Position, 0>(),
      Number("y", "position in a scan of the Java program").In("m").At<Leg, &LegData::Position, 1>(),
      Number("z", "position in a scan of the Java program").In("m").At<Leg, &LegData::Position, 2>(),
      Number("maxDuration_s", "ends the leg after this time; negative: never; overrides scannerSettings").In("s", { -1.0, 1e12 }).Default("-1"),
      Text("id", "legs are numbered 0, 1, 2 ... in the order of the file").Ignored(),
      Text("stripId", "legs with the same value write one file").Checked(FindNameFault).At<Leg, &LegData::Strip>(),
    },
    { One("platformSettings"), One("scannerSettings"), One("maxDuration_s", "the attribute of the same name, as a child element") } },

  { "scan", "legs with their own platform and scanner, as written by the planner of the Java program",
    {
      Reference("scanner", "the scanner of its legs").Default("the survey's"),
      Reference("platform", "the platform of its legs").Default("the survey's"),
      Text("id", "scans are never referenced").Ignored(),
    },
    { One("scannerRotation"), Many("leg") } },

  { "scannerRotation", "head rotation on each leg, at maximum speed",
    {
      Text("axis", "the head rotates about its own axis").Ignored(),
      Number("angle", "given by start and end").In("deg").Ignored(),
      Number("start", "head angle at the start of a leg").In("deg", HeadAngle).Default("0"),
      Number("end", "head angle at its end").In("deg", HeadAngle).Default("0"),
    },
    {} },

  { "origin", "offset of the following legs, of the Java program",
    {
      Number("x", "coordinate to the right, or east").In("m").Default("0"),
      Number("y", "coordinate forward, or north").In("m").Default("0"),
      Number("z", "coordinate up").In("m").Default("0"),
    },
    {} },

  { "platformSettings", "start and motion of a leg; at the top level, a template",
    {
      Text("id", "identifier for references"),
      Text("name", "templates are referenced by id").Ignored(),
      Reference("template", "settings of the same kind used as defaults; values given here override them"),
      Number("x", "position").In("m").At<Leg, &LegData::Position, 0>(),
      Number("y", "position").In("m").At<Leg, &LegData::Position, 1>(),
      Number("z", "position; onGround replaces it").In("m").At<Leg, &LegData::Position, 2>(),
      Text("crs", "coordinate system, as EPSG:n, WKT or PROJ").Default("the scene's").At<Leg, &LegData::Crs>(),
      Flag("onGround", "whether z is the height of the ground below").At<Leg, &LegData::OnGround>(),
      Number("movePerSec_m", "speed to the next leg; maximum speed of vehicles").In("m/s", { -1e9, 1e9 }).At<Leg, &LegData::Speed>(),
      Flag("stopAndTurn", "multicopter: stops at the waypoint, turns, and starts from rest").At<Leg, &LegData::StopAndTurn>(),
      Flag("smoothTurn", "multicopter: turns in flight; overrides stopAndTurn").At<Leg, &LegData::SmoothTurn>(),
      Flag("slowdownEnabled", "multicopter: slows down before waypoints and in turns").At<Leg, &LegData::SlowsDown>(),
      Number("yawAtDeparture_deg", "multicopter: heading at departure, anticlockwise from north").In("deg", Angle).Default("to the next leg").At<Leg, &LegData::YawAtDeparture>(),
      Text("trajectory", "interpolated platform: the file of its trajectory").Names(XmlFile::Needed).At<Leg, Track, &TrajectoryFileData::File>(),
      Word("trajectoryFormat", "~auto columns sbet tum euroc", "format of the trajectory file; auto: by its ending, .sbet and .out SBET, .tum TUM, others text columns").At<Leg, Track, &TrajectoryFileData::Format>(),
      Text("trajectoryCrs", "SBET: geographic coordinate system of the file, as EPSG:n, WKT or PROJ; it is transformed to that of the scene, or to the UTM zone of its first record").Default("EPSG:4979").At<Leg, Track, &TrajectoryFileData::Crs>(),
      Word("trajectoryBody", "~rightForwardUp forwardLeftUp forwardRightDown", "TUM, EuRoC: axes x, y, z of the body").At<Leg, Track, &TrajectoryFileData::Body>(),
      Text("trajectory_seperator", "trajectory_separator in the spelling of HELIOS++").KeepsBlanks().Alias().At<Leg, Track, &TrajectoryFileData::Separator>(),
      Text("trajectory_separator", "column separator of the trajectory file").KeepsBlanks().At<Leg, Track, &TrajectoryFileData::Separator>(),
      Integer("tIndex", "column of time, from 0").In("", Column).Default("0").At<Leg, Track, &TrajectoryFileData::Columns, 0>(),
      Integer("rollIndex", "column of roll").In("", Column).Default("1").At<Leg, Track, &TrajectoryFileData::Columns, 1>(),
      Integer("pitchIndex", "column of pitch").In("", Column).Default("2").At<Leg, Track, &TrajectoryFileData::Columns, 2>(),
      Integer("yawIndex", "column of yaw").In("", Column).Default("3").At<Leg, Track, &TrajectoryFileData::Columns, 3>(),
      Integer("xIndex", "column of x").In("", Column).Default("4").At<Leg, Track, &TrajectoryFileData::Columns, 4>(),
      Integer("yIndex", "column of y").In("", Column).Default("5").At<Leg, Track, &TrajectoryFileData::Columns, 5>(),
      Integer("zIndex", "column of z").In("", Column).Default("6").At<Leg, Track, &TrajectoryFileData::Columns, 6>(),
      Word("interpolationDomain", "position position_and_attitude", "which columns the trajectory file has").At<Leg, Track, &TrajectoryFileData::HasAttitude>(),
      Flag("toRadians", "true: the angles in the file are degrees; false: radians").Inverted().At<Leg, Track, &TrajectoryFileData::IsInRadians>(),
      Flag("syncGPSTime", "whether GPS time is the time in the file").At<Leg, Track, &TrajectoryFileData::KeepsTime>(),
      Number("slopeFilterThreshold", "thins straight parts of the trajectory; 0: no thinning").In("", NotNegative).At<Leg, Track, &TrajectoryFileData::SlopeThreshold>(),
      Number("tStart", "time in the file at the start of the leg").In("s", Moment).Default("the first one").At<Leg, Track, &TrajectoryFileData::StartTime>(),
      Number("tEnd", "time in the file at the end of the leg").In("s", Moment).Default("the last one").At<Leg, Track, &TrajectoryFileData::EndTime>(),
      Flag("teleportToStart", "whether the platform jumps to the start of the leg").At<Leg, Track, &TrajectoryFileData::TeleportsToStart>(),
    },
    {} },

  { "scannerSettings", "scan parameters of a leg, or of all legs of a plan; at the top level, a template",
    {
      Text("id", "identifier for references"),
      Text("name", "templates are referenced by id").Ignored(),
      Reference("template", "settings of the same kind used as defaults; values given here override them"),
      Flag("active", "whether the leg fires pulses").At<Leg, &LegData::Active>(),
      Number("pulseFreq_hz", "pulse frequency; a value not in pulseFreqs_Hz causes a warning").In("Hz", Frequency).Default("the first of pulseFreqs_Hz").At<&LegSettings::PulseFrequency>(),
      Number("scanFreq_hz", "lines, mirror cycles or revolutions per second; clipped to the limits of the scanner").In("Hz", ScanFrequency).Default("0").At<&LegSettings::ScanFrequency>(),
      Number("scanAngle_deg", "half angle, clipped to that of the scanner; 0: that of the scanner").In("deg", HalfAngle).Default("scanAngleMax_deg").At<&LegSettings::ScanAngle>(),
      Number("verticalAngleMin_deg", "rotating: vertical FOV min, as a mirror angle").In("deg", Angle).Default("-scanAngle_deg").At<&LegSettings::VerticalAngleMin>(),
      Number("verticalAngleMax_deg", "rotating: vertical FOV max; the window is clipped to the width of the scanner's").In("deg", Angle).Default("scanAngle_deg").At<&LegSettings::VerticalAngleMax>(),
      Number("headRotatePerSec_deg", "head rotation speed; clipped to the limit of the scanner").In("deg/s", HeadAngle).At<Scan, &ScanData::HeadRotateSpeed>(),
      Number("headRotateStart_deg", "horizontal FOV start: head angle at the start of the leg").In("deg", HeadAngle).At<Scan, &ScanData::HeadRotateStart>(),
      Number("headRotateStop_deg", "horizontal FOV end: head angle at the end of the leg, on a static platform").In("deg", HeadAngle).At<Scan, &ScanData::HeadRotateStop>(),
      Number("beamDivergence_rad", "full angle at 1/e2").In("rad", Fraction).Default("the scanner's").At<&LegSettings::BeamDivergence>(),
      Number("beamDivergenceRad", "beamDivergence_rad in the spelling of some schemas").In("rad", Fraction).Default("the scanner's").Alias().At<&LegSettings::BeamDivergence>(),
      Number("trajectoryTimeInterval_s", "time between two samples of the trajectory; 0: start and end only").In("s", NotNegative).At<Leg, &LegData::TrajectoryTimeInterval>(),
      Number("maxDuration_s", "ends the leg after this time; negative: never").In("s", { -1.0, 1e12 }).At<Leg, &LegData::MaximumDuration>(),
      Number("verticalResolution_deg", "rotating: angle between pulses of a line; sets scanFreq_hz").In("deg", HalfAngle).At<&LegSettings::VerticalResolution>(),
      Number("horizontalResolution_deg", "rotating: angle between lines; sets the head rotation speed").In("deg", HalfAngle).At<&LegSettings::HorizontalResolution>(),
      Number("opticsWarmupPhase_s", "time that mirror and head move before the leg starts").In("s", { 0.0, 1e6 }).At<Scan, &ScanData::WarmUpTime>(),
      Integer("beamSampleQuality", "give it in FWFSettings, as HELIOS does").Later(),
    },
    { One("maxDuration_s", "the attribute of the same name, as a child element") } },
  };
  // clang-format on
}

} // namespace helios
