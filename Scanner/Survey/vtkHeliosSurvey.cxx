// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosSurvey.h"

#include "heliosEpochs.h"
#include "heliosPartMotions.h"
#include "heliosSurveyDocument.h"
#include "heliosXmlValue.h"

#include <vtkObjectFactory.h>

#include <algorithm>
#include <map>

vtkStandardNewMacro(vtkHeliosSurvey);

namespace
{

/// Joins names: "a, b".
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

/// The items with attributes, by their names; null: none.
const helios::SurveyItem* FindItem(const std::string& kind)
{
  static const std::map<std::string, helios::SurveyItem> items = {
    { "survey", helios::SurveyItem::Survey },
    { "scene", helios::SurveyItem::Scene },
    { "part", helios::SurveyItem::Part },
    { "scanner", helios::SurveyItem::Scanner },
    { "platform", helios::SurveyItem::Platform },
    { "leg", helios::SurveyItem::Leg },
  };
  const auto found = items.find(kind);
  return found == items.end() ? nullptr : &found->second;
}

std::vector<std::string> ListAttributes(const std::string& kind)
{
  const helios::SurveyItem* item = FindItem(kind);
  return item ? helios::SurveyDocument::ListAttributes(*item) : std::vector<std::string>();
}

using Item = helios::SurveyItem;

} // namespace

/// The document, and the data read from it.
class vtkHeliosSurvey::Internals
{
public:
  explicit Internals(vtkHeliosSurvey* survey)
    : Survey(survey)
    , Document(std::make_unique<helios::SurveyDocument>(survey))
  {
  }

  /// Passes on a success; after a change all data is read again when it is asked for.
  template <typename ResultT>
  ResultT Change(ResultT result, bool isGood)
  {
    if (isGood)
    {
      this->IsRead = this->IsChecked = false;
      this->Survey->Modified();
    }
    return result;
  }
  bool Change(bool isGood) { return this->Change(isGood, isGood); }
  int Change(int index) { return this->Change(index, index >= 0); }

  vtkHeliosSurvey* Survey;
  std::unique_ptr<helios::SurveyDocument> Document;
  helios::SurveyData Data;
  bool IsRead = false;
  bool IsChecked = false;
};

//------------------------------------------------------------------------------
vtkHeliosSurvey::vtkHeliosSurvey()
  : Inside(new Internals(this))
{
}

//------------------------------------------------------------------------------
vtkHeliosSurvey::~vtkHeliosSurvey() = default;

//------------------------------------------------------------------------------
helios::SurveyData& vtkHeliosSurvey::GetData()
{
  if (!this->Inside->IsRead)
  {
    this->Inside->Data = this->Inside->Document->Resolve(nullptr);
    this->Inside->IsRead = true;
  }
  return this->Inside->Data;
}

//------------------------------------------------------------------------------
const helios::SurveyData& vtkHeliosSurvey::GetData() const
{
  return const_cast<vtkHeliosSurvey*>(this)->GetData();
}

//------------------------------------------------------------------------------
bool vtkHeliosSurvey::Check()
{
  if (!this->Inside->IsChecked)
  {
    this->Inside->Data = this->Inside->Document->Resolve(this);
    this->Inside->IsRead = true;
    this->Inside->IsChecked = !this->Inside->Document->HasError();
  }
  return this->Inside->IsChecked;
}

//------------------------------------------------------------------------------
bool vtkHeliosSurvey::ReadDocument(
  std::unique_ptr<helios::SurveyDocument> document, vtkObject* owner)
{
  this->Inside->Data = document->Resolve(owner);
  this->Inside->IsRead = true;
  this->Inside->IsChecked = !document->HasError();
  this->Inside->Document = std::move(document);
  this->Inside->Document->SetOwner(this);
  this->Modified();
  return this->Inside->IsChecked;
}

//------------------------------------------------------------------------------
bool vtkHeliosSurvey::WriteFile(const std::string& fileName)
{
  const helios::Status status = this->Inside->Document->Write(fileName);
  if (!status.IsOk())
  {
    vtkErrorMacro(<< status.Message() << "; give the survey another file");
  }
  return status.IsOk();
}

//------------------------------------------------------------------------------
void vtkHeliosSurvey::AddAssetDirectory(const std::string& directory)
{
  std::vector<std::string> all = this->Inside->Document->GetAssetDirectories();
  all.push_back(directory);
  this->Inside->Document->SetAssetDirectories(all);
  this->Inside->Change(true);
}

//------------------------------------------------------------------------------
void vtkHeliosSurvey::RemoveAllAssetDirectories()
{
  this->Inside->Document->SetAssetDirectories({});
  this->Inside->Change(true);
}

//------------------------------------------------------------------------------
void vtkHeliosSurvey::SetName(const std::string& name)
{
  this->SetSurveyAttribute("name", name);
}

// The same methods of several items.
#define HELIOS_ATTRIBUTES(Name)                                                                    \
  bool vtkHeliosSurvey::Set##Name##Attribute(                                                      \
    int index, const std::string& name, const std::string& value)                                  \
  {                                                                                                \
    return this->Inside->Change(this->Inside->Document->Set({ Item::Name, index }, name, value));  \
  }                                                                                                \
  std::string vtkHeliosSurvey::Get##Name##Attribute(int index, const std::string& name)            \
  {                                                                                                \
    return this->Inside->Document->Get({ Item::Name, index }, name);                               \
  }

#define HELIOS_OWN_ATTRIBUTES(Name)                                                                \
  bool vtkHeliosSurvey::Set##Name##Attribute(const std::string& name, const std::string& value)    \
  {                                                                                                \
    return this->Inside->Change(this->Inside->Document->Set({ Item::Name }, name, value));         \
  }                                                                                                \
  std::string vtkHeliosSurvey::Get##Name##Attribute(const std::string& name)                       \
  {                                                                                                \
    return this->Inside->Document->Get({ Item::Name }, name);                                      \
  }

#define HELIOS_INSTRUMENTS(Name)                                                                   \
  int vtkHeliosSurvey::Add##Name(const std::string& id)                                            \
  {                                                                                                \
    return this->Inside->Change(this->Inside->Document->Add##Name(id));                            \
  }                                                                                                \
  int vtkHeliosSurvey::Add##Name##FromFile(const std::string& reference)                           \
  {                                                                                                \
    return this->Inside->Change(this->Inside->Document->AddFromFile(Item::Name, reference));       \
  }                                                                                                \
  int vtkHeliosSurvey::GetNumberOf##Name##s() const                                                \
  {                                                                                                \
    return this->Inside->Document->GetNumberOf(Item::Name);                                        \
  }

HELIOS_OWN_ATTRIBUTES(Survey)
HELIOS_OWN_ATTRIBUTES(Scene)
HELIOS_ATTRIBUTES(Platform)
HELIOS_ATTRIBUTES(Leg)
HELIOS_ATTRIBUTES(Part)
HELIOS_ATTRIBUTES(PartTable)
HELIOS_INSTRUMENTS(Scanner)
HELIOS_INSTRUMENTS(Platform)

//------------------------------------------------------------------------------
void vtkHeliosSurvey::SetSources(
  const std::string& scene, const std::string& platform, const std::string& scanner)
{
  this->Inside->Document->SetSources(scene, platform, scanner);
  this->Inside->Change(true);
}

//------------------------------------------------------------------------------
std::string vtkHeliosSurvey::MakeFileText(
  const std::string& kind, int index, const std::string& comment, const std::string& fileName)
{
  const helios::SurveyItem* item = FindItem(kind);
  return item ? this->Inside->Document->MakeFileText({ *item, index }, comment, fileName)
              : std::string();
}

//------------------------------------------------------------------------------
int vtkHeliosSurvey::AddChannel(int scanner)
{
  return this->Inside->Change(this->Inside->Document->AddChannel(scanner));
}

//------------------------------------------------------------------------------
int vtkHeliosSurvey::GetNumberOfChannels(int scanner)
{
  return this->Inside->Document->GetNumberOfChannels(scanner);
}

//------------------------------------------------------------------------------
bool vtkHeliosSurvey::SetScannerAttribute(
  int scanner, const std::string& name, const std::string& value)
{
  return this->Inside->Change(this->Inside->Document->Set({ Item::Scanner, scanner }, name, value));
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
  return this->Inside->Change(
    this->Inside->Document->Set({ Item::Scanner, scanner, channel }, name, value));
}

//------------------------------------------------------------------------------
std::string vtkHeliosSurvey::GetChannelAttribute(int scanner, int channel, const std::string& name)
{
  return this->Inside->Document->Get({ Item::Scanner, scanner, channel }, name);
}

//------------------------------------------------------------------------------
int vtkHeliosSurvey::AddLeg(int scanner, int platform)
{
  return this->Inside->Change(this->Inside->Document->AddLeg(scanner, platform));
}

//------------------------------------------------------------------------------
void vtkHeliosSurvey::RemoveLeg(int leg)
{
  this->Inside->Document->RemoveLeg(leg);
  this->Inside->Change(true);
}

//------------------------------------------------------------------------------
void vtkHeliosSurvey::RemoveAllLegs()
{
  this->Inside->Document->RemoveAllLegs();
  this->Inside->Change(true);
}

//------------------------------------------------------------------------------
bool vtkHeliosSurvey::MoveLeg(int leg, int to)
{
  return this->Inside->Change(this->Inside->Document->MoveLeg(leg, to));
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
  return this->Inside->Change(this->Inside->Document->AddPart(loader, file));
}

//------------------------------------------------------------------------------
void vtkHeliosSurvey::RemoveAllParts()
{
  this->Inside->Document->RemoveAllParts();
  this->Inside->Change(true);
}

//------------------------------------------------------------------------------
bool vtkHeliosSurvey::RemovePart(int part)
{
  return this->Inside->Change(this->Inside->Document->RemovePart(part));
}

//------------------------------------------------------------------------------
int vtkHeliosSurvey::AddPartTable(const std::string& file)
{
  return this->Inside->Change(this->Inside->Document->AddPartTable(file));
}

//------------------------------------------------------------------------------
bool vtkHeliosSurvey::SetPartTableRows(int table, const std::string& text)
{
  return this->Inside->Change(this->Inside->Document->SetPartTableRows(table, text));
}

//------------------------------------------------------------------------------
bool vtkHeliosSurvey::RotatePart(int part, const std::string& axis, double angle)
{
  return this->Inside->Change(this->Inside->Document->RotatePart(part, axis, angle));
}

//------------------------------------------------------------------------------
int vtkHeliosSurvey::GetNumberOfAttributes(const std::string& kind)
{
  return static_cast<int>(ListAttributes(kind).size());
}

//------------------------------------------------------------------------------
std::string vtkHeliosSurvey::GetAttributeName(const std::string& kind, int index)
{
  const std::vector<std::string> all = ListAttributes(kind);
  const bool exists = index >= 0 && index < static_cast<int>(all.size());
  return exists ? all[static_cast<std::size_t>(index)] : std::string();
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
int vtkHeliosSurvey::GetNumberOfSingleParts()
{
  this->GetData();
  return this->Inside->Document->GetNumberOf(Item::Part);
}

//------------------------------------------------------------------------------
std::string vtkHeliosSurvey::GetPartName(int part) const
{
  const bool exists = part >= 0 && part < this->GetNumberOfParts();
  return exists ? this->GetData().Scene.Parts[static_cast<std::size_t>(part)].Name : std::string();
}

//------------------------------------------------------------------------------
std::string vtkHeliosSurvey::GetPartMotion(int part) const
{
  const auto& parts = this->GetData().Scene.Parts;
  const auto number = static_cast<std::size_t>(part);
  const bool mayMove = part >= 0 && part < this->GetNumberOfParts() && parts[number].IsMoving();
  return mayMove && helios::FindMoving(parts).count(number) > 0
    ? helios::DescribeMotion(parts[number].Motion, parts[number].Frames.IsGiven())
    : std::string();
}

//------------------------------------------------------------------------------
int vtkHeliosSurvey::GetNumberOfLegs() const
{
  return this->Inside->Document->GetNumberOfLegs();
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
  const bool exists = leg >= 0 && leg < static_cast<int>(this->GetData().Legs.size());
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
