// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosXmlReceiver.h"

#include "heliosMessages.h"
#include "heliosReceiver.h"
#include "vtkHeliosExpressionErrorModel.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace helios
{

namespace
{

constexpr double WattsPerNanowatt = 1e-9;

// The maximum length of an echo of one surface in a waveform [bins], and its ratio to the pulse
// length.
constexpr double MostBins = 5000.0;
constexpr double EchoPerPulse = 5.0;

/// Reads one of some words; any other is an error.
void ReadChoice(const XmlElement& element, const char* name,
  const std::vector<std::string>& choices, std::string& target)
{
  std::string given;
  if (!element.Read(name, given))
  {
    return;
  }
  if (std::find(choices.begin(), choices.end(), given) != choices.end())
  {
    target = given;
    return;
  }
  const std::string nearest = FindNearestName(given, choices);
  element.GetMessages().Error(element.Where() + ": " + name + "=\"" + given + "\" is not valid" +
    (nearest.empty() ? ": expected one of " + Enumerate(choices)
                     : "; did you mean " + nearest + "?"));
}

/// Reads gaussian, helios, or the name of a file: beside the XML, else as given.
void ReadPulseShape(const XmlElement& element, ReceiverData& receiver)
{
  std::string shape;
  if (!element.Read("pulseShape", shape))
  {
    return;
  }
  receiver.PulseShape = shape;
  receiver.PulseFile.clear();
  if (shape == "gaussian" || shape == "helios")
  {
    return;
  }
  namespace fs = std::filesystem;
  const fs::path folder = fs::path(element.GetDocument().GetPath()).parent_path();
  std::error_code ignored;
  for (const fs::path& path : { folder / shape, fs::path(shape) })
  {
    if (fs::is_regular_file(path, ignored))
    {
      receiver.PulseShape = "sampled";
      receiver.PulseFile = path.string();
      return;
    }
  }
  element.GetMessages().Error(element.Where() + ": pulseShape=\"" + shape +
    "\" is neither a pulse shape nor a file: expected gaussian, helios, or a text file of times "
    "[ns] and powers");
}

/// Reads a number of circles, or tolerances, which override earlier values.
void ReadSampling(const XmlElement& element, ReceiverData& receiver)
{
  const bool hasRange = element.Read("rangeTolerance_m", receiver.RangeTolerance);
  const bool hasEnergy = element.Read("energyTolerance", receiver.EnergyTolerance);
  int circles = 0;
  if (element.GetTag() == "FWFSettings" && element.Read("beamSampleQuality", circles))
  {
    receiver.NumberOfCircles = circles;
    if (hasRange || hasEnergy)
    {
      element.GetMessages().Warning(element.Where() + ": " +
        (hasRange ? "rangeTolerance_m" : "energyTolerance") +
        " is not used together with beamSampleQuality, which sets a fixed number of sub-rays; "
        "leave one of them");
    }
  }
  else if (hasRange || hasEnergy)
  {
    receiver.NumberOfCircles = 0;
  }
}

/// Reads extensions of vtkHelios to the dialect, on <FWFSettings> and <survey>.
void ReadOwn(const XmlElement& element, ReceiverData& receiver)
{
  ReadSampling(element, receiver);
  ReadChoice(element, "echoDetector", GetEchoDetectorNames(), receiver.EchoDetector);
  ReadChoice(element, "returnSelection", { "all", "first", "last", "strongest", "firstAndLast" },
    receiver.ReturnSelection);
  ReadPulseShape(element, receiver);
}

/// Reads attributes of <scanner> by their names in the Java program.
void ReadJavaNames(const XmlElement& element, ScannerData& data)
{
  element.Read("pulseLength_ns", data.PulseLength);
  element.Read("beamDivergence_rad", data.BeamDivergence);
  element.Read("scannerEfficiency", data.OpticalEfficiency);
  element.Read("atmosphericVisibility", data.AtmosphericVisibility);
  element.Read("scannerWaveLength", data.Wavelength);
  element.Read("numFullwaveBins", data.Receiver.NumberOfBins);
  double bins = 0.0;
  if (element.Read("winSize", bins))
  {
    data.Receiver.PeakWindow = bins * data.Receiver.BinSize;
  }
}

/// Warns of an aperture, which HELIOS reads but never uses, if it is not the receiver's.
void CheckAperture(const XmlElement& element, const char* name, const ScannerData& data)
{
  double aperture = data.ReceiverDiameter;
  if (element.Read(name, aperture) && aperture != data.ReceiverDiameter)
  {
    Sentence text;
    text << element.Where() << ": " << name << "=\"" << aperture
         << "\" has no effect; the receiver has receiverDiameter_m=\"" << data.ReceiverDiameter
         << "\" of scanner " << data.Id;
    element.GetMessages().WarnOnce(text.str(), text.str());
  }
}

void ReadFwfSettings(const XmlElement& element, ScannerData& data)
{
  if (!element)
  {
    return;
  }
  element.CheckNames();
  ReceiverData& receiver = data.Receiver;
  receiver.Where = element.Where();
  element.Read("binSize_ns", receiver.BinSize);
  ReadJavaNames(element, data);
  element.Read("winSize_ns", receiver.PeakWindow);
  element.Read("maxFullwaveRange_ns", receiver.MaximumLength);
  ReadOwn(element, receiver);
  CheckAperture(element, "apertureDiameter_m", data);
  CheckAperture(element, "apartureDiameter", data);
}

void ReadNoise(const XmlElement& scanner, ReceiverData& receiver)
{
  double noise = receiver.DetectorNoise / WattsPerNanowatt;
  scanner.Read("detectorNoise_nW", noise);
  receiver.DetectorNoise = noise * WattsPerNanowatt;
  scanner.Read("solarIrradiance_W_m2_nm", receiver.SolarIrradiance);
  scanner.Read("filterBandwidth_nm", receiver.FilterBandwidth);
  scanner.Read("fieldOfView_rad", receiver.FieldOfView);
  scanner.Read("atmosphericExtinction_1_m", receiver.Extinction);
  scanner.Read("beamQualityFactor", receiver.BeamQualityFactor);
  scanner.Read("accuracyPerMeter", receiver.AccuracyPerMeter);
  scanner.Read("accuracyAtThreshold_m", receiver.AccuracyAtThreshold);
  scanner.Read("angleAccuracy_rad", receiver.AngleAccuracy);
}

/// Checks that an attribute is an expression; an empty one is valid. Returns its name in messages.
std::string CheckExpression(const XmlElement& element, const char* name, const std::string& text)
{
  const std::string shown = element.Where() + ": " + name + "=\"" + Shorten(text) + "\"";
  const std::string fault = vtkHeliosExpressionErrorModel::FindFault(text);
  if (!fault.empty())
  {
    element.GetMessages().Error(shown + ": " + fault);
  }
  return shown;
}

void ReadExpression(
  const XmlElement& scanner, const char* tag, std::string& target, std::string& name)
{
  const XmlElement element = scanner.GetChild(tag);
  if (!element)
  {
    return;
  }
  element.CheckNames();
  if (!element.Read("expr", target) || target.empty())
  {
    element.GetMessages().Error(element.Where() + ": <" + tag +
      "> has no expr; add one, such as expr=\"0.001 * sin(THETA)\"");
  }
  name = CheckExpression(element, "expr", target);
}

void ReadErrors(const XmlElement& scanner, ErrorExpressions& errors)
{
  ReadExpression(scanner, "rangeError", errors.Range, errors.RangeName);
  ReadExpression(scanner, "deflectionError", errors.Deflection, errors.DeflectionName);
  ReadExpression(scanner, "headError", errors.Head, errors.HeadName);
  if (const XmlElement head = scanner.GetChild("headError"))
  {
    head.Read("zeroSinThreshold_deg", errors.HeadZeroSinThreshold);
  }
}

void ReadDetectorSettings(const XmlElement& element, ScannerData& data)
{
  if (element)
  {
    element.CheckNames();
    element.Read("accuracy_m", data.Accuracy);
    element.Read("rangeMin_m", data.RangeMin);
    element.Read("rangeMax_m", data.RangeMax);
    ErrorExpressions& errors = data.Receiver.Errors;
    if (element.Read("distanceMeasurementError", errors.RangeNoiseFactor))
    {
      errors.RangeNoiseFactorName =
        CheckExpression(element, "distanceMeasurementError", errors.RangeNoiseFactor);
    }
  }
}

} // namespace

//------------------------------------------------------------------------------
void ReadReceiver(const XmlElement& scanner, ScannerData& data)
{
  data.Receiver.Where = scanner.Where();
  ReadNoise(scanner, data.Receiver);
  ReadErrors(scanner, data.Receiver.Errors);
  ReadFwfSettings(scanner.GetChild("FWFSettings"), data);
}

//------------------------------------------------------------------------------
void OverrideReceiver(const XmlElement& survey, ScannerData& data)
{
  ReadFwfSettings(survey.GetChild("FWFSettings"), data);
  ReadDetectorSettings(survey.GetChild("detectorSettings"), data);
  ReadOwn(survey, data.Receiver);
}

//------------------------------------------------------------------------------
void CheckReceiver(const ScannerData& data, Messages& log)
{
  const ReceiverData& receiver = data.Receiver;
  const bool isSampled = !receiver.PulseFile.empty(); // its length is in the file
  const double ofBins = (receiver.NumberOfBins - 1) * receiver.BinSize;
  const bool isOfBins =
    receiver.NumberOfBins > 0 && (receiver.MaximumLength == 0.0 || ofBins < receiver.MaximumLength);
  const double length = isOfBins ? ofBins : receiver.MaximumLength; // 0: as the target requires
  Sentence text;
  if (!isSampled && receiver.BinSize > 0.5 * data.PulseLength)
  {
    text << "binSize_ns=\"" << receiver.BinSize << "\" is wider than half of pulseLength_ns=\""
         << data.PulseLength << "\"; give smaller bins";
  }
  else if (!isSampled && EchoPerPulse * data.PulseLength > MostBins * receiver.BinSize * (1 + 1e-9))
  {
    text << "binSize_ns=\"" << receiver.BinSize << "\" makes an echo of pulseLength_ns=\""
         << data.PulseLength << "\" " << EchoPerPulse * data.PulseLength / receiver.BinSize
         << " bins long, and at most " << MostBins << " are allowed; give wider bins";
  }
  else if (!isSampled && (isOfBins || length > 0.0) && length < data.PulseLength)
  {
    text << "waveforms of " << length << " ns ("
         << (isOfBins ? "numFullwaveBins" : "maxFullwaveRange_ns")
         << ") are shorter than pulseLength_ns=\"" << data.PulseLength
         << "\"; give longer ones, or 0: as long as the target";
  }
  if (!text.str().empty())
  {
    log.Error(receiver.Where + ": scanner " + data.Id + ": " + text.str());
  }
}

} // namespace helios
