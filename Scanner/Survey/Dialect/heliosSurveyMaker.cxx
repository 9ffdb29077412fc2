// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSurveyMaker.h"

#include "heliosAssets.h"
#include "heliosLegSettings.h"
#include "heliosXmlFilter.h"
#include "heliosXmlPlatform.h"
#include "heliosXmlRules.h"
#include "heliosXmlScanner.h"
#include "heliosXmlScene.h"
#include "heliosXmlSurvey.h"

#include <vtkObject.h>

#include <algorithm>
#include <exception>

namespace helios
{

namespace
{

/// "leg 2": the place in messages.
std::string Numbered(const std::string& what, std::size_t index)
{
  return what + " " + std::to_string(index);
}

} // namespace

//------------------------------------------------------------------------------
SurveyMaker::SurveyMaker(vtkObject* owner)
  : Owner(owner)
{
  this->Data.Name = "survey";
}

//------------------------------------------------------------------------------
/// A document in no folder, from which references are searched.
std::unique_ptr<XmlDocument> SurveyMaker::MakeNowhere(Messages& log)
{
  return XmlDocument::Make("survey", "<document/>", log);
}

//------------------------------------------------------------------------------
SurveyData& SurveyMaker::GetData()
{
  this->Resolve();
  return this->Data;
}

//------------------------------------------------------------------------------
void SurveyMaker::Change()
{
  this->IsResolved = false;
  this->IsChecked = false;
  this->Owner->Modified();
}

//------------------------------------------------------------------------------
/// Makes elements, and legs of their settings, without messages.
void SurveyMaker::Resolve()
{
  if (this->IsResolved)
  {
    return;
  }
  Messages silent(nullptr);
  this->Elements.Apply(this->Data, this->AssetDirectories, silent);
  StartLegs(this->Data);
  for (std::size_t leg = 0; leg < this->Data.Legs.size(); ++leg)
  {
    ResolveLeg(this->Data.Settings[leg], leg, this->Data, silent);
  }
  this->IsResolved = true;
}

//------------------------------------------------------------------------------
bool SurveyMaker::Check()
{
  if (!this->IsChecked || this->Data.Legs.empty())
  {
    Messages log(this->Owner);
    this->CheckAll(log);
  }
  return this->IsChecked;
}

//------------------------------------------------------------------------------
void SurveyMaker::CheckAll(Messages& log)
{
  if (this->Data.Settings.empty())
  {
    log.Error("survey " + this->Data.Name + " has no leg; add one");
  }
  this->Elements.Apply(this->Data, this->AssetDirectories, log);
  for (const ScannerData& scanner : this->Data.Scanners)
  {
    CheckScanner(scanner, log);
  }
  const bool hasGoodScanners = !log.HasError();
  for (const PlatformData& platform : this->Data.Platforms)
  {
    CheckPlatform(platform, log);
  }
  StartLegs(this->Data);
  for (std::size_t leg = 0; leg < this->Data.Legs.size(); ++leg)
  {
    CheckJourney(this->Data, leg, log);
  }
  for (std::size_t leg = 0; leg < this->Data.Legs.size(); ++leg)
  {
    hasGoodScanners ? ResolveLeg(this->Data.Settings[leg], leg, this->Data, log)
                    : CheckLegAlone(this->Data.Settings[leg], leg, this->Data, log);
  }
  this->IsResolved = hasGoodScanners;
  this->IsChecked = !log.HasError();
}

//------------------------------------------------------------------------------
void SurveyMaker::SetAssetDirectories(const std::vector<std::string>& directories)
{
  Messages silent(nullptr);
  this->AssetDirectories = directories;
  this->Data.Scene.SpectraFolders =
    FindSpectraFolders(*MakeNowhere(silent), Assets(silent, directories));
  this->Owner->Modified();
}

//------------------------------------------------------------------------------
/// Reads the element of a reference; false after an error.
template <typename ReadT>
bool SurveyMaker::ReadFromFile(const char* tag, const std::string& reference, ReadT read)
{
  Messages log(this->Owner);
  try
  {
    Assets assets(log, this->AssetDirectories);
    const auto here = MakeNowhere(log);
    const XmlElement element =
      assets.FindElement(tag, { tag, reference, "survey " + this->Data.Name }, *here);
    if (element)
    {
      read(element, assets, log);
    }
    std::vector<std::string>& all = this->Data.Documents;
    const std::vector<std::string> paths = assets.GetDocumentPaths();
    all.insert(all.end(), paths.begin(), paths.end());
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
  }
  catch (const std::exception& error) // standard library errors: out of memory, file system
  {
    log.Error(reference + ": cannot be read: " + error.what());
  }
  return !log.HasError();
}

//------------------------------------------------------------------------------
int SurveyMaker::AddScanner(const std::string& id)
{
  ScannerData scanner;
  scanner.Where = Numbered("scanner", this->Data.Scanners.size());
  scanner.Receiver.Where = scanner.Where;
  scanner.Id = id;
  scanner.Name = id;
  this->Data.Scanners.push_back(scanner);
  this->Change();
  return static_cast<int>(this->Data.Scanners.size()) - 1;
}

//------------------------------------------------------------------------------
int SurveyMaker::AddPlatform(const std::string& id)
{
  PlatformData platform;
  platform.Where = Numbered("platform", this->Data.Platforms.size());
  platform.Id = id;
  platform.Name = id;
  this->Data.Platforms.push_back(platform);
  this->Change();
  return static_cast<int>(this->Data.Platforms.size()) - 1;
}

//------------------------------------------------------------------------------
int SurveyMaker::AddScannerFromFile(const std::string& reference)
{
  ScannerData scanner;
  const auto read = [&scanner](const XmlElement& element, const Assets& assets, Messages& log)
  {
    scanner = ReadScanner(element, assets);
    FindModel(element, assets, scanner.Model);
    log.HasError() ? void() : CheckScanner(scanner, log);
  };
  if (!this->ReadFromFile("scanner", reference, read))
  {
    return -1;
  }
  this->Data.Scanners.push_back(scanner);
  this->Owner->Modified();
  return static_cast<int>(this->Data.Scanners.size()) - 1;
}

//------------------------------------------------------------------------------
int SurveyMaker::AddPlatformFromFile(const std::string& reference)
{
  PlatformData platform;
  const auto read = [&platform](const XmlElement& element, const Assets& assets, Messages&)
  {
    platform = ReadPlatform(element);
    FindModel(element, assets, platform.Model);
  };
  if (!this->ReadFromFile("platform", reference, read))
  {
    return -1;
  }
  this->Data.Platforms.push_back(platform);
  this->Owner->Modified();
  return static_cast<int>(this->Data.Platforms.size()) - 1;
}

//------------------------------------------------------------------------------
int SurveyMaker::AddChannel(int scanner)
{
  ScannerData* first = this->FindScanner(scanner);
  if (!first)
  {
    return -1;
  }
  this->Resolve(); // a channel has the elements of the first
  const std::string id = first->Id.substr(0, first->Id.find(", channel "));
  ScannerData channel = *first;
  channel.OtherChannels.clear();
  channel.Channel = std::to_string(first->GetNumberOfChannels());
  channel.Id = id + ", channel " + channel.Channel;
  if (first->Channel.empty())
  {
    first->Channel = "0";
    first->Id = id + ", channel 0";
  }
  first->OtherChannels.push_back(channel);
  this->Change();
  return static_cast<int>(first->OtherChannels.size());
}

//------------------------------------------------------------------------------
int SurveyMaker::AddLeg(int scanner, int platform)
{
  if (!this->FindScanner(scanner) || !this->FindPlatform(platform))
  {
    return -1;
  }
  LegSettings settings;
  settings.Leg.Where = Numbered("leg", this->Data.Settings.size());
  settings.Leg.Scanner = static_cast<std::size_t>(scanner);
  settings.Leg.Platform = static_cast<std::size_t>(platform);
  this->Data.Settings.push_back(settings);
  this->Change();
  return static_cast<int>(this->Data.Settings.size()) - 1;
}

//------------------------------------------------------------------------------
void SurveyMaker::RemoveLeg(int leg)
{
  std::vector<LegSettings>& all = this->Data.Settings;
  if (leg < 0 || leg >= static_cast<int>(all.size()))
  {
    return;
  }
  all.erase(all.begin() + leg);
  for (std::size_t i = static_cast<std::size_t>(leg); i < all.size(); ++i)
  {
    std::string& where = all[i].Leg.Where;
    where = where == Numbered("leg", i + 1) ? Numbered("leg", i) : where;
  }
  this->Change();
}

//------------------------------------------------------------------------------
void SurveyMaker::RemoveAllLegs()
{
  this->Data.Settings.clear();
  this->Change();
}

//------------------------------------------------------------------------------
/// One of several; null after an error if it does not exist.
template <typename DataT>
DataT* SurveyMaker::Find(std::vector<DataT>& all, int index, const char* what, std::size_t count)
{
  count = std::min(count, all.size());
  this->Where = std::string(what) + " " + std::to_string(index);
  if (index >= 0 && index < static_cast<int>(count))
  {
    return &all[static_cast<std::size_t>(index)];
  }
  Messages(this->Owner)
    .Error(
      this->Where + " does not exist; there are " + std::to_string(count) + ", counted from 0");
  return nullptr;
}

//------------------------------------------------------------------------------
LegSettings* SurveyMaker::FindLeg(int leg)
{
  return this->Find(this->Data.Settings, leg, "leg");
}

//------------------------------------------------------------------------------
PlatformData* SurveyMaker::FindPlatform(int platform)
{
  return this->Find(this->Data.Platforms, platform, "platform");
}

//------------------------------------------------------------------------------
ScannerData* SurveyMaker::FindScanner(int scanner, int channel)
{
  ScannerData* first = this->Find(this->Data.Scanners, scanner, "scanner");
  if (!first || channel == 0)
  {
    return first;
  }
  const std::string what = this->Where + ", channel";
  ScannerData* other = this->Find(first->OtherChannels, channel - 1, what.c_str());
  this->Where = what + " " + std::to_string(channel);
  return other;
}

//------------------------------------------------------------------------------
PartData* SurveyMaker::FindPart(int part)
{
  const std::size_t count = this->Data.Scene.Parts.size() - this->Elements.GetNumberOfTableParts();
  return this->Find(this->Data.Scene.Parts, part, "part", count);
}

//------------------------------------------------------------------------------
bool SurveyMaker::SetSurvey(const std::string& name, const std::string& value)
{
  if (name == "name")
  {
    this->Data.Name = MakeFolderName(value.empty() ? "survey" : value);
    this->Owner->Modified();
    return true;
  }
  this->Where = "survey " + this->Data.Name;
  return this->Set(&this->Data, name, value);
}

//------------------------------------------------------------------------------
std::string SurveyMaker::GetSurvey(const std::string& name)
{
  this->Where = "survey " + this->Data.Name;
  return name == "name" ? this->Data.Name : this->Get(&this->Data, name);
}

//------------------------------------------------------------------------------
SceneData* SurveyMaker::FindScene()
{
  this->Where = "scene";
  return &this->Data.Scene;
}

} // namespace helios
