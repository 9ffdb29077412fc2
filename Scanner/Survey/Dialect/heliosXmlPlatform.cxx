// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosXmlPlatform.h"

#include "heliosAssets.h"
#include "heliosMessages.h"

#include <algorithm>

namespace helios
{

namespace
{

struct PlatformName
{
  const char* Name;
  PlatformType Type;
};

constexpr PlatformName PlatformNames[] = { { "static", PlatformType::Static },
  { "linearpath", PlatformType::LinearPath }, { "groundvehicle", PlatformType::GroundVehicle },
  { "multicopter", PlatformType::Multicopter }, { "dummy", PlatformType::Static } };

constexpr const char* NoiseNames[6] = { "positionXNoise", "positionYNoise", "positionZNoise",
  "attitudeXNoise", "attitudeYNoise", "attitudeZNoise" };

void ReadType(const XmlElement& element, PlatformData& platform)
{
  std::string type = "static";
  element.Read("type", type);
  const auto* found = std::find_if(std::begin(PlatformNames), std::end(PlatformNames),
    [&type](const PlatformName& name) { return type == name.Name; });
  if (found == std::end(PlatformNames))
  {
    element.GetMessages().Error(element.Where() + ": platform " + platform.Id + ": type=\"" + type +
      "\" is not valid: expected static, linearpath, groundvehicle or multicopter");
    return;
  }
  platform.Type = found->Type;
}

void ReadVehicle(const XmlElement& element, VehicleData& vehicle)
{
  element.Read("base_pitch_deg", vehicle.BasePitch);
  element.Read("roll_speed_deg", vehicle.RollSpeed);
  element.Read("pitch_speed_deg", vehicle.PitchSpeed);
  element.Read("yaw_speed_deg", vehicle.YawSpeed);
  element.Read("roll_offset_deg", vehicle.RollOffset);
  element.Read("pitch_offset_deg", vehicle.PitchOffset);
}

/// Reads an interval of two attributes; an error if it is empty.
void ReadInterval(
  const XmlElement& element, const char* from, const char* to, double& low, double& high)
{
  element.Read(from, low);
  element.Read(to, high);
  if (low > high)
  {
    Sentence text;
    text << element.Where() << ": " << from << "=\"" << low << "\" is above " << to << "=\"" << high
         << "\"; exchange them";
    element.GetMessages().Error(text.str());
  }
}

NoiseData ReadNoiseElement(const XmlElement& element)
{
  NoiseData noise;
  element.CheckNames();
  const std::string type = ToLower(element.GetText("type"));
  noise.IsUniform = type == "uniform";
  if (!type.empty() && type != "normal" && !noise.IsUniform)
  {
    element.GetMessages().Error(element.Where() + ": type=\"" + element.GetText("type") +
      "\" is not valid: expected NORMAL or UNIFORM");
  }
  element.Read("mean", noise.Mean);
  element.Read("stdev", noise.Deviation);
  ReadInterval(element, "min", "max", noise.Low, noise.High);
  element.Read("clipEnabled", noise.IsClipped);
  ReadInterval(element, "clipMin", "clipMax", noise.ClipLow, noise.ClipHigh);
  element.Read("fixedLifespan", noise.Lifespan);
  return noise;
}

void ReadNoise(const XmlElement& element, PlatformData& platform)
{
  for (int k = 0; k < 6; ++k)
  {
    if (const XmlElement child = element.GetChild(NoiseNames[k]))
    {
      platform.Noise[k] = ReadNoiseElement(child);
      platform.HasNoise[k] = true;
    }
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
    element.ReadVector(pose.Position);
    pose.Orientation = element.ReadRotation();
  }
}

//------------------------------------------------------------------------------
void ReadModel(const XmlElement& element, const char* attribute, ModelData& model)
{
  std::string name;
  if (element.Read(attribute, name) && !name.empty())
  {
    model = { name, element.Where() + ": " + attribute + "=\"" + name + "\"", "" };
  }
}

//------------------------------------------------------------------------------
void FindModel(const XmlElement& element, const Assets& files, ModelData& model)
{
  if (!element || model.Name.empty())
  {
    return;
  }
  model.File = files.LookFor(model.Name, element.GetDocument());
  if (model.File.empty()) // the Java program has a folder for models
  {
    model.File = files.LookFor("Models/" + model.Name, element.GetDocument());
  }
}

//------------------------------------------------------------------------------
PlatformData ReadPlatform(const XmlElement& element)
{
  PlatformData platform;
  platform.Where = element.Where();
  platform.Id = element.GetText("id");
  platform.Name = element.Has("name") ? element.GetText("name") : platform.Id;
  element.CheckNames();
  ReadType(element, platform);
  ReadVehicle(element, platform.Vehicle);
  ReadModel(element, "visModel", platform.Model);
  ReadModel(element, "model", platform.Model);
  ReadPose(element.GetChild("scannerMount"), platform.Mount);
  ReadNoise(element, platform);
  return platform;
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
