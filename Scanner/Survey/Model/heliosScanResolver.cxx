// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosScanResolver.h"

#include "heliosLegOptics.h"

#include <algorithm>
#include <cmath>

namespace helios
{

namespace
{

/// The longest leg [s]: a slower head rotation practically never ends.
constexpr double LongestLeg = 1e9;

/// The minor axis of an elliptical beam over the major one, at least (vtkHeliosBeamSampler).
constexpr double MinimumAxisRatio = 0.01;

} // namespace

//------------------------------------------------------------------------------
ScanData ScanResolver::Resolve()
{
  this->Scan.BeamDivergence = std::isnan(this->Given.BeamDivergence) ? this->Scanner.BeamDivergence
                                                                     : this->Given.BeamDivergence;
  this->ResolvePulses();
  this->CheckBeams();
  this->CheckEllipse();
  this->ResolveScanAngles();
  this->ResolveFrequencies();
  this->ResolveScanProduct();
  this->ResolveHead();
  this->ResolveWarmUp();
  this->CheckUnused();
  return this->Scan;
}

//------------------------------------------------------------------------------
void ScanResolver::ResolvePulses()
{
  const std::vector<double>& offered = this->Scanner.PulseFrequencies;
  this->Scan.PulseFrequency = this->Given.PulseFrequency;
  MessageBuilder text;
  if (std::isnan(this->Given.PulseFrequency) && offered.empty())
  {
    text << "no pulse frequency: give pulseFreq_hz here, or pulseFreqs_Hz for scanner "
         << this->Scanner.Id;
    this->Scan.PulseFrequency = 1.0;
    this->Error(text);
  }
  else if (std::isnan(this->Given.PulseFrequency))
  {
    this->Scan.PulseFrequency = offered.front();
  }
  else if (!offered.empty() &&
    std::find(offered.begin(), offered.end(), this->Given.PulseFrequency) == offered.end())
  {
    text << "pulseFreq_hz=\"" << this->Given.PulseFrequency << "\" is not supported by scanner "
         << this->Scanner.Id << " (supported: ";
    for (const double frequency : offered)
    {
      text << frequency << (frequency == offered.back() ? " Hz); used anyway" : ", ");
    }
    this->Warning(text);
  }
}

//------------------------------------------------------------------------------
/// Checks that a beam fires before the next cycle begins.
void ScanResolver::CheckBeams()
{
  const std::vector<BeamData>& beams = this->Scanner.Beams;
  const double cycle = static_cast<double>(beams.size()) / this->Scan.PulseFrequency;
  const auto late = std::find_if(
    beams.begin(), beams.end(), [cycle](const BeamData& beam) { return beam.FiringTime >= cycle; });
  if (this->Has(Optics::SpinningChannels) && late != beams.end())
  {
    MessageBuilder text;
    text << "beam " << late - beams.begin() << " of scanner " << this->Scanner.Id
         << " fires at firingTime_s=\"" << late->FiringTime << "\", after the cycle of " << cycle
         << " s that " << beams.size() << " beams have at pulseFreq_hz=\""
         << this->Scan.PulseFrequency << "\"; give a lower pulse frequency";
    this->Error(text);
  }
}

//------------------------------------------------------------------------------
/// Checks that the minor axis of an elliptical beam is not longer than the major one, nor much
/// shorter.
void ScanResolver::CheckEllipse()
{
  const double minor = this->Scanner.MinorBeamDivergence;
  const double major = this->Scanner.BeamDivergence;
  if (minor > 0.0 && !(minor <= major && minor >= MinimumAxisRatio * major))
  {
    MessageBuilder text;
    text << "beamDivergenceMinor_rad=\"" << minor << "\" of scanner " << this->Scanner.Id
         << " is not " << MinimumAxisRatio << " to 1 times its beamDivergence_rad=\"" << major
         << "\"; give the larger angle as beamDivergence_rad, and turn the beam by "
            "beamMajorAxis_deg";
    this->Error(text);
  }
}

//------------------------------------------------------------------------------
void ScanResolver::ResolveScanAngles()
{
  const bool isGiven = this->Given.ScanAngle > 0.0; // false for NaN
  const bool isLimited = this->Scanner.ScanAngleMax > 0.0;
  const double maximum =
    isLimited ? this->Scanner.ScanAngleMax : std::max(0.0, this->Given.ScanAngle);
  MessageBuilder asked;
  asked << "scanAngle_deg=\"" << this->Given.ScanAngle << "\"";
  this->Scan.ScanAngle = isGiven
    ? this->Clip(asked, this->Given.ScanAngle, { 0.0, "", maximum, "scanAngleMax_deg" })
    : maximum;
  if (this->Has(Optics::OscillatingMirror) && !isGiven && !isLimited)
  {
    MessageBuilder text;
    text << "no scan angle: give scanAngle_deg here, or scanAngleMax_deg for scanner "
         << this->Scanner.Id;
    this->Error(text);
  }
  const double effective =
    this->Scanner.ScanAngleEffectiveMax > 0.0 ? this->Scanner.ScanAngleEffectiveMax : maximum;
  const double half = std::min(effective, this->Scan.ScanAngle);
  const double low = this->Given.VerticalAngleMin;
  const double high = this->Given.VerticalAngleMax;
  this->Scan.VerticalAngleMin = std::isnan(low) ? -half : low;
  this->Scan.VerticalAngleMax = std::isnan(high) ? half : high;
  this->ResolveWindow();
}

//------------------------------------------------------------------------------
double ScanResolver::Clip(const MessageBuilder& asked, double value, const Limits& limits)
{
  const bool isLow = value < limits.Low;
  if (!isLow && !(value > limits.High * (1.0 + 1e-9)))
  {
    return value;
  }
  const double limit = isLow ? limits.Low : limits.High;
  MessageBuilder text;
  text << asked.str() << " is clipped to " << limit << ", "
       << (isLow ? limits.LowName : limits.HighName) << " of scanner " << this->Scanner.Id;
  this->Warning(text);
  return limit;
}

//------------------------------------------------------------------------------
/// Clips a window wider than the mirror's on the sides beyond it, and only by the excess.
void ScanResolver::ResolveWindow()
{
  const double effective = this->Scanner.ScanAngleEffectiveMax > 0.0
    ? this->Scanner.ScanAngleEffectiveMax
    : this->Scanner.ScanAngleMax;
  const double low = this->Scan.VerticalAngleMin;
  const double high = this->Scan.VerticalAngleMax;
  MessageBuilder text;
  text << "verticalAngleMin_deg=\"" << low << "\" to verticalAngleMax_deg=\"" << high << "\"";
  if (this->Has(Optics::RotatingMirror) && !(low < high))
  {
    text << " is not a valid window: the first must be smaller";
    this->Error(text);
  }
  const double width = 2.0 * effective;
  if (!this->Has(Optics::RotatingMirror) || !(high - low > width * (1 + 1e-12)))
  {
    return;
  }
  text << " (" << high - low << " deg)";
  this->Clip(text, high - low, { 0.0, "", width, "twice scanAngleEffectiveMax_deg" });
  const double below = std::max(0.0, -effective - low);
  const double above = std::max(0.0, high - effective);
  this->Scan.VerticalAngleMin = low + (high - low - width) * below / (below + above);
  this->Scan.VerticalAngleMax = this->Scan.VerticalAngleMin + width;
}

//------------------------------------------------------------------------------
void ScanResolver::ResolveFrequencies()
{
  this->Scan.ScanFrequency =
    std::isnan(this->Given.ScanFrequency) ? 0.0 : this->Given.ScanFrequency;
  const bool isByResolution = this->HasResolution() && this->Has(Optics::RotatingMirror);
  if (isByResolution)
  {
    this->Scan.ScanFrequency = this->Scan.PulseFrequency * this->Given.VerticalResolution /
      (2.0 * this->Scanner.ScanAngleMax);
    if (this->Given.VerticalResolution == 0.0)
    {
      MessageBuilder text;
      text << "horizontalResolution_deg=\"" << this->Given.HorizontalResolution
           << "\" also needs verticalResolution_deg; add it";
      this->Error(text);
    }
  }
  if (!this->Has(Optics::FiberArray) && !this->Has(Optics::RisleyPrisms))
  {
    this->ClipScanFrequency();
  }
  if (isByResolution) // keeps the requested line spacing
  {
    this->Scan.HeadRotateSpeed = this->Given.HorizontalResolution * this->Scan.ScanFrequency;
  }
}

//------------------------------------------------------------------------------
void ScanResolver::ResolveScanProduct()
{
  const double frequency = this->Scan.ScanFrequency;
  const double asked = this->Scan.ScanAngle;
  if (!this->Has(Optics::OscillatingMirror) || !(asked * frequency > this->Scanner.ScanProduct))
  {
    return;
  }
  this->Scan.ScanAngle = this->Scanner.ScanProduct / frequency;
  MessageBuilder text;
  text << "a scan angle of " << asked << " deg is clipped to " << this->Scan.ScanAngle
       << " deg, since scanProduct=\"" << this->Scanner.ScanProduct << "\" of scanner "
       << this->Scanner.Id << " allows no more at scanFreq_hz=\"" << frequency << "\"";
  this->Warning(text);
}

//------------------------------------------------------------------------------
void ScanResolver::ClipScanFrequency()
{
  const double frequency = this->Scan.ScanFrequency;
  MessageBuilder text;
  const bool isSpinning = this->Has(Optics::SpinningChannels);
  if ((isSpinning || this->Has(Optics::OscillatingMirror)) && frequency == 0.0)
  {
    text << "scanFreq_hz is missing or 0, so the " << (isSpinning ? "head" : "mirror")
         << " of scanner " << this->Scanner.Id << " does not move; give its scan frequency [Hz]";
    this->Error(text);
    return;
  }
  const double maximum = this->Scanner.ScanFrequencyMax > 0.0 ? this->Scanner.ScanFrequencyMax
                                                              : std::max(frequency, 0.0);
  text << (this->HasResolution() ? "the scan frequency that the resolution requires, "
                                 : "scanFreq_hz=\"")
       << frequency << (this->HasResolution() ? " Hz," : "\"");
  this->Scan.ScanFrequency = this->Clip(text, frequency,
    { std::min(this->Scanner.ScanFrequencyMin, maximum), "scanFreqMin_Hz", maximum,
      "scanFreqMax_Hz" });
}

//------------------------------------------------------------------------------
void ScanResolver::ResolveHead()
{
  const double maximum = this->Scanner.HeadRotateSpeedMax;
  const double asked = this->Scan.HeadRotateSpeed;
  MessageBuilder text;
  text << "headRotatePerSec_deg=\"" << asked << "\"";
  this->Scan.HeadRotateSpeed = std::copysign(
    this->Clip(text, std::abs(asked), { 0.0, "", maximum, "headRotatePerSecMax_deg" }), asked);
  this->CheckHead();
}

//------------------------------------------------------------------------------
void ScanResolver::CheckHead()
{
  const double time = this->Scan.GetHeadTime();
  const bool turns = this->Scan.HeadRotateSpeed != 0.0;
  const bool isEndless = !turns || std::abs(time) > LongestLeg;
  MessageBuilder text;
  text << "the head rotates from headRotateStart_deg=\"" << this->Scan.HeadRotateStart
       << "\" to headRotateStop_deg=\"" << this->Scan.HeadRotateStop
       << "\" with headRotatePerSec_deg=\"" << this->Scan.HeadRotateSpeed << "\" ";
  if (turns && time < 0.0)
  {
    text << "and never reaches it; exchange start and stop, or change the sign of the speed";
    this->Error(text);
  }
  else if (!this->IsMoving && isEndless && this->Given.Leg.MaximumDuration < 0.0)
  {
    text << "on a static platform: the leg never ends; give a speed, or maxDuration_s";
    this->Error(text);
  }
  else if (!this->IsMoving && turns && time == 0.0)
  {
    text << "and starts at its stop: the leg has no duration; give another stop";
    this->Error(text);
  }
}

//------------------------------------------------------------------------------
void ScanResolver::ResolveWarmUp()
{
  const double before = this->Scan.GetHeadTime();
  const double turn = this->Scan.HeadRotateSpeed * this->Scan.WarmUpTime;
  if (!this->IsMoving && before > 0.0 && this->Scan.WarmUpTime >= before)
  {
    MessageBuilder text;
    text << "opticsWarmupPhase_s=\"" << this->Scan.WarmUpTime << "\" rotates the head by " << turn
         << " deg, to headRotateStop_deg=\"" << this->Scan.HeadRotateStop
         << "\" or beyond, before the first pulse; give less than " << before << " s";
    this->Error(text);
  }
  // Reduces the angle on a moving platform: only the direction of the head matters.
  this->Scan.HeadRotateStart += this->IsMoving ? std::fmod(turn, 360.0) : turn;
}

//------------------------------------------------------------------------------
void ScanResolver::CheckUnused()
{
  const bool isRotating = this->Has(Optics::RotatingMirror);
  const bool hasPrisms = this->Has(Optics::RisleyPrisms);
  const bool hasWindow =
    !std::isnan(this->Given.VerticalAngleMin) || !std::isnan(this->Given.VerticalAngleMax);
  const bool hasNoAngle = hasPrisms || this->Has(Optics::SpinningChannels);
  const bool ownsFrequency = hasPrisms || this->Has(Optics::FiberArray);
  const auto warn = [this](const char* names, bool isUnused)
  {
    MessageBuilder text;
    text << names << " not used by " << GetOpticsName(this->Scanner.Type) << " optics";
    if (isUnused)
    {
      this->Warning(text);
    }
  };
  warn("verticalResolution_deg and horizontalResolution_deg are",
    !isRotating && this->HasResolution());
  warn("verticalAngleMin_deg and verticalAngleMax_deg are", !isRotating && hasWindow);
  warn("scanAngle_deg is", hasNoAngle && this->Given.ScanAngle > 0.0);
  warn("scanFreq_hz is", ownsFrequency && this->Given.ScanFrequency > 0.0);
}

//------------------------------------------------------------------------------
void ScanResolver::Error(const MessageBuilder& text)
{
  if (this->Fires)
  {
    this->Log.Error(this->Given.Leg.Where + ": " + text.str());
  }
}

//------------------------------------------------------------------------------
void ScanResolver::Warning(const MessageBuilder& text)
{
  if (this->Fires)
  {
    const std::string message = text.str();
    std::string key = message; // one message for all channels of a scanner
    const std::size_t id = key.find(this->Scanner.Id);
    if (id != std::string::npos && !this->Scanner.Channel.empty())
    {
      key.erase(id + this->Scanner.Id.rfind(", channel "),
        std::string(", channel ").size() + this->Scanner.Channel.size());
    }
    this->Log.WarnOnce(key, this->Given.Leg.Where + ": " + message);
  }
}

} // namespace helios
