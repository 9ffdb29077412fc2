// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosLegSettings.h"

#include "heliosLegOptics.h"
#include "heliosMessages.h"

#include <algorithm>
#include <cmath>

namespace helios
{

namespace
{

/// The longest leg [s]: beyond it a head practically never stops.
constexpr double LongestLeg = 1e9;

/// Resolves one leg, step by step; a step that fails has reported why.
class LegResolver
{
public:
  LegResolver(const LegSettings& settings, const SurveyData& survey, bool isLast, Messages& log)
    : Given(settings)
    , Scanner(survey.Scanner)
    , IsMoving(survey.IsMoving())
    , Fires(settings.Leg.Active && !(survey.IsMoving() && isLast))
    , IsLast(isLast)
    , Log(log)
    , Leg(settings.Leg)
  {
  }

  LegData Resolve();

private:
  void ResolvePulses();
  void ResolveScanAngles();
  void ResolveFrequencies();
  void ResolveScanProduct();
  void ResolveHead();
  void ResolveWarmUp();
  void ResolveTrajectory();
  void CheckUnused();
  void CheckWindow();
  void CheckScanFrequency();
  void CheckHead();
  void CheckSpeed();

  bool Has(Optics type) const { return this->Scanner.Type == type; }

  bool HasResolution() const
  {
    return this->Given.VerticalResolution != 0.0 || this->Given.HorizontalResolution != 0.0;
  }

  /// Messages are about legs that fire; the others are only passed through.
  void Error(const Sentence& text);
  void Warning(const Sentence& text);

  const LegSettings& Given;
  const ScannerData& Scanner;
  bool IsMoving;
  bool Fires;
  bool IsLast;
  Messages& Log;
  LegData Leg;
};

//------------------------------------------------------------------------------
LegData LegResolver::Resolve()
{
  this->Leg.BeamDivergence = std::isnan(this->Given.BeamDivergence) ? this->Scanner.BeamDivergence
                                                                    : this->Given.BeamDivergence;
  this->ResolvePulses();
  this->ResolveScanAngles();
  this->ResolveFrequencies();
  this->ResolveScanProduct();
  this->ResolveHead();
  this->ResolveWarmUp();
  this->ResolveTrajectory();
  this->CheckUnused();
  this->CheckSpeed();
  return this->Leg;
}

//------------------------------------------------------------------------------
void LegResolver::ResolvePulses()
{
  const std::vector<double>& offered = this->Scanner.PulseFrequencies;
  this->Leg.PulseFrequency = this->Given.PulseFrequency;
  Sentence text;
  if (std::isnan(this->Given.PulseFrequency) && offered.empty())
  {
    text << "no pulse frequency: give pulseFreq_hz here, or pulseFreqs_Hz for scanner "
         << this->Scanner.Id;
    this->Leg.PulseFrequency = 1.0;
    this->Error(text);
  }
  else if (std::isnan(this->Given.PulseFrequency))
  {
    this->Leg.PulseFrequency = offered.front();
  }
  else if (!offered.empty() &&
    std::find(offered.begin(), offered.end(), this->Given.PulseFrequency) == offered.end())
  {
    text << "pulseFreq_hz=\"" << this->Given.PulseFrequency << "\" is none of scanner "
         << this->Scanner.Id << " and used all the same; it offers";
    for (const double frequency : offered)
    {
      text << ' ' << frequency;
    }
    this->Warning(text);
  }
}

//------------------------------------------------------------------------------
void LegResolver::ResolveScanAngles()
{
  const bool isGiven = this->Given.ScanAngle > 0.0; // false for NaN
  const bool isLimited = this->Scanner.ScanAngleMax > 0.0;
  const double most = isLimited ? this->Scanner.ScanAngleMax : std::max(0.0, this->Given.ScanAngle);
  this->Leg.ScanAngle = isGiven ? std::min(this->Given.ScanAngle, most) : most;
  if (isGiven && this->Given.ScanAngle > most)
  {
    Sentence text;
    text << "scanAngle_deg=\"" << this->Given.ScanAngle << "\" is clipped to " << most
         << ", scanAngleMax_deg of scanner " << this->Scanner.Id;
    this->Warning(text);
  }
  if (this->Has(Optics::OscillatingMirror) && !isGiven && !isLimited)
  {
    Sentence text;
    text << "no scan angle: give scanAngle_deg here, or scanAngleMax_deg for scanner "
         << this->Scanner.Id;
    this->Error(text);
  }
  const double effective =
    this->Scanner.ScanAngleEffectiveMax > 0.0 ? this->Scanner.ScanAngleEffectiveMax : most;
  const double half = std::min(effective, this->Leg.ScanAngle);
  const double low = this->Given.VerticalAngleMin;
  const double high = this->Given.VerticalAngleMax;
  this->Leg.VerticalAngleMin = std::isnan(low) ? -half : low;
  this->Leg.VerticalAngleMax = std::isnan(high) ? half : high;
  this->CheckWindow();
}

//------------------------------------------------------------------------------
void LegResolver::CheckWindow()
{
  const double effective = this->Scanner.ScanAngleEffectiveMax > 0.0
    ? this->Scanner.ScanAngleEffectiveMax
    : this->Scanner.ScanAngleMax;
  const double low = this->Leg.VerticalAngleMin;
  const double high = this->Leg.VerticalAngleMax;
  Sentence text;
  text << "verticalAngleMin_deg=\"" << low << "\" to verticalAngleMax_deg=\"" << high << "\" ";
  if (this->Has(Optics::RotatingMirror) && !(low < high))
  {
    text << "is no window; give a smaller one first";
    this->Error(text);
  }
  else if (this->Has(Optics::RotatingMirror) && high - low > 2.0 * effective * (1 + 1e-12))
  {
    text << "is wider than the " << 2.0 * effective << " deg of scanner " << this->Scanner.Id
         << " (twice its scanAngleEffectiveMax_deg); give a narrower window";
    this->Error(text);
  }
}

//------------------------------------------------------------------------------
void LegResolver::ResolveFrequencies()
{
  this->Leg.ScanFrequency = this->Given.ScanFrequency;
  if (this->HasResolution() && this->Has(Optics::RotatingMirror))
  {
    this->Leg.ScanFrequency = this->Leg.PulseFrequency * this->Given.VerticalResolution /
      (2.0 * this->Scanner.ScanAngleMax);
    this->Leg.HeadRotateSpeed = this->Given.HorizontalResolution * this->Leg.ScanFrequency;
    if (this->Given.VerticalResolution == 0.0)
    {
      Sentence text;
      text << "horizontalResolution_deg=\"" << this->Given.HorizontalResolution
           << "\" needs verticalResolution_deg beside it; add it";
      this->Error(text);
    }
  }
  if (!this->Has(Optics::FiberArray) && !this->Has(Optics::RisleyPrisms))
  {
    this->CheckScanFrequency();
  }
}

//------------------------------------------------------------------------------
void LegResolver::ResolveScanProduct()
{
  const double frequency = this->Leg.ScanFrequency;
  const double asked = this->Leg.ScanAngle;
  if (!this->Has(Optics::OscillatingMirror) || !(asked * frequency > this->Scanner.ScanProduct))
  {
    return;
  }
  this->Leg.ScanAngle = this->Scanner.ScanProduct / frequency;
  Sentence text;
  text << "a scan angle of " << asked << " deg is clipped to " << this->Leg.ScanAngle
       << " deg, since scanProduct=\"" << this->Scanner.ScanProduct << "\" of scanner "
       << this->Scanner.Id << " allows no more at scanFreq_hz=\"" << frequency << "\"";
  this->Warning(text);
}

//------------------------------------------------------------------------------
void LegResolver::CheckScanFrequency()
{
  const double frequency = this->Leg.ScanFrequency;
  const double least = this->Scanner.ScanFrequencyMin;
  const double most = this->Scanner.ScanFrequencyMax;
  const bool isLow = frequency < least;
  const bool isHigh = most != 0.0 && frequency > most * (1.0 + 1e-9);
  if (this->Has(Optics::OscillatingMirror) && frequency == 0.0)
  {
    Sentence text;
    text << "scanFreq_hz is missing or 0, so that the mirror of scanner " << this->Scanner.Id
         << " stands still; give how often it swings to and fro a second [Hz]";
    this->Error(text);
  }
  else if (isLow || isHigh)
  {
    Sentence text;
    text << (this->HasResolution() ? "the scan frequency that the resolution asks for, "
                                   : "scanFreq_hz=\"")
         << frequency << (this->HasResolution() ? " Hz," : "\"") << " is "
         << (isLow ? "below scanFreqMin_Hz=\"" : "above scanFreqMax_Hz=\"")
         << (isLow ? least : most) << "\" of scanner " << this->Scanner.Id << "; give "
         << (isLow ? "a higher one" : "a lower one");
    this->Error(text);
  }
}

//------------------------------------------------------------------------------
void LegResolver::ResolveHead()
{
  const double most = this->Scanner.HeadRotateSpeedMax;
  const double asked = this->Leg.HeadRotateSpeed;
  this->Leg.HeadRotateSpeed = std::clamp(asked, -most, most);
  if (this->Leg.HeadRotateSpeed != asked)
  {
    Sentence text;
    text << "headRotatePerSec_deg=\"" << asked << "\" is clipped to " << this->Leg.HeadRotateSpeed
         << ", from headRotatePerSecMax_deg=\"" << most << "\" of scanner " << this->Scanner.Id;
    this->Warning(text);
  }
  this->CheckHead();
}

//------------------------------------------------------------------------------
void LegResolver::CheckHead()
{
  const double time = this->Leg.GetHeadTime();
  const bool turns = this->Leg.HeadRotateSpeed != 0.0;
  const bool isEndless = !turns || std::abs(time) > LongestLeg;
  Sentence text;
  text << "the head turns from headRotateStart_deg=\"" << this->Leg.HeadRotateStart
       << "\" to headRotateStop_deg=\"" << this->Leg.HeadRotateStop
       << "\" with headRotatePerSec_deg=\"" << this->Leg.HeadRotateSpeed << "\" ";
  if (turns && time < 0.0)
  {
    text << "and never gets there; exchange start and stop, or the sign of the speed";
    this->Error(text);
  }
  else if (!this->IsMoving && isEndless && this->Leg.MaximumDuration < 0.0)
  {
    text << "on a platform that stands: the leg never ends; give a speed, or maxDuration_s";
    this->Error(text);
  }
  else if (!this->IsMoving && turns && time == 0.0)
  {
    text << "and is there at once: the leg lasts no time; give another stop";
    this->Error(text);
  }
}

//------------------------------------------------------------------------------
void LegResolver::ResolveWarmUp()
{
  const double before = this->Leg.GetHeadTime();
  const double turn = this->Leg.HeadRotateSpeed * this->Leg.WarmUpTime;
  if (!this->IsMoving && before > 0.0 && this->Leg.WarmUpTime >= before)
  {
    Sentence text;
    text << "opticsWarmupPhase_s=\"" << this->Leg.WarmUpTime << "\" turns the head by " << turn
         << " deg, to headRotateStop_deg=\"" << this->Leg.HeadRotateStop
         << "\" and beyond, before a pulse leaves; give less than " << before << " s";
    this->Error(text);
  }
  // On a platform that moves, only where the head looks counts, not how it got there.
  this->Leg.HeadRotateStart += this->IsMoving ? std::fmod(turn, 360.0) : turn;
}

//------------------------------------------------------------------------------
void LegResolver::ResolveTrajectory()
{
  const double asked = this->Leg.TrajectoryTimeInterval;
  const double least = 1.0 / this->Leg.PulseFrequency;
  if (asked > 0.0 && asked < least)
  {
    this->Leg.TrajectoryTimeInterval = least;
    Sentence text;
    text << "trajectoryTimeInterval_s=\"" << asked << "\" is shorter than from pulse to pulse; "
         << least << " s is used";
    this->Warning(text);
  }
}

//------------------------------------------------------------------------------
void LegResolver::CheckUnused()
{
  const bool isRotating = this->Has(Optics::RotatingMirror);
  const bool hasPrisms = this->Has(Optics::RisleyPrisms);
  const bool hasWindow =
    !std::isnan(this->Given.VerticalAngleMin) || !std::isnan(this->Given.VerticalAngleMax);
  const bool ownsFrequency = hasPrisms || this->Has(Optics::FiberArray);
  const auto warn = [this](const char* names, bool isUnused)
  {
    Sentence text;
    text << names << " not used by " << GetOpticsName(this->Scanner.Type) << " optics";
    if (isUnused)
    {
      this->Warning(text);
    }
  };
  warn("verticalResolution_deg and horizontalResolution_deg are",
    !isRotating && this->HasResolution());
  warn("verticalAngleMin_deg and verticalAngleMax_deg are", !isRotating && hasWindow);
  warn("scanAngle_deg is", hasPrisms && this->Given.ScanAngle > 0.0);
  warn("scanFreq_hz is", ownsFrequency && this->Given.ScanFrequency > 0.0);
}

//------------------------------------------------------------------------------
void LegResolver::CheckSpeed()
{
  if (this->IsMoving && !this->IsLast && !(this->Leg.Speed > 0.0))
  {
    Sentence text;
    text << this->Leg.Where << ": movePerSec_m=\"" << this->Leg.Speed
         << "\": the platform never reaches the next leg; give a speed above 0 [m/s]";
    this->Log.Error(text.str());
  }
}

//------------------------------------------------------------------------------
void LegResolver::Error(const Sentence& text)
{
  if (this->Fires)
  {
    this->Log.Error(this->Leg.Where + ": " + text.str());
  }
}

//------------------------------------------------------------------------------
void LegResolver::Warning(const Sentence& text)
{
  if (this->Fires)
  {
    this->Log.WarnOnce(text.str(), this->Leg.Where + ": " + text.str());
  }
}

/// A scanner that can do all that a leg asks of it.
ScannerData MakeAbleScanner(const LegSettings& leg, Optics type)
{
  const double least = std::numeric_limits<double>::min();
  ScannerData scanner;
  scanner.Type = type;
  scanner.PulseFrequencies = { std::isnan(leg.PulseFrequency) ? 1.0 : leg.PulseFrequency };
  scanner.ScanAngleMax = 360.0;
  scanner.ScanAngleEffectiveMax = 360.0;
  scanner.HeadRotateSpeedMax = std::max(std::abs(leg.Leg.HeadRotateSpeed), least);
  scanner.ScanProduct = std::numeric_limits<double>::infinity();
  return scanner;
}

} // namespace

//------------------------------------------------------------------------------
void CheckLegAlone(
  const LegSettings& settings, bool isLast, const SurveyData& survey, Messages& log)
{
  SurveyData able;
  able.Scanner = MakeAbleScanner(settings, survey.Scanner.Type);
  able.Platform = survey.Platform;
  AddLeg(settings, isLast, able, log);
}

//------------------------------------------------------------------------------
void AddLeg(const LegSettings& settings, bool isLast, SurveyData& survey, Messages& log)
{
  survey.Legs.push_back(LegResolver(settings, survey, isLast, log).Resolve());
}

} // namespace helios
