// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosSurvey.h"

#include "heliosEpochs.h"
#include "heliosSurveyMaker.h"

#include <vtkObjectFactory.h>

#include <algorithm>

vtkStandardNewMacro(vtkHeliosSurvey);

namespace
{

/// "a, b".
template <typename DataT>
std::string JoinNames(const std::vector<DataT>& all)
{
  std::string names;
  for (const DataT& data : all)
  {
    names += (names.empty() ? "" : ", ") + data.Name;
  }
  return names;
}

/// The attributes of a kind; none if the kind does not exist.
const std::vector<helios::Attribute>& FindAttributes(const std::string& kind)
{
  static const std::vector<helios::Attribute> none;
  return kind == "survey" ? helios::GetAttributes<helios::SurveyData>()
    : kind == "scene"     ? helios::GetAttributes<helios::SceneData>()
    : kind == "part"      ? helios::GetAttributes<helios::PartData>()
    : kind == "scanner"   ? helios::GetAttributes<helios::ScannerData>()
    : kind == "platform"  ? helios::GetAttributes<helios::PlatformData>()
    : kind == "leg"       ? helios::GetAttributes<helios::LegSettings>()
                          : none;
}

} // namespace

//------------------------------------------------------------------------------
vtkHeliosSurvey::vtkHeliosSurvey()
  : Maker(new helios::SurveyMaker(this))
{
}

//------------------------------------------------------------------------------
vtkHeliosSurvey::~vtkHeliosSurvey() = default;

//------------------------------------------------------------------------------
helios::SurveyData& vtkHeliosSurvey::GetData()
{
  return this->Maker->GetData();
}

//------------------------------------------------------------------------------
const helios::SurveyData& vtkHeliosSurvey::GetData() const
{
  return this->Maker->GetData();
}

//------------------------------------------------------------------------------
bool vtkHeliosSurvey::Check()
{
  return this->Maker->Check();
}

//------------------------------------------------------------------------------
void vtkHeliosSurvey::AddAssetDirectory(const std::string& directory)
{
  std::vector<std::string> all = this->Maker->GetAssetDirectories();
  all.push_back(directory);
  this->Maker->SetAssetDirectories(all);
}

//------------------------------------------------------------------------------
void vtkHeliosSurvey::RemoveAllAssetDirectories()
{
  this->Maker->SetAssetDirectories({});
}

//------------------------------------------------------------------------------
void vtkHeliosSurvey::SetName(const std::string& name)
{
  this->Maker->SetSurvey("name", name);
}

//------------------------------------------------------------------------------
bool vtkHeliosSurvey::SetSurveyAttribute(const std::string& name, const std::string& value)
{
  return this->Maker->SetSurvey(name, value);
}

//------------------------------------------------------------------------------
std::string vtkHeliosSurvey::GetSurveyAttribute(const std::string& name)
{
  return this->Maker->GetSurvey(name);
}

//------------------------------------------------------------------------------
bool vtkHeliosSurvey::SetSceneAttribute(const std::string& name, const std::string& value)
{
  return this->Maker->Set(this->Maker->FindScene(), name, value);
}

//------------------------------------------------------------------------------
std::string vtkHeliosSurvey::GetSceneAttribute(const std::string& name)
{
  return this->Maker->Get(this->Maker->FindScene(), name);
}

//------------------------------------------------------------------------------
int vtkHeliosSurvey::AddScanner(const std::string& id)
{
  return this->Maker->AddScanner(id);
}

//------------------------------------------------------------------------------
int vtkHeliosSurvey::AddScannerFromFile(const std::string& reference)
{
  return this->Maker->AddScannerFromFile(reference);
}

//------------------------------------------------------------------------------
int vtkHeliosSurvey::GetNumberOfScanners() const
{
  return static_cast<int>(this->GetData().Scanners.size());
}

//------------------------------------------------------------------------------
int vtkHeliosSurvey::AddPlatform(const std::string& id)
{
  return this->Maker->AddPlatform(id);
}

//------------------------------------------------------------------------------
int vtkHeliosSurvey::AddPlatformFromFile(const std::string& reference)
{
  return this->Maker->AddPlatformFromFile(reference);
}

//------------------------------------------------------------------------------
int vtkHeliosSurvey::GetNumberOfPlatforms() const
{
  return static_cast<int>(this->GetData().Platforms.size());
}

//------------------------------------------------------------------------------
int vtkHeliosSurvey::AddChannel(int scanner)
{
  return this->Maker->AddChannel(scanner);
}

//------------------------------------------------------------------------------
int vtkHeliosSurvey::GetNumberOfChannels(int scanner)
{
  const helios::ScannerData* data = this->Maker->FindScanner(scanner);
  return data ? static_cast<int>(data->GetNumberOfChannels()) : 0;
}

//------------------------------------------------------------------------------
bool vtkHeliosSurvey::SetScannerAttribute(
  int scanner, const std::string& name, const std::string& value)
{
  const int count = this->GetNumberOfChannels(scanner);
  bool isGood = count > 0;
  for (int channel = 0; isGood && channel < count; ++channel)
  {
    isGood = this->SetChannelAttribute(scanner, channel, name, value);
  }
  return isGood;
}

//------------------------------------------------------------------------------
std::string vtkHeliosSurvey::GetScannerAttribute(int scanner, const std::string& name)
{
  return this->GetChannelAttribute(scanner, 0, name);
}

//------------------------------------------------------------------------------
bool vtkHeliosSurvey::SetChannelAttribute(
  int scanner, int channel, const std::string& name, const std::string& value)
{
  return this->Maker->Set(this->Maker->FindScanner(scanner, channel), name, value);
}

//------------------------------------------------------------------------------
std::string vtkHeliosSurvey::GetChannelAttribute(int scanner, int channel, const std::string& name)
{
  return this->Maker->Get(this->Maker->FindScanner(scanner, channel), name);
}

//------------------------------------------------------------------------------
bool vtkHeliosSurvey::SetPlatformAttribute(
  int platform, const std::string& name, const std::string& value)
{
  return this->Maker->SetPlatform(platform, name, value);
}

//------------------------------------------------------------------------------
std::string vtkHeliosSurvey::GetPlatformAttribute(int platform, const std::string& name)
{
  return this->Maker->GetPlatform(platform, name);
}

//------------------------------------------------------------------------------
bool vtkHeliosSurvey::SetLegAttribute(int leg, const std::string& name, const std::string& value)
{
  return this->Maker->Set(this->Maker->FindLeg(leg), name, value);
}

//------------------------------------------------------------------------------
std::string vtkHeliosSurvey::GetLegAttribute(int leg, const std::string& name)
{
  return this->Maker->Get(this->Maker->FindLeg(leg), name);
}

//------------------------------------------------------------------------------
bool vtkHeliosSurvey::SetPartAttribute(int part, const std::string& name, const std::string& value)
{
  return this->Maker->SetPart(part, name, value);
}

//------------------------------------------------------------------------------
std::string vtkHeliosSurvey::GetPartAttribute(int part, const std::string& name)
{
  return this->Maker->GetPart(part, name);
}

//------------------------------------------------------------------------------
int vtkHeliosSurvey::AddLeg(int scanner, int platform)
{
  return this->Maker->AddLeg(scanner, platform);
}

//------------------------------------------------------------------------------
void vtkHeliosSurvey::RemoveLeg(int leg)
{
  this->Maker->RemoveLeg(leg);
}

//------------------------------------------------------------------------------
void vtkHeliosSurvey::RemoveAllLegs()
{
  this->Maker->RemoveAllLegs();
}

//------------------------------------------------------------------------------
bool vtkHeliosSurvey::SetLegPosition(int leg, double x, double y, double z)
{
  return this->SetLegAttribute(leg, "x", helios::ToXmlText(x)) &&
    this->SetLegAttribute(leg, "y", helios::ToXmlText(y)) &&
    this->SetLegAttribute(leg, "z", helios::ToXmlText(z));
}

//------------------------------------------------------------------------------
int vtkHeliosSurvey::AddPart(const std::string& loader, const std::string& file)
{
  return this->Maker->AddPart(loader, file);
}

//------------------------------------------------------------------------------
void vtkHeliosSurvey::RemoveAllParts()
{
  this->Maker->RemoveAllParts();
}

//------------------------------------------------------------------------------
int vtkHeliosSurvey::AddPartTable(const std::string& file)
{
  return this->Maker->AddPartTable(file);
}

//------------------------------------------------------------------------------
bool vtkHeliosSurvey::SetPartTableAttribute(
  int table, const std::string& name, const std::string& value)
{
  return this->Maker->SetPartTable(table, name, value);
}

//------------------------------------------------------------------------------
std::string vtkHeliosSurvey::GetPartTableAttribute(int table, const std::string& name)
{
  return this->Maker->GetPartTable(table, name);
}

//------------------------------------------------------------------------------
bool vtkHeliosSurvey::SetPartTableRows(int table, const std::string& text)
{
  return this->Maker->SetPartTableRows(table, text);
}

//------------------------------------------------------------------------------
bool vtkHeliosSurvey::RotatePart(int part, const std::string& axis, double angle)
{
  return this->Maker->RotatePart(part, axis, angle);
}

//------------------------------------------------------------------------------
int vtkHeliosSurvey::GetNumberOfAttributes(const std::string& kind)
{
  return static_cast<int>(FindAttributes(kind).size());
}

//------------------------------------------------------------------------------
std::string vtkHeliosSurvey::GetAttributeName(const std::string& kind, int index)
{
  const std::vector<helios::Attribute>& all = FindAttributes(kind);
  const bool exists = index >= 0 && index < static_cast<int>(all.size());
  return exists ? all[static_cast<std::size_t>(index)].Name : std::string();
}

//------------------------------------------------------------------------------
std::string vtkHeliosSurvey::GetName() const
{
  return this->GetData().Name;
}

//------------------------------------------------------------------------------
std::string vtkHeliosSurvey::GetScannerName() const
{
  return JoinNames(this->GetData().Scanners);
}

//------------------------------------------------------------------------------
std::string vtkHeliosSurvey::GetPlatformName() const
{
  return JoinNames(this->GetData().Platforms);
}

//------------------------------------------------------------------------------
std::string vtkHeliosSurvey::GetSceneName() const
{
  return this->GetData().Scene.Name;
}

//------------------------------------------------------------------------------
vtkIdType vtkHeliosSurvey::GetSeed() const
{
  return this->GetData().Seed;
}

//------------------------------------------------------------------------------
bool vtkHeliosSurvey::IsMoving() const
{
  bool isMoving = false;
  for (std::size_t leg = 0; leg < this->GetData().Legs.size(); ++leg)
  {
    isMoving = isMoving || this->GetData().IsMoving(leg);
  }
  return isMoving;
}

//------------------------------------------------------------------------------
int vtkHeliosSurvey::GetNumberOfEpochs() const
{
  return helios::CountEpochs(this->GetData().Scene);
}

//------------------------------------------------------------------------------
int vtkHeliosSurvey::GetNumberOfParts() const
{
  return static_cast<int>(this->GetData().Scene.Parts.size());
}

//------------------------------------------------------------------------------
std::string vtkHeliosSurvey::GetPartName(int part) const
{
  const bool exists = part >= 0 && part < this->GetNumberOfParts();
  return exists ? this->GetData().Scene.Parts[static_cast<std::size_t>(part)].Name : std::string();
}

//------------------------------------------------------------------------------
int vtkHeliosSurvey::GetNumberOfLegs() const
{
  return static_cast<int>(this->GetData().Legs.size());
}

//------------------------------------------------------------------------------
void vtkHeliosSurvey::GetLegPosition(int leg, double position[3]) const
{
  const helios::LegData* data = this->FindLeg(leg);
  const helios::Vec3 p = data ? data->Position : helios::Vec3(0.0, 0.0, 0.0);
  std::copy_n(p.GetData(), 3, position);
}

//------------------------------------------------------------------------------
bool vtkHeliosSurvey::IsLegOnGround(int leg) const
{
  const helios::LegData* data = this->FindLeg(leg);
  return data && data->OnGround;
}

//------------------------------------------------------------------------------
bool vtkHeliosSurvey::IsLegActive(int leg) const
{
  return this->FindLeg(leg) && this->GetData().Fires(static_cast<std::size_t>(leg));
}

//------------------------------------------------------------------------------
double vtkHeliosSurvey::GetLegPulseFrequency(int leg) const
{
  const helios::LegData* data = this->FindLeg(leg);
  return data && !data->Scans.empty() ? data->Scans.front().PulseFrequency : 0.0;
}

//------------------------------------------------------------------------------
double vtkHeliosSurvey::GetLegScanFrequency(int leg) const
{
  const helios::LegData* data = this->FindLeg(leg);
  return data && !data->Scans.empty() ? data->Scans.front().ScanFrequency : 0.0;
}

//------------------------------------------------------------------------------
const helios::LegData* vtkHeliosSurvey::FindLeg(int leg) const
{
  const bool exists = leg >= 0 && leg < this->GetNumberOfLegs();
  return exists ? &this->GetData().Legs[static_cast<std::size_t>(leg)] : nullptr;
}

//------------------------------------------------------------------------------
void vtkHeliosSurvey::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Name: " << this->GetName() << "\n"
     << indent << "Scanner: " << this->GetScannerName() << "\n"
     << indent << "Platform: " << this->GetPlatformName() << "\n"
     << indent << "Scene: " << this->GetSceneName() << "\n"
     << indent << "NumberOfEpochs: " << this->GetNumberOfEpochs() << "\n"
     << indent << "NumberOfParts: " << this->GetNumberOfParts() << "\n"
     << indent << "NumberOfLegs: " << this->GetNumberOfLegs() << "\n";
}
