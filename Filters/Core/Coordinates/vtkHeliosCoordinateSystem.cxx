// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosCoordinateSystem.h"

#include "heliosCoordinateSystem.h"
#include "heliosCoordinateTransform.h"
#include "heliosStatus.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkHeliosCoordinateSystem);

//------------------------------------------------------------------------------
vtkHeliosCoordinateSystem::vtkHeliosCoordinateSystem()
  : System(std::make_unique<helios::CoordinateSystem>())
{
}

//------------------------------------------------------------------------------
vtkHeliosCoordinateSystem::~vtkHeliosCoordinateSystem() = default;

//------------------------------------------------------------------------------
void vtkHeliosCoordinateSystem::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Name: " << (this->System->IsSet() ? this->GetName() : "(not known)") << "\n";
}

//------------------------------------------------------------------------------
bool vtkHeliosCoordinateSystem::SetText(const std::string& text)
{
  const helios::Status status = this->System->Set(text);
  this->Problem = status.Message();
  this->Modified();
  return status.IsOk();
}

//------------------------------------------------------------------------------
std::string vtkHeliosCoordinateSystem::GetText() const
{
  return this->System->IsSet() ? this->System->GetText() : std::string();
}

//------------------------------------------------------------------------------
std::string vtkHeliosCoordinateSystem::GetCode() const
{
  return this->System->IsSet() ? this->System->GetCode() : std::string();
}

//------------------------------------------------------------------------------
std::string vtkHeliosCoordinateSystem::GetLabel() const
{
  return this->System->IsSet() ? this->System->GetLabel() : std::string();
}

//------------------------------------------------------------------------------
std::string vtkHeliosCoordinateSystem::GetName() const
{
  return this->System->IsSet() ? this->System->GetName() : std::string();
}

//------------------------------------------------------------------------------
std::string vtkHeliosCoordinateSystem::GetWkt() const
{
  return this->System->IsSet() ? this->System->GetWkt() : std::string();
}

//------------------------------------------------------------------------------
bool vtkHeliosCoordinateSystem::IsGeographic() const
{
  return this->System->IsSet() && this->System->IsGeographic();
}

//------------------------------------------------------------------------------
double vtkHeliosCoordinateSystem::GetUnit() const
{
  return this->System->IsSet() ? this->System->GetUnit() : 1.0;
}

//------------------------------------------------------------------------------
double vtkHeliosCoordinateSystem::GetHeightUnit() const
{
  return this->System->IsSet() ? this->System->GetHeightUnit() : 1.0;
}

//------------------------------------------------------------------------------
bool vtkHeliosCoordinateSystem::HasHeightUnit() const
{
  return this->System->IsSet() && this->System->HasHeightUnit();
}

//------------------------------------------------------------------------------
std::string vtkHeliosCoordinateSystem::GetUnitName() const
{
  return this->System->IsSet() ? this->System->GetUnitName() : std::string();
}

//------------------------------------------------------------------------------
bool vtkHeliosCoordinateSystem::SetHeightUnit(double metres)
{
  const helios::CoordinateSystem system = this->System->IsSet() && metres > 0.0
    ? this->System->WithHeightUnit(metres)
    : helios::CoordinateSystem();
  if (system.IsSet())
  {
    *this->System = system;
    this->Modified();
  }
  return system.IsSet();
}

//------------------------------------------------------------------------------
double vtkHeliosCoordinateSystem::GetResolution(int axis) const
{
  return helios::GetResolution(*this->System, axis);
}

//------------------------------------------------------------------------------
bool vtkHeliosCoordinateSystem::IsSame(const std::string& text) const
{
  helios::CoordinateSystem other;
  static_cast<void>(other.Set(text)); // an unknown system is none
  return *this->System == other;
}

//------------------------------------------------------------------------------
std::string vtkHeliosCoordinateSystem::FindMetric(double x, double y, double z) const
{
  const double point[3] = { x, y, z };
  return this->System->IsSet() ? helios::FindMetric(*this->System, point) : std::string();
}
