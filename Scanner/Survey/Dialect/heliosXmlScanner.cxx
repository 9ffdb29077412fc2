// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosXmlScanner.h"

#include "heliosMessages.h"
#include "heliosXmlOptics.h"
#include "heliosXmlPlatform.h"
#include "heliosXmlReceiver.h"
#include "heliosXmlRules.h"

namespace helios
{

namespace
{

/// Reads a scanner or one of its channels; values that are not given are unchanged.
void ReadInstrument(const XmlElement& element, const Assets& files, ScannerData& scanner)
{
  element.CheckNames();
  element.ReadStored(scanner);
  ReadIncidentBeam(element, scanner);
  ReadBeams(element, files, scanner);
  ReadReceiver(element, scanner);
  ReadPose(element.GetChild("beamOrigin"), scanner.Beam);
  ReadHeadRotateAxis(element.GetChild("headRotateAxis"), scanner.HeadRotateAxis);
  ReadModel(element, "visModel", scanner.Model);
}

/// Returns a copy of the scanner with the channel's settings. Other optics start from the defaults.
ScannerData ReadChannel(
  const XmlElement& channel, const Assets& files, ScannerData scanner, std::size_t index)
{
  const ScannerData whole = scanner;
  scanner.Where = channel.Where();
  scanner.Channel = channel.Has("id") ? channel.GetText("id") : std::to_string(index);
  scanner.Id += ", channel " + scanner.Channel;
  ReadInstrument(channel, files, scanner);
  if (scanner.Type != whole.Type)
  {
    ResetOptics(scanner);
    ReadInstrument(channel, files, scanner);
  }
  return scanner;
}

/// Replaces a scanner by its channels; returns the scanner itself if it has none.
ScannerData ReadChannels(const XmlElement& element, const Assets& files, const ScannerData& scanner)
{
  std::vector<ScannerData> channels;
  for (const XmlElement& list : element.GetChildren("channels"))
  {
    list.CheckNames();
    for (const XmlElement& channel : list.GetChildren("channel"))
    {
      channels.push_back(ReadChannel(channel, files, scanner, channels.size()));
    }
  }
  if (channels.empty())
  {
    return scanner;
  }
  ScannerData first = channels.front();
  first.OtherChannels.assign(channels.begin() + 1, channels.end());
  return first;
}

void CheckChannel(const ScannerData& scanner, Messages& log)
{
  CheckOptics(scanner, log);
  CheckReceiver(scanner, log);
  if (!(scanner.Receiver.RangeMin < scanner.Receiver.RangeMax))
  {
    MessageBuilder text;
    text << scanner.Where << ": scanner " << scanner.Id << ": rangeMin_m=\""
         << scanner.Receiver.RangeMin << "\" is not below rangeMax_m=\""
         << scanner.Receiver.RangeMax << "\"; no range is measured. Correct one of them";
    log.Error(text.str());
  }
}

} // namespace

//------------------------------------------------------------------------------
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

//------------------------------------------------------------------------------
ScannerData ReadScanner(const XmlElement& element, const Assets& files)
{
  ScannerData scanner;
  scanner.Where = element.Where();
  scanner.File = element.GetDocument().GetPath();
  scanner.Id = element.GetText("id");
  scanner.Name = element.Has("name") ? element.GetText("name") : scanner.Id;
  if (!element.Has("optics"))
  {
    element.GetMessages().Error(element.Where() + ": scanner " + scanner.Id +
      " has no optics; give " +
      JoinChoices(FindXmlRule("scanner")->FindValue("optics")->GetChoices(), "or"));
  }
  ReadInstrument(element, files, scanner);
  return ReadChannels(element, files, scanner);
}

//------------------------------------------------------------------------------
void OverrideScanner(const XmlElement& survey, ScannerData& scanner)
{
  OverrideReceiver(survey, scanner);
  for (ScannerData& channel : scanner.OtherChannels)
  {
    OverrideReceiver(survey, channel);
  }
}

//------------------------------------------------------------------------------
void CheckScanner(const ScannerData& scanner, Messages& log)
{
  for (std::size_t k = 0; k < scanner.GetNumberOfChannels(); ++k)
  {
    CheckChannel(scanner.GetChannel(k), log);
  }
}

} // namespace helios
