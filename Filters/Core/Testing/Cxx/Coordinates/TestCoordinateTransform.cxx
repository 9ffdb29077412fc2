// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosCoordinateTransform.h"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

namespace
{

using Point = std::array<double, 3>;

constexpr double Tolerance = 5e-9; // [m]

helios::CoordinateSystem Make(const std::string& text)
{
  helios::CoordinateSystem system;
  REQUIRE(system.Set(text).Message() == "");
  return system;
}

helios::CoordinateTransform MakeTransform(const std::string& source, const std::string& target)
{
  helios::CoordinateTransform transform;
  CAPTURE(source, target);
  REQUIRE(transform.Set(Make(source), Make(target)).Message() == "");
  return transform;
}

Point Transform(const std::string& source, const std::string& target, const Point& point)
{
  Point image{};
  CHECK(MakeTransform(source, target).Forward(point.data(), image.data(), 1) == -1);
  return image;
}

std::string GetProblem(const std::string& source, const std::string& target)
{
  helios::CoordinateTransform transform;
  return transform.Set(Make(source), Make(target)).Message();
}

/// Why a point has no image.
std::string GetFailure(const std::string& source, const std::string& target, const Point& point)
{
  helios::CoordinateTransform transform = MakeTransform(source, target);
  Point image{};
  CAPTURE(source, target, point);
  CHECK(transform.Forward(point.data(), image.data(), 1) == 0);
  CHECK(std::isnan(image[0] + image[1] + image[2]));
  return transform.DescribeFailure(0, point.data());
}

bool Has(const std::string& text, const std::string& part)
{
  CAPTURE(text, part);
  return text.find(part) != std::string::npos;
}

double GetDistance(const Point& a, const Point& b)
{
  return std::hypot(std::hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]);
}

/// Longitude, latitude, height on a grid.
std::vector<Point> MakeGrid(
  double west, double east, double south, double north, int count, double height = 110.0)
{
  std::vector<Point> grid;
  for (int i = 0; i < count; ++i)
  {
    for (int k = 0; k < count; ++k)
    {
      const double s = (i + 0.5) / count;
      const double t = (k + 0.5) / count;
      grid.push_back({ west + s * (east - west), south + t * (north - south), height });
    }
  }
  return grid;
}

double GetLargestDistance(const std::vector<Point>& a, const std::vector<Point>& b)
{
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    largest = std::max(largest, GetDistance(a[i], b[i]));
  }
  return largest;
}

std::vector<Point> Transform(
  const std::string& source, const std::string& target, const std::vector<Point>& points)
{
  std::vector<Point> images(points.size());
  const auto count = static_cast<vtkIdType>(points.size());
  CHECK(MakeTransform(source, target).Forward(points[0].data(), images[0].data(), count) == -1);
  return images;
}

/// Largest distance of points from their original position after a round trip.
double GetRoundTrip(
  const std::string& source, const std::string& target, const std::vector<Point>& points)
{
  const std::vector<Point> there = Transform(source, target, points);
  return GetLargestDistance(Transform(target, source, there), points);
}

struct Truth
{
  double Latitude, Longitude;
  int Zone;
  double Easting, Northing;
};

/// Values by analytic continuation with 40 digits.
const Truth UTMTruths[] = {
  { 49.4, 8.7, 32, 478233.5100801130027, 5471966.6981215651213 },
  { 0, 12, 32, 833978.5569194604536, 0 },
  { 60, 6, 32, 332705.1788755488369, 6655205.4836345641084 },
  { 84, 12, 32, 534994.6550611362738, 9329005.1824474364347 },
  { 51.4778, 0, 31, 291681.911666482773, 5707228.8114013459597 },
  { -80, 12, -32, 558132.2151327991034, 1116915.044051695413 },
  { -33.8568, 151.2153, -56, 334900.5696522619126, 6252288.752888292427 },
  { 40, 29, 32, 2212740.643056014447, 4624280.9757602037603 },
};

/// Values 60 to 75 degrees from the meridian.
const Truth FarTruths[] = {
  { 30, 79, 32, 7757639.0347121435809, 6598258.9638546452634 },
  { 5, 74, 32, 10017742.795363911664, 1312194.6193369477267 },
  { 60, 84, 32, 3867065.7301191921871, 9050108.8026630538502 },
  { -45, -63, 32, -4704648.1126111603362, -8086284.5758771991072 },
  { 0, 70, 32, 9148161.678826145874, 0 },
};

std::string GetUTM(int zone)
{
  return "EPSG:" + std::to_string(zone > 0 ? 32600 + zone : 32700 - zone);
}

struct GeocentricTruth
{
  Point Geographic, Geocentric;
};

const GeocentricTruth GeocentricTruths[] = {
  { { 8.7, 49.4, 110 }, { 4110979.34551926493, 629068.238176137073, 4819709.91273481603 } },
  { { 151.2153, -33.8568, 25 },
    { -4646986.83287270713, 2553086.91691920149, -3533281.05546865375 } },
  { { 45, 45, 20200000 }, { 13294419.145060574, 13294419.145060574, 18770905.3888341798 } },
};

} // namespace

TEST_CASE("CoordinateTransform: UTM to 5e-9 m", "[CoordinateTransform]")
{
  for (const Truth& truth : UTMTruths)
  {
    CAPTURE(truth.Latitude, truth.Longitude);
    const Point place{ truth.Longitude, truth.Latitude, 12.5 };
    const Point image = Transform("EPSG:4326", GetUTM(truth.Zone), place);
    CHECK(std::abs(image[0] - truth.Easting) <= Tolerance);
    CHECK(std::abs(image[1] - truth.Northing) <= Tolerance);
    CHECK(image[2] == 12.5);
    const Point back = Transform(GetUTM(truth.Zone), "EPSG:4326", image);
    const double metresPerDegree = 111320.0;
    CHECK(std::abs(back[0] - truth.Longitude) * metresPerDegree <= Tolerance);
    CHECK(std::abs(back[1] - truth.Latitude) * metresPerDegree <= Tolerance);
  }
}

TEST_CASE("CoordinateTransform: UTM far from the meridian", "[CoordinateTransform]")
{
  for (const Truth& truth : FarTruths)
  {
    CAPTURE(truth.Latitude, truth.Longitude);
    const Point image =
      Transform("EPSG:4326", "EPSG:32632", { truth.Longitude, truth.Latitude, 0 });
    CHECK(std::abs(image[0] - truth.Easting) <= Tolerance);
    CHECK(std::abs(image[1] - truth.Northing) <= Tolerance);
  }
}

TEST_CASE("CoordinateTransform: geocentric to 2e-9 m, and back", "[CoordinateTransform]")
{
  for (const GeocentricTruth& truth : GeocentricTruths)
  {
    const Point image = Transform("EPSG:4326", "EPSG:4978", truth.Geographic);
    CAPTURE(image);
    for (int k = 0; k < 3; ++k)
    {
      const double ulp = std::abs(truth.Geocentric[k]) * 2.3e-16;
      CHECK(std::abs(image[k] - truth.Geocentric[k]) <= 2e-9 + ulp);
    }
    const Point back = Transform("EPSG:4978", "EPSG:4979", image);
    const double ulpOfHeight = truth.Geographic[2] * 2.3e-16;
    const double radians = 3.14159265358979323846 / 180.0;
    CHECK(std::abs(back[0] - truth.Geographic[0]) * radians <= 1e-14);
    CHECK(std::abs(back[1] - truth.Geographic[1]) * radians <= 1e-14);
    CHECK(std::abs(back[2] - truth.Geographic[2]) <= 2e-9 + ulpOfHeight);
  }
}

TEST_CASE("CoordinateTransform: round trip to 5e-9 m", "[CoordinateTransform]")
{
  const auto utm = Transform("EPSG:4326", "EPSG:32632", MakeGrid(6, 12, 44, 56, 40));
  for (const char* system : { "EPSG:4326", "EPSG:4978", "EPSG:32633", "ENU 50 9 100",
         "ENU 49.4 8.7 110", "EPSG:25832", "EPSG:4258" })
  {
    CAPTURE(system);
    CHECK(GetRoundTrip("EPSG:32632", system, utm) <= Tolerance);
  }
  const auto wide = Transform("EPSG:4326", "EPSG:32632", MakeGrid(-60, 78, 10, 80, 30));
  CHECK(GetRoundTrip("EPSG:32632", "EPSG:4326", wide) <= 2.0 * Tolerance); // at 1e7 m
  const auto polar = Transform("EPSG:4326", "EPSG:5041", MakeGrid(-180, 180, 80, 90, 30));
  CHECK(GetRoundTrip("EPSG:5041", "EPSG:4978", polar) <= Tolerance);
  const auto gauss = Transform("EPSG:4326", "EPSG:31467", MakeGrid(8, 10, 48, 54, 20));
  CHECK(GetRoundTrip("EPSG:31467", "EPSG:31466", gauss) <= Tolerance);
}

TEST_CASE("CoordinateTransform: GeographicLib and PROJ agree", "[CoordinateTransform]")
{
  // Without a datum, PROJ computes it on the same ellipsoid.
  const auto check = [](const char* ours, const std::string& theirs, const auto& grid)
  {
    CAPTURE(theirs);
    const auto a = Transform("EPSG:4326", ours, grid);
    const auto b = Transform("+proj=longlat +ellps=WGS84", theirs + " +ellps=WGS84", grid);
    CHECK(GetLargestDistance(a, b) <= Tolerance);
    CHECK(GetLargestDistance(a, grid) > 1e5);
  };
  check("EPSG:32632", "+proj=utm +zone=32", MakeGrid(6, 12, 44, 56, 150));
  check("EPSG:4978", "+proj=geocent", MakeGrid(-180, 180, -90, 90, 100));
  check("EPSG:5041", "+proj=ups", MakeGrid(-180, 180, 80, 90, 100));
  check("EPSG:5042", "+proj=ups +south", MakeGrid(-180, 180, -90, -80, 100));
}

TEST_CASE("CoordinateTransform: local east, north, up", "[CoordinateTransform]")
{
  const std::string local = "ENU 49.4 8.7 110";
  const Point origin{ 8.7, 49.4, 110.0 };
  CHECK(GetDistance(Transform("EPSG:4979", local, origin), { 0, 0, 0 }) <= 2e-9);
  const Point up = Transform("EPSG:4979", local, { 8.7, 49.4, 1110.0 });
  CHECK(GetDistance(up, { 0, 0, 1000.0 }) <= 2e-9);
  const Point east = Transform("EPSG:4979", local, { 8.701, 49.4, 110.0 });
  CHECK(east[0] == Approx(72.5853).margin(1e-4)); // (N + h) cos(lat) dlon, N = 6390480.191 m
  CHECK(std::abs(east[1]) < 1e-3);
  CHECK(east[2] == Approx(-east[0] * east[0] / (2.0 * 6390000.0)).epsilon(1e-2)); // curvature
  const Point north = Transform("EPSG:4979", local, { 8.7, 49.401, 110.0 });
  CHECK(north[1] == Approx(111.226).margin(1e-2));
  CHECK(std::abs(north[0]) < 1e-8);

  // The same point by the topocentric conversion of PROJ from geocentric coordinates.
  const Point there = Transform("EPSG:4978", local, { 4111000.0, 629100.0, 4819800.0 });
  const Point back = Transform(local, "EPSG:4978", there);
  CHECK(GetDistance(back, { 4111000.0, 629100.0, 4819800.0 }) <= Tolerance);

  // With a system that only PROJ supports.
  const Point gauss = Transform(local, "EPSG:31467", { 0, 0, 0 });
  CHECK(GetDistance(gauss, Transform("EPSG:4326", "EPSG:31467", origin)) <= Tolerance);
  CHECK(GetDistance(Transform("EPSG:31467", local, gauss), { 0, 0, 0 }) <= Tolerance);
}

TEST_CASE("CoordinateTransform: east comes first, whatever the definition", "[CoordinateTransform]")
{
  const Point place{ 8.7, 49.4, 110.0 };
  const Point gauss = Transform("EPSG:4326", "EPSG:31467", place); // defined north, east
  CHECK(gauss[0] == Approx(3478300.0).margin(5.0));
  CHECK(gauss[1] == Approx(5473717.0).margin(5.0));
  const Point finland = Transform("EPSG:4258", "EPSG:3067", { 27, 60, 0 }); // east, north
  CHECK(finland[0] == Approx(500000.0).margin(1e-6));
  CHECK(finland[1] == Approx(6651411.19).margin(0.1));
  const Point gk = Transform("EPSG:4258", "EPSG:3879", { 25, 60, 0 }); // north, east
  CHECK(gk[0] == Approx(25500000.0).margin(1e-6));

  // Both axis orders at the pole; axes to the south and west.
  const Point pole{ 20, 88, 0 };
  CHECK(Transform("EPSG:4326", "EPSG:32661", pole) == Transform("EPSG:4326", "EPSG:5041", pole));
  const Point cape = Transform("EPSG:4148", "EPSG:2053", { 28, -26, 0 }); // meridian 29 east
  CHECK(cape[0] == Approx(-100120.87).margin(0.1));
  CHECK(cape[1] == Approx(-2877217.61).margin(0.1));
  const Point prague{ 15, 50, 0 };
  const Point krovak = Transform("EPSG:4326", "EPSG:5513", prague); // south, west
  CHECK(GetDistance(krovak, Transform("EPSG:4326", "EPSG:5514", prague)) <= Tolerance);
  CHECK(krovak[0] == Approx(-703011.88).margin(0.1));
  CHECK(GetDistance(Transform("EPSG:5513", "EPSG:4326", krovak), prague) <= 1e-7);
}

TEST_CASE("CoordinateTransform: angles are degrees, feet stay feet", "[CoordinateTransform]")
{
  const Point paris = Transform("EPSG:4326", "EPSG:4807", { 2.5, 48, 0 }); // grads from Paris
  CHECK(paris[1] == Approx(48.0).margin(1e-3));
  CHECK(paris[0] == Approx(2.5 - 2.33722917).margin(1e-3));

  const Point manhattan{ 984000.0, 200000.0, 100.0 };
  const Point utm = Transform("EPSG:2263", "EPSG:32618", manhattan);
  CHECK(utm[0] == Approx(584386.43).margin(0.1));
  const double foot = 1200.0 / 3937.0;
  CHECK(utm[2] == Approx(100.0 * foot).epsilon(1e-12)); // no vertical part: as x and y
  const Point metres = Transform("EPSG:2263", "EPSG:32118", manhattan); // the same map in metres
  CHECK(metres[0] == Approx(984000.0 * foot).margin(1e-6));
  CHECK(metres[1] == Approx(200000.0 * foot).margin(1e-6));
}

TEST_CASE("CoordinateTransform: heights are kept except for the unit", "[CoordinateTransform]")
{
  const double foot = 1200.0 / 3937.0;
  const Point manhattan{ 984000.0, 200000.0, 100.0 };
  CHECK(Transform("EPSG:2263+6360", "EPSG:32618", manhattan)[2] == Approx(100.0 * foot));
  CHECK(Transform("EPSG:2263+6360", "EPSG:32618+5703", manhattan)[2] == Approx(100.0 * foot));
  CHECK(Transform("EPSG:32618", "EPSG:2263+6360", { 584386, 4507670, 100.0 * foot })[2] ==
    Approx(100.0));
  CHECK(Transform("EPSG:25832+7837", "EPSG:32632", { 478000, 5473000, 110 })[2] == 110.0);
  CHECK(Transform("EPSG:32632", "EPSG:25832+7837", { 478000, 5473000, 110 })[2] == 110.0);
  CHECK(Transform("EPSG:31467", "EPSG:32632", { 3478300, 5473716, 110 })[2] == 110.0);
}

TEST_CASE("CoordinateTransform: a geoid without its grid is an error", "[CoordinateTransform]")
{
  const std::string problem = GetProblem("EPSG:25832+7837", "EPSG:4979");
  CHECK(Has(problem,
    "There is no transformation from EPSG:25832+7837 (ETRS89 / UTM zone 32N + DHHN2016 height) "));
  CHECK(Has(problem, "to EPSG:4979 (WGS 84) without the grid "));
  CHECK(Has(problem, "which PROJ does not find; install it"));
  CHECK(Has(GetProblem("ENU 49.4 8.7 110", "EPSG:25832+7837"), "without the grid "));
}

TEST_CASE("CoordinateTransform: warns if a better grid exists", "[CoordinateTransform]")
{
  helios::CoordinateTransform transform = MakeTransform("EPSG:4267", "EPSG:4326");
  const Point denver{ -105.0, 39.7, 1600.0 };
  const std::string warning = transform.GetWarning(denver.data(), 1);
  CHECK(Has(warning, "From EPSG:4267 (NAD27) to EPSG:4326 (WGS 84) is accurate to "));
  CHECK(Has(warning, " it needs the grid "));
  CHECK(Has(warning, "which PROJ does not find; install it"));

  helios::CoordinateTransform exact = MakeTransform("EPSG:4326", "EPSG:32632");
  const Point place{ 8.7, 49.4, 110.0 };
  CHECK(exact.GetWarning(place.data(), 1).empty());
  CHECK(exact.GetAccuracy() == 0.0);
  helios::CoordinateTransform plain = MakeTransform("EPSG:4258", "EPSG:32632");
  CHECK(plain.GetWarning(place.data(), 1).empty());
}

TEST_CASE("CoordinateTransform: warns at a discontinuity", "[CoordinateTransform]")
{
  helios::CoordinateTransform transform = MakeTransform("EPSG:4267", "EPSG:4326");
  const double places[] = { -105.0, 39.7, 0.0, -80.0, 35.0, 0.0, -150.0, 65.0, 0.0 };
  const std::string warning = transform.GetWarning(places, 3);
  CHECK(Has(warning, "From EPSG:4267 (NAD27) to EPSG:4326 (WGS 84) PROJ uses "));
  CHECK(Has(warning, " operations for different parts of the data ("));
  CHECK(Has(warning, "): surfaces tear where these meet; split the data there. From EPSG:4267"));
  CHECK_FALSE(Has(transform.GetWarning(places, 1), "torn"));
}

TEST_CASE("CoordinateTransform: an impossible transformation is an error", "[CoordinateTransform]")
{
  const std::string problem = GetProblem("+proj=utm +zone=32 +ellps=GRS80", "EPSG:32632");
  CHECK(Has(problem,
    "There is no transformation from +proj=utm +zone=32 +ellps=GRS80 to EPSG:32632 (WGS 84 / UTM "
    "zone 32N)"));
  CHECK(Has(problem, "use systems whose datums PROJ can relate (in a PROJ string: add +datum"));
  CHECK(Has(GetProblem("EPSG:4326", "IAU_2015:30100"), "celestial body"));
}

TEST_CASE("CoordinateTransform: names the point outside the domain", "[CoordinateTransform]")
{
  CHECK(GetFailure("EPSG:4326", "EPSG:32632", { 8.7, 95, 1 }) ==
    "Point 0 (8.7, 95, 1) cannot be transformed from EPSG:4326 (WGS 84) to EPSG:32632 (WGS 84 / "
    "UTM zone 32N); it must lie in the area of use of both, in the order longitude, latitude "
    "[degrees], height");
  CHECK(Has(GetFailure("EPSG:4258", "EPSG:25832", { 8.7, 95, 1 }), "(utm: Invalid latitude)"));
  CHECK(Has(GetFailure("EPSG:32632", "EPSG:4326", { 1e9, 5e6, 1 }), "in the order east, north"));
  const double nan = std::nan("");
  GetFailure("EPSG:4326", "EPSG:32632", { 8.7, nan, 1 });
  GetFailure("EPSG:4326", "EPSG:32632", { 8.7, 49.4, nan });
  GetFailure("EPSG:4326", "EPSG:32632", { 150.0, 10.0, 0.0 }); // the other side of the Earth
  GetFailure("EPSG:4326", "EPSG:4978", { 8.7, 95, 0 });
  GetFailure("EPSG:4326", "ENU 0 0 0", { 8.7, 95, 0 });
  GetFailure("EPSG:4326", "EPSG:5041", { 0, -90, 0 });
  GetFailure("EPSG:4258", "EPSG:25832", { nan, 49.4, 0 });
  GetFailure("EPSG:32632", "EPSG:32632", { nan, 5e6, 0 });

  helios::CoordinateTransform transform = MakeTransform("EPSG:4258", "EPSG:25832");
  double points[9] = { 8.7, 49.4, 1, 8.7, 95, 1, 8.7, 95, 2 };
  CHECK(transform.Forward(points, points, 3) == 1);
  CHECK(points[0] == Approx(478233.5).margin(1.0));
}

TEST_CASE("CoordinateTransform: equal systems keep every bit", "[CoordinateTransform]")
{
  helios::CoordinateTransform transform =
    MakeTransform("EPSG:32632", "+proj=utm +zone=32 +datum=WGS84");
  CHECK(transform.IsIdentity());
  const Point point{ 478233.123456789, 5471966.987654321, 110.1 };
  CHECK(Transform("EPSG:32632", "+proj=utm +zone=32 +datum=WGS84", point) == point);
  CHECK_FALSE(MakeTransform("EPSG:32632", "EPSG:25832").IsIdentity());
}

TEST_CASE("CoordinateTransform: one copy per thread", "[CoordinateTransform]")
{
  const auto grid = MakeGrid(8, 10, 48, 54, 30);
  const helios::CoordinateTransform transform = MakeTransform("EPSG:4326", "EPSG:31467");
  const auto expected = Transform("EPSG:4326", "EPSG:31467", grid);
  std::vector<std::vector<Point>> images(4, std::vector<Point>(grid.size()));
  std::vector<std::thread> threads;
  for (auto& image : images)
  {
    threads.emplace_back(
      [&]
      {
        helios::CoordinateTransform own(transform);
        own.Forward(grid[0].data(), image[0].data(), static_cast<vtkIdType>(grid.size()));
      });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  for (const auto& image : images)
  {
    CHECK(image == expected);
  }
}

TEST_CASE(
  "CoordinateTransform: a copy without PROJ's database moves no point", "[CoordinateTransform]")
{
  const helios::CoordinateTransform transform = MakeTransform("EPSG:4326", "EPSG:31467");
  setenv("PROJ_DATA", "/none", 1);
  setenv("PROJ_LIB", "/none", 1);
  helios::CoordinateTransform copy(transform);
  unsetenv("PROJ_DATA");
  unsetenv("PROJ_LIB");
  const Point place{ 8.7, 49.4, 110.0 };
  Point image{};
  CHECK(copy.Forward(place.data(), image.data(), 1) == 0);
  CHECK(std::isnan(image[0] + image[1] + image[2]));
  CHECK(helios::CoordinateTransform(transform).Forward(place.data(), image.data(), 1) == -1);
}
