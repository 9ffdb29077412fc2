// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosCoordinateSystem.h"

#include "heliosCoordinateSystemData.h"
#include "heliosCoordinateSystemMaking.h"
#include "heliosProj.h"
#include "heliosStatus.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>

namespace helios
{

namespace
{

bool IsSameLocal(const CoordinateSystemData& a, const CoordinateSystemData& b)
{
  return a.Origin[0] == b.Origin[0] && a.Origin[2] == b.Origin[2] &&
    std::remainder(a.Origin[1] - b.Origin[1], 360.0) == 0.0;
}

bool IsSamePart(const ProjContext& context, const ProjObject& a, const ProjObject& b)
{
  return (!a && !b) ||
    (a && b && proj_is_equivalent_to_with_ctx(context.Get(), a.get(), b.get(), PJ_COMP_EQUIVALENT));
}

/// Compares both parts; axes in any order, with or without transformations to WGS 84.
bool IsSameProj(const CoordinateSystemData& a, const CoordinateSystemData& b)
{
  const ProjContext context;
  const auto makeMap = [&](const ProjObject& crs)
  {
    ProjObject map = GetHorizontalPart(context, crs.get());
    ProjObject ordered(proj_normalize_for_visualization(context.Get(), map.get()));
    return ordered ? std::move(ordered) : std::move(map);
  };
  const ProjObject one = MakeProjCRS(context, a.Text);
  const ProjObject other = MakeProjCRS(context, b.Text);
  const bool isSameHeight = a.IsCut || b.IsCut
    ? a.IsPlane && b.IsPlane && std::abs(a.HeightUnit / b.HeightUnit - 1.0) < 1e-9
    : IsSamePart(
        context, GetVerticalPart(context, one.get()), GetVerticalPart(context, other.get()));
  return isSameHeight && IsSamePart(context, makeMap(one), makeMap(other));
}

/// Names a unit of length: "metre", "foot", "US survey foot", or a number.
std::string NameUnit(double metres)
{
  static constexpr struct
  {
    double Metres;
    const char* Name;
  } units[] = { { 1.0, "metre" }, { 0.3048, "foot" }, { 1200.0 / 3937.0, "US survey foot" } };
  const auto* const found = std::find_if(std::begin(units), std::end(units),
    [metres](const auto& unit) { return std::abs(metres / unit.Metres - 1.0) < 1e-9; });
  return found == std::end(units) ? "unit of heights" : found->Name;
}

} // namespace

//------------------------------------------------------------------------------
Status CoordinateSystem::Set(const std::string& text)
{
  this->Data = nullptr;
  auto data = std::make_shared<CoordinateSystemData>();
  Status status = MakeSystem(text, *data);
  if (status.IsOk())
  {
    this->Data = data;
  }
  return status;
}

//------------------------------------------------------------------------------
const std::string& CoordinateSystem::GetText() const
{
  return this->Data->Text;
}

//------------------------------------------------------------------------------
const std::string& CoordinateSystem::GetLabel() const
{
  return this->Data->Label;
}

//------------------------------------------------------------------------------
const std::string& CoordinateSystem::GetName() const
{
  return this->Data->Name;
}

//------------------------------------------------------------------------------
const std::string& CoordinateSystem::GetCode() const
{
  return this->Data->Code;
}

//------------------------------------------------------------------------------
std::string CoordinateSystem::GetWkt() const
{
  if (this->Data->IsLocal)
  {
    return {};
  }
  const ProjContext context;
  const ProjObject crs = MakeProjCRS(context, this->Data->Text);
  const char* const options[] = { "MULTILINE=NO", nullptr };
  for (const PJ_WKT_TYPE type : { PJ_WKT1_GDAL, PJ_WKT2_2019 })
  {
    const char* wkt = proj_as_wkt(context.Get(), crs.get(), type, options);
    if (wkt)
    {
      return wkt;
    }
  }
  return {};
}

//------------------------------------------------------------------------------
bool CoordinateSystem::IsGeographic() const
{
  return this->Data->Unit == 0.0;
}

//------------------------------------------------------------------------------
double CoordinateSystem::GetUnit() const
{
  return this->Data->Unit;
}

//------------------------------------------------------------------------------
double CoordinateSystem::GetHeightUnit() const
{
  return this->Data->HeightUnit;
}

//------------------------------------------------------------------------------
bool CoordinateSystem::HasHeightUnit() const
{
  return !this->Data->HeightUnitName.empty();
}

//------------------------------------------------------------------------------
CoordinateSystem CoordinateSystem::WithHeightUnit(double metres) const
{
  const ProjContext context;
  const ProjObject crs = MakeProjCRS(context, this->Data->Text);
  const ProjObject map = crs ? GetHorizontalPart(context, crs.get()) : nullptr;
  const char* const options[] = { "MULTILINE=NO", nullptr };
  const char* wkt = map ? proj_as_wkt(context.Get(), map.get(), PJ_WKT2_2019, options) : nullptr;
  CoordinateSystem system;
  if (!wkt)
  {
    return system;
  }
  std::ostringstream text;
  const std::string unit = NameUnit(metres);
  text.precision(17);
  text << "COMPOUNDCRS[\"" << proj_get_name(map.get()) << " + height in " << unit << "\"," << wkt
       << ",VERTCRS[\"height in " << unit << "\",VDATUM[\"" << UnknownSurface
       << "\"],CS[vertical,1],AXIS[\"height (H)\",up,LENGTHUNIT[\"" << unit << "\"," << metres
       << "]]]]";
  return system.Set(text.str()).IsOk() ? system : CoordinateSystem();
}

//------------------------------------------------------------------------------
bool CoordinateSystem::IsMetric() const
{
  return this->Data->Unit == 1.0 && this->Data->HeightUnit == 1.0;
}

//------------------------------------------------------------------------------
std::string CoordinateSystem::GetUnitName() const
{
  const CoordinateSystemData& data = *this->Data;
  const bool isSame = data.HeightUnitName.empty() || data.HeightUnitName == data.UnitName ||
    (data.Unit == 0.0 && data.HeightUnit == 1.0);
  return isSame ? data.UnitName : data.UnitName + ", with heights in " + data.HeightUnitName;
}

//------------------------------------------------------------------------------
bool CoordinateSystem::operator==(const CoordinateSystem& other) const
{
  const CoordinateSystemData* a = this->Data.get();
  const CoordinateSystemData* b = other.Data.get();
  if (!a || !b || a->Text == b->Text)
  {
    return (!a && !b) || (a && b);
  }
  if (a->IsLocal || b->IsLocal)
  {
    return a->IsLocal && b->IsLocal && IsSameLocal(*a, *b);
  }
  return IsSameProj(*a, *b);
}

//------------------------------------------------------------------------------
double GetResolution(const CoordinateSystem& system, int axis)
{
  constexpr double degrees = 1e-9;
  constexpr double metres = 1e-4;
  const double unit = !system.IsSet() ? 1.0 : axis == 2 ? system.GetHeightUnit() : system.GetUnit();
  const double power = unit > 0.0 ? std::floor(std::log10(metres / unit) + 1e-9) : 0.0;
  // a negative power of ten is the nearest number to what its digits say only as a quotient
  const double step = power < 0.0 ? 1.0 / std::pow(10.0, -power) : std::pow(10.0, power);
  return unit > 0.0 ? step : degrees;
}

} // namespace helios
