// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosXmlPlatform.h"

#include "heliosAssets.h"
#include "heliosMessages.h"

namespace helios
{

namespace
{

/// Checks an interval of two attributes; an error if it is empty.
void CheckInterval(const std::string& where, const char* from, const char* to, double low,
  double high, Messages& log)
{
  if (low > high)
  {
    MessageBuilder text;
    text << where << ": " << from << "=\"" << low << "\" is above " << to << "=\"" << high
         << "\"; exchange them";
    log.Error(text.str());
  }
}

void CheckNoise(const NoiseData& noise, const std::string& where, Messages& log)
{
  CheckInterval(where, "min", "max", noise.Low, noise.High, log);
  CheckInterval(where, "clipMin", "clipMax", noise.ClipLow, noise.ClipHigh, log);
}

NoiseData ReadNoiseElement(const XmlElement& element)
{
  NoiseData noise;
  element.CheckNames();
  noise.IsOn = true;
  element.ReadStored(noise);
  CheckNoise(noise, element.Where(), element.GetMessages());
  return noise;
}

void ReadNoise(const XmlElement& element, PlatformData& platform)
{
  for (int k = 0; k < 6; ++k)
  {
    if (const XmlElement child = element.GetChild(NoiseNames[k]))
    {
      platform.Noise[k] = ReadNoiseElement(child);
    }
  }
  if (const XmlElement child = element.GetChild("navigationError"))
  {
    platform.Errors = NavigationErrorData();
    child.CheckNames();
    child.ReadStored(platform.Errors);
  }
}

} // namespace

//------------------------------------------------------------------------------
void ReadPose(const XmlElement& element, Pose& pose)
{
  if (element)
  {
    pose = Pose();
    element.CheckNames();
    element.ReadStored(pose);
    pose.Orientation = element.ReadRotation();
  }
}

//------------------------------------------------------------------------------
void ReadModel(const XmlElement& element, const char* attribute, ModelData& model)
{
  std::string name;
  if (element.Read(attribute, name) && !name.empty())
  {
    model = { name, element.Where(attribute) + ": " + attribute + "=\"" + name + "\"", "" };
  }
}

//------------------------------------------------------------------------------
void FindModel(const XmlElement& element, const Assets& files, ModelData& model)
{
  if (!element || model.Name.empty())
  {
    return;
  }
  model.File = files.FindPath(model.Name, element.GetDocument());
  if (model.File.empty()) // the Java program has a folder for models
  {
    model.File = files.FindPath("Models/" + model.Name, element.GetDocument());
  }
}

//------------------------------------------------------------------------------
PlatformData ReadPlatform(const XmlElement& element)
{
  PlatformData platform;
  platform.Where = element.Where();
  platform.File = element.GetDocument().GetPath();
  element.CheckNames();
  element.ReadStored(platform);
  platform.Name = element.Has("name") ? platform.Name : platform.Id;
  ReadModel(element, "visModel", platform.Model);
  ReadModel(element, "model", platform.Model);
  ReadPose(element.GetChild("scannerMount"), platform.Mount);
  ReadNoise(element, platform);
  return platform;
}

//------------------------------------------------------------------------------
void CheckPlatform(const PlatformData& platform, Messages& log)
{
  for (int k = 0; k < 6; ++k)
  {
    CheckNoise(platform.Noise[k], platform.Where + ", " + NoiseNames[k], log);
  }
}

//------------------------------------------------------------------------------
void OverridePlatform(const XmlElement& survey, PlatformData& platform)
{
  ReadNoise(survey, platform);
  if (platform.Type == PlatformType::Interpolated)
  {
    ReadPose(survey.GetChild("scannerMount"), platform.Mount);
  }
}

} // namespace helios
