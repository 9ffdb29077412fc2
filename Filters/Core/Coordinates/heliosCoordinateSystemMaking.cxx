// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosCoordinateSystemMaking.h"

#include "heliosProj.h"
#include "heliosStatus.h"

#include <vtkMath.h>
#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <vector>

namespace helios
{

namespace
{

const char* const Forms =
  "give \"EPSG:n\", WKT, a PROJ string, or \"ENU latitude longitude height\"";

constexpr std::size_t LongestShown = 60;

/// Shortens a text for messages; it may be a page of WKT.
std::string Shorten(const std::string& text)
{
  return text.size() <= LongestShown ? text : text.substr(0, LongestShown) + "...";
}

/// Returns 1 for a ratio that differs from it by rounding only.
double Snap(double ratio)
{
  return std::abs(ratio - 1.0) < 1e-12 ? 1.0 : ratio;
}

double GetDegrees(double radians)
{
  return Snap(radians / vtkMath::RadiansFromDegrees(1.0));
}

bool IsLocalText(const std::string& text)
{
  return text.size() >= 3 && vtksys::SystemTools::UpperCase(text.substr(0, 3)) == "ENU" &&
    (text.size() == 3 || text[3] == ' ' || text[3] == '\t');
}

/// Parses three numbers after "ENU", with no further text.
bool ParseOrigin(const std::string& text, double origin[3])
{
  const char* at = text.data() + 3;
  const char* end = text.data() + text.size();
  const auto isText = [](char c) { return c != ' ' && c != '\t'; };
  for (int k = 0; k < 3; ++k)
  {
    at = std::find_if(at, end, isText);
    const auto result = std::from_chars(at, end, origin[k]);
    if (result.ec != std::errc() || !std::isfinite(origin[k]))
    {
      return false;
    }
    at = result.ptr;
  }
  return std::find_if(at, end, isText) == end;
}

Status MakeLocalSystem(CoordinateSystemData& data)
{
  double* origin = data.Origin;
  if (!ParseOrigin(data.Text, origin) || std::abs(origin[0]) > 90.0 || std::abs(origin[1]) > 360.0)
  {
    return Status::Error("\"" + Shorten(data.Text) +
      "\" is not a valid local system: expected \"ENU latitude longitude height\" in degrees "
      "(latitude -90 to 90) and metres, e.g. \"ENU 49.4 8.7 110\"");
  }
  data.IsLocal = true;
  data.Label = data.Name = data.Code = data.Text;
  data.UnitName = data.HeightUnitName = "metre";
  data.Projection = MakeLocal(origin[0], origin[1], origin[2]);
  return {};
}

struct Axis
{
  std::string Direction;
  std::string UnitName;
  double Unit = 1.0; // [m] or [rad]
};

std::vector<Axis> GetAxes(const ProjContext& context, const PJ* crs)
{
  std::vector<Axis> axes;
  const ProjObject system(proj_crs_get_coordinate_system(context.Get(), crs));
  const int count = system ? proj_cs_get_axis_count(context.Get(), system.get()) : 0;
  for (int i = 0; i < count; ++i)
  {
    const char* direction = nullptr;
    const char* unit = nullptr;
    Axis axis;
    proj_cs_get_axis_info(context.Get(), system.get(), i, nullptr, nullptr, &direction, &axis.Unit,
      &unit, nullptr, nullptr);
    axis.Direction = direction ? direction : "";
    axis.UnitName = unit ? unit : "";
    axes.push_back(axis);
  }
  return axes;
}

/// Derives the order from the axis directions after PROJ normalization, which keeps south and west.
/// Polar systems, where both axes point south or north, have the axes in the order east, north.
AxisOrder GetAxisOrder(const std::vector<Axis>& axes)
{
  const auto isAlong = [&](int i, const char* positive, const char* negative)
  { return axes[i].Direction == positive || axes[i].Direction == negative; };
  AxisOrder order;
  const bool isSwapped = isAlong(0, "north", "south") && isAlong(1, "east", "west");
  const bool isMap = isAlong(0, "east", "west") && isAlong(1, "north", "south");
  if (isSwapped)
  {
    std::swap(order.From[0], order.From[1]);
  }
  if (isSwapped || isMap)
  {
    order.Factor[0] = axes[order.From[0]].Direction == "west" ? -1.0 : 1.0;
    order.Factor[1] = axes[order.From[1]].Direction == "south" ? -1.0 : 1.0;
  }
  return order;
}

///@{
/// EPSG codes of the map projection parameters used here.
const char* const LatitudeOfOrigin = "8801";
const char* const LongitudeOfOrigin = "8802";
const char* const ScaleAtOrigin = "8805";
const char* const FalseEasting = "8806";
const char* const FalseNorthing = "8807";
///@}

/// Parameters of a map projection in degrees and metres.
std::map<std::string, double> GetParameters(const ProjContext& context, const PJ* conversion)
{
  std::map<std::string, double> parameters;
  const int count = proj_coordoperation_get_param_count(context.Get(), conversion);
  for (int i = 0; i < count; ++i)
  {
    const char* code = nullptr;
    const char* category = nullptr;
    double value = 0.0;
    double unit = 1.0;
    proj_coordoperation_get_param(context.Get(), conversion, i, nullptr, nullptr, &code, &value,
      nullptr, &unit, nullptr, nullptr, nullptr, &category);
    const bool isAngle = category && std::string(category) == "angular";
    parameters[code ? code : ""] = value * (isAngle ? GetDegrees(unit) : unit);
  }
  return parameters;
}

bool IsWGS84(const ProjContext& context, const PJ* geodetic)
{
  const char* const codes[] = { "4326", "4979", "4978" };
  return std::any_of(std::begin(codes), std::end(codes),
    [&](const char* code)
    {
      const ProjObject known(
        proj_create_from_database(context.Get(), "EPSG", code, PJ_CATEGORY_CRS, false, nullptr));
      return known &&
        proj_is_equivalent_to_with_ctx(
          context.Get(), geodetic, known.get(), PJ_COMP_EQUIVALENT_EXCEPT_AXIS_ORDER_GEOGCRS);
    });
}

MapProjectionPointer MakeMap(const ProjContext& context, const PJ* crs)
{
  const ProjObject conversion(proj_crs_get_coordoperation(context.Get(), crs));
  const char* code = nullptr;
  if (!conversion ||
    !proj_coordoperation_get_method_info(context.Get(), conversion.get(), nullptr, nullptr, &code))
  {
    return nullptr;
  }
  std::map<std::string, double> parameters = GetParameters(context, conversion.get());
  const MapOrigin origin{ parameters[LongitudeOfOrigin], parameters[ScaleAtOrigin],
    parameters[FalseEasting], parameters[FalseNorthing] };
  const double latitude = parameters[LatitudeOfOrigin];
  const std::string method = code ? code : "";
  const bool isFinite = std::all_of(parameters.begin(), parameters.end(),
    [](const auto& parameter) { return std::isfinite(parameter.second); });
  if (!isFinite || !(origin.Scale > 0.0))
  {
    return nullptr;
  }
  if (method == "9807" && latitude == 0.0)
  {
    return MakeTransverseMercator(origin);
  }
  return method == "9810" && std::abs(latitude) == 90.0
    ? MakePolarStereographic(latitude > 0.0, origin)
    : nullptr;
}

/// Returns the GeographicLib projection of a system on WGS 84 in degrees and metres, else null.
MapProjectionPointer FindProjection(
  const ProjContext& context, const PJ* crs, const CoordinateSystemData& data)
{
  const ProjObject geodetic(proj_crs_get_geodetic_crs(context.Get(), crs));
  if (!data.Axes.IsIdentity() || !geodetic || !IsWGS84(context, geodetic.get()))
  {
    return nullptr;
  }
  switch (proj_get_type(crs))
  {
    case PJ_TYPE_GEOGRAPHIC_2D_CRS:
    case PJ_TYPE_GEOGRAPHIC_3D_CRS:
      return MakeGeographic();
    case PJ_TYPE_GEOCENTRIC_CRS:
      return MakeGeocentric();
    case PJ_TYPE_PROJECTED_CRS:
      return data.Unit == 1.0 ? MakeMap(context, crs) : nullptr;
    default:
      return nullptr;
  }
}

/// Returns "EPSG:n"; empty without a code.
std::string GetId(const PJ* crs)
{
  const char* authority = proj_get_id_auth_name(crs, 0);
  const char* code = proj_get_id_code(crs, 0);
  return authority && code ? std::string(authority) + ":" + code : std::string();
}

/// Returns the code of the whole, or of both parts, which have the same authority:
/// "EPSG:25832+7837".
std::string FindCode(const ProjContext& context, const PJ* crs)
{
  const ProjObject vertical = GetVerticalPart(context, crs);
  const ProjObject horizontal = GetHorizontalPart(context, crs);
  const std::string whole = GetId(crs);
  const std::string map = horizontal ? GetId(horizontal.get()) : std::string();
  const std::string heights = vertical ? GetId(vertical.get()) : std::string();
  const std::size_t colon = map.find(':');
  if (!whole.empty() || !vertical)
  {
    return whole.empty() ? map : whole;
  }
  const bool isOfOne =
    colon != std::string::npos && heights.compare(0, colon + 1, map, 0, colon + 1) == 0;
  return isOfOne ? map + "+" + heights.substr(colon + 1) : std::string();
}

void SetName(const ProjContext& context, const PJ* crs, CoordinateSystemData& data)
{
  const std::string name = proj_get_name(crs);
  const bool isPage = data.Text.size() > LongestShown && !name.empty() && name != "unknown";
  data.Code = FindCode(context, crs);
  data.Label = !data.Code.empty() ? data.Code : isPage ? name : Shorten(data.Text);
  data.Name = data.Label;
  if (!name.empty() && name != "unknown" && name != data.Label)
  {
    data.Name += " (" + name + ")";
  }
}

void SetHeights(const ProjContext& context, const PJ* crs, CoordinateSystemData& data)
{
  const ProjObject vertical = GetVerticalPart(context, crs);
  const std::vector<Axis> axes = vertical ? GetAxes(context, vertical.get()) : std::vector<Axis>();
  data.IsCompound = !axes.empty();
  if (data.IsCompound)
  {
    data.HeightUnit = axes[0].Unit;
    data.HeightUnitName = axes[0].UnitName;
    data.Axes.Factor[2] = axes[0].Direction == "down" ? -1.0 : 1.0;
  }
}

/// Returns whether a vertical part states no more than a unit.
bool HasUnknownSurface(const ProjContext& context, const PJ* crs)
{
  const ProjObject vertical = GetVerticalPart(context, crs);
  const ProjObject datum(vertical ? proj_crs_get_datum(context.Get(), vertical.get()) : nullptr);
  return datum && vtksys::SystemTools::LowerCase(proj_get_name(datum.get())) == UnknownSurface;
}

/// Names a system whose vertical part only states a unit: "EPSG:2263, heights in metre (NAD83 / New
/// York Long Island (ftUS))".
void SetNameOfUnit(const PJ* map, CoordinateSystemData& data)
{
  const std::string id = GetId(map);
  const std::string name = proj_get_name(map);
  data.Label = (id.empty() ? name : id) + ", heights in " + data.HeightUnitName;
  data.Name = data.Label + (id.empty() ? "" : " (" + name + ")");
}

/// Heights of a system without a vertical part.
void SetPlane(const std::vector<Axis>& axes, bool hasUnknownSurface, CoordinateSystemData& data)
{
  data.IsPlane = axes.size() == 2 && (!data.IsCompound || hasUnknownSurface);
  data.IsCut = data.IsPlane && data.IsCompound;
  data.IsCompound = data.IsCompound && !data.IsCut;
  if (data.IsPlane && !data.IsCut)
  {
    data.HeightUnit = data.Unit > 0.0 ? data.Unit : 1.0;
  }
}

Status MakeProjSystem(CoordinateSystemData& data)
{
  ProjContext context;
  const ProjObject crs = MakeProjCRS(context, data.Text);
  if (!crs)
  {
    const std::string reason = context.ReleaseMessage();
    return Status::Error("\"" + Shorten(data.Text) + "\" is not a coordinate system known to PROJ" +
      (reason.empty() ? "" : " (" + reason + ")") + "; " + Forms);
  }
  SetName(context, crs.get(), data);
  const ProjObject horizontal = GetHorizontalPart(context, crs.get());
  const ProjObject ordered(
    horizontal ? proj_normalize_for_visualization(context.Get(), horizontal.get()) : nullptr);
  const std::vector<Axis> axes = ordered ? GetAxes(context, ordered.get()) : std::vector<Axis>();
  if (axes.size() < 2)
  {
    return Status::Error(data.Name + " has no horizontal part; " + Forms);
  }
  const PJ_TYPE type = proj_get_type(horizontal.get());
  const bool isGeographic = type == PJ_TYPE_GEOGRAPHIC_2D_CRS || type == PJ_TYPE_GEOGRAPHIC_3D_CRS;
  const bool isGeocentric = type == PJ_TYPE_GEOCENTRIC_CRS;
  data.Axes = isGeocentric ? AxisOrder() : GetAxisOrder(axes);
  data.Unit = isGeographic ? 0.0 : axes[0].Unit;
  data.UnitName = isGeographic ? "degrees" : axes[0].UnitName;
  if (isGeographic)
  {
    data.Axes.Factor[0] *= GetDegrees(axes[0].Unit);
    data.Axes.Factor[1] *= GetDegrees(axes[1].Unit);
  }
  if (axes.size() > 2)
  {
    data.HeightUnit = axes[2].Unit;
    data.HeightUnitName = axes[2].UnitName;
  }
  SetHeights(context, crs.get(), data);
  SetPlane(axes, HasUnknownSurface(context, crs.get()), data);
  if (data.IsCut)
  {
    SetNameOfUnit(horizontal.get(), data);
  }
  if (proj_get_type(crs.get()) == type)
  {
    data.Projection = FindProjection(context, crs.get(), data);
  }
  return {};
}

} // namespace

//------------------------------------------------------------------------------
Status MakeSystem(const std::string& text, CoordinateSystemData& data)
{
  const std::string blanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string::npos)
  {
    return Status::Error(std::string("The name of the coordinate system is empty; ") + Forms);
  }
  data.Text = text.substr(first, text.find_last_not_of(blanks) + 1 - first);
  return IsLocalText(data.Text) ? MakeLocalSystem(data) : MakeProjSystem(data);
}

} // namespace helios
