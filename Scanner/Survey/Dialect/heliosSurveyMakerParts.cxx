// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Parts of a scene, and what follows from an attribute that was set.
#include "heliosSurveyMaker.h"

#include "heliosAssets.h"
#include "heliosXmlFilter.h"
#include "heliosXmlPlatform.h"
#include "heliosXmlRules.h"

#include <vtkObject.h>

namespace helios
{

namespace
{

/// Whether an attribute names the files of a part: filepath or efilepath of its loader.
bool NamesFiles(const PartData& part, const std::string& name)
{
  const std::string& loader = GetLoaderName(part.Type);
  return name == loader + "/filepath" || name == loader + "/efilepath";
}

bool StartsWith(const std::string& text, const std::string& start)
{
  return text.compare(0, start.size(), start) == 0;
}

} // namespace

//------------------------------------------------------------------------------
int SurveyMaker::AddPart(const std::string& loader, const std::string& file)
{
  Messages log(this->Owner);
  this->Elements.RemoveTableParts(this->Data.Scene.Parts);
  PartData part;
  part.Where = "part " + std::to_string(this->Data.Scene.Parts.size());
  part.Name = std::to_string(this->Data.Scene.Parts.size());
  XmlValueRule rule;
  std::string loaders;
  for (const std::string& each : GetLoaders())
  {
    loaders += (loaders.empty() ? "" : " ") + each;
  }
  rule.Choices = loaders.c_str();
  int type = 0;
  if (ParseChoice({ "filter", loader, part.Where }, rule, log, type))
  {
    part.Type = static_cast<Loader>(type);
    part.Files = { Assets(log, this->AssetDirectories)
                     .FindFile({ "filepath", file, part.Where }, *MakeNowhere(log)) };
  }
  if (log.HasError())
  {
    return -1;
  }
  this->Data.Scene.Parts.push_back(part);
  this->Change();
  return static_cast<int>(this->Data.Scene.Parts.size()) - 1;
}

//------------------------------------------------------------------------------
void SurveyMaker::RemoveAllParts()
{
  this->Data.Scene.Parts.clear();
  this->Elements.RemoveParts();
  this->Owner->Modified();
}

//------------------------------------------------------------------------------
int SurveyMaker::AddPartTable(const std::string& file)
{
  Messages log(this->Owner);
  const std::string path = file.empty()
    ? file
    : Assets(log, this->AssetDirectories)
        .FindFile({ "file", file, "part table" }, *MakeNowhere(log));
  if (log.HasError())
  {
    return -1;
  }
  this->Change();
  return this->Elements.AddTable(path);
}

//------------------------------------------------------------------------------
bool SurveyMaker::SetPartTable(int table, const std::string& name, const std::string& value)
{
  Messages log(this->Owner);
  const bool isGood = this->Elements.SetTable(table, name, value, log);
  isGood ? this->Change() : void();
  return isGood;
}

//------------------------------------------------------------------------------
std::string SurveyMaker::GetPartTable(int table, const std::string& name)
{
  Messages log(this->Owner);
  return this->Elements.GetTable(table, name, log);
}

//------------------------------------------------------------------------------
bool SurveyMaker::SetPartTableRows(int table, const std::string& text)
{
  Messages log(this->Owner);
  const bool isGood = this->Elements.SetTableRows(table, text, log);
  isGood ? this->Change() : void();
  return isGood;
}

//------------------------------------------------------------------------------
/// Finds the file of an attribute that names one; false after an error.
bool SurveyMaker::FindFile(const Attribute* attribute, XmlValue& value, Messages& log)
{
  if (attribute && attribute->Rule->IsFile && !value.Text.empty())
  {
    value.Text = Assets(log, this->AssetDirectories).FindFile(value, *MakeNowhere(log));
  }
  return !log.HasError();
}

//------------------------------------------------------------------------------
/// Finds the model that an attribute names.
void SurveyMaker::FollowModel(ScannerData& scanner, const XmlValue& value)
{
  if (value.Name == "visModel")
  {
    scanner.Model = this->MakeModel(value);
  }
}

//------------------------------------------------------------------------------
void SurveyMaker::FollowModel(PlatformData& platform, const XmlValue& value)
{
  if (value.Name == "model")
  {
    platform.Model = this->MakeModel(value);
  }
}

//------------------------------------------------------------------------------
ModelData SurveyMaker::MakeModel(const XmlValue& value) const
{
  Messages silent(nullptr);
  const Assets assets(silent, this->AssetDirectories);
  const auto here = MakeNowhere(silent);
  const std::string place = value.Where + ": " + value.Name + "=\"" + value.Text + "\"";
  ModelData model = { value.Text, place, assets.FindPath(value.Text, *here) };
  model.File = model.File.empty() ? assets.FindPath("Models/" + value.Text, *here) : model.File;
  return value.Text.empty() ? ModelData() : model;
}

//------------------------------------------------------------------------------
bool SurveyMaker::SetPlatform(int platform, const std::string& name, const std::string& value)
{
  PlatformData* data = this->FindPlatform(platform);
  if (!data || name != "type" || value != "interpolated")
  {
    return this->Set(data, name, value);
  }
  data->Type = PlatformType::Interpolated;
  this->Change();
  return true;
}

//------------------------------------------------------------------------------
std::string SurveyMaker::GetPlatform(int platform, const std::string& name)
{
  PlatformData* data = this->FindPlatform(platform);
  const bool isFlown = data && name == "type" && data->Type == PlatformType::Interpolated;
  return isFlown ? "interpolated" : this->Get(data, name);
}

//------------------------------------------------------------------------------
/// The files of a part by the parameters of its loader; false after an error.
bool SurveyMaker::SetFiles(PartData& part, const XmlValue& value)
{
  Messages log(this->Owner);
  Assets assets(log, this->AssetDirectories);
  const auto here = MakeNowhere(log);
  const bool isPattern = value.Name.find("/efilepath") != std::string::npos;
  const std::vector<std::string> files = isPattern
    ? assets.FindFiles(value, *here)
    : std::vector<std::string>{ assets.FindFile(value, *here) };
  if (!log.HasError())
  {
    part.Files = files;
    this->Change();
  }
  return !log.HasError();
}

//------------------------------------------------------------------------------
bool SurveyMaker::SetPart(int part, const std::string& name, const std::string& value)
{
  PartData* data = this->FindPart(part);
  const bool isFile = data && NamesFiles(*data, name);
  return isFile ? this->SetFiles(*data, { name, value, this->Where })
                : this->Set(data, name, value);
}

//------------------------------------------------------------------------------
std::string SurveyMaker::GetPart(int part, const std::string& name)
{
  PartData* data = this->FindPart(part);
  const bool isFile = data && NamesFiles(*data, name);
  return isFile ? data->Files.empty() ? "" : data->Files.front() : this->Get(data, name);
}

//------------------------------------------------------------------------------
bool SurveyMaker::RotatePart(int part, const std::string& axis, double angle)
{
  PartData* data = this->FindPart(part);
  if (!data)
  {
    return false;
  }
  Messages log(this->Owner);
  const XmlElementRule* rot = FindXmlRule("rot");
  const XmlValue text{ "angle_deg", ToXmlText(angle), this->Where };
  const bool isGood = ParseReal(text, *rot->FindValue("angle_deg"), log, angle);
  const Vec3* direction = FindRotationAxis(axis);
  int ignored = 0;
  if (!direction)
  {
    ParseChoice({ "axis", axis, this->Where }, *rot->FindValue("axis"), log, ignored);
  }
  if (!isGood || !direction)
  {
    return false;
  }
  data->Rotation = AxisAngle(*direction, angle) * data->Rotation;
  this->Owner->Modified();
  return true;
}

//------------------------------------------------------------------------------
void SurveyMaker::Follow(LegSettings& leg, const std::string&, const std::string& where)
{
  leg.Leg.Where = where;
}

//------------------------------------------------------------------------------
/// Names errors of angles and ranges as in messages of a run.
void SurveyMaker::Follow(ScannerData& scanner, const std::string& name, const std::string& where)
{
  ErrorExpressions& errors = scanner.Receiver.Errors;
  scanner.Where = where;
  scanner.Receiver.Where = where;
  const auto set = [&](const char* of, const std::string& value, std::string& shown)
  { shown = name == of ? where + ": " + name + "=\"" + Shorten(value) + "\"" : shown; };
  set("rangeError/expr", errors.Range, errors.RangeName);
  set("deflectionError/expr", errors.Deflection, errors.DeflectionName);
  set("headError/expr", errors.Head, errors.HeadName);
  set("distanceMeasurementError", errors.RangeNoiseFactor, errors.RangeNoiseFactorName);
  if (name == "channel/id")
  {
    scanner.Id =
      scanner.Id.substr(0, scanner.Id.find(", channel ")) + ", channel " + scanner.Channel;
  }
  if (name == "rangeTolerance_m" || name == "energyTolerance")
  {
    scanner.Receiver.NumberOfCircles = 0; // adaptive
  }
}

//------------------------------------------------------------------------------
/// A noise with an attribute is on.
void SurveyMaker::Follow(PlatformData& platform, const std::string& name, const std::string& where)
{
  platform.Where = where;
  for (int k = 0; k < 6; ++k)
  {
    NoiseData& noise = platform.Noise[k];
    noise.IsOn = noise.IsOn || StartsWith(name, std::string(NoiseNames[k]) + "/");
  }
}

//------------------------------------------------------------------------------
void SurveyMaker::Follow(SceneData& scene, const std::string&, const std::string& where)
{
  scene.Where = where;
}

//------------------------------------------------------------------------------
void SurveyMaker::Follow(PartData& part, const std::string& name, const std::string& where)
{
  part.Where = where;
  part.Material.Where = where;
  VoxelData& voxels = part.Voxels;
  voxels.ReadNormals =
    !voxels.EstimateNormals && (voxels.ReadNormals || StartsWith(name, "xyzloader/normal"));
}

} // namespace helios
