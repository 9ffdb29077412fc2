// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosXmlReceiver.h"

#include "heliosMessages.h"

namespace helios
{

namespace
{

// The maximum length of an echo of one surface in a waveform [bins], and its ratio to the pulse
// length.
constexpr double MaximumBins = 5000.0;
constexpr double EchoPerPulse = 5.0;

/// Checks the sub-rays: the last setting counts, a number of circles, or tolerances.
void CheckSampling(const XmlElement& element, ReceiverData& receiver)
{
  const bool hasRange = element.Has("rangeTolerance_m");
  const bool isAdaptive = hasRange || element.Has("energyTolerance");
  const bool isFixed = element.Has("beamSampleQuality");
  if (isAdaptive && isFixed)
  {
    element.GetMessages().Warning(element.Where() + ": " +
      (hasRange ? "rangeTolerance_m" : "energyTolerance") +
      " is not used together with beamSampleQuality, which sets a fixed number of sub-rays; "
      "leave one of them");
  }
  else if (isAdaptive)
  {
    receiver.NumberOfCircles = 0;
  }
}

/// Reads the attributes of <FWFSettings> and <survey>.
void ReadAttributes(const XmlElement& element, ScannerData& data)
{
  element.ReadStored(data);
  CheckSampling(element, data.Receiver);
}

/// Reads winSize of the Java program, in bins; winSize_ns overrides it.
void ReadWindow(const XmlElement& element, ReceiverData& receiver)
{
  double bins = 0.0;
  if (element.Read("winSize", bins) && !element.Has("winSize_ns"))
  {
    receiver.PeakWindow = bins * receiver.BinSize;
  }
}

/// Warns of an aperture, which HELIOS reads but never uses, if it is not the receiver's.
void CheckAperture(const XmlElement& element, const char* name, const ScannerData& data)
{
  double aperture = data.Receiver.ReceiverDiameter;
  if (element.Read(name, aperture) && aperture != data.Receiver.ReceiverDiameter)
  {
    MessageBuilder text;
    text << element.Where() << ": " << name << "=\"" << aperture
         << "\" has no effect; the receiver has receiverDiameter_m=\""
         << data.Receiver.ReceiverDiameter << "\" of scanner " << data.Id;
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
  data.Receiver.Where = element.Where();
  ReadAttributes(element, data);
  ReadWindow(element, data.Receiver);
  CheckAperture(element, "apertureDiameter_m", data);
  CheckAperture(element, "apartureDiameter", data);
}

/// Reads an error of an angle, and names it in messages.
void ReadError(
  const XmlElement& scanner, const char* tag, ErrorExpressions& errors, std::string& name)
{
  const XmlElement element = scanner.GetChild(tag);
  if (!element)
  {
    return;
  }
  element.CheckNames();
  const std::string text = element.GetText("expr");
  if (text.empty())
  {
    element.GetMessages().Error(element.Where() + ": <" + tag +
      "> has no expr; add one, such as expr=\"0.001 * sin(THETA)\"");
  }
  element.ReadStored(errors);
  name = element.Where("expr") + ": expr=\"" + Shorten(text) + "\"";
}

void ReadErrors(const XmlElement& scanner, ErrorExpressions& errors)
{
  ReadError(scanner, "rangeError", errors, errors.RangeName);
  ReadError(scanner, "deflectionError", errors, errors.DeflectionName);
  ReadError(scanner, "headError", errors, errors.HeadName);
}

/// Reads the errors; a channel's errors replace its scanner's.
void ReadPanoramicErrors(const XmlElement& scanner, PanoramicErrorData& errors)
{
  if (const XmlElement element = scanner.GetChild("panoramicError"))
  {
    errors = PanoramicErrorData();
    element.CheckNames();
    element.ReadStored(errors);
  }
}

void ReadDetectorSettings(const XmlElement& element, ScannerData& data)
{
  if (element)
  {
    element.CheckNames();
    element.ReadStored(data);
    if (element.Has("distanceMeasurementError"))
    {
      data.Receiver.Errors.RangeNoiseFactorName = element.Where() +
        ": distanceMeasurementError=\"" + Shorten(data.Receiver.Errors.RangeNoiseFactor) + "\"";
    }
  }
}

} // namespace

//------------------------------------------------------------------------------
void ReadReceiver(const XmlElement& scanner, ScannerData& data)
{
  data.Receiver.Where = scanner.Where();
  ReadErrors(scanner, data.Receiver.Errors);
  ReadPanoramicErrors(scanner, data.Receiver.Panoramic);
  ReadFwfSettings(scanner.GetChild("FWFSettings"), data);
}

//------------------------------------------------------------------------------
void OverrideReceiver(const XmlElement& survey, ScannerData& data)
{
  ReadFwfSettings(survey.GetChild("FWFSettings"), data);
  ReadDetectorSettings(survey.GetChild("detectorSettings"), data);
  ReadAttributes(survey, data);
}

//------------------------------------------------------------------------------
void CheckReceiver(const ScannerData& data, Messages& log)
{
  const ReceiverData& receiver = data.Receiver;
  const bool isSampled = !receiver.PulseFile.empty(); // its length is in the file
  const double ofBins = (receiver.NumberOfBins - 1) * receiver.BinSize;
  const bool isOfBins = receiver.NumberOfBins > 0 &&
    (receiver.MaximumWaveformLength == 0.0 || ofBins < receiver.MaximumWaveformLength);
  const double length =
    isOfBins ? ofBins : receiver.MaximumWaveformLength; // 0: as the target requires
  MessageBuilder text;
  if (!isSampled && receiver.BinSize > 0.5 * data.Receiver.PulseLength)
  {
    text << "binSize_ns=\"" << receiver.BinSize << "\" is wider than half of pulseLength_ns=\""
         << data.Receiver.PulseLength << "\"; give smaller bins";
  }
  else if (!isSampled &&
    EchoPerPulse * data.Receiver.PulseLength > MaximumBins * receiver.BinSize * (1 + 1e-9))
  {
    text << "binSize_ns=\"" << receiver.BinSize << "\" makes an echo of pulseLength_ns=\""
         << data.Receiver.PulseLength << "\" "
         << EchoPerPulse * data.Receiver.PulseLength / receiver.BinSize
         << " bins long, and at most " << MaximumBins << " are allowed; give wider bins";
  }
  else if (!isSampled && (isOfBins || length > 0.0) && length < data.Receiver.PulseLength)
  {
    text << "waveforms of " << length << " ns ("
         << (isOfBins ? "numFullwaveBins" : "maxFullwaveRange_ns")
         << ") are shorter than pulseLength_ns=\"" << data.Receiver.PulseLength
         << "\"; give longer ones, or 0: as long as the target";
  }
  if (!text.str().empty())
  {
    log.Error(receiver.Where + ": scanner " + data.Id + ": " + text.str());
  }
}

} // namespace helios
