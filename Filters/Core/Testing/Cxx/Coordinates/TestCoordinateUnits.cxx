// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Identity, units, resolution and epochs of coordinate systems.
#include "heliosCoordinateTransform.h"
#include "vtkHeliosCoordinateSystem.h"

#include <vtkNew.h>

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <string>

namespace
{

using Point = std::array<double, 3>;

constexpr double Foot = 0.3048;
constexpr double SurveyFoot = 1200.0 / 3937.0;
const Point Manhattan{ 984000.0, 200000.0, 100.0 };
const Point Speyer{ 8.44, 49.32, 150.0 };

helios::CoordinateSystem Make(const std::string& text)
{
  helios::CoordinateSystem system;
  REQUIRE(system.Set(text).Message() == "");
  return system;
}

Point Transform(const helios::CoordinateSystem& source, const helios::CoordinateSystem& target,
  const Point& point)
{
  helios::CoordinateTransform transform;
  REQUIRE(transform.Set(source, target).Message() == "");
  Point image{};
  CHECK(transform.Forward(point.data(), image.data(), 1) == -1);
  return image;
}

double GetHeight(const std::string& source, const std::string& target, const Point& point)
{
  return Transform(Make(source), Make(target), point)[2];
}

/// WKT of 2001 and of 2019, as LAS files hold them.
std::string MakeWkt(const std::string& text)
{
  return Make(text).GetWkt();
}

} // namespace

TEST_CASE("CoordinateUnits: a compound system is named by both codes", "[CoordinateUnits]")
{
  CHECK(Make("EPSG:25832").GetCode() == "EPSG:25832");
  CHECK(Make("EPSG:25832+7837").GetCode() == "EPSG:25832+7837");
  CHECK(Make(MakeWkt("EPSG:25832+7837")).GetCode() == "EPSG:25832+7837");
  CHECK(Make(MakeWkt("EPSG:25832+7837")).GetLabel() == "EPSG:25832+7837");
  CHECK(Make("EPSG:7415").GetCode() == "EPSG:7415"); // a compound with a code of its own
  CHECK(Make("ENU 49.4 8.7 110").GetCode() == "ENU 49.4 8.7 110");
  CHECK(Make("+proj=tmerc +lat_0=10 +lon_0=9.123 +datum=WGS84").GetCode().empty());
  CHECK(Make("EPSG:2263").WithHeightUnit(1.0).GetCode().empty());
  CHECK(Make("EPSG:2263").WithHeightUnit(1.0).GetName() ==
    "EPSG:2263, heights in metre (NAD83 / New York Long Island (ftUS))");
}

TEST_CASE("CoordinateUnits: systems are compared by both parts, in any form", "[CoordinateUnits]")
{
  CHECK(Make(MakeWkt("EPSG:25832")) == Make("EPSG:25832"));
  CHECK(Make(MakeWkt("EPSG:25832+7837")) == Make("EPSG:25832+7837"));
  CHECK(Make("EPSG:25832+7837") != Make("EPSG:25832"));
  CHECK(Make("EPSG:25832+7837") != Make("EPSG:25832+5783")); // another height
  CHECK(Make("EPSG:25832+7837") != Make("EPSG:25833+7837"));
  CHECK(Make("EPSG:2263").WithHeightUnit(SurveyFoot) == Make("EPSG:2263")); // same unit as x and y
  CHECK(Make("EPSG:2263").WithHeightUnit(1.0) != Make("EPSG:2263"));
  CHECK(Make("EPSG:2263").WithHeightUnit(1.0) == Make("EPSG:2263").WithHeightUnit(1.0));
  CHECK(Make("EPSG:2263").WithHeightUnit(1.0) != Make("EPSG:2263+5703"));
  std::string bound = MakeWkt("EPSG:31467"); // written by GDAL, with a transformation to WGS 84
  const std::string ellipsoid = "AUTHORITY[\"EPSG\",\"7004\"]],";
  bound.insert(
    bound.find(ellipsoid) + ellipsoid.size(), "TOWGS84[598.1,73.7,418.2,0.202,0.045,-2.455,6.7],");
  CHECK(bound.find("6.7],AUTHORITY") != std::string::npos);
  CHECK(Make(bound) == Make("EPSG:31467"));
}

TEST_CASE(
  "CoordinateUnits: heights have the stated unit, else that of x and y", "[CoordinateUnits]")
{
  CHECK(Make("EPSG:2263").GetHeightUnit() == Approx(SurveyFoot).epsilon(1e-12));
  CHECK_FALSE(Make("EPSG:2263").HasHeightUnit());
  CHECK(Make("EPSG:2263+5703").GetHeightUnit() == 1.0);
  CHECK(Make("EPSG:2263+5703").HasHeightUnit());
  CHECK(Make("EPSG:4326").GetHeightUnit() == 1.0);
  CHECK_FALSE(Make("EPSG:4326").HasHeightUnit());
  CHECK(Make("EPSG:4979").HasHeightUnit());
  const helios::CoordinateSystem feet = Make("EPSG:32618").WithHeightUnit(Foot);
  CHECK(feet.HasHeightUnit());
  CHECK(feet.GetHeightUnit() == Foot);
  CHECK(feet.GetUnit() == 1.0);
  CHECK(feet.GetUnitName() == "metre, with heights in foot");
  CHECK_FALSE(Make("ENU 49.4 8.7 110").WithHeightUnit(1.0).IsSet());
}

TEST_CASE("CoordinateUnits: heights follow the unit of both systems", "[CoordinateUnits]")
{
  CHECK(GetHeight("EPSG:2263", "EPSG:32618", Manhattan) == Approx(100.0 * SurveyFoot));
  CHECK(GetHeight("EPSG:2263+5703", "EPSG:32618", Manhattan) == Approx(100.0));
  CHECK(
    GetHeight("EPSG:32618", "EPSG:2263", { 584386, 4507670, 100.0 }) == Approx(100.0 / SurveyFoot));
  CHECK(GetHeight("EPSG:2263", "EPSG:4326", Manhattan) == Approx(100.0 * SurveyFoot));
  CHECK(GetHeight("EPSG:2263", "EPSG:4979", Manhattan) == Approx(100.0 * SurveyFoot));
  const helios::CoordinateSystem metres = Make("EPSG:2263").WithHeightUnit(1.0);
  CHECK(Transform(metres, Make("EPSG:32618"), Manhattan)[2] == Approx(100.0));
  CHECK(Transform(Make("EPSG:2263"), metres, Manhattan)[2] == Approx(100.0 * SurveyFoot));
  // the height above the ellipsoid is in metres before it becomes X, Y, Z
  const Point low{ Manhattan[0], Manhattan[1], 0.0 };
  const Point up = Transform(Make("EPSG:2263"), Make("EPSG:4978"), Manhattan);
  const Point down = Transform(Make("EPSG:2263"), Make("EPSG:4978"), low);
  CHECK(std::hypot(up[0] - down[0], up[1] - down[1], up[2] - down[2]) ==
    Approx(100.0 * SurveyFoot).epsilon(1e-6));
}

TEST_CASE("CoordinateUnits: stored coordinates have a step by unit and axis", "[CoordinateUnits]")
{
  const auto steps = [](const std::string& text)
  {
    const helios::CoordinateSystem system = Make(text);
    return Point{ helios::GetResolution(system, 0), helios::GetResolution(system, 1),
      helios::GetResolution(system, 2) };
  };
  CHECK(steps("EPSG:25832") == Point{ 1e-4, 1e-4, 1e-4 });
  CHECK(steps("EPSG:4326") == Point{ 1e-9, 1e-9, 1e-4 });
  CHECK(steps("EPSG:2263+5703") == Point{ 1e-4, 1e-4, 1e-4 });
  CHECK(steps("+proj=utm +zone=32 +datum=WGS84 +units=km") == Point{ 1e-7, 1e-7, 1e-7 });
  CHECK(helios::GetResolution(helios::CoordinateSystem(), 2) == 1e-4);
}

TEST_CASE("CoordinateUnits: a plate moves with the epoch", "[CoordinateUnits]")
{
  helios::CoordinateTransform transform;
  REQUIRE(transform.Set(Make("EPSG:7912"), Make("EPSG:25832")).IsOk());
  CHECK(transform.GetYearlyMotion(Speyer.data()) == Approx(0.025).margin(0.002)); // Eurasia
  const std::string warning = transform.GetWarning(Speyer.data(), 1);
  CAPTURE(warning);
  CHECK(warning.find("From EPSG:7912 (ITRF2014) to EPSG:25832 (ETRS89 / UTM zone 32N) coordinates "
                     "move by 2.5 cm a year, and their epoch is not known: the result is 0.2") !=
    std::string::npos);
  CHECK(warning.find(" m off for coordinates of 2020; give the epoch") != std::string::npos);
  const auto moveAt = [&](double year)
  {
    transform.SetEpoch(year);
    Point image{};
    CHECK(transform.Forward(Speyer.data(), image.data(), 1) == -1);
    return image;
  };
  const Point reference = moveAt(0.0);
  const Point then = moveAt(2026.0);
  CHECK(transform.GetWarning(Speyer.data(), 1).empty());
  CHECK(std::hypot(then[0] - reference[0], then[1] - reference[1]) == Approx(0.40).margin(0.02));
  helios::CoordinateTransform copy(transform); // used by another thread
  Point image{};
  CHECK(copy.Forward(Speyer.data(), image.data(), 1) == -1);
  CHECK(image == then);
  REQUIRE(transform.Set(Make("EPSG:25832"), Make("EPSG:31467")).IsOk());
  CHECK(transform.GetYearlyMotion(Speyer.data()) == 0.0);
}

TEST_CASE("CoordinateUnits: the VTK class answers for known and unknown texts", "[CoordinateUnits]")
{
  vtkNew<vtkHeliosCoordinateSystem> system;
  CHECK(system->GetUnit() == 1.0);
  CHECK(system->GetResolution(0) == 1e-4);
  CHECK(system->SetText("EPSG:2263"));
  CHECK(system->GetName() == "EPSG:2263 (NAD83 / New York Long Island (ftUS))");
  CHECK(system->GetUnit() == Approx(SurveyFoot));
  CHECK(system->FindMetric(984000.0, 200000.0, 0.0) == "EPSG:32618");
  CHECK(system->IsSame(MakeWkt("EPSG:2263")));
  CHECK_FALSE(system->HasHeightUnit());
  CHECK(system->SetHeightUnit(1.0));
  CHECK(system->GetHeightUnit() == 1.0);
  CHECK(system->GetText().find("COMPOUNDCRS[") == 0);
  CHECK_FALSE(system->SetHeightUnit(0.0));
  CHECK(system->SetText("EPSG:4326"));
  CHECK(system->IsGeographic());
  CHECK_FALSE(system->SetText("no system"));
  CHECK(system->GetProblem().find("\"no system\" is not a coordinate system known to PROJ") == 0);
  CHECK(system->GetText().empty());
  CHECK(system->IsSame(""));
  CHECK_FALSE(system->IsSame("EPSG:25832"));
}
