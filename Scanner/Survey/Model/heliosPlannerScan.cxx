// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPlannerScan.h"

#include "heliosMessages.h"

#include <algorithm>
#include <cmath>

namespace helios
{

namespace
{

constexpr double DefaultResolution = 0.1; // [deg]
constexpr double FullCircle = 360.0;

/// Returns the scan frequency [Hz] at which pulses of a line are at the resolution.
double FindScanFrequency(const ScannerData& scanner, double pulseFrequency, double resolution)
{
  const bool isLimited = scanner.ScanFrequencyMax > 0.0;
  const double maximum =
    isLimited ? scanner.ScanFrequencyMax : std::numeric_limits<double>::infinity();
  const bool isRotating = scanner.Type == Optics::RotatingMirror && scanner.ScanAngleMax > 0.0;
  const double wanted =
    isRotating ? pulseFrequency * resolution / (2.0 * scanner.ScanAngleMax) : maximum;
  return std::isfinite(wanted) ? std::clamp(wanted, scanner.ScanFrequencyMin, maximum) : 0.0;
}

/// Completes settings that are not given.
void CompleteSettings(
  const ScannerData& scanner, const PlannerRequest& request, LegSettings& settings)
{
  ScanData& scan = settings.Scan;
  settings.PulseFrequency =
    request.PulseFrequency > 0.0 ? request.PulseFrequency : settings.PulseFrequency;
  const double pulseFrequency =
    std::isnan(settings.PulseFrequency) && !scanner.PulseFrequencies.empty()
    ? scanner.PulseFrequencies.front()
    : settings.PulseFrequency;
  if (scan.HeadRotateStart == scan.HeadRotateStop)
  {
    scan.HeadRotateStop = scan.HeadRotateStart + FullCircle;
  }
  const bool isAsked = request.Resolution > 0.0;
  const double resolution = isAsked ? request.Resolution : DefaultResolution;
  const bool hasResolution =
    settings.VerticalResolution != 0.0 || settings.HorizontalResolution != 0.0;
  if (isAsked || (!hasResolution && std::isnan(settings.ScanFrequency)))
  {
    settings.VerticalResolution = 0.0;
    settings.HorizontalResolution = 0.0;
    settings.ScanFrequency = FindScanFrequency(scanner, pulseFrequency, resolution);
    scan.HeadRotateSpeed = 0.0;
  }
  if (scan.HeadRotateSpeed == 0.0 && settings.VerticalResolution == 0.0)
  {
    const double wanted = settings.ScanFrequency > 0.0 ? resolution * settings.ScanFrequency
                                                       : scanner.HeadRotateSpeedMax;
    scan.HeadRotateSpeed = std::copysign(
      std::min(wanted, scanner.HeadRotateSpeedMax), scan.HeadRotateStop - scan.HeadRotateStart);
  }
}

/// Computes the elevations in the window of a vertical polygon mirror; false for other scanners.
bool FindElevations(const PlannerData& data, double& low, double& high)
{
  const ScannerData& scanner = data.Survey.Scanners.front();
  const ScanData& scan = data.Survey.Legs.front().Scans.front();
  const Vec3 axis =
    Rotate(data.Survey.Platforms.front().Mount.Orientation, scanner.HeadRotateAxis.Normalized());
  const Vec3 side = Rotate(scanner.Beam.Orientation, { 1.0, 0.0, 0.0 });
  const bool isVertical = std::abs(axis[2] - 1.0) < 1e-9 && std::abs(side[0] - 1.0) < 1e-9;
  low = std::max(-90.0, scan.VerticalAngleMin);
  high = std::min(90.0, scan.VerticalAngleMax);
  return isVertical && scanner.Type == Optics::RotatingMirror && scanner.GetNumberOfChannels() == 1;
}

void SetIfNotGiven(double& target, double value)
{
  target = std::isnan(target) ? value : target;
}

} // namespace

//------------------------------------------------------------------------------
Vec3 FindInstrument(const PlatformData& platform, const ScannerData& scanner)
{
  const Vec3 axis = scanner.HeadRotateAxis.Normalized();
  const Vec3 onAxis = axis * scanner.Beam.Position.Dot(axis);
  return platform.Mount.Position + Rotate(platform.Mount.Orientation, onAxis);
}

//------------------------------------------------------------------------------
LegSettings MakeSettings(const ScanData& scan)
{
  LegSettings settings;
  settings.PulseFrequency = scan.PulseFrequency;
  settings.ScanFrequency = scan.ScanFrequency;
  settings.ScanAngle = scan.ScanAngle;
  settings.VerticalAngleMin = scan.VerticalAngleMin;
  settings.VerticalAngleMax = scan.VerticalAngleMax;
  settings.BeamDivergence = scan.BeamDivergence;
  settings.Scan.HeadRotateSpeed = std::abs(scan.HeadRotateSpeed);
  settings.Scan.WarmUpTime = scan.WarmUpTime;
  return settings;
}

//------------------------------------------------------------------------------
bool ResolveScan(
  LegSettings settings, const PlannerRequest& request, PlannerData& data, Messages& log)
{
  const ScannerData& scanner = data.Survey.Scanners.front();
  if (scanner.HeadRotateSpeedMax <= 0.0)
  {
    log.Error(scanner.Where + ": scanner " + scanner.Id +
      " has a head that does not rotate (headRotatePerSecMax_deg is 0), so it does not cover a "
      "full circle; give another scanner");
    return false;
  }
  CompleteSettings(scanner, request, settings);
  const int before = log.GetNumberOfErrors();
  data.Survey.Legs = { settings.Leg };
  ResolveLeg(settings, 0, data.Survey, log);
  return log.GetNumberOfErrors() == before;
}

//------------------------------------------------------------------------------
void ResolveLimits(PlannerData& data, Messages& log)
{
  PlannerSettings& settings = data.Settings;
  if (settings.HasScannerLimits)
  {
    const ScannerData& scanner = data.Survey.Scanners.front();
    SetIfNotGiven(settings.RangeMin, scanner.Receiver.RangeMin);
    SetIfNotGiven(settings.RangeMax, scanner.Receiver.RangeMax);
    double low = 0.0;
    double high = 0.0;
    if (FindElevations(data, low, high))
    {
      SetIfNotGiven(settings.ElevationMin, low);
      SetIfNotGiven(settings.ElevationMax, high);
    }
    else if (std::isnan(settings.ElevationMin) || std::isnan(settings.ElevationMax))
    {
      log.Warning(scanner.Where + ": scanner " + scanner.Id +
        " is not a vertical polygon mirror with one channel: its field of view does not limit the "
        "visibility; give elevationMin_deg and elevationMax_deg");
    }
  }
  SetIfNotGiven(settings.RangeMin, 0.0);
  SetIfNotGiven(settings.RangeMax, VTK_DOUBLE_MAX);
  SetIfNotGiven(settings.ElevationMin, -90.0);
  SetIfNotGiven(settings.ElevationMax, 90.0);
}

} // namespace helios
