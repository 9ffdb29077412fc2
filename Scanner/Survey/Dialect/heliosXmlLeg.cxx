// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosXmlLeg.h"

#include "heliosAssets.h"
#include "heliosMessages.h"

namespace helios
{

namespace
{

/// The maximum depth of nested templates: deeper ones are cyclic.
constexpr int DeepestTemplate = 32;

constexpr const char* ColumnNames[7] = { "tIndex", "rollIndex", "pitchIndex", "yawIndex", "xIndex",
  "yIndex", "zIndex" };

/// Reads the settings of one leg, after those of its templates.
class LegReader
{
public:
  explicit LegReader(Assets& files)
    : Files(files)
  {
  }

  void ReadPlatformSettings(const XmlElement& element, LegSettings& settings, int depth = 0);
  void ReadScannerSettings(const XmlElement& element, LegSettings& settings, int depth = 0);

private:
  XmlElement FindTemplate(const XmlElement& element, int depth);
  void ReadTrajectory(const XmlElement& element, TrajectoryFileData& trajectory);

  Assets& Files;
};

//------------------------------------------------------------------------------
void LegReader::ReadPlatformSettings(const XmlElement& element, LegSettings& settings, int depth)
{
  element.CheckNames();
  if (const XmlElement base = this->FindTemplate(element, depth))
  {
    this->ReadPlatformSettings(base, settings, depth + 1);
  }
  LegData& leg = settings.Leg;
  element.ReadVector(leg.Position);
  element.Read("crs", leg.Crs);
  element.Read("onGround", leg.OnGround);
  element.Read("movePerSec_m", leg.Speed);
  element.Read("stopAndTurn", leg.StopAndTurn);
  element.Read("smoothTurn", leg.SmoothTurn);
  element.Read("slowdownEnabled", leg.SlowsDown);
  element.Read("yawAtDeparture_deg", leg.YawAtDeparture);
  this->ReadTrajectory(element, leg.Trajectory);
}

//------------------------------------------------------------------------------
void LegReader::ReadTrajectory(const XmlElement& element, TrajectoryFileData& trajectory)
{
  std::string file;
  if (element.Read("trajectory", file))
  {
    trajectory.Where = element.Where();
    trajectory.File =
      this->Files.FindFile({ "trajectory", file, element.Where() }, element.GetDocument());
  }
  element.ReadAsWritten("trajectory_seperator", trajectory.Separator);
  element.ReadAsWritten("trajectory_separator", trajectory.Separator);
  for (int k = 0; k < 7; ++k)
  {
    element.Read(ColumnNames[k], trajectory.Columns[k]);
  }
  bool isInDegrees = !trajectory.IsInRadians;
  element.Read("toRadians", isInDegrees);
  trajectory.IsInRadians = !isInDegrees;
  std::string domain;
  if (element.Read("interpolationDomain", domain))
  {
    trajectory.HasAttitude = domain != "position";
    if (domain != "position" && domain != "position_and_attitude")
    {
      element.GetMessages().Error(element.Where() + ": interpolationDomain=\"" + domain +
        "\" is not valid: expected position or position_and_attitude");
    }
  }
  element.Read("syncGPSTime", trajectory.KeepsTime);
  element.Read("slopeFilterThreshold", trajectory.SlopeThreshold);
  element.Read("tStart", trajectory.StartTime);
  element.Read("tEnd", trajectory.EndTime);
  element.Read("teleportToStart", trajectory.TeleportsToStart);
}

//------------------------------------------------------------------------------
void LegReader::ReadScannerSettings(const XmlElement& element, LegSettings& settings, int depth)
{
  element.CheckNames();
  if (const XmlElement base = this->FindTemplate(element, depth))
  {
    this->ReadScannerSettings(base, settings, depth + 1);
  }
  LegData& leg = settings.Leg;
  ScanData& scan = settings.Scan;
  element.Read("active", leg.Active);
  element.Read("pulseFreq_hz", settings.PulseFrequency);
  element.Read("scanFreq_hz", settings.ScanFrequency);
  element.Read("scanAngle_deg", settings.ScanAngle);
  element.Read("verticalAngleMin_deg", settings.VerticalAngleMin);
  element.Read("verticalAngleMax_deg", settings.VerticalAngleMax);
  element.Read("headRotatePerSec_deg", scan.HeadRotateSpeed);
  element.Read("headRotateStart_deg", scan.HeadRotateStart);
  element.Read("headRotateStop_deg", scan.HeadRotateStop);
  element.Read("beamDivergenceRad", settings.BeamDivergence);
  element.Read("beamDivergence_rad", settings.BeamDivergence);
  element.Read("trajectoryTimeInterval_s", leg.TrajectoryTimeInterval);
  element.Read("maxDuration_s", leg.MaximumDuration);
  element.Read("verticalResolution_deg", settings.VerticalResolution);
  element.Read("horizontalResolution_deg", settings.HorizontalResolution);
  element.Read("opticsWarmupPhase_s", scan.WarmUpTime);
}

//------------------------------------------------------------------------------
XmlElement LegReader::FindTemplate(const XmlElement& element, int depth)
{
  if (!element.Has("template"))
  {
    return {};
  }
  if (depth < DeepestTemplate)
  {
    return this->Files.FindElement(element.GetTag().c_str(), element, "template");
  }
  element.GetMessages().Error(element.Where() + ": template=\"" + element.GetText("template") +
    "\" refers back to itself; remove the template of the last one");
  return {};
}

/// The strip of a leg, as a part of file names.
std::string ReadStrip(const XmlElement& leg)
{
  const std::string strip = leg.GetText("stripId");
  if (strip.find_first_of("/\\") != std::string::npos)
  {
    leg.GetMessages().Error(leg.Where() + ": stripId=\"" + strip +
      "\" is not valid in a file name; give one without / and \\");
  }
  return strip;
}

} // namespace

//------------------------------------------------------------------------------
LegSettings ReadLeg(const XmlElement& leg, LegSettings settings, Assets& files)
{
  leg.CheckNames();
  settings.Leg.Where = leg.Where();
  settings.Leg.Strip = ReadStrip(leg);
  leg.ReadVector(settings.Leg.Position);
  LegReader reader(files);
  if (const XmlElement platform = leg.GetChild("platformSettings"))
  {
    reader.ReadPlatformSettings(platform, settings);
  }
  if (const XmlElement scanner = leg.GetChild("scannerSettings"))
  {
    settings.Leg.Where = scanner.Where();
    reader.ReadScannerSettings(scanner, settings);
  }
  leg.Read("maxDuration_s", settings.Leg.MaximumDuration);
  return settings;
}

//------------------------------------------------------------------------------
LegSettings ReadScannerSettings(const XmlElement& element, Assets& files)
{
  LegSettings settings;
  settings.Leg.Where = element.Where();
  LegReader(files).ReadScannerSettings(element, settings);
  return settings;
}

//------------------------------------------------------------------------------
void CheckTemplates(const XmlElement& root, Assets& files)
{
  LegReader reader(files);
  for (const XmlElement& settings : root.GetChildren("platformSettings"))
  {
    LegSettings scratch;
    reader.ReadPlatformSettings(settings, scratch);
  }
  for (const XmlElement& settings : root.GetChildren("scannerSettings"))
  {
    LegSettings scratch;
    reader.ReadScannerSettings(settings, scratch);
  }
}

} // namespace helios
