// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosCoordinateSystem.h"
#include "heliosCoordinateTransform.h"
#include "heliosStatus.h"

#include <catch2/catch.hpp>

#include <string>

namespace
{

helios::CoordinateSystem Make(const std::string& text)
{
  helios::CoordinateSystem system;
  REQUIRE(system.Set(text).Message() == "");
  REQUIRE(system.IsSet());
  return system;
}

/// The error message of a text.
std::string GetProblem(const std::string& text)
{
  helios::CoordinateSystem system;
  const helios::Status status = system.Set(text);
  CHECK_FALSE(system.IsSet());
  return status.Message();
}

bool Has(const std::string& text, const std::string& part)
{
  CAPTURE(text, part);
  return text.find(part) != std::string::npos;
}

const char* const UTM32WKT1 =
  R"(PROJCS["WGS 84 / UTM zone 32N",GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,298.257223563]],)"
  R"(PRIMEM["Greenwich",0],UNIT["degree",0.0174532925199433]],PROJECTION["Transverse_Mercator"],)"
  R"(PARAMETER["latitude_of_origin",0],PARAMETER["central_meridian",9],PARAMETER["scale_factor",0.9996],)"
  R"(PARAMETER["false_easting",500000],PARAMETER["false_northing",0],UNIT["metre",1]])";

const char* const UTM32ESRI =
  R"(PROJCS["WGS_1984_UTM_Zone_32N",GEOGCS["GCS_WGS_1984",DATUM["D_WGS_1984",)"
  R"(SPHEROID["WGS_1984",6378137.0,298.257223563]],PRIMEM["Greenwich",0.0],UNIT["Degree",0.0174532925199433]],)"
  R"(PROJECTION["Transverse_Mercator"],PARAMETER["False_Easting",500000.0],PARAMETER["False_Northing",0.0],)"
  R"(PARAMETER["Central_Meridian",9.0],PARAMETER["Scale_Factor",0.9996],PARAMETER["Latitude_Of_Origin",0.0],)"
  R"(UNIT["Meter",1.0]])";

} // namespace

TEST_CASE("CoordinateSystem: has a name and units", "[CoordinateSystem]")
{
  const helios::CoordinateSystem utm = Make(" EPSG:32632\n");
  CHECK(utm.GetText() == "EPSG:32632");
  CHECK(utm.GetName() == "EPSG:32632 (WGS 84 / UTM zone 32N)");
  CHECK(utm.IsMetric());
  CHECK_FALSE(utm.IsGeographic());
  CHECK(utm.GetUnitName() == "metre");
  CHECK(Make("WGS 84 / UTM zone 32N").GetName() == utm.GetName());
  CHECK(Make("etrs89 / utm zone 32n + dhhn2016 height") == Make("EPSG:25832+7837"));

  const helios::CoordinateSystem degrees = Make("EPSG:4326");
  CHECK(degrees.IsGeographic());
  CHECK_FALSE(degrees.IsMetric());
  CHECK(degrees.GetUnit() == 0.0);
  CHECK(degrees.GetUnitName() == "degrees");
  CHECK(Make("EPSG:4807").GetUnitName() == "degrees"); // the definition uses grads

  const helios::CoordinateSystem feet = Make("EPSG:2263+6360");
  CHECK_FALSE(feet.IsMetric());
  CHECK(feet.GetUnit() == Approx(1200.0 / 3937.0).epsilon(1e-12));
  CHECK(feet.GetHeightUnit() == Approx(1200.0 / 3937.0).epsilon(1e-12));
  CHECK(feet.GetUnitName() == "US survey foot");
  CHECK(Make("EPSG:32618+6360").GetUnitName() == "metre, with heights in US survey foot");
  CHECK_FALSE(Make("EPSG:32618+6360").IsMetric());

  CHECK(Make("EPSG:4978").IsMetric());
  CHECK(Make("enu 49.4 8.7 110").IsMetric());
  CHECK(Make("ENU 49.4 8.7 110").GetName() == "ENU 49.4 8.7 110");
  CHECK(Make(UTM32ESRI).GetName() == "WGS 84 / UTM zone 32N");
  CHECK(utm.GetLabel() == "EPSG:32632");
  CHECK(Make(UTM32WKT1).GetLabel() == "WGS 84 / UTM zone 32N");
  CHECK(Make("+proj=utm +zone=32 +datum=WGS84").GetName() == "+proj=utm +zone=32 +datum=WGS84");
}

TEST_CASE("CoordinateSystem: equal systems compare equal in every notation", "[CoordinateSystem]")
{
  const helios::CoordinateSystem utm = Make("EPSG:32632");
  for (const char* same : { "epsg:32632", "urn:ogc:def:crs:EPSG::32632", UTM32WKT1, UTM32ESRI,
         "+proj=utm +zone=32 +datum=WGS84 +units=m +no_defs",
         "+proj=tmerc +lat_0=0 +lon_0=9 +k=0.9996 +x_0=500000 +y_0=0 +datum=WGS84" })
  {
    CAPTURE(same);
    CHECK(Make(same) == utm);
    CHECK(utm == Make(same));
  }
  for (const char* other : { "EPSG:32633", "EPSG:25832", "EPSG:4326", "EPSG:4978",
         "EPSG:32632+5773", "ENU 0 9 0", "+proj=utm +zone=32 +datum=WGS84 +units=us-ft" })
  {
    CAPTURE(other);
    CHECK(Make(other) != utm);
    CHECK(utm != Make(other));
  }
  CHECK(Make("EPSG:4326") == Make("OGC:CRS84")); // the axis order is normalized
  CHECK(Make("EPSG:4326") == Make("+proj=longlat +datum=WGS84 +no_defs"));
  CHECK(Make("EPSG:32661") == Make("EPSG:5041"));
  CHECK(Make("ENU 49.4 8.7 110") == Make("ENU  49.40\t8.7 1.1e2"));
  CHECK(Make("ENU 10 190 0") == Make("ENU 10 -170 0"));
  CHECK(Make("ENU 49.4 8.7 110") != Make("ENU 49.4 8.7 111"));
  CHECK(helios::CoordinateSystem() == helios::CoordinateSystem());
  CHECK(helios::CoordinateSystem() != utm);
}

TEST_CASE("CoordinateSystem: an invalid text is an error", "[CoordinateSystem]")
{
  const std::string forms =
    "give \"EPSG:n\", WKT, a PROJ string, or \"ENU latitude longitude height\"";
  CHECK(GetProblem(" ") == "The name of the coordinate system is empty; " + forms);
  const std::string unknown = GetProblem("EPSG:99999"); // the words in parentheses are PROJ's
  CHECK(Has(unknown, "\"EPSG:99999\" is not a coordinate system known to PROJ (crs not found"));
  CHECK(Has(unknown, "; " + forms));
  CHECK(Has(GetProblem("EPSG:1149"), "\"EPSG:1149\" is not a coordinate system")); // an operation
  CHECK(Has(GetProblem("foo"), "\"foo\" is not a coordinate system"));
  CHECK(Has(GetProblem("Amersfoor"), "\"Amersfoor\" is not a coordinate system"));
  CHECK(Has(GetProblem("UTM32"), "\"UTM32\" is not a coordinate system"));
  CHECK(Has(GetProblem("EPSG:32632 x"), "\"EPSG:32632 x\" is not a coordinate system"));
  CHECK(Has(GetProblem("ETRS89 + foo"), "\"ETRS89 + foo\" is not a coordinate system"));
  CHECK(Has(GetProblem("32632"), "\"32632\" is not a coordinate system"));
  CHECK(Has(GetProblem("+proj=nonsense"), "\"+proj=nonsense\" is not a coordinate system"));
  CHECK(Has(GetProblem("PROJCS[\"broken\",GEOGCS["), "is not a coordinate system known to PROJ"));
  CHECK(Has(GetProblem(std::string(500, 'x')), "\"" + std::string(60, 'x') + "...\" is no"));
  CHECK(GetProblem("EPSG:5783") == "EPSG:5783 (DHHN92 height) has no horizontal part; " + forms);
  for (const char* text : { "ENU", "ENU 49.4 8.7", "ENU 49.4 8.7 110 1", "ENU 91 0 0",
         "ENU 49,4 8.7 110", "ENU nan 0 0", "ENU 0 inf 0", "ENU 0 361 0" })
  {
    CAPTURE(text);
    CHECK(Has(GetProblem(text),
      std::string("\"") + text + "\" is not a valid local system: expected \"ENU"));
  }
}

TEST_CASE("CoordinateSystem: systems that cannot be used for scans are refused with the reason",
  "[CoordinateSystem]")
{
  const double heidelberg[3] = { 8.7, 49.4, 110.0 };
  CHECK(helios::CheckMetric(Make("EPSG:4326"), heidelberg).Message() ==
    "EPSG:4326 (WGS 84) is in degrees; reproject it to a metric system, e.g. "
    "<filter type=\"crs\"> with target EPSG:32632");
  const double bergen[3] = { 5.3, 60.4, 0.0 }; // zone 32 by the exception for Norway
  CHECK(Has(helios::CheckMetric(Make("EPSG:4258"), bergen).Message(), "target EPSG:32632"));
  const double sydney[3] = { 151.2153, -33.8568, 0.0 };
  CHECK(Has(helios::CheckMetric(Make("EPSG:4326"), sydney).Message(), "target EPSG:32756"));
  const double poles[2][3] = { { 0.0, 88.0, 0.0 }, { 0.0, -88.0, 0.0 } };
  CHECK(Has(helios::CheckMetric(Make("EPSG:4326"), poles[0]).Message(), "target EPSG:5041"));
  CHECK(Has(helios::CheckMetric(Make("EPSG:4326"), poles[1]).Message(), "target EPSG:5042"));
  const double manhattan[3] = { 984000.0, 200000.0, 30.0 };
  CHECK(Has(helios::CheckMetric(Make("EPSG:2263"), manhattan).Message(),
    "(NAD83 / New York Long Island (ftUS)) is in US survey foot; reproject it to a metric system, "
    "e.g. <filter type=\"crs\"> with target EPSG:32618"));
  const double nowhere[3] = { 8.7, 95.0, 0.0 };
  CHECK(Has(helios::CheckMetric(Make("EPSG:4326"), nowhere).Message(), "with target a UTM zone"));
  CHECK(helios::CheckMetric(Make("EPSG:32632"), heidelberg).IsOk());
  CHECK(helios::CheckMetric(Make("ENU 0 0 0"), heidelberg).IsOk());
}

TEST_CASE("CoordinateSystem: its WKT is an equal system", "[CoordinateSystem]")
{
  for (const char* text :
    { "EPSG:25832", "EPSG:25832+7837", "EPSG:4326", "EPSG:2263", "EPSG:4978" })
  {
    CAPTURE(text);
    const helios::CoordinateSystem system = Make(text);
    const std::string wkt = system.GetWkt();
    CHECK(Has(wkt, "[\""));
    CHECK(wkt.find('\n') == std::string::npos);
    CHECK(wkt.find("CRS[") == std::string::npos); // WKT 1 has only CS
    CHECK(Make(wkt) == system);
    CHECK(Make(wkt).GetWkt() == wkt);
  }
  CHECK(Make("ENU 49.4 8.7 110").GetWkt().empty());
  // WKT 1 does not have this projection
  CHECK(Has(
    Make("+proj=ob_tran +o_proj=longlat +o_lon_p=-162 +o_lat_p=39 +lon_0=180 +type=crs").GetWkt(),
    "[\""));
}
