// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosSurvey.h"

#include "heliosPlays.h"

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

} // namespace

//------------------------------------------------------------------------------
vtkHeliosSurvey::vtkHeliosSurvey()
  : Data(new helios::SurveyData)
{
}

//------------------------------------------------------------------------------
vtkHeliosSurvey::~vtkHeliosSurvey() = default;

//------------------------------------------------------------------------------
std::string vtkHeliosSurvey::GetName() const
{
  return this->Data->Name;
}

//------------------------------------------------------------------------------
std::string vtkHeliosSurvey::GetScannerName() const
{
  return JoinNames(this->Data->Scanners);
}

//------------------------------------------------------------------------------
std::string vtkHeliosSurvey::GetPlatformName() const
{
  return JoinNames(this->Data->Platforms);
}

//------------------------------------------------------------------------------
std::string vtkHeliosSurvey::GetSceneName() const
{
  return this->Data->Scene.Name;
}

//------------------------------------------------------------------------------
vtkIdType vtkHeliosSurvey::GetSeed() const
{
  return this->Data->Seed;
}

//------------------------------------------------------------------------------
bool vtkHeliosSurvey::IsMoving() const
{
  bool isMoving = false;
  for (std::size_t leg = 0; leg < this->Data->Legs.size(); ++leg)
  {
    isMoving = isMoving || this->Data->IsMoving(leg);
  }
  return isMoving;
}

//------------------------------------------------------------------------------
int vtkHeliosSurvey::GetNumberOfPlays() const
{
  return helios::CountPlays(this->Data->Scene);
}

//------------------------------------------------------------------------------
int vtkHeliosSurvey::GetNumberOfParts() const
{
  return static_cast<int>(this->Data->Scene.Parts.size());
}

//------------------------------------------------------------------------------
std::string vtkHeliosSurvey::GetPartName(int part) const
{
  const bool exists = part >= 0 && part < this->GetNumberOfParts();
  return exists ? this->Data->Scene.Parts[static_cast<std::size_t>(part)].Name : std::string();
}

//------------------------------------------------------------------------------
int vtkHeliosSurvey::GetNumberOfLegs() const
{
  return static_cast<int>(this->Data->Legs.size());
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
  return this->FindLeg(leg) && this->Data->Fires(static_cast<std::size_t>(leg));
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
  return exists ? &this->Data->Legs[static_cast<std::size_t>(leg)] : nullptr;
}

//------------------------------------------------------------------------------
void vtkHeliosSurvey::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Name: " << this->GetName() << "\n"
     << indent << "Scanner: " << this->GetScannerName() << "\n"
     << indent << "Platform: " << this->GetPlatformName() << "\n"
     << indent << "Scene: " << this->GetSceneName() << "\n"
     << indent << "NumberOfPlays: " << this->GetNumberOfPlays() << "\n"
     << indent << "NumberOfParts: " << this->GetNumberOfParts() << "\n"
     << indent << "NumberOfLegs: " << this->GetNumberOfLegs() << "\n";
}
