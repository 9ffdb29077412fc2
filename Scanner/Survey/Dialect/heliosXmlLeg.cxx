// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosXmlLeg.h"

#include "heliosAssets.h"
#include "heliosMessages.h"

namespace helios
{

namespace
{

/// Reads the settings of one leg, after the settings of its templates.
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
  element.ReadStored(settings);
  this->ReadTrajectory(element, settings.Leg.Trajectory);
}

//------------------------------------------------------------------------------
void LegReader::ReadTrajectory(const XmlElement& element, TrajectoryFileData& trajectory)
{
  std::string file;
  if (element.Read("trajectory", file))
  {
    trajectory.Where = element.Where();
    trajectory.File = this->Files.Trajectories != AssetNeed::Replaced
      ? this->Files.FindFile(
          { "trajectory", file, element.Where("trajectory") }, element.GetDocument())
      : this->Files.FindPath(file, element.GetDocument());
  }
}

//------------------------------------------------------------------------------
void LegReader::ReadScannerSettings(const XmlElement& element, LegSettings& settings, int depth)
{
  element.CheckNames();
  if (const XmlElement base = this->FindTemplate(element, depth))
  {
    this->ReadScannerSettings(base, settings, depth + 1);
  }
  element.ReadStored(settings);
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
  element.GetMessages().Error(element.Where("template") + ": template=\"" +
    element.GetText("template") + "\" refers back to itself; remove the template of the last one");
  return {};
}

} // namespace

//------------------------------------------------------------------------------
LegSettings ReadLeg(const XmlElement& leg, LegSettings settings, Assets& files)
{
  leg.CheckNames();
  settings.Leg.Where = leg.Where();
  leg.ReadStored(settings);
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
