// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSurveyEdit.h"

#include "heliosMessages.h"
#include "heliosPlatformKind.h"
#include "heliosXmlValue.h"

#include <vtkMath.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace helios
{

using viewer::FindPlatformKind;
using viewer::IsOnGround;
using viewer::PlatformKind;

namespace
{

constexpr double FineResolution = 0.1;       // [deg], initial, of a static instrument
constexpr double UsualScanAngle = 30.0;      // [deg], half, from the air
constexpr double UsualScanFrequency = 100.0; // [Hz], without a limit of the instrument
constexpr double MaximumScanFrequency = 400.0;
constexpr double MaximumHeight = 3000.0; // [m]
constexpr double MaximumMast = 10.0;     // [m], of what drives
constexpr double MaximumSpeed = 100.0;   // [m/s]

/// Returns the half scan angle of emitted pulses [deg].
double FindHalfAngle(const ScannerData& scanner)
{
  const double angle =
    scanner.ScanAngleEffectiveMax > 0.0 ? scanner.ScanAngleEffectiveMax : scanner.ScanAngleMax;
  return angle > 0.0 ? angle : 90.0;
}

/// Returns the kind of a moving platform; one that nothing is known of is an aircraft.
PlatformKind FindKind(const SurveyEdit& edit)
{
  const PlatformKind kind = FindPlatformKind(edit.PlatformModel);
  return kind == PlatformKind::Unknown ? PlatformKind::Aircraft : kind;
}

/// The minimum height at which an instrument has returns [m]; what drives is on the ground.
double FindMinimumHeight(const SurveyEdit& edit)
{
  return IsOnGround(FindKind(edit)) ? 0.0 : std::max(1.0, edit.ScannerModel.Receiver.RangeMin);
}

double FindMaximumHeight(const SurveyEdit& edit)
{
  const double minimum = FindMinimumHeight(edit);
  return IsOnGround(FindKind(edit))
    ? MaximumMast
    : std::max(2.0 * minimum, std::min(edit.ScannerModel.Receiver.RangeMax, MaximumHeight));
}

/// Sets height, speed and scan angle as they are usual for a kind of platform.
void SetUsualMotion(SurveyEdit& edit)
{
  const PlatformKind kind = FindKind(edit);
  edit.Height = IsOnGround(kind) ? 0.0 : kind == PlatformKind::Multicopter ? 50.0 : 500.0;
  edit.Settings.Leg.Speed = kind == PlatformKind::Person ? 1.2
    : kind == PlatformKind::Tractor                      ? 2.0
    : kind == PlatformKind::Car                          ? 10.0
    : kind == PlatformKind::Multicopter                  ? 5.0
                                                         : 60.0;
}

bool HasWindow(const SurveyEdit& edit)
{
  return !edit.IsMoving() && edit.ScannerModel.Type == Optics::RotatingMirror;
}

bool HasScanAngle(const SurveyEdit& edit)
{
  const Optics type = edit.ScannerModel.Type;
  return edit.IsMoving() && type != Optics::RisleyPrisms && type != Optics::SpinningChannels;
}

bool HasScanFrequency(const ScannerData& scanner)
{
  return scanner.Type != Optics::RisleyPrisms && scanner.Type != Optics::FiberArray;
}

double FindMaximumScanFrequency(const ScannerData& scanner)
{
  return scanner.ScanFrequencyMax > 0.0 ? scanner.ScanFrequencyMax : MaximumScanFrequency;
}

/// Returns the storage of a number; null: none.
double* FindNumber(LegSettings& settings, const std::string& name)
{
  const std::pair<const char*, double*> all[] = { { "headStart", &settings.Scan.HeadRotateStart },
    { "headStop", &settings.Scan.HeadRotateStop }, { "headSpeed", &settings.Scan.HeadRotateSpeed },
    { "verticalMin", &settings.VerticalAngleMin }, { "verticalMax", &settings.VerticalAngleMax },
    { "scanAngle", &settings.ScanAngle }, { "pulseFrequency", &settings.PulseFrequency },
    { "scanFrequency", &settings.ScanFrequency }, { "speed", &settings.Leg.Speed } };
  for (const auto& number : all)
  {
    if (name == number.first)
    {
      return number.second;
    }
  }
  return nullptr;
}

double* FindNumber(SurveyEdit& edit, const std::string& name)
{
  return name == "height" ? &edit.Height
    : name == "overlap"   ? &edit.Overlap
                          : FindNumber(edit.Settings, name);
}

/// Returns the nearest valid value of a range.
double Limit(const EditRange& range, double value)
{
  if (range.Choices.empty())
  {
    return std::clamp(value, range.Low, range.High);
  }
  const auto isNearer = [value](double a, double b)
  { return std::abs(a - value) < std::abs(b - value); };
  return *std::min_element(range.Choices.begin(), range.Choices.end(), isNearer);
}

/// Adds the change of a number to the text.
void AddChange(const EditRange& range, double asked, double given, MessageBuilder& text)
{
  if (asked != given && !std::isnan(asked))
  {
    text << (text.str().empty() ? "" : "; ") << range.Label << " " << asked << " " << range.Unit
         << " becomes " << given << " " << range.Unit;
    range.Choices.empty() ? text << " (" << range.Low << " to " << range.High << ")"
                          : text << ", which the instrument supports";
  }
}

void LimitNumbers(const SurveyEdit& edit, LegSettings& settings, MessageBuilder& text)
{
  for (const EditRange& range : FindRanges(edit))
  {
    if (double* number = FindNumber(settings, range.Name))
    {
      const double given = Limit(range, std::isnan(*number) ? range.Low : *number);
      AddChange(range, *number, given, text);
      *number = given;
    }
  }
}

/// Makes the head stop after its start.
void LimitHead(LegSettings& settings, MessageBuilder& text)
{
  ScanData& scan = settings.Scan;
  if (!(scan.HeadRotateStop >= scan.HeadRotateStart + 1.0))
  {
    scan.HeadRotateStart = std::min(scan.HeadRotateStart, 359.0);
    scan.HeadRotateStop = scan.HeadRotateStart + 1.0;
    text << (text.str().empty() ? "" : "; ") << "the head rotates by at least 1 deg, to "
         << scan.HeadRotateStop << " deg";
  }
}

/// Limits a window to that of the mirror, and makes it non-empty.
void LimitWindow(const ScannerData& scanner, LegSettings& settings, MessageBuilder& text)
{
  const double widest = 2.0 * FindHalfAngle(scanner);
  const double low = settings.VerticalAngleMin;
  const double high = settings.VerticalAngleMax;
  settings.VerticalAngleMax = std::clamp(high, std::min(low + 1.0, 180.0), low + widest);
  if (settings.VerticalAngleMax != high)
  {
    text << (text.str().empty() ? "" : "; ") << "the window of 1 to " << widest << " deg ends at "
         << settings.VerticalAngleMax << " deg";
  }
}

/// Limits the scan angle of an oscillating mirror by its frequency.
void LimitSwing(const ScannerData& scanner, LegSettings& settings, MessageBuilder& text)
{
  const double maximum = scanner.ScanProduct / settings.ScanAngle;
  if (settings.ScanFrequency > maximum)
  {
    settings.ScanFrequency = maximum;
    text << (text.str().empty() ? "" : "; ") << "scan frequency is " << maximum
         << " Hz at most with this scan angle";
  }
}

/// Returns the initial settings of an instrument.
LegSettings MakeUsualSettings(const SurveyEdit& edit)
{
  const ScannerData& scanner = edit.ScannerModel;
  LegSettings settings;
  settings.Leg.Speed = edit.Settings.Leg.Speed;
  settings.PulseFrequency =
    scanner.PulseFrequencies.empty() ? LegSettings::NotGiven : scanner.PulseFrequencies.front();
  const double half = FindHalfAngle(scanner);
  if (HasScanFrequency(scanner))
  {
    const double wanted = edit.IsMoving() || std::isnan(settings.PulseFrequency)
      ? UsualScanFrequency
      : settings.PulseFrequency * FineResolution / (2.0 * half);
    settings.ScanFrequency =
      std::clamp(wanted, scanner.ScanFrequencyMin, FindMaximumScanFrequency(scanner));
  }
  if (HasScanAngle(edit))
  {
    settings.ScanAngle = IsOnGround(FindKind(edit)) ? half : std::min(half, UsualScanAngle);
  }
  if (HasWindow(edit))
  {
    settings.VerticalAngleMin = -std::min(half, 90.0);
    settings.VerticalAngleMax = std::min(half, 90.0);
  }
  if (!edit.IsMoving())
  {
    const double speed = HasScanFrequency(scanner) ? FineResolution * settings.ScanFrequency : 10.0;
    settings.Scan.HeadRotateSpeed = std::min(speed, scanner.HeadRotateSpeedMax);
    settings.Scan.HeadRotateStop = 360.0;
  }
  return settings;
}

/// Sets the position of a leg from its ground point.
void Place(const SurveyEdit& edit, EditLeg& leg)
{
  LegData& data = leg.Settings.Leg;
  data.Position[2] = RoundComputed(leg.Ground + (edit.IsMoving() ? edit.Height : 0.0));
  data.OnGround = data.OnGround && !edit.IsMoving();
}

/// Updates the edit after a change of the platform or a number.
void Follow(SurveyEdit& edit)
{
  edit.HasArea = edit.HasArea && edit.IsMoving();
  for (EditLeg& leg : edit.Legs)
  {
    Place(edit, leg);
  }
}

/// Resets every leg to the instrument's settings, except for its position.
void BeginAgain(SurveyEdit& edit)
{
  edit.Settings = MakeUsualSettings(edit);
  ClampSettings(edit, edit.Settings);
  for (EditLeg& leg : edit.Legs)
  {
    const LegData where = leg.Settings.Leg;
    leg.Settings = edit.Settings;
    leg.Settings.Leg = where;
    leg.Settings.Leg.Active = true;
  }
  Follow(edit);
}

void LimitHeight(SurveyEdit& edit)
{
  edit.Height = std::clamp(edit.Height, FindMinimumHeight(edit), FindMaximumHeight(edit));
}

} // namespace

//------------------------------------------------------------------------------
void SetFlownHeight(SurveyEdit& edit, double height)
{
  edit.Height = std::max(0.0, RoundComputed(height));
  LimitHeight(edit);
  for (EditLeg& leg : edit.Legs)
  {
    leg.Ground = leg.Settings.Leg.Position[2] - edit.Height;
  }
}

//------------------------------------------------------------------------------
std::vector<EditRange> FindRanges(const SurveyEdit& edit)
{
  const ScannerData& scanner = edit.ScannerModel;
  std::vector<EditRange> ranges;
  if (HasWindow(edit))
  {
    ranges.push_back({ "verticalMin", "vertical FOV min", "deg", -90.0, 89.0, {} });
    ranges.push_back({ "verticalMax", "vertical FOV max", "deg", -89.0, 90.0, {} });
  }
  if (HasScanAngle(edit))
  {
    ranges.push_back({ "scanAngle", "scan angle", "deg", 1.0, FindHalfAngle(scanner), {} });
  }
  if (!edit.IsMoving())
  {
    ranges.push_back({ "headStart", "horizontal FOV start", "deg", 0.0, 359.0, {} });
    ranges.push_back({ "headStop", "horizontal FOV end", "deg", 1.0, 360.0, {} });
    const double maximum = scanner.HeadRotateSpeedMax;
    ranges.push_back(
      { "headSpeed", "rotation speed", "deg/s", std::min(0.1, maximum), maximum, {} });
  }
  if (scanner.PulseFrequencies.size() > 1)
  {
    std::vector<double> choices = scanner.PulseFrequencies;
    std::sort(choices.begin(), choices.end());
    ranges.push_back(
      { "pulseFrequency", "pulse frequency", "Hz", choices.front(), choices.back(), choices });
  }
  if (HasScanFrequency(scanner))
  {
    const double maximum = FindMaximumScanFrequency(scanner);
    const double minimum = std::min(maximum, std::max(1.0, scanner.ScanFrequencyMin));
    ranges.push_back({ "scanFrequency", "scan frequency", "Hz", minimum, maximum, {} });
  }
  if (edit.IsMoving())
  {
    ranges.push_back({ "height", "height above ground", "m", FindMinimumHeight(edit),
      FindMaximumHeight(edit), {} });
    ranges.push_back({ "speed", "speed", "m/s", 0.5, MaximumSpeed, {} });
    ranges.push_back({ "overlap", "strip overlap", "%", 0.0, 95.0, {} });
  }
  return ranges;
}

//------------------------------------------------------------------------------
double GetSetting(const SurveyEdit& edit, const std::string& name)
{
  SurveyEdit copy = edit;
  const double* number = FindNumber(copy, name);
  return number ? *number : std::numeric_limits<double>::quiet_NaN();
}

//------------------------------------------------------------------------------
std::string SetSetting(SurveyEdit& edit, const std::string& name, double value)
{
  const std::vector<EditRange> ranges = FindRanges(edit);
  const auto range = std::find_if(
    ranges.begin(), ranges.end(), [&name](const EditRange& one) { return one.Name == name; });
  if (range == ranges.end() || !std::isfinite(value))
  {
    return name + " is not a setting of " + edit.ScannerModel.Name + " on " +
      edit.PlatformModel.Name;
  }
  MessageBuilder text;
  const double given = Limit(*range, value);
  AddChange(*range, value, given, text);
  *FindNumber(edit, name) = given;
  std::string also = ClampSettings(edit, edit.Settings);
  for (EditLeg& leg : edit.Legs)
  {
    if (double* number = FindNumber(leg.Settings, name))
    {
      *number = given;
      ClampSettings(edit, leg.Settings);
    }
  }
  Follow(edit);
  return text.str() + (text.str().empty() || also.empty() ? "" : "; ") + also;
}

//------------------------------------------------------------------------------
std::string ClampSettings(const SurveyEdit& edit, LegSettings& settings)
{
  MessageBuilder text;
  LimitNumbers(edit, settings, text);
  if (!edit.IsMoving())
  {
    LimitHead(settings, text);
  }
  if (HasWindow(edit))
  {
    LimitWindow(edit.ScannerModel, settings, text);
  }
  if (HasScanAngle(edit) && edit.ScannerModel.Type == Optics::OscillatingMirror)
  {
    LimitSwing(edit.ScannerModel, settings, text);
  }
  return text.str();
}

//------------------------------------------------------------------------------
void ChoosePlatform(SurveyEdit& edit, const std::string& reference, const PlatformData& platform)
{
  const bool wasMoving = edit.IsMoving();
  const PlatformKind before = FindKind(edit);
  edit.Platform = reference;
  edit.PlatformModel = platform;
  const bool isSame = wasMoving == edit.IsMoving() && (!wasMoving || before == FindKind(edit));
  if (!isSame && edit.IsMoving())
  {
    SetUsualMotion(edit);
    LimitHeight(edit);
  }
  isSame ? Follow(edit) : BeginAgain(edit);
}

//------------------------------------------------------------------------------
void ChooseScanner(SurveyEdit& edit, const std::string& reference, const ScannerData& scanner)
{
  edit.Scanner = reference;
  edit.ScannerModel = scanner;
  LimitHeight(edit);
  BeginAgain(edit);
}

//------------------------------------------------------------------------------
void AddLeg(SurveyEdit& edit, const Vec3& place, bool onGround)
{
  edit.HasArea = false;
  EditLeg leg;
  leg.Settings = edit.Settings;
  edit.Legs.push_back(leg);
  MoveLeg(edit, edit.Legs.size() - 1, place, onGround);
}

//------------------------------------------------------------------------------
void MoveLeg(SurveyEdit& edit, std::size_t leg, const Vec3& place, bool onGround)
{
  if (leg < edit.Legs.size())
  {
    edit.HasArea = false;
    edit.Legs[leg].Ground = place[2];
    edit.Legs[leg].Settings.Leg.Position = RoundComputed(place);
    edit.Legs[leg].Settings.Leg.Crs.clear();
    edit.Legs[leg].Settings.Leg.OnGround = onGround;
    Place(edit, edit.Legs[leg]);
  }
}

//------------------------------------------------------------------------------
void RemoveLeg(SurveyEdit& edit, std::size_t leg)
{
  if (leg < edit.Legs.size())
  {
    edit.HasArea = false;
    edit.Legs.erase(edit.Legs.begin() + static_cast<std::ptrdiff_t>(leg));
  }
}

//------------------------------------------------------------------------------
void SetLines(SurveyEdit& edit, const std::vector<FlightLine>& lines)
{
  edit.Legs.clear();
  for (const FlightLine& line : lines)
  {
    for (const bool isStart : { true, false })
    {
      EditLeg leg;
      leg.Settings = edit.Settings;
      leg.Settings.Leg.Position = RoundComputed(isStart ? line.first : line.second);
      leg.Settings.Leg.Active = isStart;
      leg.Ground = leg.Settings.Leg.Position[2] - edit.Height;
      edit.Legs.push_back(leg);
      Place(edit, edit.Legs.back());
    }
  }
}

} // namespace helios
