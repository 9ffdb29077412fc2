// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosXmlScanner.h"

#include "heliosMessages.h"
#include "heliosXmlOptics.h"
#include "heliosXmlReceiver.h"

namespace helios
{

namespace
{

/// Catalogues count the detection threshold in nanowatts whatever its name says.
constexpr double WattsPerUnit = 1e-9;

Pose ReadPose(const XmlElement& element)
{
  Pose pose;
  if (element)
  {
    element.CheckNames();
    element.ReadVector(pose.Position);
    pose.Orientation = element.ReadRotation();
  }
  return pose;
}

void ReadHeadRotateAxis(const XmlElement& element, Vec3& axis)
{
  if (!element)
  {
    return;
  }
  element.CheckNames();
  Vec3 direction(0.0, 0.0, 0.0);
  element.ReadVector(direction);
  if (direction.Norm() > 0.1)
  {
    direction.Normalize();
    axis = direction;
    return;
  }
  element.GetMessages().Warning(element.Where() +
    ": <headRotateAxis> is shorter than 0.1 and not used; the head turns about 0 0 1");
}

void CheckChannels(const XmlElement& scanner)
{
  const XmlElement channels = scanner.GetChild("channels");
  if (channels)
  {
    scanner.GetMessages().Error(channels.Where() + ": scanner " + scanner.GetText("id") +
      ": <channels> come with a later version; use a scanner with a single channel");
  }
}

/// The numbers that are taken over as they are.
void ReadNumbers(const XmlElement& element, ScannerData& scanner)
{
  element.Read("pulseFreqs_Hz", scanner.PulseFrequencies);
  element.Read("pulseLength_ns", scanner.PulseLength);
  element.Read("beamDivergence_rad", scanner.BeamDivergence);
  element.Read("wavelength_nm", scanner.Wavelength);
  element.Read("averagePower_w", scanner.AveragePower);
  element.Read("opticalEfficiency", scanner.OpticalEfficiency);
  element.Read("receiverDiameter_m", scanner.ReceiverDiameter);
  element.Read("atmosphericVisibility_km", scanner.AtmosphericVisibility);
  element.Read("accuracy_m", scanner.Accuracy);
  element.Read("rangeMin_m", scanner.RangeMin);
  element.Read("rangeMax_m", scanner.RangeMax);
  element.Read("maxNOR", scanner.MaximumNumberOfReturns);
  element.Read("scanAngleMax_deg", scanner.ScanAngleMax);
  element.Read("scanAngleEffectiveMax_deg", scanner.ScanAngleEffectiveMax);
  element.Read("scanFreqMin_Hz", scanner.ScanFrequencyMin);
  element.Read("scanFreqMax_Hz", scanner.ScanFrequencyMax);
  element.Read("headRotatePerSecMax_deg", scanner.HeadRotateSpeedMax);
}

} // namespace

//------------------------------------------------------------------------------
ScannerData ReadScanner(const XmlElement& element)
{
  ScannerData scanner;
  scanner.Where = element.Where();
  scanner.Id = element.GetText("id");
  scanner.Name = element.Has("name") ? element.GetText("name") : scanner.Id;
  element.CheckNames();
  ReadOptics(element, scanner);
  CheckChannels(element);
  ReadNumbers(element, scanner);
  double threshold = scanner.DetectionThreshold / WattsPerUnit;
  element.Read("receivedEnergyMin_W", threshold);
  scanner.DetectionThreshold = threshold * WattsPerUnit;
  ReadReceiver(element, scanner);
  scanner.Beam = ReadPose(element.GetChild("beamOrigin"));
  ReadHeadRotateAxis(element.GetChild("headRotateAxis"), scanner.HeadRotateAxis);
  return scanner;
}

//------------------------------------------------------------------------------
PlatformData ReadPlatform(const XmlElement& element)
{
  PlatformData platform;
  platform.Id = element.GetText("id");
  platform.Name = element.Has("name") ? element.GetText("name") : platform.Id;
  std::string type = "static";
  element.Read("type", type);
  if (type == "linearpath")
  {
    platform.Type = PlatformType::LinearPath;
  }
  else if (type == "groundvehicle" || type == "multicopter")
  {
    element.GetMessages().Error(element.Where() + ": platform " + platform.Id + ": type=\"" + type +
      "\" comes with a later version; those that exist now are static and linearpath");
  }
  else if (type != "static" && type != "dummy")
  {
    element.GetMessages().Error(element.Where() + ": platform " + platform.Id + ": type=\"" + type +
      "\" is none; give static or linearpath");
  }
  element.CheckNames();
  platform.Mount = ReadPose(element.GetChild("scannerMount"));
  return platform;
}

//------------------------------------------------------------------------------
void OverrideScanner(const XmlElement& survey, ScannerData& scanner)
{
  OverrideReceiver(survey, scanner);
}

//------------------------------------------------------------------------------
void CheckScanner(const ScannerData& scanner, Messages& log)
{
  CheckOptics(scanner, log);
  CheckReceiver(scanner, log);
  Sentence text;
  if (!(scanner.RangeMin < scanner.RangeMax))
  {
    text << "rangeMin_m=\"" << scanner.RangeMin << "\" is not below rangeMax_m=\""
         << scanner.RangeMax << "\"; no range is measured. Correct one of them";
  }
  if (!text.str().empty())
  {
    log.Error(scanner.Where + ": scanner " + scanner.Id + ": " + text.str());
  }
}

} // namespace helios
